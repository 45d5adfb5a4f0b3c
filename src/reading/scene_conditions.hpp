// Why a key of a scene does nothing where the value of one other key does not tell (Idle): named
// here, listed in the rows of scene_keys.cpp. Of a row the first that holds is named.
#pragma once

#include "src/input/key_table.hpp"
#include "src/scene/scene.hpp"

namespace cagetol::idle {

using Reason = Idle<Scene>;
extern const Reason kStatic, kNoGrowth, kNoBalance, kRigid, kDry, kOutsideUnused, kCatalogue,
    kNoLipsAtRest, kNoEndOil, kPlaneFlanges, kHertzFlanges, kRingModuliUnused, kRollerModuliUnused,
    kCagePoissonUnused, kCageModulusUnused, kWidthUnused, kRingDensityUnused, kCageDensityUnused,
    kCageTemperatureUnused, kOilTemperatureUnused, kTemperatureFound, kRingMaterialUnused,
    kRollerMaterialUnused, kCageMaterialUnused, kShaftLoose, kHousingLoose, kShaftMaterialUnused,
    kHousingMaterialUnused, kShaftDensityUnused, kHousingDensityUnused, kNoRingTurns, kColdInlet,
    kNoRamp, kNoDirection, kNoRadialLoad, kNoDuty, kOverTime, kNoWhirl, kNoTurningLoad, kNoOrder;

}  // namespace cagetol::idle
