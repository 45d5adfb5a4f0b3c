// How much oil a named supply leaves in the gaps of a bearing. No source measures these gaps in a
// rolling bearing: they are assumptions, which reports list with a range, held against makers'
// torque models at speed (tests/ACCURACY.md). Oil is thrown outwards, so that the outer race and a
// cage's outer lands have more of it than the inner race.
#pragma once

#include "src/scene/scene.hpp"

namespace cagetol {

struct OilLayers {
  double inner, outer;  ///< gaps up to which oil fills the inlets of the races [m]
  double pocket, land;  ///< likewise in pockets and at flanges, and at guide lands [m]
  double share;         ///< volume fraction of oil in the free space
};

/// automatic: grease of a lubricant whose name says so, else a circulation.
OilSupply oil_supply(const Lubrication& lubrication);

/// What the scene gives, the rest that of its supply.
OilLayers oil_layers(const Lubrication& lubrication);

}  // namespace cagetol
