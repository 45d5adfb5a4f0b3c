#include "analysis/tolerance/assumption_verdict.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <functional>
#include <map>

#include "analysis/compare/holm.hpp"
#include "analysis/compare/matched_runs.hpp"
#include "analysis/statistics/binomial_bounds.hpp"

namespace cagetol {
namespace {

/// Largest k at which the condition still holds, of 0 ... n; n + 1 where it holds for none.
std::size_t largest_where(std::size_t n, const std::function<bool(std::size_t)>& holds) {
  if (!holds(0)) return n + 1;
  std::size_t low = 0, high = n + 1;
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

double at_most(std::size_t failures, double failing_share, std::size_t runs) {
  return gsl_cdf_binomial_P(static_cast<unsigned>(failures), failing_share,
                            static_cast<unsigned>(runs));
}

double settling_power(std::size_t runs, double yield, double target, double lower_confidence,
                      double upper_confidence) {
  if (yield > target) {
    const std::size_t few = largest_where(runs, [&](std::size_t failures) {
      return at_most(failures, 1 - target, runs) <= 1 - lower_confidence;
    });
    return few > runs ? 0 : at_most(few, 1 - yield, runs);
  }
  // So many failures, or fewer, are no evidence against the target.
  const std::size_t tolerated = largest_where(runs, [&](std::size_t failures) {
    return failures == 0 || 1 - at_most(failures - 1, 1 - target, runs) > 1 - upper_confidence;
  });
  return 1 - at_most(tolerated, 1 - yield, runs);
}

std::vector<Judgement> judged(const StudyData& runs, const std::string& what) {
  require_independent_runs(runs, what);
  return judge_all(runs);
}

PairedShare paired_change(const StudyData& confirming, const std::vector<Judgement>& reference,
                          const StudyData& runs, const std::vector<Judgement>& joint,
                          double confidence) {
  std::map<std::int64_t, bool> meets;
  for (const std::size_t i : first_runs(confirming))
    meets[confirming.row[i]] = reference[i] == Judgement::meets;
  std::size_t pairs = 0, gained = 0, lost = 0;
  for (const std::size_t i : first_runs(runs)) {
    const auto partner = meets.find(runs.row[i]);
    if (partner == meets.end()) continue;
    const bool now = joint[i] == Judgement::meets;
    ++pairs;
    gained += now && !partner->second;
    lost += !now && partner->second;
  }
  return paired_share(pairs, gained, lost, confidence);
}

std::vector<QuantityChange> quantity_changes(const StudyData& confirming, const StudyData& runs,
                                             double confidence) {
  std::vector<QuantityChange> changes;
  for (const MatchedRuns& pairs : matched_runs(confirming, runs)) {
    const auto& limits = confirming.plan.limits;
    if (std::any_of(limits.begin(), limits.end(),
                    [&](const Limit& limit) { return limit.quantity == pairs.quantity; }))
      changes.push_back({pairs.quantity, pairs.unit,
                         paired_difference(pairs.reference, pairs.values, confidence)});
  }
  return changes;
}

void answer(double target, const AssumptionVerdicts& all, AlternativeVerdict& verdict,
            double yield_if_pass, const FitShare& fit) {
  if (verdict.lower_bound >= target) {
    verdict.answer = AssumptionAnswer::holds;
    return;
  }
  if (verdict.upper_bound < target) {
    verdict.answer = AssumptionAnswer::fails;
    return;
  }
  const bool open = verdict.yield < target && yield_if_pass >= target;  // lost runs decide
  if (!open)
    verdict.runs_needed = target >= fit.bound
                              ? 0
                              : settling_runs(verdict.yield / fit.share, target / fit.bound,
                                              all.lower_confidence, all.upper_confidence);
}

std::vector<std::size_t> threats_of(const std::vector<AlternativeVerdict>& verdicts) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < verdicts.size(); ++k)
    if (verdicts[k].answer != AssumptionAnswer::holds) order.push_back(k);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const AlternativeVerdict &first = verdicts[a], &second = verdicts[b];
    if (first.answer != second.answer) return first.answer == AssumptionAnswer::fails;
    if (first.answer == AssumptionAnswer::fails) return first.yield < second.yield;
    return first.change.change.value < second.change.change.value;
  });
  return order;
}

}  // namespace

const char* answer_name(AssumptionAnswer answer) {
  constexpr const char* kNames[] = {"holds", "fails", "not resolved"};
  return kNames[static_cast<int>(answer)];
}

std::size_t settling_runs(double yield, double target, double lower_confidence,
                          double upper_confidence) {
  const auto settles = [&](std::size_t runs) {
    return settling_power(runs, yield, target, lower_confidence, upper_confidence) >= kWantedPower;
  };
  std::size_t enough = 1;
  while (!settles(enough)) {
    enough *= 2;
    if (enough > kMostSettlingRuns) return 0;
  }
  std::size_t too_few = enough / 2;
  while (enough - too_few > 1) {
    const std::size_t middle = too_few + (enough - too_few) / 2;
    (settles(middle) ? enough : too_few) = middle;
  }
  return enough;
}

AssumptionVerdicts judge_assumptions(const StudyData& confirming,
                                     const std::vector<StudyData>& alternatives,
                                     const ConfirmationRules& rules) {
  AssumptionVerdicts all;
  if (alternatives.empty()) return all;
  const auto count = static_cast<double>(alternatives.size());
  all.lower_confidence = attempt_confidence(rules);
  all.upper_confidence = 1 - (1 - all.lower_confidence) / count;
  const auto reference = judged(confirming, "the paired change of the yield");
  std::vector<double> p_values;
  for (const StudyData& runs : alternatives) {
    const auto joint = judged(runs, "the exact bound of the yield");
    AlternativeVerdict verdict;
    verdict.runs = joint.size();
    const auto number = [&](Judgement which) {
      return static_cast<std::size_t>(std::count(joint.begin(), joint.end(), which));
    };
    verdict.meeting = number(Judgement::meets);
    verdict.unknown = number(Judgement::unknown);
    const auto n = static_cast<double>(verdict.runs),
               meeting = static_cast<double>(verdict.meeting),
               perhaps = static_cast<double>(verdict.meeting + verdict.unknown);
    const double risk = 1 - all.lower_confidence;
    const FitShare fit = fit_share(runs, 0, risk);
    verdict.yield = verdict.runs > 0 ? fit.share * meeting / n : kUndefined;
    verdict.lower_bound = fit.bound * clopper_pearson_lower(meeting, n, 1 - fit.risk_left * risk);
    verdict.upper_bound = fit.share * clopper_pearson_upper(perhaps, n, all.upper_confidence);
    answer(rules.target_yield, all, verdict, verdict.runs > 0 ? fit.share * perhaps / n : 1, fit);
    verdict.change = paired_change(confirming, reference, runs, joint, rules.confidence);
    verdict.quantities = quantity_changes(confirming, runs, rules.confidence);
    p_values.push_back(verdict.change.p_value);
    all.alternatives.push_back(std::move(verdict));
  }
  const std::vector<double> adjusted = holm_adjusted(p_values);
  for (std::size_t k = 0; k < adjusted.size(); ++k) {
    AlternativeVerdict& verdict = all.alternatives[k];
    verdict.named = adjusted[k] <= kFalseAlarms / static_cast<double>(rules.attempts);
    all.holding += verdict.answer == AssumptionAnswer::holds;
    all.failing += verdict.answer == AssumptionAnswer::fails;
    all.unresolved += verdict.answer == AssumptionAnswer::not_resolved;
  }
  all.threats = threats_of(all.alternatives);
  return all;
}

}  // namespace cagetol
