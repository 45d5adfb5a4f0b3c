#include "analysis/tolerance/attempt_choice.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/tolerance/cost.hpp"

namespace cagetol {
namespace {

constexpr double kRounding = 1e-9;
/// Least chance of being confirmed, by its estimate, with which a wide tolerance is tried while
/// another attempt remains.
constexpr double kFairChance = 0.1;
/// The last attempt takes the widest candidate whose predicted chance is at least this share of the
/// best: estimates without a failing run differ by nothing but luck.
constexpr double kNearlyAsSure = 0.8;

/// True when no tolerance is wider and one is narrower.
bool narrower(const std::vector<double>& widths, const std::vector<double>& than) {
  bool some = false;
  for (std::size_t d = 0; d < widths.size(); ++d) {
    if (widths[d] > than[d] * (1 + kRounding)) return false;
    some = some || widths[d] < than[d] * (1 - kRounding);
  }
  return some;
}

/// Of being confirmed, with no more than so many runs.
double chance(double yield, std::size_t most_runs, ConfirmationRules rules) {
  rules.most_runs = most_runs;
  return confirming_probability(yield, confirmation_size(yield, rules), rules);
}

Recommendation widest_of(const MixtureStudy& mixture, const CandidateFilter& allowed) {
  return recommend_allowed(mixture.runs, mixture.tolerances.mixture, mixture.tolerances.curves,
                           mixture.tolerances.tests, mixture.joint, mixture.resampling, allowed);
}

/// Of cages that fit together, by candidate; 1 where nothing is known of jams.
double share_without_jam(const StudyData& runs, std::size_t candidate) {
  return candidate < runs.jam.candidate.size() ? 1 - runs.jam.candidate[candidate] : 1;
}

double estimate_of(const MixtureStudy& mixture, std::size_t candidate) {
  return std::min(mixture.tolerances.curves.candidates[candidate].if_unknown_fail,
                  share_without_jam(mixture.runs, candidate));
}

double expected_of(const MixtureStudy& mixture, std::size_t candidate) {
  return std::min(expected_yield(mixture.tolerances.curves.candidates[candidate]),
                  share_without_jam(mixture.runs, candidate));
}

/// Of being confirmed with so many runs, averaged over what the yield may be after the mixture's
/// effective runs (Jeffreys' prior).
double predicted_chance(const MixtureStudy& mixture, std::size_t candidate, std::size_t runs,
                        const ConfirmationRules& rules) {
  constexpr double kSteps = 96, kMinimumShare = 1e-6;
  const Yield& yield = mixture.tolerances.curves.candidates[candidate];
  const double passing = yield.if_unknown_fail / yield.fits * yield.ess,
               failing = yield.ess - passing;
  double sum = 0, below = 0;
  for (double step = 1; step <= kSteps; ++step) {
    // Failing shares from 1e-6 to 1, in equal ratios.
    const double up_to = std::pow(kMinimumShare, 1 - step / kSteps);
    const double reached = gsl_cdf_beta_P(up_to, failing + 0.5, passing + 0.5);
    const double middle = up_to * std::pow(kMinimumShare, 0.5 / kSteps);
    sum += (reached - below) *
           confirming_probability(
               std::min((1 - middle) * yield.fits, share_without_jam(mixture.runs, candidate)),
               runs, rules);
    below = reached;
  }
  return sum;
}

/// Runs kept back for the attempts that may follow this candidate: what the narrower one needs that
/// needs least, no more than an equal share of what is left.
std::size_t kept_back(const MixtureStudy& mixture, const std::vector<double>& widths,
                      std::size_t left, std::size_t following, const ConfirmationRules& rules) {
  if (following == 0) return 0;
  const std::size_t share = left / (following + 1);
  std::size_t need = 0;
  for (std::size_t k = 0; k < mixture.runs.plan.candidates.size(); ++k) {
    ConfirmationRules affordable = rules_for(rules, mixture.runs, k);
    if (!(estimate_of(mixture, k) >= rules.target_yield) || !can_confirm(affordable) ||
        !narrower(snapped_tolerances(mixture.runs, mixture.runs.plan.candidates[k]), widths))
      continue;
    affordable.most_runs = share;
    const std::size_t runs = confirmation_size(expected_of(mixture, k), affordable);
    need = need == 0 ? runs : std::min(need, runs);
  }
  return std::min(share, following * need);
}

std::string percent(double share) {
  return fmt::format("{:.1f} %", 100 * share);
}

PassedOver reason_of(const StudyData& runs, const Yield& yield, std::size_t k) {
  const StudyPlan& plan = runs.plan;
  const ConfirmationRules alone = rules_for(
      {plan.target_yield, plan.confidence, 1, std::numeric_limits<std::size_t>::max() / 4}, runs,
      k);
  if (yield.ess < kMinimumEffectiveRuns)
    return {k,
            fmt::format("the mixture holds {:.0f} effective runs of it, too few to judge it",
                        yield.ess),
            can_confirm(alone) ? confirming_runs(0, alone) : 0};
  if (const double fitting = share_without_jam(runs, k);
      fitting <= plan.target_yield || !can_confirm(alone))
    return {k, fmt::format("{} of its cages jam", percent(1 - fitting)), 0};
  if (yield.if_unknown_fail < plan.target_yield)
    return {k,
            fmt::format("its estimated yield of {} is below the target",
                        percent(yield.if_unknown_fail)),
            0};
  const double expected = std::min(expected_yield(yield), share_without_jam(runs, k));
  if (expected <= plan.target_yield)
    return {
        k,
        fmt::format("its yield, estimated at {} and at least {}, cannot be distinguished from the "
                    "target",
                    percent(yield.if_unknown_fail), percent(yield.lower_bound)),
        0};
  const std::size_t needed = confirmation_size(expected, alone);
  return {k,
          fmt::format("the runs left would hardly have confirmed its yield, estimated at {}",
                      percent(yield.if_unknown_fail)),
          needed};
}

}  // namespace

ToleranceStudy study_tolerances(const StudyData& runs, const std::vector<Judgement>& joint,
                                const Resampling& resampling) {
  ToleranceStudy study;
  study.mixture = mixture_weights(runs);
  study.curves = yield_curves(runs, study.mixture, joint, resampling, runs.plan.confidence);
  study.tests = test_binding(runs, study.mixture, study.curves, joint, resampling);
  return study;
}

MixtureStudy study_mixture(const StudyData& mixture) {
  StudyData runs = select_samples(mixture, first_runs(mixture));
  auto joint = judge_all(runs);
  Resampling resampling(runs, kUsualResamples);
  ToleranceStudy tolerances = study_tolerances(runs, joint, resampling);
  return {std::move(runs), std::move(joint), std::move(resampling), std::move(tolerances)};
}

Recommendation recommendation_of(const MixtureStudy& mixture, std::size_t candidate) {
  return widest_of(mixture, [&](std::size_t k) { return k == candidate; });
}

std::optional<AttemptChoice> choose_attempt(const MixtureStudy& mixture, const CampaignPlan& plan,
                                            const std::vector<Tolerance>& failed) {
  const StudyPlan& study = mixture.runs.plan;
  const ConfirmationRules rules = confirmation_rules(study, 0);
  const auto rules_of = [&](std::size_t k) { return rules_for(rules, mixture.runs, k); };
  if (failed.size() >= rules.attempts || !affords_attempt(plan, rules)) return std::nullopt;
  const std::size_t left = plan.confirm_runs - decided_runs(plan);
  const std::size_t following = rules.attempts - failed.size() - 1;
  const std::size_t stated = plan.settings.confirm_samples;
  const auto tolerances_of = [&](std::size_t k) {
    return snapped_tolerances(mixture.runs, study.candidates[k]);
  };
  const auto promising = [&](std::size_t k) {
    return estimate_of(mixture, k) >= rules.target_yield && can_confirm(rules_of(k)) &&
           confirming_runs(0, rules_of(k)) <= left &&
           std::all_of(failed.begin(), failed.end(), [&](const Tolerance& other) {
             return narrower(tolerances_of(k), other.tolerance_widths_mm) ||
                    (same_tolerances(tolerances_of(k), other.tolerance_widths_mm) &&
                     !same_centres({tolerances_of(k), study.candidates[k].shifts}, other));
           });
  };
  const auto most_runs = [&](std::size_t k) {
    const std::size_t runs = left - kept_back(mixture, tolerances_of(k), left, following, rules);
    return std::max(confirming_runs(0, rules_of(k)), stated > 0 ? std::min(runs, stated) : runs);
  };
  const auto sure = [&](std::size_t k) {
    return chance(expected_of(mixture, k), most_runs(k), rules_of(k));
  };
  const auto fair = [&](std::size_t k) {
    return chance(estimate_of(mixture, k), most_runs(k), rules_of(k));
  };
  const auto size_of = [&](std::size_t k) {
    ConfirmationRules sized = rules_of(k);
    sized.most_runs = most_runs(k);
    return confirmation_size(expected_of(mixture, k), sized);
  };
  Recommendation next;
  if (following > 0)
    next =
        widest_of(mixture, [&](std::size_t k) { return promising(k) && fair(k) >= kFairChance; });
  if (!next.meets_target)
    next =
        widest_of(mixture, [&](std::size_t k) { return promising(k) && sure(k) >= kWantedPower; });
  if (!next.meets_target) {
    const auto predicted = [&](std::size_t k) {
      return predicted_chance(mixture, k, size_of(k), rules_of(k));
    };
    double surest = 0;
    for (std::size_t k = 0; k < study.candidates.size(); ++k)
      if (promising(k)) surest = std::max(surest, predicted(k));
    next = widest_of(mixture, [&](std::size_t k) {
      return promising(k) && predicted(k) >= kNearlyAsSure * surest;
    });
  }
  if (!next.meets_target) return std::nullopt;
  return AttemptChoice{size_of(next.candidate), next};
}

std::vector<PassedOver> passed_over(const StudyData& runs, const YieldCurves& curves,
                                    const std::vector<Tolerance>& tried) {
  std::vector<PassedOver> list;
  if (tried.empty()) return list;
  const StudyPlan& plan = runs.plan;
  const double decided = worth_of_tolerances(plan, tried.back().tolerance_widths_mm);
  for (std::size_t k = 0; k < plan.candidates.size(); ++k) {
    const Tolerance tolerance = snapped_tolerance(runs, plan.candidates[k]);
    const bool wider = worth_of_tolerances(plan, tolerance.tolerance_widths_mm) >
                       decided + kRounding * std::abs(decided);
    const bool fresh = std::none_of(tried.begin(), tried.end(), [&](const auto& other) {
      return same_tolerance(tolerance, other);
    });
    if (wider && fresh) list.push_back(reason_of(runs, curves.candidates[k], k));
  }
  return list;
}

}  // namespace cagetol
