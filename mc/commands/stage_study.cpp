#include "mc/commands/stage_study.hpp"

#include <fmt/format.h>

#include "mc/sweep/sweep_directory.hpp"
#include "src/input/unit.hpp"

namespace cagetol {
namespace {

/// Every stage has random numbers of its own; all follow from the study's seed.
long stage_seed(long seed, const std::string& stage) {
  return static_cast<long>(std::stoull(text_hash(fmt::format("{} {}", seed, stage)), nullptr, 16) >>
                           11);
}

}  // namespace

Study stage_study(const Study& base, const Stage& stage) {
  return changed_study(base, [&](Study& study) {
    study.name += ", " + stage.name;
    study.seed = stage_seed(base.seed, stage.name);
    study.samples = static_cast<long>(stage.rows);
    study.redraw_jams = true;
    study.allowed_failure_share = 1;  // judged over the campaign, which may go on with another
    // A budget may be raised: stages and their runs stay as they are.
    study.recommend.pilot_samples = RecommendPlan{}.pilot_samples;
    study.recommend.confirm_samples = study.recommend.budget_samples = 0;
    study.recommend.budget_time = study.recommend.assumption_samples = 0;
    study.screen = {};
    study.map = {};
    // So may ranges, of which a stage knows one value: DIR/assumptions.json holds them.
    for (Assumption& assumption : study.scene.assumptions)
      assumption = {assumption.key, assumption.note};
    if (stage.tolerances.empty()) return;
    study.recommend.attempts = static_cast<long>(stage.error_shares);
    study.design = DesignKind::random;
    study.cages_per_lot = 1;
    study.extra_replicates = 0;
    for (std::size_t d = 0; d < stage.tolerances.size(); ++d) {
      const RecommendedTolerance& tolerance = stage.tolerances[d];
      auto& dimension = study.tolerance.dimensions[d];
      dimension.cost.reset();
      dimension.candidates = {tolerance.grade.empty() ? number_text(tolerance.tolerance_width_mm)
                                                      : tolerance.grade};
      if (tolerance.centre) dimension.centres = {*tolerance.centre};
    }
  });
}

}  // namespace cagetol
