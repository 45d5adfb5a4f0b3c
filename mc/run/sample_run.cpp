#include "mc/run/sample_run.hpp"

#include <limits>
#include <optional>

#include "distributions/basics/random_stream.hpp"
#include "mc/run/sample_history.hpp"
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

}  // namespace

namespace {

SampleRun run_scene(const Study& study, const Scene& as_drawn, std::uint64_t id,
                    SimulateOptions options,
                    const std::function<void(const Instant&)>& on_instant) {
  const OperatingScene scene = as_drawn;
  const HistoryPlan& plan = study.history;
  std::optional<SampleHistory> history;
  if (plan.points > 0) history.emplace(plan, scene);
  if (history) options.on_window = [&](double begin) { history->restart(begin); };
  std::optional<CageStress> stress;
  if (history || on_instant)
    options.on_state = [&](double t, const double* y, const System& system) {
      const auto& cage = system.model.flexible.model;
      if (cage && !stress) stress.emplace(*cage);
      const Instant at{t, y, system, stress ? &*stress : nullptr};
      if (history) history->record(at);
      if (on_instant) on_instant(at);
    };
  if (is_flexible(scene) && cage_is_checked(study, id))
    options.cage_model = checked_cage(scene, options);
  SampleRun run{simulate(scene, options), {}};
  if (options.cage_model && run.outcome.status == Status::ok)
    run.outcome.run.cage_frequency_error =
        cage_error(scene, *options.cage_table, *options.cage_model);
  if (history) run.history = history->take();
  return run;
}

}  // namespace

SampleRun run_sample(const Study& study, const Sample& sample, SimulateOptions options,
                     const std::function<void(const Instant&)>& on_instant) {
  if (study.points.empty()) return run_scene(study, sample.scene, sample.id, options, on_instant);
  std::vector<Outcome> outcomes;
  for (const OperatingPointPlan& point : study.points) {
    outcomes.push_back(
        run_scene(study, at_operating_point(sample.scene, point), sample.id, options, on_instant)
            .outcome);
    if (outcomes.back().status != Status::ok) break;
  }
  return {join_points(study, outcomes), {}};
}

}  // namespace cagetol
