#include "mc/commands/companion_stages.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>

#include "analysis/fidelity/control_variate.hpp"
#include "analysis/fidelity/multifidelity.hpp"
#include "analysis/report/companion.hpp"
#include "mc/adopted_runs.hpp"
#include "mc/commands/command.hpp"
#include "mc/ladder/rungs.hpp"
#include "mc/sweep_directory.hpp"

namespace cagetol {
namespace {

/// Most that the companion may cost, in times of the study.
constexpr double kLargestCost = 0.5;

/// A rung with its time as a share of that of motion in space (tests/ACCURACY.md).
struct Helper {
  Rung rung;
  double cost = 0;
};

/// Cheaper by far than the study's own model.
std::vector<Helper> helpers_of(const Study& study) {
  std::vector<Helper> helpers;
  if (is_quasi_static(study.scene)) return helpers;
  const auto& all = climbing_rungs();
  for (const Rung& rung : rungs_for(study.scene, all))
    if (rung.name == all[0].name)
      helpers.push_back({rung, 0.01});
    else if (rung.name == all[1].name && !has_planar_rollers(study.scene))
      helpers.push_back({rung, 0.15});
  return helpers;
}

struct Offer {
  Helper helper;
  std::string quantity;
  double ratio = 1;  ///< cheap runs for each run of the study
  double gain = 0;   ///< predicted for the quantity's mean
};

std::vector<double> first_values(const StudyData& runs, const std::string& quantity,
                                 std::size_t count) {
  std::vector<double> values = ok_values(runs, find_quantity(runs, quantity)->values);
  values.resize(std::min(count, values.size()));
  return values;
}

Offer best_offer(const Helper& helper, const StudyData& runs, const StudyData& pilot) {
  Offer best{helper, "", 1, 0};
  for (const Limit& limit : runs.plan.limits) {
    const auto expensive = first_values(runs, limit.quantity, pilot.size()),
               cheap = first_values(pilot, limit.quantity, pilot.size());
    const double correlation =
        helped_estimate(HelpedStatistic::mean, {expensive, cheap}, {}).correlation;
    if (std::isnan(correlation)) continue;
    const double ratio =
        std::min(best_cheap_ratio(correlation, helper.cost), kLargestCost / helper.cost);
    const double gain = gain_at_cost(correlation, 1, ratio, helper.cost);
    if (gain > best.gain) best = {helper, limit.quantity, ratio, gain};
  }
  return best;
}

}  // namespace

void check_companion(const Study& study) {
  if (study.multifidelity != "auto") return;
  for (const Helper& helper : helpers_of(study)) rung_study(study, helper.rung, 2);
}

int run_companion(const Study& study, const std::string& directory, StagedSweeps& stages) {
  if (study.multifidelity != "auto") return kDone;
  const StudyData whole = read_study_data(study_file_path(directory));
  const StudyData runs = select_samples(whole, first_runs(whole));
  const std::string folder = directory + "/" + kCompanionFolder;
  const auto pilot_folder = [&](const Helper& helper) {
    return folder + "/pilot-" + helper.rung.name;
  };
  Offer best;
  for (const Helper& helper : helpers_of(study)) {
    const long pairs = std::min(study.fidelity_samples, study.samples);
    const int code = stages.sweep(rung_study(study, helper.rung, pairs), pilot_folder(helper));
    if (code != kDone) return code;
    const Offer offer =
        best_offer(helper, runs, read_study_data(study_file_path(pilot_folder(helper))));
    if (offer.gain > best.gain) best = offer;
  }
  if (best.gain < kLeastMultifidelityGain) {
    spdlog::info("multifidelity: no cheap model helps, the largest gain predicted is {:.2f}",
                 best.gain);
    return kDone;
  }
  const auto samples =
      static_cast<long>(std::ceil(best.ratio * static_cast<double>(study.samples)));
  spdlog::info("multifidelity: {} helps, a gain of {:.1f} is predicted for the mean of {}",
               best.helper.rung.name, best.gain, best.quantity);
  const Study companion = rung_study(study, best.helper.rung, samples);
  adopt_runs(companion, folder, pilot_folder(best.helper));
  return stages.sweep(companion, folder);
}

}  // namespace cagetol
