#include "src/reading/scene_conditions.hpp"

#include <cmath>

#include "src/operation/operating_clearance.hpp"
#include "src/scene/materials.hpp"
#include "src/scene/whirl_window.hpp"

namespace cagetol::idle {
namespace {

bool given(double value) {
  return !std::isnan(value);
}

bool hertz(const ContactParameters& contact) {
  return contact.law == ForceLaw::hertz;
}

/// Whether a ring's flanges meet spherical-ended rollers.
bool meets_spheres(const Scene& s, bool inner) {
  const FlangeSides sides = inner ? s.bearing.inner_flanges : s.bearing.outer_flanges;
  return sides != FlangeSides::none && sphere_flange_angle(s, inner) > 0;
}

bool bars_use_moduli(const Scene& s) {
  return !is_quasi_static(s) &&
         (hertz(s.contact.bar) || (is_lubricated(s) && s.lubrication.pocket_film));
}

/// Every run in time tells the pressure of its races.
bool races_use_moduli(const Scene& s) {
  return !is_quasi_static(s) || hertz(s.contact.race) || is_lubricated(s);
}

bool has_line_races(const Scene& s) {
  return hertz(s.contact.race) && s.contact.race_approach == RaceApproach::line;
}

bool all_given(const Scene& s, const MaterialChoice& material) {
  return given(material.young) && given(material.poisson) && given(material.density) &&
         (given(material.expansion) || !s.temperature.growth);
}

bool inner_fit_presses(const Scene& s) {
  return operating_clearance(s).inner_fit.pressure > 0;
}
bool outer_fit_presses(const Scene& s) {
  return operating_clearance(s).outer_fit.pressure > 0;
}

bool outer_grows_by_rotation(const Scene& s) {
  return grows_by_rotation(s) && largest_outer_speed(s.operation) != 0;
}

bool strengths_given(const CageGeometry& cage) {
  return given(cage.yield_stress) && given(cage.tensile_strength) && given(cage.fatigue_strength);
}

/// Whether a modulus or a strength that is in use depends on the cage's temperature.
bool cage_softens(const Scene& s) {
  const bool strengths = is_flexible(s) && !strengths_given(s.cage) &&
                         !material_named(s.cage.material.name).softer.empty();
  return strengths || (softens(s.cage.material) && (is_flexible(s) || bars_use_moduli(s)));
}

/// Where the rings, or the cage, have the oil's temperature and something depends on it.
bool oil_warms_rings(const Scene& s) {
  return s.temperature.growth &&
         !(given(s.temperature.inner_ring) && given(s.temperature.outer_ring));
}
bool oil_warms_cage(const Scene& s) {
  return !given(s.cage.temperature) &&
         (cage_softens(s) || (s.temperature.growth && !is_quasi_static(s)));
}

}  // namespace

// clang-format off
constinit const Reason kStatic{"model.motion = \"quasi-static\""};
constinit const Reason kNoGrowth{"temperature.growth = false"};
constinit const Reason kNoBalance{"temperature.balance = false"};
constinit const Reason kRigid{"cage.model = \"rigid\""};
constinit const Reason kDry{"lubrication.model = \"none\""};

constinit const Reason kOutsideUnused{"no result depends on it but by contact.race.approach = \"line\", a fit or the rotation of the outer ring",
    [](const Scene& s) { return !has_line_races(s) && !outer_fit_presses(s) && !outer_grows_by_rotation(s); }};
constinit const Reason kCatalogue{"rating life and warnings alone depend on it, no simulated result", [](const Scene&) { return true; }};
constinit const Reason kNoLipsAtRest{"model.motion = \"quasi-static\"",
    [](const Scene& s) { return is_quasi_static(s) && !given(s.cage.retention_inner[0]) && !given(s.cage.retention_outer[0]); }};
constinit const Reason kNoEndOil{"no oil at roller ends (lubrication.model, lubrication.end_film)", [](const Scene& s) { return !has_end_film(s); }};
constinit const Reason kPlaneFlanges{"plane flanges (bearing.outer_flange_angle_deg, bearing.inner_flange_angle_deg)",
    [](const Scene& s) { return !meets_spheres(s, true) && !meets_spheres(s, false); }};
constinit const Reason kHertzFlanges{"spherical roller ends deflect by Hertz (roller.end_radius_mm)",
    [](const Scene& s) { return (s.bearing.outer_flanges == FlangeSides::none || meets_spheres(s, false)) && (s.bearing.inner_flanges == FlangeSides::none || meets_spheres(s, true)); }};
constinit const Reason kRingModuliUnused{"model.motion = \"quasi-static\" and contact.race.force_law = \"impact\"",
    [](const Scene& s) { return !races_use_moduli(s) && !inner_fit_presses(s) && !outer_fit_presses(s) && !grows_by_rotation(s); }};
constinit const Reason kRollerModuliUnused{"model.motion = \"quasi-static\" and contact.race.force_law = \"impact\"",
    [](const Scene& s) { return !races_use_moduli(s) && !grows_by_rotation(s); }};
constinit const Reason kCagePoissonUnused{"cage.model = \"rigid\" and contact.bar.force_law = \"impact\"",
    [](const Scene& s) { return !is_flexible(s) && !bars_use_moduli(s); }};
constinit const Reason kCageModulusUnused{"cage.model = \"rigid\" and contact.bar.force_law = \"impact\"",
    [](const Scene& s) { return !is_flexible(s) && !bars_use_moduli(s) && !grows_by_rotation(s); }};
constinit const Reason kWidthUnused{"bearing.inner_ring_mass_kg is given",
    [](const Scene& s) { return given(s.bearing.inner_ring_mass) && !has_free_ring_tilt(s); }};
constinit const Reason kRingDensityUnused{"bearing.inner_ring_mass_kg is given",
    [](const Scene& s) { return given(s.bearing.inner_ring_mass) && !has_free_ring_tilt(s) && !grows_by_rotation(s); }};
constinit const Reason kCageDensityUnused{"the cage's mass and inertias are given",
    [](const Scene& s) { return !is_flexible(s) && given(s.cage.mass) && given(s.cage.polar_inertia) && given(s.cage.transverse_inertia); }};
constinit const Reason kCageTemperatureUnused{"no modulus, strength or dimension of the cage depends on it",
    [](const Scene& s) { return !cage_softens(s) && !s.temperature.growth; }};
constinit const Reason kOilTemperatureUnused{"lubrication.model = \"none\"",
    [](const Scene& s) { return !is_lubricated(s) && !oil_warms_rings(s) && !oil_warms_cage(s); }};
constinit const Reason kTemperatureFound{"temperature.balance = true finds it", [](const Scene& s) { return s.temperature.balance && !is_quasi_static(s); }};
constinit const Reason kRingMaterialUnused{"all properties of the rings' material are given",
    [](const Scene& s) { return all_given(s, s.bearing.ring_material); }};
constinit const Reason kRollerMaterialUnused{"all properties of the rollers' material are given",
    [](const Scene& s) { return all_given(s, s.roller.material); }};
constinit const Reason kCageMaterialUnused{"all properties of the cage's material are given",
    [](const Scene& s) { return all_given(s, s.cage.material) && (!is_flexible(s) || (given(s.cage.mode_damping) && strengths_given(s.cage))); }};
constinit const Reason kShaftLoose{"no pressure between inner ring and shaft", [](const Scene& s) { return !inner_fit_presses(s); }};
constinit const Reason kHousingLoose{"no pressure between outer ring and housing", [](const Scene& s) { return !outer_fit_presses(s); }};
constinit const Reason kShaftMaterialUnused{"no pressure between inner ring and shaft, or all properties given",
    [](const Scene& s) { return all_given(s, s.fit.shaft_material) || (!inner_fit_presses(s) && !(s.temperature.growth && given(s.fit.inner_interference))); }};
constinit const Reason kHousingMaterialUnused{"no pressure between outer ring and housing, or all properties given",
    [](const Scene& s) { return all_given(s, s.fit.housing_material) || (!outer_fit_presses(s) && !(s.temperature.growth && given(s.fit.outer_interference))); }};
constinit const Reason kShaftDensityUnused{"no centrifugal growth of the shaft",
    [](const Scene& s) { return !grows_by_rotation(s) || largest_inner_speed(s.operation) == 0; }};
constinit const Reason kHousingDensityUnused{"no centrifugal growth of the housing",
    [](const Scene& s) { return !outer_fit_presses(s) || !outer_grows_by_rotation(s) || !given(s.fit.housing_diameter); }};
constinit const Reason kNoRingTurns{"no ring turns",
    [](const Scene& s) { return largest_inner_speed(s.operation) == 0 && largest_outer_speed(s.operation) == 0; }};
constinit const Reason kColdInlet{"the inlet is not heated (lubrication.rolling_resistance, lubrication.inlet_heating)",
    [](const Scene& s) { return !s.lubrication.rolling_resistance || !s.lubrication.inlet_heating; }};
constinit const Reason kNoRamp{"no speed to ramp from is given (speed.ramp_from_rpm, speed.outer_ramp_from_rpm)",
    [](const Scene& s) { return !given(s.operation.speed_ramp_from) && !given(s.operation.outer_ramp_from); }};
constinit const Reason kNoDirection{"load.radial_N = 0",
    [](const Scene& s) { return largest_radial_load(s.operation) == 0 && s.operation.table.direction.empty(); }};
constinit const Reason kNoRadialLoad{"no radial load", [](const Scene& s) { return largest_radial_load(s.operation) == 0; }};
constinit const Reason kNoDuty{"no duty to repeat", [](const Scene& s) { return s.operation.table.empty(); }};
constinit const Reason kOverTime{"a duty over time has its window in seconds or from its phases",
    [](const Scene& s) { return changes_over_time(s.operation); }};
constinit const Reason kNoWhirl{"the window is too short to tell whirl (20 revolutions, 40 under a load that turns)",
    [](const Scene& s) { return !is_whirl_window(s); }};
constinit const Reason kNoTurningLoad{"no load turns (load.rotating_N, load.unbalance_g_mm)",
    [](const Scene& s) { return !load_turns(s); }};
constinit const Reason kNoOrder{"only cvode-bdf has an order to choose", [](const Scene& s) { return s.integration.method != IntegrationMethod::cvode_bdf; }};
// clang-format on

}  // namespace cagetol::idle
