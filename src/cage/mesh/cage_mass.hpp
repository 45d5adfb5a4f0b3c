// Mass, mass centre and inertia of a rigid window cage: a hollow cylinder minus Z pockets with
// faces parallel to the central radial plane of the pocket. Exact for this shape. Squareness has no
// effect on the mass.
#pragma once

#include "src/scene/scene.hpp"

namespace cagetol {

struct CageMass {
  double mass = 0;                    ///< [kg]
  double centre_y = 0, centre_z = 0;  ///< mass centre in the cage frame, from deviating pockets [m]
  double polar_inertia = 0;           ///< about the bearing axis through the mass centre [kg m^2]
  double transverse_inertia =
      0;  ///< mean of those about the two diameters through the mass centre [kg m^2]
};

CageMass cage_mass(const CageGeometry& cage, long roller_count);

}  // namespace cagetol
