#include "analysis/tolerance/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/sensitivity/noise_share.hpp"
#include "analysis/statistics/binomial_bounds.hpp"
#include "analysis/statistics/summary.hpp"
#include "analysis/study/refused.hpp"

namespace cagetol {
namespace {

/// Share of a budget that the mixture gets; the confirmations have the rest.
constexpr double kMixtureShare = 0.5;
constexpr std::size_t kResamples = 500;

double seconds_per_run(const StudyData& pilot) {
  for (const Column& column : pilot.timing)
    if (column.name == "wall_s" && pilot.size() > 0) {
      const std::vector<double> equal(pilot.size(), 1.0);
      return weighted_mean(column.values, equal);
    }
  return 0;
}

/// Runs of a mixture of so many rows, noise replicates included.
double runs_of_rows(const StudyPlan& study, double rows) {
  return rows * (1 + study.extra_replicates);
}

/// Runs that the budgets leave after the pilot; nothing where there is no budget.
std::optional<double> runs_left(const StudyData& pilot, const CampaignPlan& plan) {
  const CampaignSettings& settings = pilot.plan.campaign;
  std::optional<double> left;
  const auto at_most = [&](double runs) { left = left ? std::min(*left, runs) : runs; };
  const auto spent = static_cast<double>(pilot.size());
  if (settings.budget_samples > 0) at_most(static_cast<double>(settings.budget_samples) - spent);
  if (settings.budget_h > 0 && plan.seconds_per_run > 0)
    at_most(3600 * settings.budget_h * plan.processes / plan.seconds_per_run - spent);
  return left;
}

std::string duration(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

std::string noise_text(const StudyData& pilot) {
  std::string text;
  for (const Limit& limit : pilot.plan.limits) {
    const Column* column = find_quantity(pilot, limit.quantity);
    if (column == nullptr) continue;
    const NoiseShare noise = noise_share(pilot, column->values, pilot.plan.confidence, kResamples);
    if (!(noise.share.value > 0)) continue;
    text += fmt::format(
        "\n  noise owns {:.0f} % of the variance of {} ({:.0f} to {:.0f} %): no design lowers the "
        "variance of its mean more than {:.1f} times",
        100 * noise.share.value, limit.quantity, 100 * noise.share.lower, 100 * noise.share.upper,
        1 / noise.share.value);
  }
  return text;
}

/// True when no band is wider and one is narrower.
bool narrower(const std::vector<double>& bands, const Recommendation& than) {
  bool some = false;
  for (std::size_t d = 0; d < bands.size(); ++d) {
    if (bands[d] > than.bands[d].band_mm * (1 + 1e-9)) return false;
    some = some || bands[d] < than.bands[d].band_mm * (1 - 1e-9);
  }
  return some;
}

/// What an attempt may count on: halfway from the estimate to its bound, since the best of many
/// looks too good.
double expected_yield(const Yield& yield) {
  return 0.5 * (yield.if_unknown_fail + yield.lower_bound);
}

/// The tolerance to try next, narrower than every one that failed. Preferred are those that the
/// runs afforded will probably confirm; where there is none, the surest.
Recommendation next_recommendation(const StudyData& runs, const ToleranceStudy& study,
                                   const std::vector<Judgement>& joint,
                                   const Resampling& resampling, const ConfirmationRules& rules,
                                   const std::vector<Attempt>& failed) {
  const auto chance = [&](std::size_t k) {
    const double yield = expected_yield(study.curves.candidates[k]);
    return confirming_probability(yield, confirmation_size(yield, rules), rules);
  };
  const auto fresh = [&](std::size_t k) {
    const auto bands = snapped_bands(runs, runs.plan.candidates[k]);
    return std::all_of(failed.begin(), failed.end(), [&](const Attempt& attempt) {
      return narrower(bands, attempt.recommendation);
    });
  };
  const auto recommend = [&](const std::vector<BindingTest>& tests) {
    double surest = 0;
    const auto probable = recommend_tolerance(runs, study.mixture, study.curves, tests, joint,
                                              resampling, [&](std::size_t k) {
                                                if (!fresh(k)) return false;
                                                surest = std::max(surest, chance(k));
                                                return chance(k) >= kWantedPower;
                                              });
    if (probable.meets_target) return probable;
    return recommend_tolerance(runs, study.mixture, study.curves, tests, joint, resampling,
                               [&](std::size_t k) { return fresh(k) && chance(k) >= surest; });
  };
  const Recommendation held = recommend(study.tests);
  if (held.meets_target) return held;
  const Recommendation other = recommend(freed(study.tests));
  return other.meets_target ? other : held;
}

}  // namespace

ConfirmationRules confirmation_rules(const StudyPlan& study, std::size_t most_runs) {
  return {study.target_yield, study.confidence, std::max<std::size_t>(study.campaign.attempts, 1),
          most_runs};
}

CampaignPlan plan_campaign(const StudyData& pilot, std::size_t study_rows, double processes) {
  const StudyPlan& study = pilot.plan;
  CampaignPlan plan{0, 0, seconds_per_run(pilot), processes};
  const auto rules = confirmation_rules(study, 0);
  const std::size_t fewest = confirming_runs(0, rules);
  const auto attempts = static_cast<double>(rules.attempts);
  const auto left = runs_left(pilot, plan);
  if (!left) {
    plan.mixture_rows = study_rows;
    plan.most_confirm_runs = study.campaign.confirm_samples > 0 ? study.campaign.confirm_samples
                                                                : std::max(study_rows, 2 * fewest);
  } else {
    const double stated = static_cast<double>(study.campaign.confirm_samples);
    const double confirm =
        std::max(0.0, stated > 0 ? stated : (1 - kMixtureShare) * *left / attempts);
    plan.most_confirm_runs = static_cast<std::size_t>(confirm);
    plan.mixture_rows = static_cast<std::size_t>(
        std::max(0.0, (*left - attempts * confirm) / (1 + study.extra_replicates)));
  }
  const auto candidates = static_cast<double>(study.candidates.size());
  const double wanted_rows = kFewestEffectiveRuns * candidates;
  if (plan.most_confirm_runs < fewest || plan.mixture_rows < kFewestEffectiveRuns)
    throw Refused(fmt::format(
        "the budget leaves {} rows to compare {} candidates and {} runs for each of {} attempts to "
        "confirm; with no failing run at all, {} runs are needed to confirm {:g} % with {:g} % "
        "confidence. About {:.0f} runs in all would do",
        plan.mixture_rows, study.candidates.size(), plan.most_confirm_runs, rules.attempts, fewest,
        100 * study.target_yield, 100 * study.confidence,
        static_cast<double>(pilot.size()) +
            2 * std::max(runs_of_rows(study, wanted_rows),
                         2 * attempts * static_cast<double>(fewest))));
  return plan;
}

nlohmann::ordered_json to_json(const CampaignPlan& plan) {
  return {{"mixture_rows", plan.mixture_rows},
          {"most_confirm_runs", plan.most_confirm_runs},
          {"seconds_per_run", plan.seconds_per_run},
          {"processes", plan.processes}};
}

CampaignPlan campaign_plan_of(const nlohmann::ordered_json& json) {
  return {json.at("mixture_rows").get<std::size_t>(),
          json.at("most_confirm_runs").get<std::size_t>(), json.at("seconds_per_run").get<double>(),
          json.at("processes").get<double>()};
}

std::string plan_text(const StudyData& pilot, const CampaignPlan& plan) {
  const StudyPlan& study = pilot.plan;
  const auto rules = confirmation_rules(study, plan.most_confirm_runs);
  const double mixture = runs_of_rows(study, static_cast<double>(plan.mixture_rows));
  const auto confirm = static_cast<double>(plan.most_confirm_runs);
  const double each = plan.seconds_per_run / plan.processes;
  std::string text = fmt::format(
      "plan, by the pilot's {:.3g} s a run on {:g} processes:\n"
      "  mixture: {} rows over {} candidates, {:.0f} runs, {}\n"
      "  confirmation: at most {} attempts of {} to {} runs each at {:.6g} % confidence, {} each",
      plan.seconds_per_run, plan.processes, plan.mixture_rows, study.candidates.size(), mixture,
      duration(each * mixture), rules.attempts, confirming_runs(0, rules), plan.most_confirm_runs,
      100 * attempt_confidence(rules), "up to " + duration(each * confirm));
  if (static_cast<double>(plan.mixture_rows) <
      kFewestEffectiveRuns * static_cast<double>(study.candidates.size()))
    text += fmt::format(
        "\n  fewer than {:.0f} rows for each candidate: some may have too few effective runs to be "
        "judged",
        kFewestEffectiveRuns);
  return text + noise_text(pilot);
}

ToleranceStudy study_tolerances(const StudyData& runs, const std::vector<Judgement>& joint,
                                const Resampling& resampling) {
  ToleranceStudy study;
  study.mixture = mixture_weights(runs);
  study.curves = yield_curves(runs, study.mixture, joint, resampling, runs.plan.confidence);
  study.tests = test_binding(runs, study.mixture, study.curves, joint, resampling);
  return study;
}

LostRuns& LostRuns::operator+=(const LostRuns& other) {
  lost += other.lost;
  runs += other.runs;
  return *this;
}

double LostRuns::least_share() const {
  return clopper_pearson_lower(static_cast<double>(lost), static_cast<double>(runs), kConfidence);
}

LostRuns count_lost(const StudyData& runs) {
  const auto lost = std::count_if(runs.status.begin(), runs.status.end(), [](RunStatus status) {
    return status == RunStatus::failed || status == RunStatus::censored ||
           status == RunStatus::poisoned;
  });
  return {static_cast<std::size_t>(lost), runs.size()};
}

Campaign run_campaign(const Stage& pilot,
                      const std::function<CampaignPlan(const StudyData& pilot)>& plan,
                      const RunStage& run_stage) {
  Campaign campaign;
  const auto piloted = run_stage(pilot);
  if (!piloted) return campaign;
  const CampaignPlan planned = plan(*piloted);
  const auto mixed = run_stage({"mixture", planned.mixture_rows, {}});
  if (!mixed) return campaign;

  const StudyData runs = select_samples(*mixed, first_runs(*mixed));
  const auto joint = judge_all(runs);
  const Resampling resampling(runs, kResamples);
  const ToleranceStudy study = study_tolerances(runs, joint, resampling);
  const auto rules = confirmation_rules(runs.plan, planned.most_confirm_runs);
  while (campaign.attempts.size() < rules.attempts) {
    const Recommendation next =
        next_recommendation(runs, study, joint, resampling, rules, campaign.attempts);
    if (!next.meets_target) {
      campaign.end = CampaignEnd::no_candidate;
      return campaign;
    }
    const Stage stage{fmt::format("confirm-{}", campaign.attempts.size() + 1),
                      confirmation_size(expected_yield(next.yield), rules), next.bands};
    const auto confirming = run_stage(stage);
    if (!confirming) return campaign;
    campaign.attempts.push_back({next, judge_confirmation(*confirming, rules)});
    if (campaign.attempts.back().confirmation.passed) {
      campaign.end = CampaignEnd::confirmed;
      return campaign;
    }
  }
  campaign.end = CampaignEnd::not_confirmed;
  return campaign;
}

}  // namespace cagetol
