// Fresh independent runs at one tolerance: the only thing that confirms it.
//
// The best of many noisy candidates looks too good, so the bound that chose it claims nothing.
// Confirming runs are new and independent, their bound is exact (Clopper-Pearson). At most m
// attempts are planned beforehand and each has the confidence 1 - alpha/m: whatever the attempts
// are and whenever they stop, the probability that any of them confirms a tolerance whose yield is
// below the target is at most alpha = 1 - confidence (Bonferroni). An attempt after one that passed
// shares its alpha/m: the first tolerance below the target that is tried is confirmed with at most
// that probability, and its failure ends the sequence. An attempt ends when its allowed failures
// are used up: the exact bounds hold at such a stop, for P(fewer runs) is that of as many failures.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "analysis/tolerance/fit_share.hpp"

namespace cagetol {

struct ConfirmationRules {
  double target_yield = 0.95, confidence = 0.95;
  std::size_t attempts = 1;   ///< m
  std::size_t most_runs = 0;  ///< that one attempt may have
  FitShare fit = {};          ///< of the tolerance that is tried; yields contain it, runs do not
};

ConfirmationRules confirmation_rules(const StudyPlan& study, std::size_t most_runs);

/// The same for a candidate of the runs.
ConfirmationRules rules_for(ConfirmationRules rules, const StudyData& runs, std::size_t candidate);

/// Whether some number of runs confirms.
bool can_confirm(const ConfirmationRules& rules);

/// 1 - (1 - confidence) / m.
double attempt_confidence(const ConfirmationRules& rules);

/// Fewest runs that confirm when `failures` of them fail. Throws Refused unless
/// can_confirm().
std::size_t confirming_runs(std::size_t failures, const ConfirmationRules& rules);

/// Largest number of failing runs with which `runs` confirm; nothing when even none would not.
std::optional<std::size_t> allowed_failures(std::size_t runs, const ConfirmationRules& rules);

/// Probability that `runs` runs of a tolerance with this yield confirm it.
double confirming_probability(double yield, std::size_t runs, const ConfirmationRules& rules);

/// How sure an attempt should be of success, if its yield is as expected.
inline constexpr double kWantedPower = 0.9;

/// Fewest runs, up to `most_runs`, that confirm a tolerance of this yield with kWantedPower; where
/// none do, the largest number up to `most_runs` at which one more failure becomes affordable. At
/// least confirming_runs(0).
std::size_t confirmation_size(double yield, const ConfirmationRules& rules);

/// One attempt, judged by rules_for() its tolerance. Jammed runs and runs without a result count as
/// not meeting the limits.
struct Confirmation {
  std::size_t runs = 0, meeting = 0, unknown = 0;
  Yield yield;  ///< bounds at attempt_confidence()
  bool passed = false;
  bool judged_again = false;  ///< StudyData::judged_again: it passed or failed, and claims nothing
  bool confirms() const { return passed && !judged_again; }
};

/// In the directory of an attempt: what its runs were to be judged by when the first was made.
inline constexpr const char* kJudgedByFile = "judged_by.json";

/// Whether the runs of an attempt's directory were to be judged by something else; without that
/// file by what their study.h5 says.
bool is_judged_again(const std::filesystem::path& attempt, const StudyPlan& plan);

/// Throws Refused unless the runs are independent.
Confirmation judge_confirmation(const StudyData& study, const ConfirmationRules& planned);

/// Place of the last attempt that passed, the widest; where none did, of the one with the highest
/// lower bound.
std::size_t surest_attempt(const std::vector<Confirmation>& attempts);

/// The attempts of a campaign, judged each with its own share of the error.
struct JudgedAttempts {
  std::vector<Confirmation> attempts;
  std::size_t decisive = 0;  ///< the last that passed; where none did, the last
  /// Of the decisive one. Where it followed others that passed, it is the least of their bounds,
  /// and the target where one that failed followed it (Hsu and Berger,
  /// J. Am. Stat. Assoc. 94, 1999, 468): so it holds with the confidence, whatever attempt decides.
  double lower_bound = 0;
};
JudgedAttempts judge_attempts(const std::vector<StudyData>& attempts);

/// Whether all planned runs are there, or those up to the one that used up the allowed failures.
bool is_complete(const StudyData& attempt);

}  // namespace cagetol
