// Mass, mass centre and inertia of a rigid window cage: a hollow cylinder less Z pockets whose
// faces are parallel to the pocket's own central radial plane. Exact for that shape; squareness
// moves no mass.
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
