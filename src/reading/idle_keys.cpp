// Above 400 lines: one table, which says of every key where it does nothing.
#include "src/reading/idle_keys.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/operation/operating_clearance.hpp"
#include "src/reading/scene_keys.hpp"
#include "src/scene/materials.hpp"

namespace cagetol {
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
  return !is_quasi_static(s) || hertz(s.contact.race) || is_lubricated(s) ||
         s.film.model != FilmModel::none;
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

/// Catalogue values have a use outside the run: they are named only where they vary.
constexpr std::string_view kCatalogue =
    "rating life and warnings alone depend on it, no simulated result";

/// One reason for which the keys that begin so do nothing.
struct Rule {
  std::vector<std::string_view> keys;  ///< names, or beginnings of names that end with "*"
  bool (*idle)(const Scene&);
  std::string_view why;
};

/// One table, hence one file: of two rules that hold the first gives the reason.
const std::vector<Rule>& rules() {
  static const std::vector<Rule> all = {
      {{"bearing.outside_diameter_mm"},
       [](const Scene& s) {
         return !has_line_races(s) && !outer_fit_presses(s) && !outer_grows_by_rotation(s);
       },
       "no result depends on it but by contact.race.approach = \"line\", a fit or the rotation of "
       "the "
       "outer ring"},
      {{"bearing.dynamic_rating_kN", "bearing.static_rating_kN", "bearing.reference_speed_rpm",
        "bearing.limiting_speed_rpm", "bearing.minimum_load_factor"},
       [](const Scene&) { return true; },
       kCatalogue},
      // What equilibria leave out.
      {{"cage.unbalance*",
        "cage.mass_kg",
        "cage.polar_inertia_kg_mm2",
        "cage.transverse_inertia_kg_mm2",
        "cage.young_GPa",
        "cage.poisson",
        "cage.density_kg_m3",
        "cage.expansion_um_m_K",
        "cage.material",
        "cage.temperature_C",
        "cage.guidance",
        "cage.guide_clearance_mm",
        "cage.land_offset_mm",
        "cage.land_width_mm",
        "cage.face_radius_mm",
        "cage.retention_width_inner_mm",
        "cage.retention_width_outer_mm",
        "cage.edge_radius_mm",
        "bearing.inner_land_diameter_mm",
        "cage.model",
        "cage.modes",
        "cage.bar_modes",
        "cage.mode_damping",
        "cage.mesh_density",
        "cage.corner_radius_mm",
        "cage.yield_stress_MPa",
        "cage.tensile_strength_MPa",
        "cage.fatigue_strength_MPa",
        "cage.centrifugal",
        "cage.coriolis",
        "cage.inner_diameter_mm",
        "cage.outer_diameter_mm",
        "cage.width_mm",
        "cage.pocket_squareness_mrad",
        "contact.bar.*",
        "contact.end.*",
        "contact.flange.*",
        "contact.land.*",
        "friction.*",
        "film.*",
        "start.state",
        "lubrication.race_roughness_um",
        "lubrication.pocket_*",
        "lubrication.rolling_resistance",
        "lubrication.inlet_heating",
        "lubrication.conductivity_W_m_K",
        "lubrication.film_traction",
        "lubrication.eyring_stress_MPa",
        "lubrication.limiting_shear_ratio",
        "lubrication.end_film",
        "lubrication.churning",
        "lubrication.oil_share",
        "lubrication.roller_drag",
        "lubrication.carried_along",
        "lubrication.land_film*",
        "start.cage_offset_*",
        "window.*",
        "integration.*",
        "discretisation.bar_stations",
        "load.ramp_ms",
        "speed.ramp*",
        "speed.outer_ramp_from_rpm",
        "contact.race.static*",
        "contact.race.dynamic*",
        "contact.race.roughness_um",
        "bearing.flange_clearance_mm",
        "roller.corner_radius_mm",
        "roller.end_radius_mm",
        "bearing.shoulder_diameter_mm",
        "bearing.outer_flanges",
        "bearing.outer_flange_angle_deg",
        "bearing.inner_flange*",
        "bearing.outer_land_diameter_mm",
        "load.axial_N"},
       is_quasi_static,
       "model.motion = \"quasi-static\""},
      {{"bearing.tilt_stiffness_N_m_rad", "bearing.inner_ring_polar_inertia_kg_mm2",
        "bearing.inner_ring_transverse_inertia_kg_mm2", "load.tilting_moment_*"},
       [](const Scene& s) { return !has_free_ring_tilt(s); },
       "model.ring_tilt = \"prescribed\""},
      {{"roller.corner_radius_mm"},
       [](const Scene& s) { return !has_end_film(s); },
       "no oil at roller ends (lubrication.model, lubrication.end_film)"},
      {{"bearing.inner_flange_diameter_mm", "bearing.inner_flange_clearance_mm",
        "bearing.inner_flange_angle_deg"},
       [](const Scene& s) { return s.bearing.inner_flanges == FlangeSides::none; },
       "bearing.inner_flanges = \"none\""},
      {{"bearing.outer_flange_angle_deg"},
       [](const Scene& s) { return s.bearing.outer_flanges == FlangeSides::none; },
       "bearing.outer_flanges = \"none\""},
      {{"bearing.outer_flange_angle_deg", "bearing.inner_flange_angle_deg"},
       [](const Scene& s) { return s.roller.end_radius == 0; },
       "roller.end_radius_mm = 0"},
      {{"roller.end_radius_mm"},
       [](const Scene& s) { return !meets_spheres(s, true) && !meets_spheres(s, false); },
       "plane flanges (bearing.outer_flange_angle_deg, bearing.inner_flange_angle_deg)"},
      {{"contact.flange.stiffness*", "contact.flange.exponent"},
       [](const Scene& s) {
         const bool outer = s.bearing.outer_flanges == FlangeSides::none || meets_spheres(s, false);
         const bool inner = s.bearing.inner_flanges == FlangeSides::none || meets_spheres(s, true);
         return outer && inner;
       },
       "spherical roller ends deflect by Hertz (roller.end_radius_mm)"},
      {{"waviness.inner_1_count", "waviness.inner_1_phase_deg"},
       [](const Scene& s) { return s.bearing.inner_waviness[0].amplitude == 0; },
       "waviness.inner_1_um = 0"},
      {{"waviness.inner_2_count", "waviness.inner_2_phase_deg"},
       [](const Scene& s) { return s.bearing.inner_waviness[1].amplitude == 0; },
       "waviness.inner_2_um = 0"},
      {{"waviness.outer_1_count", "waviness.outer_1_phase_deg"},
       [](const Scene& s) { return s.bearing.outer_waviness[0].amplitude == 0; },
       "waviness.outer_1_um = 0"},
      {{"waviness.outer_2_count", "waviness.outer_2_phase_deg"},
       [](const Scene& s) { return s.bearing.outer_waviness[1].amplitude == 0; },
       "waviness.outer_2_um = 0"},
      // Materials.
      {{"bearing.ring_young_GPa", "bearing.ring_poisson"},
       [](const Scene& s) {
         return !races_use_moduli(s) && !inner_fit_presses(s) && !outer_fit_presses(s) &&
                !grows_by_rotation(s);
       },
       "model.motion = \"quasi-static\" and contact.race.force_law = \"impact\""},
      {{"roller.young_GPa", "roller.poisson"},
       [](const Scene& s) { return !races_use_moduli(s) && !grows_by_rotation(s); },
       "model.motion = \"quasi-static\" and contact.race.force_law = \"impact\""},
      {{"cage.poisson"},
       [](const Scene& s) { return !is_flexible(s) && !bars_use_moduli(s); },
       "cage.model = \"rigid\" and contact.bar.force_law = \"impact\""},
      {{"cage.young_GPa"},
       [](const Scene& s) {
         return !is_flexible(s) && !bars_use_moduli(s) && !grows_by_rotation(s);
       },
       "cage.model = \"rigid\" and contact.bar.force_law = \"impact\""},
      {{"bearing.width_mm"},
       [](const Scene& s) { return given(s.bearing.inner_ring_mass) && !has_free_ring_tilt(s); },
       "bearing.inner_ring_mass_kg is given"},
      {{"bearing.ring_density_kg_m3"},
       [](const Scene& s) {
         return given(s.bearing.inner_ring_mass) && !has_free_ring_tilt(s) && !grows_by_rotation(s);
       },
       "bearing.inner_ring_mass_kg is given"},
      {{"cage.density_kg_m3"},
       [](const Scene& s) {
         return !is_flexible(s) && given(s.cage.mass) && given(s.cage.polar_inertia) &&
                given(s.cage.transverse_inertia);
       },
       "the cage's mass and inertias are given"},
      {{"cage.temperature_C"},
       [](const Scene& s) { return !cage_softens(s) && !s.temperature.growth; },
       "no modulus, strength or dimension of the cage depends on it"},
      {{"lubrication.temperature_C"},
       [](const Scene& s) {
         const bool rings = s.temperature.growth &&
                            !(given(s.temperature.inner_ring) && given(s.temperature.outer_ring));
         const bool cage = s.temperature.growth && !is_quasi_static(s);
         return !is_lubricated(s) && !rings &&
                (given(s.cage.temperature) || !(cage_softens(s) || cage));
       },
       "lubrication.model = \"none\""},
      {{"bearing.ring_material"},
       [](const Scene& s) { return all_given(s, s.bearing.ring_material); },
       "all properties of the rings' material are given"},
      {{"roller.material"},
       [](const Scene& s) { return all_given(s, s.roller.material); },
       "all properties of the rollers' material are given"},
      {{"cage.material"},
       [](const Scene& s) {
         return all_given(s, s.cage.material) &&
                (!is_flexible(s) || (given(s.cage.mode_damping) && strengths_given(s.cage)));
       },
       "all properties of the cage's material are given"},
      // Operating clearance.
      {{"temperature.reference_C", "temperature.inner_ring_C", "temperature.outer_ring_C",
        "temperature.rollers_C", "temperature.shaft_C", "temperature.housing_C",
        "bearing.ring_expansion_um_m_K", "roller.expansion_um_m_K", "cage.expansion_um_m_K",
        "fit.shaft_expansion_um_m_K", "fit.housing_expansion_um_m_K"},
       [](const Scene& s) { return !s.temperature.growth; },
       "temperature.growth = false"},
      {{"temperature.shaft_C", "fit.shaft_bore_mm", "fit.shaft_young_GPa", "fit.shaft_poisson",
        "fit.shaft_density_kg_m3", "fit.shaft_expansion_um_m_K"},
       [](const Scene& s) { return !inner_fit_presses(s); },
       "no pressure between inner ring and shaft"},
      {{"temperature.housing_C", "fit.housing_diameter_mm", "fit.housing_young_GPa",
        "fit.housing_poisson", "fit.housing_expansion_um_m_K"},
       [](const Scene& s) { return !outer_fit_presses(s); },
       "no pressure between outer ring and housing"},
      {{"fit.shaft_material"},
       [](const Scene& s) {
         return all_given(s, s.fit.shaft_material) ||
                (!inner_fit_presses(s) &&
                 !(s.temperature.growth && given(s.fit.inner_interference)));
       },
       "no pressure between inner ring and shaft, or all properties given"},
      {{"fit.housing_material"},
       [](const Scene& s) {
         return all_given(s, s.fit.housing_material) ||
                (!outer_fit_presses(s) &&
                 !(s.temperature.growth && given(s.fit.outer_interference)));
       },
       "no pressure between outer ring and housing, or all properties given"},
      {{"fit.shaft_density_kg_m3"},
       [](const Scene& s) {
         return !grows_by_rotation(s) || largest_inner_speed(s.operation) == 0;
       },
       "no centrifugal growth of the shaft"},
      {{"fit.housing_density_kg_m3"},
       [](const Scene& s) {
         return !outer_fit_presses(s) || !outer_grows_by_rotation(s) ||
                !given(s.fit.housing_diameter);
       },
       "no centrifugal growth of the housing"},
      {{"speed.centrifugal_growth"},
       [](const Scene& s) {
         return largest_inner_speed(s.operation) == 0 && largest_outer_speed(s.operation) == 0;
       },
       "no ring turns"},
      // The cage.
      {{"cage.modes", "cage.bar_modes", "cage.mode_damping", "cage.mesh_density",
        "cage.corner_radius_mm", "cage.centrifugal", "cage.coriolis", "cage.yield_stress_MPa",
        "cage.tensile_strength_MPa", "cage.fatigue_strength_MPa"},
       [](const Scene& s) { return !is_flexible(s); },
       "cage.model = \"rigid\""},
      {{"cage.unbalance_phase_deg"},
       [](const Scene& s) { return s.cage.unbalance == 0; },
       "cage.unbalance_g_mm = 0"},
      {{"cage.guide_clearance_mm", "lubrication.land_film*"},
       [](const Scene& s) { return s.cage.guidance == Guidance::roller; },
       "cage.guidance = \"roller\""},
      {{"lubrication.land_film_*"},
       [](const Scene& s) { return !s.lubrication.land_film; },
       "lubrication.land_film = false"},
      // Contact laws.
      {{"contact.race.restitution*", "contact.race.approach"},
       [](const Scene& s) { return !hertz(s.contact.race); },
       "contact.race.force_law = \"impact\""},
      {{"contact.bar.restitution*"},
       [](const Scene& s) { return !hertz(s.contact.bar); },
       "contact.bar.force_law = \"impact\""},
      {{"contact.race.stiffness*", "contact.race.exponent", "contact.race.damping*"},
       [](const Scene& s) { return hertz(s.contact.race); },
       "contact.race.force_law = \"hertz\""},
      {{"contact.bar.stiffness*", "contact.bar.exponent", "contact.bar.damping*"},
       [](const Scene& s) { return hertz(s.contact.bar); },
       "contact.bar.force_law = \"hertz\""},
      // Oil.
      {{"film.*"}, is_lubricated, "lubrication.model = \"film\" brings films of its own"},
      {{"film.viscosity_Pa_s", "film.pressure_viscosity_1_GPa", "film.minimum_force_N"},
       [](const Scene& s) { return s.film.model == FilmModel::none; },
       "film.model = \"none\""},
      {{"lubrication.lubricant",
        "lubrication.viscosity_*",
        "lubrication.density_kg_m3",
        "lubrication.pressure_viscosity_1_GPa",
        "lubrication.conductivity_W_m_K",
        "lubrication.eyring_stress_MPa",
        "lubrication.limiting_shear_ratio",
        "lubrication.race_*",
        "lubrication.pocket_*",
        "lubrication.squeeze",
        "lubrication.rolling_resistance",
        "lubrication.inlet_heating",
        "lubrication.film_traction",
        "lubrication.end_film",
        "lubrication.churning",
        "lubrication.oil_share",
        "lubrication.roller_drag",
        "lubrication.carried_along",
        "lubrication.land_film*",
        "contact.race.roughness_um",
        "contact.bar.roughness_um",
        "contact.end.roughness_um",
        "contact.flange.roughness_um",
        "window.longest_settle_revolutions"},
       [](const Scene& s) { return !is_lubricated(s); },
       "lubrication.model = \"none\""},
      {{"lubrication.conductivity_W_m_K"},
       [](const Scene& s) {
         return !s.lubrication.rolling_resistance || !s.lubrication.inlet_heating;
       },
       "the inlet is not heated (lubrication.rolling_resistance, lubrication.inlet_heating)"},
      {{"lubrication.inlet_heating"},
       [](const Scene& s) { return !s.lubrication.rolling_resistance; },
       "lubrication.rolling_resistance = false"},
      {{"lubrication.eyring_stress_MPa", "lubrication.limiting_shear_ratio"},
       [](const Scene& s) { return !s.lubrication.film_traction; },
       "lubrication.film_traction = false"},
      {{"lubrication.oil_share", "lubrication.roller_drag", "lubrication.carried_along"},
       [](const Scene& s) { return !s.lubrication.churning; },
       "lubrication.churning = false"},
      // Window and method.
      {{"window.settle_revolutions"},
       [](const Scene& s) { return given(s.window.settle_time); },
       "window.settle_time_s is given"},
      {{"window.measure_revolutions"},
       [](const Scene& s) { return given(s.window.measure_time); },
       "window.measure_time_s is given"},
      {{"speed.ramp_ms"},
       [](const Scene& s) {
         return !given(s.operation.speed_ramp_from) && !given(s.operation.outer_ramp_from);
       },
       "no speed to ramp from is given (speed.ramp_from_rpm, speed.outer_ramp_from_rpm)"},
      {{"load.direction_deg"},
       [](const Scene& s) {
         return largest_radial_load(s.operation) == 0 && s.operation.table.direction.empty();
       },
       "load.radial_N = 0"},
      {{"duty.direction_deg"},
       [](const Scene& s) { return largest_radial_load(s.operation) == 0; },
       "no radial load"},
      {{"load.radial_N"},
       [](const Scene& s) { return !s.operation.table.radial_load.empty(); },
       "duty.radial_N is given"},
      {{"load.direction_deg"},
       [](const Scene& s) { return !s.operation.table.direction.empty(); },
       "duty.direction_deg is given"},
      {{"load.axial_N"},
       [](const Scene& s) { return !s.operation.table.axial_load.empty(); },
       "duty.axial_N is given"},
      {{"load.tilting_moment_y_N_m"},
       [](const Scene& s) { return !s.operation.table.moment_y.empty(); },
       "duty.moment_y_N_m is given"},
      {{"load.tilting_moment_z_N_m"},
       [](const Scene& s) { return !s.operation.table.moment_z.empty(); },
       "duty.moment_z_N_m is given"},
      {{"speed.inner_rpm"},
       [](const Scene& s) { return !s.operation.table.inner_speed.empty(); },
       "duty.inner_rpm is given"},
      {{"speed.outer_rpm"},
       [](const Scene& s) { return !s.operation.table.outer_speed.empty(); },
       "duty.outer_rpm is given"},
      {{"duty.repeat_s"},
       [](const Scene& s) { return s.operation.table.empty(); },
       "no duty to repeat"},
      {{"speed.oscillation_Hz"},
       [](const Scene& s) { return s.operation.swing_amplitude == 0; },
       "speed.oscillation_amplitude_deg = 0"},
      {{"window.settle_revolutions", "window.measure_revolutions", "window.peak_revolutions",
        "window.extrapolate_revolutions", "window.longest_settle_revolutions",
        "watch.cage_drift_max", "watch.power_surplus_max"},
       [](const Scene& s) { return changes_over_time(s.operation); },
       "a duty over time has its window in seconds or from its phases"},
      {{"load.rotating_rpm"},
       [](const Scene& s) { return s.operation.rotating_load == 0; },
       "load.rotating_N = 0"},
      {{"load.rotating_phase_deg"},
       [](const Scene& s) { return s.operation.rotating_load == 0 && s.operation.unbalance == 0; },
       "no load turns (load.rotating_N, load.unbalance_g_mm)"},
      {{"environment.shaft_inclination_deg"},
       [](const Scene& s) { return s.operation.gravity == 0; },
       "environment.gravity_m_s2 = 0"},
      {{"speed.ramp_from_rpm", "speed.outer_ramp_from_rpm"},
       [](const Scene& s) { return s.operation.speed_ramp == 0; },
       "speed.ramp_ms = 0"},
      {{"integration.max_order"},
       [](const Scene& s) { return s.integration.method != IntegrationMethod::cvode_bdf; },
       "only cvode-bdf has an order to choose"},
  };
  return all;
}

bool names(std::string_view pattern, std::string_view key) {
  return pattern.ends_with('*') ? key.starts_with(pattern.substr(0, pattern.size() - 1))
                                : key == pattern;
}

}  // namespace

std::string why_idle(const Scene& scene, std::string_view key) {
  for (const Rule& rule : rules())
    for (const std::string_view pattern : rule.keys)
      if (names(pattern, key) && rule.idle(scene)) return std::string(rule.why);
  return "";
}

std::vector<std::string> idle_notes(const Scene& scene,
                                    const std::function<bool(const std::string& key)>& varies) {
  static const Scene plain;
  std::vector<std::pair<std::string, std::string>> keys_by_reason;
  for (const auto& key : scene_keys()) {
    const std::string why = why_idle(scene, key.name);
    if (why.empty()) continue;
    const bool told =
        why != kCatalogue && !key.range.required && key_text(key, scene) != key_text(key, plain);
    if (!told && !(varies && varies(key.name))) continue;
    const auto known = std::find_if(keys_by_reason.begin(), keys_by_reason.end(),
                                    [&](const auto& entry) { return entry.first == why; });
    if (known == keys_by_reason.end())
      keys_by_reason.emplace_back(why, key.name);
    else
      known->second += ", " + key.name;
  }
  std::vector<std::string> notes;
  for (const auto& [why, keys] : keys_by_reason)
    notes.push_back("without effect (" + why + "): " + keys);
  return notes;
}

}  // namespace cagetol
