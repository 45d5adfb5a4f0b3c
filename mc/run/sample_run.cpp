#include "mc/run/sample_run.hpp"

#include <limits>
#include <optional>

#include "distributions/basics/random_stream.hpp"
#include "mc/run/history_channels.hpp"
#include "mc/study/operating_points.hpp"
#include "src/cage/solve/unsolved_cage.hpp"
#include "src/cage/table/cage_check.hpp"
#include "src/cage/table/scene_cage.hpp"
#include "src/operation/operating_scene.hpp"

namespace cagetol {
namespace {

bool cage_is_checked(const Study& study, std::uint64_t id) {
  return uniform(static_cast<std::uint64_t>(study.seed), Purpose::check, id, 0, 0) <
         study.cage_check_share;
}

/// The cage of a sample that is checked, made before its run; nullptr where there is none.
std::shared_ptr<const CageModel> checked_cage(const Scene& scene, const SimulateOptions& options) {
  if (!options.cage_table) return nullptr;
  const auto made = scene_cage_model(scene, *options.cage_table);
  const auto* model = std::get_if<std::shared_ptr<const CageModel>>(&made);
  return model == nullptr ? nullptr : *model;
}

/// Largest frequency error of the sample's cage model against a full solve; NaN where that has no
/// solution.
double cage_error(const Scene& scene, const CageTable& table, const CageModel& model) {
  try {
    return check_cage_model(table, pocket_deviations(scene, table.cage), model).largest_error;
  } catch (const UnsolvedCage&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

Outcome run_scene(const Study& study, const Scene& as_drawn, std::uint64_t id,
                  SimulateOptions options, const std::function<void(const Instant&)>& on_instant) {
  const OperatingScene scene = as_drawn;
  std::optional<CageStress> stress;
  if (on_instant)
    options.on_state = [&](double t, const double* y, const System& system) {
      const auto& cage = system.model.flexible.model;
      if (cage && !stress) stress.emplace(*cage);
      on_instant({t, y, system, stress ? &*stress : nullptr});
    };
  if (is_flexible(scene) && cage_is_checked(study, id))
    options.cage_model = checked_cage(scene, options);
  Outcome outcome = simulate(scene, options);
  if (options.cage_model && outcome.status == Status::ok)
    outcome.run.cage_frequency_error = cage_error(scene, *options.cage_table, *options.cage_model);
  return outcome;
}

}  // namespace

Outcome run_sample(const Study& study, const Sample& sample, SimulateOptions options,
                   const std::function<void(const Instant&)>& on_instant) {
  if (study.points.empty()) return run_scene(study, sample.scene, sample.id, options, on_instant);
  std::vector<Outcome> outcomes;
  for (const OperatingPointPlan& point : study.points) {
    outcomes.push_back(
        run_scene(study, at_operating_point(sample.scene, point), sample.id, options, on_instant));
    if (outcomes.back().status != Status::ok) break;
  }
  return join_points(study, outcomes);
}

}  // namespace cagetol
