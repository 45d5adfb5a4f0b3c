#include "mc/ladder/rungs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "src/operation/operating_scene.hpp"
#include "src/reading/scene_keys.hpp"
#include "src/scene/pocket_clearances.hpp"

namespace cagetol {
namespace {

constexpr double kOffsetShare = 0.1;    // of the narrowest pocket's clearance
constexpr double kSceneSamples = 1000;  // a usual study
// As far as the keys go (scene_keys.cpp).
constexpr long kFinestMesh = 12, kFinestSlices = 100;

/// Later settings replace earlier ones of the same key.
std::vector<std::string> joined(std::vector<std::string> settings,
                                const std::vector<std::string>& more) {
  for (const std::string& setting : more) {
    std::erase_if(settings,
                  [&](const std::string& old) { return setting_key(old) == setting_key(setting); });
    settings.push_back(setting);
  }
  return settings;
}

std::vector<Rung> climbed(const std::vector<Rung>& steps) {
  std::vector<Rung> rungs;
  for (const Rung& step : steps) {
    const std::vector<std::string> below =
        rungs.empty() ? std::vector<std::string>{} : rungs.back().settings;
    rungs.push_back({step.name, step.meaning, joined(below, step.settings)});
  }
  return rungs;
}

UncertainInput noise_of(const std::string& key, const std::string& unit, const Scene& scene,
                        const Law& law) {
  UncertainInput input;
  input.key = key;
  input.unit = unit;
  input.nominal = key_numbers(*find_key(scene_keys(), key), scene);
  input.noise = law;
  return input;
}

std::vector<UncertainInput> start_scatter(const Scene& scene) {
  const UncertainInput phase = noise_of("start.cage_phase_deg", "deg", scene, Uniform{0, 360});
  const Law offset = Normal{0, kOffsetShare * 1e6 * narrowest_tangential(OperatingScene(scene))};
  return {noise_of("start.cage_offset_y_um", "um", scene, offset),
          noise_of("start.cage_offset_z_um", "um", scene, offset), phase};
}

}  // namespace

const std::vector<Rung>& climbing_rungs() {
  static const std::vector<Rung> rungs = climbed({
      {"quasi-static",
       "equilibria of ring and rollers over the cage's turn, five slices of a contact",
       {"model.motion='quasi-static'", "cage.model='rigid'", "discretisation.race_slices=5",
        "integration.tolerance=0.02"}},
      {"coarse-3",
       "motion of rollers, ring and a rigid cage, three slices, integration tolerance 0.02",
       {"model.motion='dynamic'", "discretisation.race_slices=3"}},
      {"coarse-5", "five slices", {"discretisation.race_slices=5"}},
      {"rigid-5", "integration tolerance 0.005", {"integration.tolerance=0.005"}},
      {"flexible-6",
       "flexible cage with 6 modes, at rest",
       {"cage.model='flexible'", "cage.modes=6", "cage.bar_modes=false", "cage.centrifugal=false",
        "cage.coriolis=false"}},
      {"bars",
       fmt::format("{} modes, and a static one of every bar", CageGeometry{}.modes),
       {fmt::format("cage.modes={}", CageGeometry{}.modes), "cage.bar_modes=true"}},
      {"rotating", "modes feel the rotation", {"cage.centrifugal=true", "cage.coriolis=true"}},
      {"full",
       "integration as by default",
       {fmt::format("integration.method='{}'", spelled(Integration{}.method)),
        fmt::format("integration.tolerance={}", Integration{}.tolerance)}},
  });
  return rungs;
}

std::vector<Rung> refining_rungs(const Scene& scene) {
  const bool flexible = scene.cage.model == CageKind::flexible;
  std::vector<Rung> rungs;
  const double tolerance = scene.integration.tolerance / 10;
  Rung& integrator = rungs.emplace_back(Rung{"integrator",
                                             fmt::format("integration tolerance {:g}", tolerance),
                                             {fmt::format("integration.tolerance={}", tolerance)}});
  if (const IntegrationMethod finest = IntegrationMethod::rodasp;
      scene.integration.method != finest) {
    integrator.meaning += fmt::format(", method {}", spelled(finest));
    integrator.settings.push_back(fmt::format("integration.method='{}'", spelled(finest)));
  }
  const long most = std::min<long>(kMostElasticModes, kMostModes - scene.bearing.roller_count);
  if (!flexible)
    rungs.push_back(
        {"modes",
         fmt::format("flexible cage with {} modes", CageGeometry{}.modes),
         {"cage.model='flexible'", fmt::format("cage.modes={}", CageGeometry{}.modes)}});
  else if (scene.cage.modes < most)
    rungs.push_back({"modes",
                     fmt::format("{} modes of the flexible cage, and its bars'", most),
                     {fmt::format("cage.modes={}", most), "cage.bar_modes=true"}});
  const long slices = std::min(2 * scene.discretisation.race_slices + 1, kFinestSlices);
  if (slices > scene.discretisation.race_slices)
    rungs.push_back({"slices",
                     fmt::format("{} slices of a contact", slices),
                     {fmt::format("discretisation.race_slices={}", slices)}});
  const long density = std::min(scene.cage.mesh_density + 2, kFinestMesh);
  if (flexible && density > scene.cage.mesh_density)
    rungs.push_back({"mesh",
                     fmt::format("{} finite elements through the cage's thickness", density),
                     {fmt::format("cage.mesh_density={}", density)}});
  const bool timed = !std::isnan(scene.window.measure_time);
  const Rung window = {
      "window",
      "measured twice as long",
      {timed ? fmt::format("window.measure_time_s={}", 2 * scene.window.measure_time)
             : fmt::format("window.measure_revolutions={}", 2 * scene.window.measure_revolutions)}};
  // A duty over time has the length that it has.
  if (!changes_over_time(scene.operation)) rungs.push_back(window);
  rungs.push_back({"as-run", "the scene as it is", {}});
  return rungs;
}

Scene on_rung(Scene scene, const Rung& rung) {
  toml::table table;
  for (const std::string& setting : rung.settings) apply_setting(table, setting);
  const auto pockets = static_cast<std::size_t>(scene.bearing.roller_count);
  for (const TomlLeaf& leaf : toml_leaves(table))
    read_key(*find_key(scene_keys(), leaf.name), *leaf.node, "rung " + rung.name, pockets, scene);
  return scene;
}

namespace {
bool fits(const Scene& on_rung) {
  try {
    check_scene(on_rung, "rung");
    return true;
  } catch (const InputError&) {
    return false;
  }
}
}  // namespace

std::vector<Rung> rungs_for(const Scene& scene, const std::vector<Rung>& rungs) {
  std::vector<Rung> own;
  std::set<std::string> seen = {dump_keys(scene_keys(), on_rung(scene, rungs.back()))};
  for (std::size_t i = 0; i + 1 < rungs.size(); ++i) {
    const Scene other = on_rung(scene, rungs[i]);
    if (fits(other) && seen.insert(dump_keys(scene_keys(), other)).second) own.push_back(rungs[i]);
  }
  own.push_back(rungs.back());
  return own;
}

Study rung_study(const Study& study, const Rung& rung, long samples) {
  for (const std::string& setting : rung.settings)
    for (const UncertainInput& input : study.inputs)
      if (input.key == setting_key(setting))
        throw InputError({}, "scene." + input.key, "a distribution",
                         "the model ladder switches this key from rung to rung",
                         "give it one value, or leave the ladder out (fidelity = \"pinned\")");
  return changed_study(study, [&](Study& changed) {
    changed.name += ", rung " + rung.name;
    changed.fidelity = "pinned";
    changed.fidelity_decision = {};
    changed.samples = samples;
    changed.design = DesignKind::random;
    changed.cages_per_lot = 1;
    changed.extra_replicates = 0;
    changed.allowed_failure_share = 1;  // a rung that fails is a finding
    if (changed.inputs.empty()) changed.inputs = start_scatter(changed.scene);
    changed.scene = on_rung(changed.scene, rung);
  });
}

double ladder_study_samples(const Study& study) {
  return study.samples > 1 ? static_cast<double>(study.samples) : kSceneSamples;
}

}  // namespace cagetol
