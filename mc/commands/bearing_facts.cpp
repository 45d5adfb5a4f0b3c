#include "mc/commands/bearing_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mc/commands/cage_drawing.hpp"
#include "mc/commands/operating_text.hpp"
#include "mc/host/json_number.hpp"
#include "mc/run/clearance_chains.hpp"
#include "mc/study/operating_points.hpp"
#include "mc/study/study.hpp"
#include "mc/study/tolerance_filling.hpp"
#include "mc/sweep/stored_study.hpp"
#include "src/heat_balance.hpp"
#include "src/input/unit.hpp"
#include "src/lubrication/lubricant.hpp"
#include "src/operation/heat_shed.hpp"
#include "src/operation/operating_clearance.hpp"
#include "src/quantities/operating_point.hpp"
#include "src/quantities/quantity_labels.hpp"
#include "src/reading/scene_keys.hpp"
#include "src/scene/materials.hpp"
#include "src/scene/oil_supply.hpp"
#include "src/scene/pocket_clearances.hpp"

namespace cagetol {
namespace {

/// Rows of names and values; what is not known is left out.
class Entries {
 public:
  Entries& text(const std::string& name, const std::string& words) {
    list_.push_back({{"name", name}, {"text", words}});
    return *this;
  }
  Entries& value(const std::string& name, double number, const std::string& unit) {
    if (std::isfinite(number)) list_.push_back({{"name", name}, {"value", number}, {"unit", unit}});
    return *this;
  }
  Json titled(const std::string& title) const { return {{"title", title}, {"entries", list_}}; }

