#include "analysis/tolerance/attempt_choice.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/statistics/summary.hpp"
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
  const Yield& yield = mixture.tolerances.curves.candidates[candidate];
  return std::min(std::max(expected_yield(yield), (1 - mixture.beyond) * yield.fits),
                  share_without_jam(mixture.runs, candidate));
}

/// Where no run misses a limit: the share of normal values beyond the nearest, with the runs' means
/// and standard deviations; else 1.
double share_beyond(const StudyData& runs, const std::vector<Judgement>& joint) {
  if (!std::all_of(joint.begin(), joint.end(), [](Judgement of) { return of == Judgement::meets; }))
    return 1;
  constexpr double kNever = 1e-9;
  double share = kNever;
  const std::vector<double> equal(joint.size(), 1.0);
  for (const Limit& limit : runs.plan.limits) {
    const auto& values = find_quantity(runs, limit.quantity)->values;
    const double mean = weighted_mean(values, equal),
                 scatter = weighted_standard_deviation(values, equal);
    const auto beyond = [&](std::optional<double> bound) {
      if (bound && scatter > 0)
        share = std::max(share, gsl_cdf_ugaussian_Q(std::abs(*bound - mean) / scatter));
    };
    beyond(limit.minimum);
    beyond(limit.maximum);
  }
  return share;
}

/// Of being confirmed with so many runs, averaged over what the yield may be after the mixture's
/// effective runs (Jeffreys' prior) and as many more as a limit far away is worth.
double predicted_chance(const MixtureStudy& mixture, std::size_t candidate, std::size_t runs,
                        const ConfirmationRules& rules) {
  constexpr double kSteps = 96, kMinimumShare = 1e-6;
  const Yield& yield = mixture.tolerances.curves.candidates[candidate];
  const double passing = yield.if_unknown_fail / yield.fits * yield.ess,
               failing = yield.ess - passing, far = 1 / mixture.beyond - 1;
  double sum = 0, below = 0;
  for (double step = 1; step <= kSteps; ++step) {
    // Failing shares from 1e-6 to 1, in equal ratios.
    const double up_to = std::pow(kMinimumShare, 1 - step / kSteps);
    const double reached = gsl_cdf_beta_P(up_to, failing + 0.5, passing + far + 0.5);
    const double middle = up_to * std::pow(kMinimumShare, 0.5 / kSteps);
    sum += (reached - below) *
           confirming_probability(
               std::min((1 - middle) * yield.fits, share_without_jam(mixture.runs, candidate)),
               runs, rules);
    below = reached;
  }
  return sum;
}

/// Candidates by what the mixture and the attempts so far say of them, each attempt at the share
/// 1 / `shares` of the error.
class Choice {
 public:
  Choice(const MixtureStudy& mixture, const CampaignPlan& plan, const std::vector<Tried>& tried,
         std::size_t shares)
      : mixture_(mixture),
        tried_(tried),
        rules_(confirmation_rules(mixture.runs.plan, 0)),
        stated_(plan.settings.confirm_samples),
        left_(plan.confirm_runs - decided_runs(plan)) {
    rules_.attempts = shares;
    fewest_ = confirming_runs(0, rules_);
    for (const Tried& each : tried) ++(each.passed ? passed_ : failed_);
  }

  bool affords_attempt() const { return failed_ < rules_.attempts && left_ >= fewest_; }

  std::optional<AttemptChoice> next() const {
    if (failed_ + 1 < rules_.attempts)
      if (auto wide = widest_fair()) return wide;
    return surest([](std::size_t) { return true; });
  }

  /// What leaves the narrower one its runs.
  std::optional<AttemptChoice> widest_fair() const {
    const auto most = [&](std::size_t k) {
      const auto kept = narrower_than(k);
      return left_ - (kept ? std::min(kept->runs, left_) : 0);
    };
    const Recommendation next = widest_of(mixture_, [&](std::size_t k) {
      return promising(k) && most(k) >= fewest(k) &&
             chance(estimate_of(mixture_, k), limited(k, most(k)), rules(k)) >= kFairChance;
    });
    if (!next.meets_target) return std::nullopt;
    return AttemptChoice{size(next.candidate, most(next.candidate)), next};
  }

  std::optional<AttemptChoice> narrower_than(std::size_t wide) const {
    return surest([&](std::size_t k) { return narrower(widths(k), widths(wide)); });
  }

  /// Whether, as this sequence, both candidates take fewer runs than where the narrower one follows
  /// only if the wider one fails. Needs beyond the budget count up to four times what is left.
  bool takes_less_than(const Choice& divided, std::size_t wide, std::size_t narrow) const {
    const auto need = [&](const Choice& choice, std::size_t k) {
      return static_cast<double>(choice.size(k, 4 * left_));
    };
    const double failing =
        1 - predicted_chance(mixture_, wide, divided.size(wide, 4 * left_), divided.rules(wide));
    return need(*this, narrow) + need(*this, wide) <=
           need(divided, wide) + failing * need(divided, narrow);
  }

  /// Whether more runs of the mixture may find a candidate to try.
  bool open() const {
    for (std::size_t k = 0; k < mixture_.runs.plan.candidates.size(); ++k)
      if (mixture_.tolerances.curves.candidates[k].upper_bound >= rules_.target_yield &&
          share_without_jam(mixture_.runs, k) >= rules_.target_yield && untried(k))
        return true;
    return false;
  }

  /// What all runs left will probably confirm at this share of the error, and cannot at the other.
  std::optional<AttemptChoice> unaffordable_for(const Choice& divided) const {
    const Recommendation next = widest_of(mixture_, [&](std::size_t k) { return probable(k); });
    if (!next.meets_target || divided.fewest(next.candidate) <= left_) return std::nullopt;
    return AttemptChoice{size(next.candidate, left_), next};
  }

