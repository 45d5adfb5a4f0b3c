// Above 400 lines: one table, a key a row.
#include "src/reading/scene_keys.hpp"

#include <algorithm>
#include <set>

#include "src/lubrication/lubricant.hpp"
#include "src/reading/assumptions.hpp"
#include "src/reading/duty_file.hpp"
#include "src/reading/oil_keys.hpp"
#include "src/reading/scene_conditions.hpp"
#include "src/reading/unmodelled_keys.hpp"
#include "src/scene/materials.hpp"

namespace cagetol {
namespace {

using namespace idle;

std::vector<std::string> lubricant_names() {
  std::vector<std::string> names;
  for (const LubricantPreset& preset : lubricant_presets()) names.push_back(preset.name);
  return names;
}

std::vector<std::string> material_names() {
  std::vector<std::string> names;
  for (const MaterialPreset& preset : material_presets()) names.push_back(preset.name);
  return names;
}

// clang-format off
#define AT(member) [](Scene& s) -> auto& { return s.member; }

void add_ring_and_roller_keys(KeyTable<Scene>& keys) {
  const KeyTable<Scene> table = {
      {"name", any_value(), AT(name), "name of the scene, for titles"},
      {"model.motion", any_value(), AT(model.motion), "dynamic: equations of motion; quasi-static: equilibria of ring and rollers over one turn of the cage at full load and kinematic speed; no cage forces, no slip, of oil only the films of the races"},
      {"model.ring_tilt", any_value(), AT(model.ring_tilt), "tilt of the inner ring; prescribed: the misalignment, whatever moment it takes; free: two degrees of freedom, held by the rollers, the shaft (bearing.tilt_stiffness_N_m_rad) and the ring's inertia"},
      {"bearing.roller_count", required(within(3, 64)), AT(bearing.roller_count), "number of rollers and pockets Z"},
      {"bearing.bore_diameter_mm", required(above(0)), AT(bearing.bore_diameter), "bore d"},
      {"bearing.outside_diameter_mm", required(above(0)), AT(bearing.outside_diameter), "outside diameter D", {kOutsideUnused}},
      {"bearing.width_mm", required(above(0)), AT(bearing.width), "width B of the rings", {kWidthUnused}},
      {"bearing.inner_raceway_diameter_mm", required(above(0)), AT(bearing.inner_raceway_diameter), "inner raceway F, catalogue value"},
      {"bearing.outer_raceway_diameter_mm", required(above(0)), AT(bearing.outer_raceway_diameter), "outer raceway E, catalogue value"},
      {"bearing.shoulder_diameter_mm", required(or_auto(above(0))), AT(bearing.shoulder_diameter), "rim of the outer ring's flanges (shoulders); auto: it has none", {kStatic}},
      {"bearing.outer_flanges", any_value(), AT(bearing.outer_flanges), "sides of the outer ring with a flange; left: at -x", {kStatic}},
      {"bearing.inner_flanges", any_value(), AT(bearing.inner_flanges), "likewise of the inner ring; N: none outside, both inside; NJ: both and one; NUP: both and both", {kStatic}},
      {"bearing.inner_flange_diameter_mm", or_auto(above(0)), AT(bearing.inner_flange_diameter), "rim of the inner ring's flanges; auto: it has none", {kStatic, R"(bearing.inner_flanges = "none")"}},
      {"bearing.inner_flange_clearance_mm", or_auto(at_least(0)), AT(bearing.inner_flange_clearance), "axial clearance of a roller between both flanges of the inner ring, half of it at a single one; auto: flange_clearance_mm", {kStatic, R"(bearing.inner_flanges = "none")"}},
      {"bearing.outer_flange_angle_deg", within(0, 10), AT(bearing.outer_flange_angle), "angle of the outer ring's flanges to the radial plane, open towards their rim, which spherical-ended rollers (roller.end_radius_mm) meet at one point; 0: plane, for flat ends", {kStatic, R"(bearing.outer_flanges = "none")", "roller.end_radius_mm = 0"}},
      {"bearing.inner_flange_angle_deg", within(0, 10), AT(bearing.inner_flange_angle), "likewise of the inner ring's flanges", {kStatic, R"(bearing.inner_flanges = "none")", "roller.end_radius_mm = 0"}},
      {"bearing.outer_land_diameter_mm", or_auto(above(0)), AT(bearing.outer_land_diameter), "diameter of the surface on the outer ring that meets the cage's outside; auto: flanges on both sides, or else the raceway", {kStatic}},
      {"bearing.inner_land_diameter_mm", or_auto(above(0)), AT(bearing.inner_land_diameter), "diameter of the surface on the inner ring that meets the cage's bore; auto: flanges on both sides, or else the raceway", {kStatic}},
      {"bearing.internal_clearance_um", required(within(-200, 2000)), AT(bearing.internal_clearance), "diametral internal clearance added to what the raceways and rollers leave, half on each raceway"},
      {"bearing.flange_clearance_mm", required(at_least(0)), AT(bearing.flange_clearance), "axial clearance of a roller between both flanges of the outer ring, total; half of it at a single one", {kStatic}},
      {"bearing.ring_material", one_of(material_names()), AT(bearing.ring_material.name), "named material of the rings, for its keys that are left to auto", {kRingMaterialUnused}},
      {"bearing.ring_young_GPa", or_auto(above(0)), AT(bearing.ring_material.young), "Young's modulus of the rings; auto: of the named material", {kRingModuliUnused}},
      {"bearing.ring_poisson", or_auto(within(0, 0.49)), AT(bearing.ring_material.poisson), "Poisson's ratio of the rings; auto: likewise", {kRingModuliUnused}},
      {"bearing.ring_density_kg_m3", or_auto(above(0)), AT(bearing.ring_material.density), "density of the rings; auto: likewise", {kRingDensityUnused}},
      {"bearing.ring_expansion_um_m_K", or_auto(within(0, 300)), AT(bearing.ring_material.expansion), "linear thermal expansion of the rings, in 1e-6/K; auto: likewise", {kNoGrowth}},
      {"bearing.inner_ring_mass_kg", or_auto(above(0)), AT(bearing.inner_ring_mass), "moving mass of the inner ring; auto: from its geometry"},
      {"bearing.inner_ring_polar_inertia_kg_mm2", or_auto(above(0)), AT(bearing.inner_ring_polar_inertia), "of a ring whose tilt is free: moment of inertia about its centre line, for the gyroscopic moment; auto: hollow cylinder of its mass", {R"(model.ring_tilt = "prescribed")"}},
      {"bearing.inner_ring_transverse_inertia_kg_mm2", or_auto(above(0)), AT(bearing.inner_ring_transverse_inertia), "of a ring whose tilt is free: moment of inertia about a diameter; auto: hollow cylinder of its mass", {R"(model.ring_tilt = "prescribed")"}},
      {"bearing.misalignment_y_mrad", within(-50, 50), AT(bearing.misalignment_y), "slope of the inner ring's centre line in y, fixed in space; of a ring whose tilt is free: the slope at which its shaft is at rest"},
      {"bearing.misalignment_z_mrad", within(-50, 50), AT(bearing.misalignment_z), "likewise the slope in z"},
      {"bearing.tilt_stiffness_N_m_rad", at_least(0), AT(bearing.tilt_stiffness), "stiffness with which the shaft holds a ring whose tilt is free; 0: only the rollers hold it", {R"(model.ring_tilt = "prescribed")"}},
      {"bearing.dynamic_rating_kN", or_auto(above(0)), AT(bearing.dynamic_rating), "basic dynamic load rating C, for rating life and warnings, no simulated result; auto: by ISO 281 from rollers and raceways", {kCatalogue}},
      {"bearing.static_rating_kN", or_auto(above(0)), AT(bearing.static_rating), "basic static load rating C0, likewise; auto: by ISO 76", {kCatalogue}},
      {"bearing.reference_speed_rpm", or_auto(above(0)), AT(bearing.reference_speed), "thermal reference speed, for the minimum load by SKF's rule; auto: not known", {kCatalogue}},
      {"bearing.limiting_speed_rpm", or_auto(above(0)), AT(bearing.limiting_speed), "limiting speed, above which `cagetol check` warns; auto: not known", {kCatalogue}},
      {"bearing.minimum_load_factor", or_auto(above(0)), AT(bearing.minimum_load_factor), "factor k_r of the minimum load by SKF's rule (0.1 in series 10, 0.15 in series 2, 3 and 4, 0.2 in series 22, 0.25 in series 23); auto: not known", {kCatalogue}},
      {"roller.diameter_mm", required(above(0)), AT(roller.diameter), "roller diameter D_we"},
      {"roller.length_mm", required(above(0)), AT(roller.length), "roller length L_we"},
      {"roller.corner_radius_mm", or_auto(at_least(0)), AT(roller.corner_radius), "radius between a roller's end and its cylinder: beyond it oil holds the flat end off a flange; auto: 0.06 D_we, an assumption", {kStatic, kNoEndOil}},
      {"roller.end_radius_mm", at_least(0), AT(roller.end_radius), "radius R_e of the rollers' ends, spheres centred on the axis: they meet inclined flanges R_e sin(angle) from the roller's axis; 0: flat ends", {kStatic, kPlaneFlanges}},
      {"roller.taper_um", within(-500, 500), AT(roller.taper), "diameter at the +x end minus diameter at the -x end"},
      {"roller.profile", any_value(), AT(roller.profile), "axial profile; logarithmic: ISO/TS 16281"},
      {"roller.material", one_of(material_names()), AT(roller.material.name), "named material of the rollers, for its keys that are left to auto", {kRollerMaterialUnused}},
      {"roller.young_GPa", or_auto(above(0)), AT(roller.material.young), "Young's modulus of the rollers; auto: of the named material", {kRollerModuliUnused}},
      {"roller.poisson", or_auto(within(0, 0.49)), AT(roller.material.poisson), "Poisson's ratio of the rollers; auto: likewise", {kRollerModuliUnused}},
      {"roller.density_kg_m3", or_auto(above(0)), AT(roller.material.density), "density of the rollers; auto: likewise"},
      {"roller.expansion_um_m_K", or_auto(within(0, 300)), AT(roller.material.expansion), "linear thermal expansion of the rollers; auto: likewise", {kNoGrowth}},
  };
  keys.insert(keys.end(), table.begin(), table.end());
}

void add_waviness_keys(KeyTable<Scene>& keys) {
  const auto add = [&](const std::string& ring, std::array<Waviness, kHarmonics> BearingGeometry::*form, const std::array<Reason, kHarmonics>& round) {
    for (std::size_t n = 0; n < kHarmonics; ++n) {
      const auto at = [form, n](auto Waviness::*member) {
        return [form, n, member](Scene& s) -> auto& { return (s.bearing.*form)[n].*member; };
      };
      const std::string name = "waviness." + ring + "_" + std::to_string(n + 1);
      const KeyTable<Scene> table = {
          {name + "_um", within(-500, 500), at(&Waviness::amplitude), "amplitude of the " + std::string(n == 0 ? "first" : "second") + " harmonic of the " + ring + " raceway's radial form, outwards: a cos(k theta - phase), theta as the angle of rollers, from +y towards +z, in the ring, which turns; half the waviness of one harmonic; fits, heat and rotation do not change it"},
          {name + "_count", within(1, 200), at(&Waviness::count), "its number of waves k around the raceway", {round[n]}},
          {name + "_phase_deg", within(-360, 360), at(&Waviness::phase), "its phase; the first crest stands at phase over k from +y at the start of the run", {round[n]}},
      };
      keys.insert(keys.end(), table.begin(), table.end());
    }
  };
  add("inner", &BearingGeometry::inner_waviness, {"waviness.inner_1_um = 0", "waviness.inner_2_um = 0"});
  add("outer", &BearingGeometry::outer_waviness, {"waviness.outer_1_um = 0", "waviness.outer_2_um = 0"});
}

void add_cage_keys(KeyTable<Scene>& keys) {
  const KeyTable<Scene> table = {
      {"cage.model", any_value(), AT(cage.model), "cage model; rigid: six degrees of freedom; flexible: elastic modes and stress too", {kStatic}},
      {"cage.inner_diameter_mm", required(above(0)), AT(cage.inner_diameter), "inner diameter of the cage", {kNoLipsAtRest}},
      {"cage.outer_diameter_mm", required(above(0)), AT(cage.outer_diameter), "outer diameter of the cage", {kNoLipsAtRest}},
      {"cage.width_mm", required(above(0)), AT(cage.width), "axial width of the cage", {kStatic}},
      {"cage.pocket_width_mm", required(above(0)), AT(cage.pocket_width), "circumferential opening S of a pocket"},
      {"cage.pocket_length_mm", required(above(0)), AT(cage.pocket_length), "axial opening L of a pocket"},
      {"cage.pocket_pitch_mrad", within(-100, 100), AT(cage.pocket_pitch), "angular deviation of a pocket's centre"},
      {"cage.pocket_squareness_mrad", within(-100, 100), AT(cage.pocket_squareness), "angle of a pocket's bar faces to the bearing axis", {kStatic}},
      {"cage.material", one_of(material_names()), AT(cage.material.name), "named material of the cage, for its keys that are left to auto", {kStatic, kCageMaterialUnused}},
      {"cage.temperature_C", or_auto(within(-60, 250)), AT(cage.temperature), "temperature of the cage, for the modulus of the named material and, with temperature.growth, its dimensions; auto: lubrication.temperature_C", {kStatic, kCageTemperatureUnused}},
      {"cage.young_GPa", or_auto(above(0)), AT(cage.material.young), "Young's modulus of the cage; auto: of the named material at its temperature", {kStatic, kCageModulusUnused}},
      {"cage.poisson", or_auto(within(0, 0.49)), AT(cage.material.poisson), "Poisson's ratio of the cage; auto: of the named material", {kStatic, kCagePoissonUnused}},
      {"cage.density_kg_m3", or_auto(above(0)), AT(cage.material.density), "density of the cage; auto: likewise", {kStatic, kCageDensityUnused}},
      {"cage.expansion_um_m_K", or_auto(within(0, 300)), AT(cage.material.expansion), "linear thermal expansion of the cage, of fibre-filled polymers along the flow; auto: likewise", {kStatic, kNoGrowth}},
      {"cage.swelling_percent", within(-1, 3), AT(cage.swelling), "growth of every length of a polymer cage by moisture, between the state that the scene's dimensions are of and that in which it runs; about 0.2 for pa66-gf25 from dry as moulded to humid air (50 %), negative where a cage of conditioned dimensions dries out", {kStatic}},
      {"cage.yield_stress_MPa", or_auto(above(0)), AT(cage.yield_stress), "yield stress of the cage, for cage_strength_utilisation; auto: of the named material at its temperature", {kStatic, kRigid}},
      {"cage.tensile_strength_MPa", or_auto(above(0)), AT(cage.tensile_strength), "tensile strength of the cage, for cage_fatigue_utilisation; auto: likewise", {kStatic, kRigid}},
      {"cage.fatigue_strength_MPa", or_auto(above(0)), AT(cage.fatigue_strength), "fully reversed fatigue strength of the cage (amplitude), for the same; auto: likewise", {kStatic, kRigid}},
      {"cage.mass_kg", or_auto(above(0)), AT(cage.mass), "mass of the cage; auto: from geometry and density", {kStatic}},
      {"cage.polar_inertia_kg_mm2", or_auto(above(0)), AT(cage.polar_inertia), "moment of inertia about the bearing axis; auto: from geometry and density", {kStatic}},
      {"cage.transverse_inertia_kg_mm2", or_auto(above(0)), AT(cage.transverse_inertia), "moment of inertia about a diameter; auto: from geometry and density", {kStatic}},
      {"cage.unbalance_g_mm", at_least(0), AT(cage.unbalance), "unbalance of the cage, mass times eccentricity of its mass centre, beside that of deviating pockets", {kStatic}},
      {"cage.unbalance_phase_deg", within(-360, 360), AT(cage.unbalance_phase), "its direction, from the middle of pocket 0, positive turned about +x", {kStatic, "cage.unbalance_g_mm = 0"}},
      {"cage.guidance", any_value(), AT(cage.guidance), "what guides the cage: outer-ring shoulders or inner ring; rollers hold no cage by flat pocket faces, and are refused unless model.motion = \"quasi-static\"", {kStatic}},
      {"cage.guide_clearance_mm", or_auto(above(0)), AT(cage.guide_clearance), "radial guide clearance; auto: from the diameters", {kStatic, R"(cage.guidance = "roller")"}},
      {"cage.land_offset_mm", or_auto(above(0)), AT(cage.land_offset), "guide lands at x = +- this; auto: middle of the side rings", {kStatic}},
      {"cage.land_width_mm", or_auto(at_least(0)), AT(cage.land_width), "axial width of a land, at whose two edges it touches, at the lower one where it is tilted; 0: at its middle; auto: that of the cage's side rings, 0 where races and bars follow the impact law, which lumps a contact at a point", {kStatic}},
      {"cage.face_radius_mm", or_auto(above(0)), AT(cage.face_radius), "radius of the bars' hollow faces in the radial plane, about the rollers' pitch circle; auto: flat faces", {kStatic}},
      {"cage.retention_width_inner_mm", or_auto(above(0)), AT(cage.retention_inner), "opening of a pocket between lips at the cage's bore; auto: no lips there"},
      {"cage.retention_width_outer_mm", or_auto(above(0)), AT(cage.retention_outer), "likewise at the cage's outside"},
      {"cage.edge_radius_mm", above(0), AT(cage.edge_radius), "rounding of the bars' edges and of lips, on which rollers ride that stand beside the faces", {kNoLipsAtRest}},
      {"cage.modes", within(0, kMostElasticModes), AT(cage.modes), "elastic modes of a flexible cage, lowest first", {kStatic, kRigid}},
      {"cage.bar_modes", any_value(), AT(cage.bar_modes), "with them a static mode of every bar: how it deflects under rollers beyond what the elastic modes carry", {kStatic, kRigid}},
      {"cage.mode_damping", or_auto(within(0, 1)), AT(cage.mode_damping), "damping ratio of the elastic modes; auto: half the loss factor of the named material", {kStatic, kRigid}},
      {"cage.mesh_density", within(1, 12), AT(cage.mesh_density), "finite elements through the thickness of a flexible cage", {kStatic, kRigid}},
      {"cage.corner_radius_mm", at_least(0), AT(cage.corner_radius), "radius of a flexible cage's pocket corners, which its stiffness and its stress there have; the default is an assumption; 0: sharp, whose stress belongs to the mesh and is for comparisons at one cage.mesh_density only", {kStatic, kRigid}},
      {"cage.centrifugal", any_value(), AT(cage.centrifugal), "centrifugal loading of the elastic modes", {kStatic, kRigid}},
      {"cage.coriolis", any_value(), AT(cage.coriolis), "Coriolis coupling of the elastic modes", {kStatic, kRigid}},
      {"cage.allow_interference", any_value(), AT(allow_interference), "simulate the elastic pinch of a roller larger than its pocket instead of reporting the jam"},
  };
  keys.insert(keys.end(), table.begin(), table.end());
}

void add_clearance_keys(KeyTable<Scene>& keys) {
  const KeyTable<Scene> table = {
      {"fit.inner_interference_um", or_auto(within(-2000, 2000)), AT(fit.inner_interference), "interference of the inner ring on its shaft, of diameters, cold and before mounting, smoothing of the surfaces deducted; below 0: a clearance; auto: no seat, the ring is free to grow"},
      {"fit.shaft_bore_mm", at_least(0), AT(fit.shaft_bore), "bore of a hollow shaft; 0: solid", {kShaftLoose}},
      {"fit.shaft_material", one_of(material_names()), AT(fit.shaft_material.name), "named material of the shaft, for its keys that are left to auto", {kShaftMaterialUnused}},
      {"fit.shaft_young_GPa", or_auto(above(0)), AT(fit.shaft_material.young), "Young's modulus of the shaft; auto: of the named material", {kShaftLoose}},
      {"fit.shaft_poisson", or_auto(within(0, 0.49)), AT(fit.shaft_material.poisson), "Poisson's ratio of the shaft; auto: likewise", {kShaftLoose}},
      {"fit.shaft_density_kg_m3", or_auto(above(0)), AT(fit.shaft_material.density), "density of the shaft, for its centrifugal growth; auto: likewise", {kShaftLoose, kShaftDensityUnused}},
      {"fit.shaft_expansion_um_m_K", or_auto(within(0, 300)), AT(fit.shaft_material.expansion), "linear thermal expansion of the shaft; auto: likewise", {kNoGrowth, kShaftLoose}},
      {"fit.outer_interference_um", or_auto(within(-2000, 2000)), AT(fit.outer_interference), "interference of the outer ring in its housing, likewise"},
      {"fit.housing_diameter_mm", or_auto(above(0)), AT(fit.housing_diameter), "outside diameter of the housing; auto: much larger than the bearing", {kHousingLoose}},
      {"fit.housing_material", one_of(material_names()), AT(fit.housing_material.name), "named material of the housing, for its keys that are left to auto", {kHousingMaterialUnused}},
      {"fit.housing_young_GPa", or_auto(above(0)), AT(fit.housing_material.young), "Young's modulus of the housing; auto: of the named material", {kHousingLoose}},
      {"fit.housing_poisson", or_auto(within(0, 0.49)), AT(fit.housing_material.poisson), "Poisson's ratio of the housing; auto: likewise", {kHousingLoose}},
      {"fit.housing_density_kg_m3", or_auto(above(0)), AT(fit.housing_material.density), "density of a housing of given diameter, for its centrifugal growth with an outer ring that turns; auto: likewise", {kHousingDensityUnused}},
      {"fit.housing_expansion_um_m_K", or_auto(within(0, 300)), AT(fit.housing_material.expansion), "linear thermal expansion of the housing; auto: likewise", {kNoGrowth, kHousingLoose}},
      {"temperature.growth", any_value(), AT(temperature.growth), "rings, rollers, cage, shaft and housing grow by heat: the scene's dimensions and fits are those at temperature.reference_C; false: the dimensions are those in operation, the other keys of this section do nothing"},
      {"temperature.reference_C", within(-60, 250), AT(temperature.reference), "temperature at which dimensions and interferences are given", {kNoGrowth}},
      {"temperature.inner_ring_C", or_auto(within(-60, 250)), AT(temperature.inner_ring), "temperature of the inner ring; auto: lubrication.temperature_C (also of dry bearings)", {kNoGrowth, kTemperatureFound}},
      {"temperature.outer_ring_C", or_auto(within(-60, 250)), AT(temperature.outer_ring), "temperature of the outer ring; auto: likewise", {kNoGrowth, kTemperatureFound}},
      {"temperature.rollers_C", or_auto(within(-60, 250)), AT(temperature.rollers), "temperature of the rollers; auto: mean of both rings (the cage has cage.temperature_C)", {kNoGrowth}},
      {"temperature.shaft_C", or_auto(within(-60, 250)), AT(temperature.shaft), "temperature of the shaft; auto: that of the inner ring", {kNoGrowth, kShaftLoose}},
      {"temperature.housing_C", or_auto(within(-60, 250)), AT(temperature.housing), "temperature of the housing; auto: that of the outer ring", {kNoGrowth, kHousingLoose}},
      {"temperature.balance", any_value(), AT(temperature.balance), "the temperature of oil and outer ring is that at which the nominal bearing sheds what it loses (ISO 15312 and the oil that flows through), found by short runs before all others; false: temperatures are given", {kStatic}},
      {"temperature.ambient_C", within(-60, 250), AT(temperature.ambient), "temperature of what the bearing sheds its heat to", {kStatic, kNoBalance}},
      {"temperature.conductance_W_K", or_auto(above(0)), AT(temperature.conductance), "heat shed for each kelvin of the outer ring above ambient; auto: of ISO 15312, 0.016 W/mm2 over pi B (d + D) at 50 K", {kStatic, kNoBalance}},
      {"temperature.oil_flow_l_min", at_least(0), AT(temperature.oil_flow), "oil that flows through the bearing and takes heat along", {kStatic, kNoBalance}},
      {"temperature.oil_inlet_C", or_auto(within(-60, 250)), AT(temperature.oil_inlet), "temperature at which that oil comes; auto: temperature.ambient_C", {kStatic, kNoBalance, "temperature.oil_flow_l_min = 0"}},
      {"temperature.inner_above_K", within(-50, 100), AT(temperature.inner_above), "how much warmer than outer ring and oil the inner ring is", {kStatic, kNoBalance, kNoGrowth}},
      {"temperature.found_C", or_auto(within(-60, 250)), AT(temperature.found), "written by the program: the temperature found, of outer ring and oil", {kStatic, kNoBalance}},
      {"temperature.found_power_W", or_auto(any_value()), AT(temperature.found_power), "written by the program: the power that the nominal bearing loses there", {kStatic, kNoBalance}},
      {"temperature.found_slope_W_K", or_auto(any_value()), AT(temperature.found_slope), "written by the program: how much more it sheds than it loses a kelvin above", {kStatic, kNoBalance}},
  };
  keys.insert(keys.end(), table.begin(), table.end());
}

// One contact kind; AT cannot capture, so the member comes as a pointer.
void add_contact_keys(KeyTable<Scene>& keys, const std::string& kind, ContactParameters Contacts::*contact, const std::string& between, bool may_be_hertz) {
  const auto at = [contact](auto ContactParameters::*member) {
    return [contact, member](Scene& s) -> auto& { return s.contact.*contact.*member; };
  };
  const std::string name = "contact." + kind + ".";
  const auto laws = may_be_hertz ? any_value() : one_of({spelled(ForceLaw::impact)});
  const bool race = kind == "race";
  using Reasons = std::vector<Reason>;
  const Reasons moves{kStatic}, any = race ? Reasons{} : moves;
  Reasons damps = any, restores = any;
  if (may_be_hertz) damps.push_back(race ? R"(contact.race.force_law = "hertz")" : R"(contact.bar.force_law = "hertz")");
  if (may_be_hertz) restores.push_back(race ? R"(contact.race.force_law = "impact")" : R"(contact.bar.force_law = "impact")");
  Reasons stiff = damps;
  if (kind == "flange") stiff.push_back(kHertzFlanges);
  const KeyTable<Scene> table = {
      {name + "force_law", laws, at(&ContactParameters::law), "normal force law of " + between, any},
      {name + "stiffness_N_mm_e", above(0), at(&ContactParameters::stiffness), "impact: K, for a depth in mm", stiff},
      {name + "exponent", within(1, 3), at(&ContactParameters::exponent), "impact: e", stiff},
      {name + "damping_N_s_mm", at_least(0), at(&ContactParameters::damping), "impact: c_max", damps},
      {name + "damping_depth_mm", above(0), at(&ContactParameters::damping_depth), "impact: depth at which the damping is full", damps},
      {name + "static_coefficient", or_auto(within(0, 2)), at(&ContactParameters::friction_static), "mu_s of this contact; auto: friction.static_coefficient", moves},
      {name + "dynamic_coefficient", or_auto(within(0, 2)), at(&ContactParameters::friction_dynamic), "mu_d of this contact; auto: friction.dynamic_coefficient", moves},
      {name + "static_speed_m_s", or_auto(above(0)), at(&ContactParameters::static_speed), "v_s of this contact; auto: friction.static_speed_m_s", moves},
      {name + "dynamic_speed_m_s", or_auto(above(0)), at(&ContactParameters::dynamic_speed), "v_d of this contact; auto: friction.dynamic_speed_m_s", moves},
  };
  keys.insert(keys.end(), table.begin(), table.end());
  if (kind != "land")  // whose film ends at lubrication.land_film_minimum_um
    keys.push_back({name + "roughness_um", or_auto(above(0)), at(&ContactParameters::roughness), "composite rms roughness under an oil film; auto: lubrication.race_roughness_um, elsewhere lubrication.pocket_roughness_um", {kStatic, kDry}});
  if (!may_be_hertz) return;
  if (race)
    keys.push_back({name + "approach", any_value(), [](Scene& s) -> auto& { return s.contact.race_approach; }, "hertz: elastic approach of roller and race; palmgren: a bearing maker's formula, the same at both races; line: two-dimensional theory, which counts the rings' thickness; met by both races together at the load per length 5 F/(Z L) (NU 205: 23 % stiffer)", restores});
  const KeyTable<Scene> hertz = {
      {name + "restitution", above(0, 1), at(&ContactParameters::restitution), "hertz: coefficient of restitution at the reference speed (Hunt-Crossley damping)", restores},
      {name + "restitution_speed_m_s", above(0), at(&ContactParameters::restitution_speed), "hertz: reference speed of the restitution", restores},
  };
  keys.insert(keys.end(), hertz.begin(), hertz.end());
}

void add_operation_keys(KeyTable<Scene>& keys) {
  const KeyTable<Scene> table = {
      {"friction.static_coefficient", within(0, 2), AT(contact.friction_static), "mu_s, peak of the friction law", {kStatic}},
      {"friction.dynamic_coefficient", within(0, 2), AT(contact.friction_dynamic), "mu_d, friction of full sliding", {kStatic}},
      {"friction.static_speed_m_s", above(0), AT(contact.static_speed), "v_s, sliding speed at which friction peaks", {kStatic}},
      {"friction.dynamic_speed_m_s", above(0), AT(contact.dynamic_speed), "v_d, sliding speed from which friction is mu_d", {kStatic}},
      {"lubrication.model", required_where(R"(model.motion = "dynamic")", any_value()), AT(lubrication.model), "oil in the bearing; film: films, rolling resistance and traction at races and pockets, a film at guide lands (src/lubrication); none: dry, the other keys of this section do nothing"},
      {"lubrication.lubricant", one_of(lubricant_names()), AT(lubrication.lubricant), "named oil, for the keys of this section that are left to auto", {kDry}},
      {"lubrication.temperature_C", within(-60, 250), AT(lubrication.temperature), "temperature of the oil in the bearing", {kOilTemperatureUnused, kTemperatureFound}},
      {"lubrication.viscosity_40_mm2_s", or_auto(above(0)), AT(lubrication.viscosity_40), "kinematic viscosity at 40 degC; auto: of the named lubricant", {kDry}},
      {"lubrication.viscosity_100_mm2_s", or_auto(above(0)), AT(lubrication.viscosity_100), "kinematic viscosity at 100 degC; auto: of the named lubricant", {kDry}},
      {"lubrication.density_kg_m3", or_auto(above(0)), AT(lubrication.density), "density at 15 degC; auto: of the named lubricant", {kDry}},
      {"lubrication.viscosity_Pa_s", or_auto(above(0)), AT(lubrication.viscosity), "dynamic viscosity at the temperature of the oil; auto: from the kinematic viscosities", {kDry}},
      {"lubrication.pressure_viscosity_1_GPa", or_auto(above(0)), AT(lubrication.pressure_viscosity), "pressure-viscosity coefficient; auto: of the named lubricant", {kDry}},
      {"lubrication.conductivity_W_m_K", above(0), AT(lubrication.conductivity), "thermal conductivity of the oil", {kStatic, kDry, kColdInlet}},
      {"lubrication.eyring_stress_MPa", above(0), AT(lubrication.eyring_stress), "shear stress at which the oil ceases to be Newtonian", {kStatic, kDry, "lubrication.film_traction = false"}},
      {"lubrication.limiting_shear_ratio", or_auto(above(0)), AT(lubrication.limiting_shear), "largest shear stress of the oil over the mean contact pressure; auto: of the named lubricant", {kStatic, kDry, "lubrication.film_traction = false"}},
      {"lubrication.race_roughness_um", above(0), AT(lubrication.race_roughness), "composite rms roughness of roller and race", {kStatic, kDry}},
      {"lubrication.supply", any_value(), AT(lubrication.supply), "how oil comes to the bearing, for layers and oil share that are left to auto; auto: \"grease\" for lubricants called grease, else \"circulation\"", {kDry}},
      {"lubrication.race_layer_um", or_auto(or_flooded(above(0))), AT(lubrication.race_layer), "gap up to which oil fills the inlets of the inner race; auto: of the supply", {kDry}},
      {"lubrication.outer_layer_um", or_auto(or_flooded(above(0))), AT(lubrication.outer_layer), "gap up to which oil fills the inlets of the outer race; auto: of the supply", {kDry}},
      {"lubrication.land_layer_um", or_auto(or_flooded(above(0))), AT(lubrication.land_layer), "gap up to which oil fills that between guide lands and their ring; auto: of the supply", {kStatic, R"(cage.guidance = "roller")", "lubrication.land_film = false", kDry}},
      {"lubrication.pocket_roughness_um", above(0), AT(lubrication.pocket_roughness), "composite rms roughness of roller and pocket", {kStatic, kDry}},
      {"lubrication.pocket_layer_um", or_auto(above(0)), AT(lubrication.pocket_layer), "gap up to which oil fills that between roller and pocket, at bars and ends, and at flanges; auto: of the supply", {kStatic, kDry}},
      {"lubrication.squeeze", any_value(), AT(lubrication.squeeze), "films resist the approach of the surfaces", {kDry}},
      {"lubrication.rolling_resistance", any_value(), AT(lubrication.rolling_resistance), "hydrodynamic rolling resistance of the races", {kStatic, kDry}},
      {"lubrication.inlet_heating", any_value(), AT(lubrication.inlet_heating), "shear heating in the inlet lowers the rolling resistance", {kStatic, kDry, "lubrication.rolling_resistance = false"}},
      {"lubrication.film_traction", any_value(), AT(lubrication.film_traction), "the film shears in sliding contacts; off: they rub as without oil", {kStatic, kDry}},
      {"lubrication.pocket_film", any_value(), AT(lubrication.pocket_film), "oil between rollers and the bars of their pockets", {kStatic, kDry}},
      {"lubrication.end_film", any_value(), AT(lubrication.end_film), "oil between roller ends and pockets or flanges", {kStatic, kDry}},
      {"lubrication.churning", any_value(), AT(lubrication.churning), "drag of the oil and air in the free space on rollers and cage", {kStatic, kDry}},
      {"lubrication.oil_share", or_auto(within(0, 1)), AT(lubrication.oil_share), "share of the free space that is oil: some 0.02 under mist or jet, 0.1 to 0.3 in a bath; in the literature a constant to be calibrated; auto: of the supply", {kStatic, kDry, "lubrication.churning = false"}},
      {"lubrication.roller_drag", at_least(0), AT(lubrication.roller_drag), "drag coefficient of a roller across its axis", {kStatic, kDry, "lubrication.churning = false"}},
      {"lubrication.carried_along", within(0, 1), AT(lubrication.carried_along), "share of the cage's speed at which the oil and air turn", {kStatic, kDry, "lubrication.churning = false"}},
      {"lubrication.land_film", any_value(), AT(lubrication.land_film), "oil film between the lands of a guided cage and their ring (Ocvirk, half of it in suction left out)", {kStatic, R"(cage.guidance = "roller")", kDry}},
      {"lubrication.land_film_width_mm", or_auto(above(0)), AT(lubrication.land_film_width), "axial width of a land; auto: that of the cage's side rings", {kStatic, R"(cage.guidance = "roller")", "lubrication.land_film = false", kDry}},
      {"lubrication.land_film_minimum_um", above(0), AT(lubrication.land_film_minimum), "gap at which roughness ends that film and the lands touch", {kStatic, R"(cage.guidance = "roller")", "lubrication.land_film = false", kDry}},
      {"load.radial_N", required(at_least(0)), AT(operation.radial_load), "radial load on the inner ring", {"duty.radial_N is given"}},
      {"load.axial_N", any_value(), AT(operation.axial_load), "axial load on the inner ring, along +x: carried from a flange of the inner ring by the rollers' ends to one of the outer ring, while the inner ring moves axially; 0: it keeps its place", {kStatic, "duty.axial_N is given"}},
      {"load.direction_deg", within(-360, 360), AT(operation.load_direction), "direction of the radial load in the bearing's plane: 0 along -z, as gravity on a horizontal shaft; positive turned about +x, from y towards z, so that 90 is along +y", {kNoDirection, "duty.direction_deg is given"}},
      {"load.rotating_N", at_least(0), AT(operation.rotating_load), "further radial load on the inner ring whose direction turns"},
      {"load.rotating_rpm", or_auto(within(-1e6, 1e6)), AT(operation.rotating_speed), "speed at which the rotating load turns, about +x; auto: with the inner ring", {"load.rotating_N = 0"}},
      {"load.rotating_phase_deg", within(-360, 360), AT(operation.rotating_phase), "direction of rotating load and unbalance at the start of the run, as load.direction_deg", {kNoTurningLoad}},
      {"load.unbalance_g_mm", at_least(0), AT(operation.unbalance), "unbalance of what turns with the inner ring: loads it by unbalance times speed squared, turning with it"},
      {"load.tilting_moment_y_N_m", any_value(), AT(operation.tilting_moment_y), "moment on an inner ring whose tilt is free, towards +y: it raises the slope of the centre line in y (as a vector it points along +z)", {R"(model.ring_tilt = "prescribed")", "duty.moment_y_N_m is given"}},
      {"load.tilting_moment_z_N_m", any_value(), AT(operation.tilting_moment_z), "likewise the moment towards +z (a vector along -y)", {R"(model.ring_tilt = "prescribed")", "duty.moment_z_N_m is given"}},
      {"load.ramp_ms", at_least(0), AT(operation.load_ramp), "time over which load and moment rise smoothly from zero", {kStatic}},
      {"speed.inner_rpm", required(within(-1e6, 1e6)), AT(operation.inner_speed), "speed of the inner ring about +x", {"duty.inner_rpm is given"}},
      {"speed.outer_rpm", within(-1e6, 1e6), AT(operation.outer_speed), "speed of the outer ring about +x", {"duty.outer_rpm is given"}},
      {"speed.ramp_from_rpm", or_auto(within(-1e6, 1e6)), AT(operation.speed_ramp_from), "speed of the inner ring at the start of a smooth ramp; auto: no ramp", {kStatic, "speed.ramp_ms = 0"}},
      {"speed.outer_ramp_from_rpm", or_auto(within(-1e6, 1e6)), AT(operation.outer_ramp_from), "likewise of the outer ring", {kStatic, "speed.ramp_ms = 0"}},
      {"speed.ramp_ms", at_least(0), AT(operation.speed_ramp), "duration of the speed ramps", {kStatic, kNoRamp}},
      {"speed.centrifugal_growth", any_value(), AT(operation.centrifugal_growth), "rings with shaft and housing, rollers and cage grow by rotation; false: the dimensions are those at speed", {kNoRingTurns}},
      {"duty.file", any_value(), AT(operation.table.file), "CSV file of a duty over time, its path relative to this file: the header names columns as the keys below with their units (time_s, inner_rpm, radial_kN ...), one line for each instant; resolved scenes hold its values in these keys"},
      {"duty.time_s", at_least(0), AT(operation.table.time), "instants of a duty over time, increasing; values between them lie on straight lines, the first and the last one hold before and after"},
      {"duty.inner_rpm", within(-1e6, 1e6), AT(operation.table.inner_speed), "speed of the inner ring at these instants; left out: speed.inner_rpm"},
      {"duty.outer_rpm", within(-1e6, 1e6), AT(operation.table.outer_speed), "likewise of the outer ring; left out: speed.outer_rpm"},
      {"duty.radial_N", at_least(0), AT(operation.table.radial_load), "likewise the radial load; left out: load.radial_N"},
      {"duty.direction_deg", within(-36000, 36000), AT(operation.table.direction), "likewise its direction; left out: load.direction_deg", {kNoRadialLoad}},
      {"duty.axial_N", any_value(), AT(operation.table.axial_load), "likewise the axial load; left out: load.axial_N"},
      {"duty.moment_y_N_m", any_value(), AT(operation.table.moment_y), "likewise the moment towards +y; left out: load.tilting_moment_y_N_m"},
      {"duty.moment_z_N_m", any_value(), AT(operation.table.moment_z), "likewise the moment towards +z; left out: load.tilting_moment_z_N_m"},
      {"duty.repeat_s", or_auto(above(0)), AT(operation.table.repeat), "period after which the duty begins anew; a straight line leads from the last instant to the first one; auto: the last values hold", {kNoDuty}},
      {"phase.name", any_value(), AT(phase.name), "names of parts of a run under a duty over time, with quantities of their own (driving_slip_ratio@NAME); or as tables [[phase]] with name, from_s, to_s"},
      {"phase.from_s", at_least(0), AT(phase.from), "where each of them begins"},
      {"phase.to_s", above(0), AT(phase.to), "where each of them ends"},
      {"environment.gravity_m_s2", within(-1e4, 1e4), AT(operation.gravity), "gravity, along -z where the shaft is horizontal"},
      {"environment.shaft_inclination_deg", within(-90, 90), AT(operation.shaft_inclination), "angle of the bearing's axis (+x) above the horizontal; 90: a vertical shaft, gravity along -x", {"environment.gravity_m_s2 = 0"}},
      {"start.state", any_value(), AT(start.state), "steady: of a lubricated bearing, the speeds of cage and rollers and the sides of pockets at which the torques on the cage balance over a turn, where they do; equilibrium: loaded static equilibrium, rolling without slip; centred: ring and cage centred, rollers at mid-clearance; auto: steady where lubrication.model = \"film\", else equilibrium", {kStatic}},
      {"start.cage_offset_x_um", any_value(), AT(start.cage_offset_x), "axial offset of the cage at the start", {kStatic}},
      {"start.cage_offset_y_um", any_value(), AT(start.cage_offset_y), "offset of the cage in y at the start", {kStatic}},
      {"start.cage_offset_z_um", any_value(), AT(start.cage_offset_z), "offset of the cage in z at the start", {kStatic}},
      {"start.cage_phase_deg", any_value(), AT(start.cage_phase), "angle by which rollers and cage are turned together at the start"},
      {"window.settle_revolutions", at_least(0), AT(window.settle_revolutions), "cage revolutions before measuring", {kStatic, "window.settle_time_s is given", kOverTime}},
      {"window.measure_revolutions", at_least(1e-6), AT(window.measure_revolutions), "cage revolutions measured, as the cage makes them; a cage that skids ends its window after three times as many without slip (windows_cut)", {kStatic, "window.measure_time_s is given", kOverTime}},
      {"window.peak_revolutions", or_auto(above(0)), AT(window.peak_revolutions), "cage revolutions from the beginning of the window over which peaks, minima and quantiles are taken; auto: the whole window", {kStatic, kOverTime}},
      {"window.longest_settle_revolutions", at_least(0), AT(window.longest_settle_revolutions), "cage revolutions to which settling is extended, by the length of the window at a time, while a lubricated bearing drifts; one that still drifts then has failed", {kStatic, kDry, kOverTime}},
      {"window.whirl_clearance_um", or_auto(above(0)), AT(window.whirl_clearance), "clearance over which the cage's whirl is taken; auto: the least of guide clearance and half the pockets' clearance of this scene; a study writes that of its nominal bearing", {kStatic, kOverTime, kNoWhirl}},
      {"window.settle_time_s", or_auto(at_least(0)), AT(window.settle_time), "time before measuring; auto: settle_revolutions; under a duty over time, until its first phase begins, else for one period of one that repeats, else 0", {kStatic}},
      {"window.measure_time_s", or_auto(at_least(1e-9)), AT(window.measure_time), "time measured; auto: measure_revolutions; under a duty over time, until its last phase ends, else one period of one that repeats, else until its last instant", {kStatic}},
      {"window.history_interval_us", above(0), AT(history_interval), "interval of time histories, where they are asked for", {kStatic}},
      {"discretisation.race_slices", within(1, 100), AT(discretisation.race_slices), "slices of a roller-race contact along the roller"},
      {"discretisation.bar_stations", within(1, 100), AT(discretisation.bar_stations), "axial stations of a roller-bar contact", {kStatic}},
      {"integration.method", any_value(), AT(integration.method), "time integration method", {kStatic}},
      {"integration.tolerance", above(0, 10), AT(integration.tolerance), "error tolerance, multiple of the error scales: D_we/7500, 0.001 of the fastest raceway surface's speed but at least 1 cm/s, and these over lever arms (1 um and 1 cm/s for the NU 205)", {kStatic}},
      {"integration.max_step_us", or_auto(above(0)), AT(integration.max_step), "largest step; auto: 50 us, and at steady speeds a fortieth of the time between two rollers that pass, if that is more", {kStatic}},
      {"integration.max_order", within(1, 5), AT(integration.max_order), "highest order of cvode-bdf", {kStatic, kNoOrder}},
      {"integration.step_budget", or_auto(within(1, 1e12)), AT(integration.step_budget), "attempted steps after which a run is censored; auto: 100000, as many for each turn of the cage, and a million for each second, to the end of the window", {kStatic}},
      {"integration.wall_budget_s", at_least(0), AT(integration.wall_budget), "wall-clock limit of a run, which then counts as not run; 0: none", {kStatic}},
      {"watch.static_consistency_max", above(0), AT(watch.static_consistency_max), "largest static consistency error; a run that exceeds it by more than its window leaves open has failed"},
      {"watch.energy_residual_max", above(0), AT(watch.energy_residual_max), "largest relative energy residual; a run that exceeds it by more than its steps leave open has failed"},
      {"watch.cage_drift_max", above(0), AT(watch.cage_drift_max), "largest change of the cage's mean speed over the window, as a share of the kinematic speed; while a lubricated bearing exceeds it, by more than chance, it is not stationary", {kOverTime}},
      {"watch.power_surplus_max", above(0), AT(watch.power_surplus_max), "likewise the largest energy of motion stored or given back, as a share of the power dissipated", {kOverTime}},
  };
  keys.insert(keys.end(), table.begin(), table.end());
}
#undef AT
// clang-format on

KeyTable<Scene> make_scene_keys() {
  KeyTable<Scene> keys;
  add_ring_and_roller_keys(keys);
  add_waviness_keys(keys);
  add_cage_keys(keys);
  add_clearance_keys(keys);
  add_contact_keys(keys, "race", &Contacts::race, "roller against raceways", true);
  add_contact_keys(keys, "bar", &Contacts::bar, "roller against pocket bars", true);
  add_contact_keys(keys, "end", &Contacts::end, "roller end against pocket side ring face", false);
  add_contact_keys(keys, "flange", &Contacts::flange, "roller end against ring flange", false);
  add_contact_keys(keys, "land", &Contacts::land, "cage against its guiding land", false);
  add_operation_keys(keys);
  return keys;
}

// The nominal value of a distribution, or the node itself where it is a plain value; nullptr: keep
// the default.
const toml::node* nominal_node(const toml::node& node) {
  const auto* table = node.as_table();
  return table && is_distribution(*table) ? table->get("nominal") : &node;
}

}  // namespace

const KeyTable<Scene>& scene_keys() {
  static const KeyTable<Scene> keys = make_scene_keys();
  return keys;
}

Scene example_scene() {
  Scene scene;
  scene.name = "scene";
  return scene;
}

bool is_distribution(const toml::table& table) {
  for (const char* name : {"law", "lot", "pocket", "noise", "nominal"})
    if (table.contains(name)) return true;
  return false;
}

namespace {

/// Which keys a scene gives.
struct Given {
  std::set<std::string> keys;
  std::set<std::string> laws_alone;  ///< distributions without a nominal value
};

/// Whether the key must be given: always, or because of the value that another key has.
bool is_required(const Key<Scene>& key, const Scene& scene) {
  const std::string& condition = key.range.required_where;
  return condition.empty() ? key.range.required : condition_holds(scene_keys(), condition, scene);
}

void refuse_missing(const Given& given, const Scene& scene, const std::string& file) {
  std::string missing;
  int count = 0;
  bool oil_alone = true;
  for (const auto& key : scene_keys()) {
    if (!is_required(key, scene) || given.keys.contains(key.name)) continue;
    oil_alone = oil_alone && key.name == "lubrication.model";
    missing += "\n    " + key.name + (key.unit == "-" ? "" : " [" + key.unit + "]") + ": " +
               key.meaning +
               (given.laws_alone.contains(key.name) ? " - its distribution has no nominal" : "");
    ++count;
  }
  if (count == 0) return;
  if (oil_alone) throw no_word_of_oil("a dynamic scene must say", file);
  throw InputError({file, 0}, "", "",
                   "the scene leaves out " + std::to_string(count) +
                       (count == 1 ? " key that has" : " keys that have") +
                       " no default, because each bearing has its own:" + missing,
                   "give each a value (in a study below [scene], or in the scene file that its "
                   "scene.file names); `cagetol --dump-default scene` prints an example with every "
                   "key");
}

}  // namespace

Scene read_scene(const toml::table& root, const std::string& file) {
  Scene scene = example_scene();
  Given given;
  const auto& keys = scene_keys();
  const auto read = [&](const TomlLeaf& leaf) {
    if (leaf.name == "assumption") {
      scene.assumptions = read_assumptions(*leaf.node, file);
      return;
    }
    if (leaf.name == "phase" && leaf.node->is_array()) {
      read_phases(*leaf.node, file, scene.phase);
      return;
    }
    const auto* key = find_key(keys, leaf.name);
    if (!key) {
      const bool empty_section =
          leaf.node->is_table() && std::any_of(keys.begin(), keys.end(), [&](const auto& known) {
            return known.name.starts_with(leaf.name + ".");
          });
      if (empty_section && leaf.node->as_table()->empty()) return;
      refuse_unmodelled_key(leaf, file);
      throw unknown_key(leaf, file, key_infos(keys));
    }
    const auto* node = nominal_node(*leaf.node);
    const auto count = static_cast<std::size_t>(scene.bearing.roller_count);
    if (node) read_key(*key, *node, file, count, scene);
    (node ? given.keys : given.laws_alone).insert(key->name);
  };
  const auto leaves = toml_leaves(root, is_distribution);
  // The number of rollers first: it is the length of every per-pocket array.
  for (const auto& leaf : leaves)
    if (leaf.name == "bearing.roller_count") read(leaf);
  for (const auto& leaf : leaves) read(leaf);
  if (!scene.operation.table.file.empty())
    read_duty_file(*find_node(root, "duty.file"), file, scene.operation.table);
  refuse_missing(given, scene, file);
  refuse_given_temperatures(scene, root, file);
  check_scene(scene, file, &root);
  return scene;
}

}  // namespace cagetol