 private:
  Json list_ = Json::array();
};

/// NU, NJ, NUP, N, NF or the flanges in words.
std::string type_of(const BearingGeometry& bearing) {
  using enum FlangeSides;
  const auto one = [](FlangeSides sides) { return sides == left || sides == right; };
  const FlangeSides outer = bearing.outer_flanges, inner = bearing.inner_flanges;
  if (outer == both && inner == none) return "NU, flanges on the outer ring";
  if (outer == both && one(inner)) return "NJ, flanges on the outer and one on the inner ring";
  if (outer == both && inner == both) return "NUP, flanges on both rings";
  if (outer == none && inner == both) return "N, flanges on the inner ring";
  if (one(outer) && inner == both) return "NF, flanges on the inner and one on the outer ring";
  return fmt::format("flanges of the outer ring: {}, of the inner ring: {}", spelled(outer),
                     spelled(inner));
}

Json bearing_group(const Scene& scene, const OperatingPoint& at) {
  const BearingGeometry& b = scene.bearing;
  return Entries()
      .text("type", type_of(b))
      .text("bore × outside × width",
            fmt::format("{:.6g} × {:.6g} × {:.6g} mm", 1e3 * b.bore_diameter,
                        1e3 * b.outside_diameter, 1e3 * b.width))
      .text("rollers", fmt::format("{}, each {:.6g} × {:.6g} mm", b.roller_count,
                                   1e3 * scene.roller.diameter.front(), 1e3 * scene.roller.length))
      .value("dynamic load rating C", 1e-3 * at.dynamic_rating, "kN")
      .value("static load rating C0", 1e-3 * at.static_rating, "kN")
      .titled("Bearing");
}

Json load_group(const Scene& scene, const OperatingPoint& at) {
  const Operation& operation = scene.operation;
  Entries entries;
  entries.value("radial load", operation.radial_load, "N");
  if (operation.axial_load != 0) entries.value("axial load", operation.axial_load, "N");
  if (operation.rotating_load != 0) entries.value("rotating load", operation.rotating_load, "N");
  if (!operation.table.empty()) entries.text("duty", "load or speed change over time");
  entries.value("speed of the inner ring", operation.inner_speed / kRpm, "r/min");
  if (operation.outer_speed != 0)
    entries.value("speed of the outer ring", operation.outer_speed / kRpm, "r/min");
  return entries.value("speed factor n dm", 1e3 * at.pitch_diameter * at.speed / kRpm, "mm/min")
      .value("load ratio C/P", at.dynamic_rating / at.load, "-")
      .value("static safety C0/P0", at.static_rating / at.largest_load, "-")
      .value("rating life L10", at.life_time / 3600, "h")
      .value("minimum load, SKF's rule", at.minimum_load_skf, "N")
      .value("minimum load, C0/60", at.minimum_load_schaeffler, "N")
      .value("largest roller load", at.roller_load, "N")
      .value("largest pressure", 1e-6 * at.race_pressure, "MPa")
      .value("load zone", at.load_zone * 180 / std::numbers::pi, "deg")
      .titled("Load and speed");
}

/// Without slip, and with the mean slip of the runs where that is known.
Json order_group(const OperatingPoint& at, double slip) {
  Entries entries;
  for (const OperatingRow& row : operating_rows()) {
    if (!is_order(row) || !std::isfinite(row.value(at))) continue;
    std::string name = row.key, text = fmt::format("{:.5g}", row.value(at));
    std::ranges::replace(name, '_', ' ');
    if (std::isfinite(slip))
      text += fmt::format(", with slip {:.5g}", row.value(with_slip(at, slip)));
    entries.text(name, text);
  }
  return entries.titled("Multiples of the shaft's speed");
}

Json clearance_group(const Scene& scene, const OperatingPoint& at) {
  Entries entries;
  return entries.value("internal, diametral", 1e6 * at.clearance.internal, "µm")
      .value("total, roller to both bars", 1e6 * at.clearance.pocket_width, "µm")
      .value("roller to both pocket ends", 1e6 * at.clearance.pocket_length, "µm")
      .value("guide, radial", 1e6 * at.clearance.guide, "µm")
      .value("roller to flanges, axial", 1e6 * at.clearance.flange, "µm")
      .titled(changes_in_operation(scene) ? "Clearances in operation" : "Clearances");
}

std::string guided_by(Guidance guidance) {
  return guidance == Guidance::outer   ? "the outer ring"
         : guidance == Guidance::inner ? "the inner ring"
                                       : "the rollers";
}

Json cage_group(const Scene& scene, const OperatingPoint& at) {
  const Strength strength = cage_strength(scene);
  Entries entries;
  entries.text("material", scene.cage.material.name)
      .value("mass", 1e3 * at.cage_mass, "g")
      .text("guided by", guided_by(scene.cage.guidance))
      .text("pocket, width × length",
            fmt::format("{:.6g} × {:.6g} mm", 1e3 * scene.cage.pocket_width.front(),
                        1e3 * scene.cage.pocket_length.front()));
  if (is_flexible(scene))
    entries.value("fatigue strength", 1e-6 * strength.fatigue, "MPa")
        .value("yield strength", 1e-6 * strength.yield, "MPa");
  return entries.titled("Cage");
}

Json oil_group(const Scene& scene, const OperatingPoint& at) {
  const Lubrication& oil = scene.lubrication;
  if (oil.model == LubricationModel::none)
    return Entries().text("lubricant", "none: a dry bearing").titled("Lubricant");
  const Oil named = lubricant_named(oil.lubricant).oil;
  Entries entries;
  entries.text("oil", oil.lubricant).value("temperature", oil.temperature, "°C");
  if (std::isnan(oil.viscosity))
    entries.value(
        "viscosity there",
        kinematic_viscosity(viscosity_curve(given_or(oil.viscosity_40, named.viscosity_40),
                                            given_or(oil.viscosity_100, named.viscosity_100)),
                            oil.temperature),
        "mm²/s");
  else
    entries.value("dynamic viscosity", 1e3 * oil.viscosity, "mPa s");
  const OilLayers layers = oil_layers(oil);
  const auto layer = [&](const char* name, double gap) {
    std::isfinite(gap) ? entries.value(name, 1e6 * gap, "µm") : entries.text(name, "flooded");
  };
  entries.text("supply", spelled(oil_supply(oil)));
  layer("oil at the inner race up to a gap of", layers.inner);
  layer("oil at the outer race up to a gap of", layers.outer);
  return entries.value("film at the inner race", 1e6 * at.film, "µm")
      .value("film over roughness", at.lambda, "-")
      .titled("Lubricant");
}

/// Power that the nominal bearing sheds by each path, and what more warmth around it does; null
/// where temperatures are given.
Json heat_json(const Scene& scene) {
  const Temperatures& t = scene.temperature;
  if (!t.balance || std::isnan(t.found)) return {};
  const HeatShed whole = heat_shed(scene);
  Scene still = scene;
  still.temperature.oil_flow = 0;
  const double housing = heat_shed(still).at(t.found);
  return {{"temperature_C", t.found},
          {"ambient_C", t.ambient},
          {"housing_W", housing},
          {"oil_W", whole.at(t.found) - housing},
          {"warmer_by_10_K_of_ambient_K", 10 * heat_shed(still).slope / t.found_slope}};
}

Json heat_group(const Json& heat) {
  Entries entries;
  entries.value("oil and outer ring, found", heat["temperature_C"], "°C")
      .value("ambient", heat["ambient_C"], "°C")
      .value("shed by the housing", heat["housing_W"], "W")
      .value("taken along by oil", heat["oil_W"], "W")
      .value("10 K more around it warm it by", heat["warmer_by_10_K_of_ambient_K"], "K");
  return entries.titled("Heat");
}

/// What a run models, a sentence for each part.
std::vector<std::string> model_sentences(const Study& study) {
  const Scene& scene = study.scene;
  const Simplification& model = scene.model;
  std::vector<std::string> list;
  if (model.motion == MotionModel::quasi_static)
    return {
        "Ring and rollers in static equilibrium at every position of the cage; no motion of the "
        "cage, slip or friction."};
  list.emplace_back("Every roller moves in space, with skew, tilt and slip.");
  list.push_back(is_flexible(scene)
                     ? fmt::format("The cage is flexible: {} elastic modes{}, stress at its "
                                   "fillets.",
                                   scene.cage.modes, scene.cage.bar_modes ? " and its bars" : "")
                     : "The cage is a rigid body with six degrees of freedom: no stress.");
  list.push_back(model.ring_tilt == TiltModel::free
                     ? "The inner ring moves and tilts under load and moment."
                     : "The inner ring moves under load; its misalignment is prescribed.");
  list.push_back(
      scene.lubrication.model == LubricationModel::film
          ? "Oil: films, rolling resistance, traction and drag. Contacts are isothermal but "
            "for the inlet."
          : "No oil: dry contacts with velocity-dependent friction.");
  list.push_back(changes_in_operation(scene)
                     ? "Fits, temperatures or rotation change the clearances as the scene states."
                     : "Dimensions are those in operation: no fits, heat or growth are computed.");
  const double all = scene.window.measure_revolutions;
  std::string elsewhere;
  for (const OperatingPointPlan& at : study.points)
    if (const double own = at_operating_point(scene, at).window.measure_revolutions; own != all)
      elsewhere += fmt::format("; {:.6g} measured at {}", own, at.name);
  list.push_back(fmt::format("Each run: {:.6g} revolutions of the cage after {:.6g} to settle{}.",
                             all, scene.window.settle_revolutions, elsewhere));
  return list;
}

Json section_json(const Scene& scene) {
  const BearingGeometry& b = scene.bearing;
  const auto mm = [](double length) { return std::isfinite(length) ? Json(1e3 * length) : Json(); };
  return {{"rollers", b.roller_count},
          {"roller_diameter_mm", mm(scene.roller.diameter.front())},
          {"roller_length_mm", mm(scene.roller.length)},
          {"pitch_radius_mm", mm(pitch_radius(b))},
          {"bore_mm", mm(b.bore_diameter)},
          {"outside_mm", mm(b.outside_diameter)},
          {"width_mm", mm(b.width)},
          {"inner_raceway_mm", mm(b.inner_raceway_diameter)},
          {"outer_raceway_mm", mm(b.outer_raceway_diameter)},
          {"inner_land_mm", mm(inner_land_diameter(b))},
          {"outer_land_mm", mm(outer_land_diameter(b))},
          {"outer_flanges", spelled(b.outer_flanges)},
          {"inner_flanges", spelled(b.inner_flanges)},
          {"load_direction_deg", scene.operation.load_direction * 180 / std::numbers::pi},
          {"radial_load_N", scene.operation.radial_load},
          {"inner_speed_rpm", scene.operation.inner_speed / kRpm},
          {"outer_speed_rpm", scene.operation.outer_speed / kRpm},
          {"cage",
           {{"inner_mm", mm(scene.cage.inner_diameter)},
            {"outer_mm", mm(scene.cage.outer_diameter)},
            {"width_mm", mm(scene.cage.width)},
            {"pocket_width_mm", mm(scene.cage.pocket_width.front())},
            {"pocket_length_mm", mm(scene.cage.pocket_length.front())}}}};
}

/// Mean of a quantity over the samples, at the operating point `label` where one is named; NaN: not
/// known.
double mean_of(const std::string& quantity, const Study& study, const OutcomesById& outcomes,
               const std::string& label = "") {
  const int row = labelled_index(labelled_name(quantity, label), quantity_labels(study));
  double sum = 0, count = 0;
  for (const auto& [id, outcome] : outcomes)
    if (outcome.status == Status::ok && id < static_cast<std::uint64_t>(study.samples))
      sum += outcome.quantities.at(static_cast<std::size_t>(row)), ++count;
  return sum / count;
}

std::vector<std::string> warnings_of(const Scene& scene, double power) {
  std::vector<std::string> warnings = operating_warnings(scene);
  if (const std::string doubt = temperature_doubt(scene, power); !doubt.empty())
    warnings.insert(warnings.begin(), doubt);
  return warnings;
}

/// Values of assumptions as runs take them. Of those left to auto it knows oil, guide clearance and
/// conductance; others are left out.
Json assumed_json(const Scene& scene) {
  Scene used = scene;
  Lubrication& oil = used.lubrication;
  const OilLayers layers = oil_layers(oil);
  oil.race_layer = layers.inner, oil.outer_layer = layers.outer, oil.oil_share = layers.share;
  oil.pocket_layer = layers.pocket, oil.land_layer = layers.land, oil.supply = oil_supply(oil);
  used.cage.guide_clearance =
      pocket_clearances(scene, 0).ring[scene.cage.guidance == Guidance::outer];
  used.temperature.conductance =
      heat_shed(scene).slope - scene.temperature.oil_flow * oil_heat_capacity(scene);
  Json list = Json::object();
  for (const Assumption& assumed : scene.assumptions) {
    const Key<Scene>& key = *find_key(scene_keys(), assumed.key);
    const Json value = Json::parse(key_text(key, used), nullptr, false);
    if (!value.is_discarded() && value != "auto")
      list[key.name] = {
          {"value", value}, {"unit", key.unit}, {"automatic", key_text(key, scene) == "\"auto\""}};
  }
  return list;
}

Json points_json(const Study& study, const OutcomesById& outcomes) {
  Json list = Json::array();
  for (const OperatingPointPlan& plan : study.points) {
    const Scene scene = at_operating_point(study.scene, plan);
    const OperatingPoint at = operating_point(scene);
    list.push_back(
        {{"name", plan.name},
         {"weight", plan.weight},
         {"radial_load_N", scene.operation.radial_load},
         {"inner_speed_rpm", scene.operation.inner_speed / kRpm},
         {"speed_factor_mm_min", json_number(1e3 * at.pitch_diameter * at.speed / kRpm)},
         {"load_ratio", json_number(at.dynamic_rating / at.load)},
         {"warnings", warnings_of(scene, mean_of("power_loss_W", study, outcomes, plan.name))}});
  }
  return list;
}

/// Of the dimensions that get a tolerance: nominal value, Pp of their laws, what is to fit.
Json dimensions_json(const Study& study) {
  Json list = Json::array();
  for (const ToleranceFilling& filling : tolerance_fillings(study))
    list.push_back({{"key", filling.key},
                    {"nominal_mm", json_number(filling.nominal_mm)},
                    {"capability", json_number(filling.capability)},
                    {"mean_share", json_number(filling.mean_mm / filling.tolerance_width_mm)},
                    {"counterpart", filling.counterpart},
                    {"counterpart_mm", json_number(filling.counterpart_mm)}});
  return list;
}

/// Of the clearances that scatter.
Json chains_json(const Study& study) {
  const auto um = [](const Interval& of) { return Json{1e6 * of.lower, 1e6 * of.upper}; };
  Json list = Json::array();
  for (const ClearanceChain& chain : clearance_chains(study))
    if (!chain.keys.empty())
      list.push_back({{"name", chain.name},
                      {"keys", chain.keys},
                      {"nominal_um", 1e6 * chain.nominal},
                      {"worst_um", um(chain.worst)},
                      {"rss_um", um(chain.rss)},
                      {"sampled_um", um(chain.sampled)},
                      {"cages", kChainCages},
                      {"levels", {kChainTail, 1 - kChainTail}}});
  return list;
}

Json facts_of(const Study& study, const OutcomesById& outcomes) {
  const Scene& scene = study.scene;
  const OperatingPoint at = operating_point(scene);
  Json strength;
  if (is_flexible(scene)) {
    const Strength of_cage = cage_strength(scene);
    strength = {{"fatigue_MPa", 1e-6 * of_cage.fatigue}, {"yield_MPa", 1e-6 * of_cage.yield}};
  }
  Json groups = {bearing_group(scene, at),
                 load_group(scene, at),
                 order_group(at, mean_of("cage_slip_ratio", study, outcomes)),
                 clearance_group(scene, at),
                 cage_group(scene, at),
                 oil_group(scene, at)};
  const Json heat = heat_json(scene);
  if (!heat.is_null()) groups.push_back(heat_group(heat));
  return {
      {"name", scene.name},
      {"groups", groups},
      {"heat", heat},
      {"model", model_sentences(study)},
      {"points", points_json(study, outcomes)},
      {"assumed", assumed_json(scene)},
      {"dimensions", dimensions_json(study)},
      {"chains", chains_json(study)},
      {"warnings",
       warnings_of(scene, study.points.empty() ? mean_of("power_loss_W", study, outcomes) : kAuto)},
      {"strength", strength},
      {"section", section_json(scene)},
      {"drawing", pocket_drawing_json(scene, 0)}};
}

}  // namespace

Json bearing_facts(const std::filesystem::path& study_file) {
  try {
    const StudyFile file = read_study_file(study_file);
    return facts_of(read_resolved_study(file.study_toml, study_file), file.outcomes);
  } catch (const std::exception& problem) {
    return {{"problem", problem.what()}};
  }
}

}  // namespace cagetol
