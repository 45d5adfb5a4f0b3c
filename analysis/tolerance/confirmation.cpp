#include "analysis/tolerance/confirmation.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <fstream>

#include "analysis/study/refused.hpp"

namespace cagetol {
namespace {

/// Of the runs, which are of cages that fit.
double risk_of_runs(const ConfirmationRules& rules) {
  return rules.fit.risk_left * (1 - attempt_confidence(rules));
}

/// Whether `runs` with `failures` confirm. The Clopper-Pearson bound reaches the target exactly
/// when so few failures have at most the probability alpha/m at the target yield.
bool confirms(std::size_t failures, std::size_t runs, const ConfirmationRules& rules) {
  return can_confirm(rules) &&
         gsl_cdf_binomial_P(static_cast<unsigned>(failures),
                            1 - rules.target_yield / rules.fit.bound,
                            static_cast<unsigned>(runs)) <= risk_of_runs(rules);
}

}  // namespace

ConfirmationRules confirmation_rules(const StudyPlan& study, std::size_t most_runs) {
  return {study.target_yield, study.confidence, std::max<std::size_t>(study.campaign.attempts, 1),
          most_runs};
}

ConfirmationRules rules_for(ConfirmationRules rules, const StudyData& runs, std::size_t candidate) {
  rules.fit = fit_share(runs, candidate, 1 - attempt_confidence(rules));
  return rules;
}

bool can_confirm(const ConfirmationRules& rules) {
  return rules.target_yield < rules.fit.bound;
}

double attempt_confidence(const ConfirmationRules& rules) {
  return 1 - (1 - rules.confidence) / static_cast<double>(rules.attempts);
}

std::size_t confirming_runs(std::size_t failures, const ConfirmationRules& rules) {
  if (!can_confirm(rules))
    throw Refused("no number of runs confirms a target yield of 1, or of the share that fits");
  std::size_t enough = failures + 1;
  while (!confirms(failures, enough, rules)) enough *= 2;
  std::size_t too_few = failures;
  while (enough - too_few > 1) {
    const std::size_t middle = too_few + (enough - too_few) / 2;
    (confirms(failures, middle, rules) ? enough : too_few) = middle;
  }
  return enough;
}

std::optional<std::size_t> allowed_failures(std::size_t runs, const ConfirmationRules& rules) {
  if (runs == 0 || !confirms(0, runs, rules)) return std::nullopt;
  std::size_t failures = 0, too_many = runs;
  while (too_many - failures > 1) {
    const std::size_t middle = failures + (too_many - failures) / 2;
    (confirms(middle, runs, rules) ? failures : too_many) = middle;
  }
  return failures;
}

double confirming_probability(double yield, std::size_t runs, const ConfirmationRules& rules) {
  const auto failures = allowed_failures(runs, rules);
  if (!failures) return 0;
  return gsl_cdf_binomial_P(static_cast<unsigned>(*failures),
                            std::max(1 - yield / rules.fit.share, 0.0),
                            static_cast<unsigned>(runs));
}

std::size_t confirmation_size(double yield, const ConfirmationRules& rules) {
  std::size_t runs = confirming_runs(0, rules);
  for (std::size_t failures = 0;; ++failures) {
    const std::size_t next = confirming_runs(failures, rules);
    if (failures > 0 && next > rules.most_runs) return runs;
    runs = next;
    if (confirming_probability(yield, runs, rules) >= kWantedPower) return runs;
  }
}

Confirmation judge_confirmation(const StudyData& study, const ConfirmationRules& planned) {
  require_independent_runs(study, "the exact bound of the yield");
  const ConfirmationRules rules = rules_for(planned, study, 0);
  const auto joint = judge_all(study);
  Confirmation result;
  result.runs = joint.size();
  result.meeting =
      static_cast<std::size_t>(std::count(joint.begin(), joint.end(), Judgement::meets));
  result.unknown =
      static_cast<std::size_t>(std::count(joint.begin(), joint.end(), Judgement::unknown));
  const std::vector<double> equal(joint.size(), 1.0);
  result.yield = yield_of_all(
      estimate_yield(study, joint, equal, Resampling(study, 1), 1 - risk_of_runs(rules)),
      rules.fit);
  result.judged_again = study.judged_again;
  result.passed = result.runs > 0 && confirms(result.runs - result.meeting, result.runs, rules);
  return result;
}

bool is_judged_again(const std::filesystem::path& attempt, const StudyPlan& plan) {
  std::ifstream stream(attempt / kJudgedByFile);
  const auto before = stream ? nlohmann::ordered_json::parse(stream, nullptr, false)
                             : judgement_of(read_study_plan(plan.whole.dump(), ""));
  return before != judgement_of(plan);
}

JudgedAttempts judge_attempts(const std::vector<StudyData>& attempts) {
  JudgedAttempts judged;
  std::optional<double> bound;  // of those that passed one after another
  bool some_passed = false;
  for (const StudyData& attempt : attempts) {
    const ConfirmationRules rules = confirmation_rules(attempt.plan, 0);
    judged.attempts.push_back(judge_confirmation(attempt, rules));
    const auto& [runs, meeting, unknown, yield, passed, again] = judged.attempts.back();
    if (passed) {
      bound = std::min(bound.value_or(1), yield.lower_bound);
      judged.lower_bound = *bound;
    } else {
      judged.lower_bound = some_passed ? rules.target_yield : yield.lower_bound;
      bound.reset();
    }
    if (passed || !some_passed) judged.decisive = judged.attempts.size() - 1;
    some_passed = some_passed || passed;
  }
  return judged;
}

bool is_complete(const StudyData& attempt) {
  const auto planned = static_cast<std::size_t>(attempt.design.samples_planned);
  if (attempt.size() >= planned) return true;
  const ConfirmationRules rules = rules_for(confirmation_rules(attempt.plan, 0), attempt, 0);
  const Confirmation judged = judge_confirmation(attempt, rules);
  return judged.runs - judged.meeting > allowed_failures(planned, rules).value_or(planned);
}

std::size_t surest_attempt(const std::vector<Confirmation>& attempts) {
  for (std::size_t i = attempts.size(); i-- > 0;)
    if (attempts[i].passed) return i;
  const auto less_sure = [](const Confirmation& a, const Confirmation& b) {
    return a.yield.lower_bound < b.yield.lower_bound;
  };
  return static_cast<std::size_t>(std::max_element(attempts.begin(), attempts.end(), less_sure) -
                                  attempts.begin());
}

}  // namespace cagetol
