// Why a key of a scene does nothing where the value of one other key does not tell (Idle): named
// here, listed in the rows of scene_keys.cpp. The first of a row that holds is the reason told.
#pragma once

#include <cmath>

#include "src/input/key_table.hpp"
#include "src/operation/operating_clearance.hpp"
#include "src/scene/materials.hpp"

namespace cagetol::idle {

inline bool given(double value) {
  return !std::isnan(value);
}

inline bool hertz(const ContactParameters& contact) {
  return contact.law == ForceLaw::hertz;
}

/// Whether a ring's flanges meet spherical-ended rollers.
inline bool meets_spheres(const Scene& s, bool inner) {
  const FlangeSides sides = inner ? s.bearing.inner_flanges : s.bearing.outer_flanges;
  return sides != FlangeSides::none && sphere_flange_angle(s, inner) > 0;
}

inline bool bars_use_moduli(const Scene& s) {
  return !is_quasi_static(s) &&
         (hertz(s.contact.bar) || (is_lubricated(s) && s.lubrication.pocket_film));
}

/// Every run in time tells the pressure of its races.
inline bool races_use_moduli(const Scene& s) {
  return !is_quasi_static(s) || hertz(s.contact.race) || is_lubricated(s) ||
         s.film.model != FilmModel::none;
}

inline bool has_line_races(const Scene& s) {
  return hertz(s.contact.race) && s.contact.race_approach == RaceApproach::line;
}

inline bool all_given(const Scene& s, const MaterialChoice& material) {
  return given(material.young) && given(material.poisson) && given(material.density) &&
         (given(material.expansion) || !s.temperature.growth);
}

inline bool inner_fit_presses(const Scene& s) {
  return operating_clearance(s).inner_fit.pressure > 0;
}
inline bool outer_fit_presses(const Scene& s) {
  return operating_clearance(s).outer_fit.pressure > 0;
}

inline bool outer_grows_by_rotation(const Scene& s) {
  return grows_by_rotation(s) && largest_outer_speed(s.operation) != 0;
}

inline bool strengths_given(const CageGeometry& cage) {
  return given(cage.yield_stress) && given(cage.tensile_strength) && given(cage.fatigue_strength);
}

/// Whether a modulus or a strength that is in use depends on the cage's temperature.
inline bool cage_softens(const Scene& s) {
  const bool strengths = is_flexible(s) && !strengths_given(s.cage) &&
                         !material_named(s.cage.material.name).softer.empty();
  return strengths || (softens(s.cage.material) && (is_flexible(s) || bars_use_moduli(s)));
}

/// Where the rings, or the cage, have the oil's temperature and something depends on it.
inline bool oil_warms_rings(const Scene& s) {
  return s.temperature.growth &&
         !(given(s.temperature.inner_ring) && given(s.temperature.outer_ring));
}
inline bool oil_warms_cage(const Scene& s) {
  return !given(s.cage.temperature) &&
         (cage_softens(s) || (s.temperature.growth && !is_quasi_static(s)));
}

// clang-format off
using Reason = Idle<Scene>;

constexpr Reason kStatic{"model.motion = \"quasi-static\""};
constexpr Reason kNoGrowth{"temperature.growth = false"};
constexpr Reason kRigid{"cage.model = \"rigid\""};
constexpr Reason kDry{"lubrication.model = \"none\""};

constexpr Reason kOutsideUnused{"no result depends on it but by contact.race.approach = \"line\", a fit or the rotation of the outer ring",
    [](const Scene& s) { return !has_line_races(s) && !outer_fit_presses(s) && !outer_grows_by_rotation(s); }};
constexpr Reason kCatalogue{"rating life and warnings alone depend on it, no simulated result", [](const Scene&) { return true; }};
constexpr Reason kNoLipsAtRest{"model.motion = \"quasi-static\"",
    [](const Scene& s) { return is_quasi_static(s) && !given(s.cage.retention_inner) && !given(s.cage.retention_outer); }};
constexpr Reason kNoEndOil{"no oil at roller ends (lubrication.model, lubrication.end_film)", [](const Scene& s) { return !has_end_film(s); }};
constexpr Reason kPlaneFlanges{"plane flanges (bearing.outer_flange_angle_deg, bearing.inner_flange_angle_deg)",
    [](const Scene& s) { return !meets_spheres(s, true) && !meets_spheres(s, false); }};
constexpr Reason kHertzFlanges{"spherical roller ends deflect by Hertz (roller.end_radius_mm)",
    [](const Scene& s) { return (s.bearing.outer_flanges == FlangeSides::none || meets_spheres(s, false)) && (s.bearing.inner_flanges == FlangeSides::none || meets_spheres(s, true)); }};
constexpr Reason kRingModuliUnused{"model.motion = \"quasi-static\" and contact.race.force_law = \"impact\"",
    [](const Scene& s) { return !races_use_moduli(s) && !inner_fit_presses(s) && !outer_fit_presses(s) && !grows_by_rotation(s); }};
constexpr Reason kRollerModuliUnused{"model.motion = \"quasi-static\" and contact.race.force_law = \"impact\"",
    [](const Scene& s) { return !races_use_moduli(s) && !grows_by_rotation(s); }};
constexpr Reason kCagePoissonUnused{"cage.model = \"rigid\" and contact.bar.force_law = \"impact\"",
    [](const Scene& s) { return !is_flexible(s) && !bars_use_moduli(s); }};
constexpr Reason kCageModulusUnused{"cage.model = \"rigid\" and contact.bar.force_law = \"impact\"",
    [](const Scene& s) { return !is_flexible(s) && !bars_use_moduli(s) && !grows_by_rotation(s); }};
constexpr Reason kWidthUnused{"bearing.inner_ring_mass_kg is given",
    [](const Scene& s) { return given(s.bearing.inner_ring_mass) && !has_free_ring_tilt(s); }};
constexpr Reason kRingDensityUnused{"bearing.inner_ring_mass_kg is given",
    [](const Scene& s) { return given(s.bearing.inner_ring_mass) && !has_free_ring_tilt(s) && !grows_by_rotation(s); }};
constexpr Reason kCageDensityUnused{"the cage's mass and inertias are given",
    [](const Scene& s) { return !is_flexible(s) && given(s.cage.mass) && given(s.cage.polar_inertia) && given(s.cage.transverse_inertia); }};
constexpr Reason kCageTemperatureUnused{"no modulus, strength or dimension of the cage depends on it",
    [](const Scene& s) { return !cage_softens(s) && !s.temperature.growth; }};
constexpr Reason kOilTemperatureUnused{"lubrication.model = \"none\"",
    [](const Scene& s) { return !is_lubricated(s) && !oil_warms_rings(s) && !oil_warms_cage(s); }};
constexpr Reason kRingMaterialUnused{"all properties of the rings' material are given",
    [](const Scene& s) { return all_given(s, s.bearing.ring_material); }};
constexpr Reason kRollerMaterialUnused{"all properties of the rollers' material are given",
    [](const Scene& s) { return all_given(s, s.roller.material); }};
constexpr Reason kCageMaterialUnused{"all properties of the cage's material are given",
    [](const Scene& s) { return all_given(s, s.cage.material) && (!is_flexible(s) || (given(s.cage.mode_damping) && strengths_given(s.cage))); }};
constexpr Reason kShaftLoose{"no pressure between inner ring and shaft", [](const Scene& s) { return !inner_fit_presses(s); }};
constexpr Reason kHousingLoose{"no pressure between outer ring and housing", [](const Scene& s) { return !outer_fit_presses(s); }};
constexpr Reason kShaftMaterialUnused{"no pressure between inner ring and shaft, or all properties given",
    [](const Scene& s) { return all_given(s, s.fit.shaft_material) || (!inner_fit_presses(s) && !(s.temperature.growth && given(s.fit.inner_interference))); }};
constexpr Reason kHousingMaterialUnused{"no pressure between outer ring and housing, or all properties given",
    [](const Scene& s) { return all_given(s, s.fit.housing_material) || (!outer_fit_presses(s) && !(s.temperature.growth && given(s.fit.outer_interference))); }};
constexpr Reason kShaftDensityUnused{"no centrifugal growth of the shaft",
    [](const Scene& s) { return !grows_by_rotation(s) || largest_inner_speed(s.operation) == 0; }};
constexpr Reason kHousingDensityUnused{"no centrifugal growth of the housing",
    [](const Scene& s) { return !outer_fit_presses(s) || !outer_grows_by_rotation(s) || !given(s.fit.housing_diameter); }};
constexpr Reason kNoRingTurns{"no ring turns",
    [](const Scene& s) { return largest_inner_speed(s.operation) == 0 && largest_outer_speed(s.operation) == 0; }};
constexpr Reason kLubricated{"lubrication.model = \"film\" brings films of its own", is_lubricated};
constexpr Reason kColdInlet{"the inlet is not heated (lubrication.rolling_resistance, lubrication.inlet_heating)",
    [](const Scene& s) { return !s.lubrication.rolling_resistance || !s.lubrication.inlet_heating; }};
constexpr Reason kNoRamp{"no speed to ramp from is given (speed.ramp_from_rpm, speed.outer_ramp_from_rpm)",
    [](const Scene& s) { return !given(s.operation.speed_ramp_from) && !given(s.operation.outer_ramp_from); }};
constexpr Reason kNoDirection{"load.radial_N = 0",
    [](const Scene& s) { return largest_radial_load(s.operation) == 0 && s.operation.table.direction.empty(); }};
constexpr Reason kNoRadialLoad{"no radial load", [](const Scene& s) { return largest_radial_load(s.operation) == 0; }};
constexpr Reason kNoDuty{"no duty to repeat", [](const Scene& s) { return s.operation.table.empty(); }};
constexpr Reason kOverTime{"a duty over time has its window in seconds or from its phases",
    [](const Scene& s) { return changes_over_time(s.operation); }};
constexpr Reason kNoTurningLoad{"no load turns (load.rotating_N, load.unbalance_g_mm)",
    [](const Scene& s) { return s.operation.rotating_load == 0 && s.operation.unbalance == 0; }};
constexpr Reason kNoOrder{"only cvode-bdf has an order to choose", [](const Scene& s) { return s.integration.method != IntegrationMethod::cvode_bdf; }};
// clang-format on

}  // namespace cagetol::idle