 private:
  bool probable(std::size_t k) const {
    return promising(k) &&
           chance(expected_of(mixture_, k), limited(k, left_), rules(k)) >= kWantedPower;
  }

  std::vector<double> widths(std::size_t k) const {
    return snapped_tolerances(mixture_.runs, mixture_.runs.plan.candidates[k]);
  }

  /// Narrower than what failed, or as wide about another centre; wider than what is confirmed.
  bool untried(std::size_t k) const {
    const StudyPlan& study = mixture_.runs.plan;
    const Tolerance own{widths(k), study.candidates[k].all_shifts()};
    return std::all_of(tried_.begin(), tried_.end(), [&](const Tried& each) {
      const auto& other = each.tolerance.tolerance_widths_mm;
      if (each.passed) {
        const double confirmed = worth_of_tolerances(study, other);
        return worth_of_tolerances(study, own.tolerance_widths_mm) >
               confirmed + kRounding * std::abs(confirmed);
      }
      return narrower(own.tolerance_widths_mm, other) ||
             (same_tolerances(own.tolerance_widths_mm, other) &&
              !same_centres(own, each.tolerance));
    });
  }

  bool promising(std::size_t k) const {
    return estimate_of(mixture_, k) >= rules_.target_yield && can_confirm(rules(k)) &&
           fewest(k) <= left_ && untried(k);
  }

  /// Its runs are of cages that fit.
  ConfirmationRules rules(std::size_t k) const { return rules_for(rules_, mixture_.runs, k); }
  std::size_t fewest(std::size_t k) const { return confirming_runs(0, rules(k)); }
  std::size_t limited(std::size_t k, std::size_t runs) const {
    return std::max(fewest(k), stated_ > 0 ? std::min(runs, stated_) : runs);
  }

  std::size_t size(std::size_t k, std::size_t most) const {
    ConfirmationRules sized = rules(k);
    sized.most_runs = limited(k, most);
    return confirmation_size(expected_of(mixture_, k), sized);
  }

  /// The widest that all runs left will probably confirm; where there is none, the widest that is
  /// nearly as sure as the surest.
  std::optional<AttemptChoice> surest(const CandidateFilter& among) const {
    Recommendation next =
        widest_of(mixture_, [&](std::size_t k) { return among(k) && probable(k); });
    if (!next.meets_target) {
      const auto predicted = [&](std::size_t k) {
        return predicted_chance(mixture_, k, size(k, left_), rules(k));
      };
      double best = passed_ > 0 ? kFairChance / kNearlyAsSure : 0;
      for (std::size_t k = 0; k < mixture_.runs.plan.candidates.size(); ++k)
        if (promising(k) && among(k)) best = std::max(best, predicted(k));
      next = widest_of(mixture_, [&](std::size_t k) {
        return promising(k) && among(k) && predicted(k) >= kNearlyAsSure * best;
      });
    }
    if (!next.meets_target) return std::nullopt;
    return AttemptChoice{size(next.candidate, left_), next};
  }

  const MixtureStudy& mixture_;
  const std::vector<Tried>& tried_;
  ConfirmationRules rules_;
  std::size_t stated_, left_, fewest_ = 0, passed_ = 0, failed_ = 0;
};

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

bool wider(const StudyData& runs, const AttemptChoice& a, const AttemptChoice& b) {
  const auto worth = [&](const AttemptChoice& of) {
    const auto& candidate = runs.plan.candidates[of.recommendation.candidate];
    return worth_of_tolerances(runs.plan, snapped_tolerances(runs, candidate));
  };
  return worth(a) > worth(b);
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
  const double beyond = share_beyond(runs, joint);
  return {std::move(runs), std::move(joint), std::move(resampling), std::move(tolerances), beyond};
}

Recommendation recommendation_of(const MixtureStudy& mixture, std::size_t candidate) {
  return widest_of(mixture, [&](std::size_t k) { return k == candidate; });
}

std::optional<AttemptChoice> choose_attempt(const MixtureStudy& mixture, CampaignPlan& plan,
                                            const std::vector<Tried>& tried) {
  if (tried.empty()) plan.error_shares = confirmation_rules(mixture.runs.plan, 0).attempts;
  const Choice choice(mixture, plan, tried, plan.error_shares);
  if (!tried.empty() || plan.error_shares == 1)
    return choice.affords_attempt() ? choice.next() : std::nullopt;
  const Choice sequence(mixture, plan, tried, 1);
  const auto wide = choice.affords_attempt() ? choice.widest_fair() : std::nullopt;
  if (!sequence.affords_attempt()) return std::nullopt;
  if (auto alone = sequence.unaffordable_for(choice);
      alone && !(wide && wider(mixture.runs, *wide, *alone))) {
    plan.error_shares = 1;
    return alone;
  }
  auto narrow = wide ? sequence.narrower_than(wide->recommendation.candidate) : std::nullopt;
  if (!narrow)
    narrow = sequence.next();
  else if (!sequence.takes_less_than(choice, wide->recommendation.candidate,
                                     narrow->recommendation.candidate))
    return wide;
  if (narrow) plan.error_shares = 1;
  return narrow;
}

bool may_find_more(const MixtureStudy& mixture, const CampaignPlan& plan,
                   const std::vector<Tried>& tried) {
  const Choice choice(mixture, plan, tried, std::max<std::size_t>(plan.error_shares, 1));
  return choice.affords_attempt() && choice.open();
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
