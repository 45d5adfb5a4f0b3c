// What becomes of the verdict under alternatives of assumptions.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/report/assumption_runs.hpp"
#include "analysis/report/json_parts.hpp"
#include "analysis/sensitivity/features.hpp"
#include "analysis/statistics/summary.hpp"
#include "analysis/tolerance/assumption_verdict.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kMostNamed = 4;

std::string with_value(const AssumedValue& alternative) {
  return fmt::format("{} = {}", alternative.key, alternative.value);
}

/// Mean of a quantity with these bands less that with the narrowest candidate; nothing where one of
/// them has too few effective runs.
class ToleranceChange {
 public:
  ToleranceChange(const ReportBasis& basis, const Tolerance& tolerance) : basis_(basis) {
    const StudyData& runs = basis.runs;
    const auto& candidates = runs.plan.candidates;
    if (candidates.empty()) return;
    std::size_t narrowest = 0, chosen = candidates.size();
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      if (same_tolerance(snapped_tolerance(runs, candidates[k]), tolerance)) chosen = k;
      if (candidates[k].bands_mm < candidates[narrowest].bands_mm) narrowest = k;
    }
    if (chosen == candidates.size() || chosen == narrowest) return;
    const MixtureWeights mixture = mixture_weights(runs);
    wide_ = mixture.candidate[chosen];
    narrow_ = mixture.candidate[narrowest];
    known_ = effective_sample_size(wide_) >= kLeastEffectiveRuns &&
             effective_sample_size(narrow_) >= kLeastEffectiveRuns;
  }

  Json of(const std::string& quantity) const {
    const Column* column = find_quantity(basis_.runs, quantity);
    if (!known_ || column == nullptr) return nullptr;
    const auto values = ok_values(basis_.runs, column->values);
    const auto mean = [&](std::span<const double> drawn, const std::vector<double>& weights) {
      std::vector<double> product(drawn.begin(), drawn.end());
      for (std::size_t i = 0; i < product.size(); ++i) product[i] *= weights[i];
      return weighted_mean(values, product);
    };
    return to_json(basis_.resampling.estimate(
        [&](std::span<const double> drawn) { return mean(drawn, wide_) - mean(drawn, narrow_); },
        basis_.confidence));
  }

 private:
  const ReportBasis& basis_;
  std::vector<double> wide_, narrow_;
  bool known_ = false;
};

Json change_json(const AlternativeVerdict& verdict) {
  Json change = to_json(verdict.change.change);
  change["pairs"] = verdict.change.pairs;
  change["gained"] = verdict.change.gained;
  change["lost"] = verdict.change.lost;
  change["p_value"] = verdict.change.p_value;
  change["adjusted_p_value"] = verdict.adjusted_p;
  change["named"] = verdict.named;
  return change;
}

Json alternative_json(const AssumptionPlan& plan, const AssumedValue& alternative,
                      const AlternativeVerdict& verdict, const ToleranceChange& tolerance) {
  Json quantities = Json::array();
  for (const QuantityChange& quantity : verdict.quantities)
    quantities.push_back({{"quantity", quantity.quantity},
                          {"unit", quantity.unit},
                          {"pairs", quantity.paired.pairs},
                          {"confirming_mean", number(quantity.paired.first_mean)},
                          {"change", to_json(quantity.paired.difference)},
                          {"change_by_tolerance", tolerance.of(quantity.quantity)}});
  return {{"key", alternative.key},
          {"name", plain_name(alternative.key)},
          {"unit", alternative.unit},
          {"note", alternative.note},
          {"low", alternative.low},
          {"high", alternative.high},
          {"nominal", number(alternative.nominal)},
          {"value", alternative.value},
          {"directory", alternative_directory(plan, alternative)},
          {"runs", verdict.runs},
          {"meeting_runs", verdict.meeting},
          {"unknown_runs", verdict.unknown},
          {"yield", number(verdict.yield)},
          {"lower_bound", verdict.lower_bound},
          {"upper_bound", verdict.upper_bound},
          {"verdict", answer_name(verdict.answer)},
          {"runs_needed", verdict.runs_needed > 0 ? Json(verdict.runs_needed) : Json()},
          {"yield_change", change_json(verdict)},
          {"quantities", quantities}};
}

/// "a = 1, b = 2 and 3 more", the most threatening first.
std::string names_of(const AssumptionRuns& runs, const AssumptionVerdicts& verdicts,
                     AssumptionAnswer answer) {
  std::string names;
  std::size_t count = 0;
  for (const std::size_t k : verdicts.threats) {
    if (verdicts.alternatives[k].answer != answer) continue;
    if (++count <= kMostNamed) names += (count > 1 ? ", " : "") + with_value(runs.alternatives[k]);
  }
  if (count > kMostNamed) names += fmt::format(" and {} more", count - kMostNamed);
  return names;
}

std::string statement_of(const AssumptionRuns& runs, const AssumptionVerdicts& verdicts) {
  const std::size_t planned = runs.plan.alternatives.size(), judged = runs.alternatives.size();
  if (runs.plan.attempt == 0 || judged == 0)
    return fmt::format("Not judged under the {} alternatives of its assumptions.", planned);
  std::string text =
      fmt::format("The target of the yield holds under {} of {} alternatives of the assumptions",
                  verdicts.holding, judged);
  if (verdicts.failing > 0)
    text += "; it fails under " + names_of(runs, verdicts, AssumptionAnswer::fails);
  if (verdicts.unresolved > 0)
    text +=
        "; it is not resolved under " + names_of(runs, verdicts, AssumptionAnswer::not_resolved);
  text += ".";
  if (judged < planned) text += fmt::format(" {} are not run yet.", planned - judged);
  if (!verdicts.threats.empty())
    text += fmt::format(" Measuring {} would settle most.",
                        runs.alternatives[verdicts.threats.front()].key);
  return text;
}

}  // namespace

Json assumption_verdicts_json(const ReportBasis& basis, const std::vector<StudyData>& confirmations,
                              const std::optional<AssumptionRuns>& runs, Json& verdict) {
  if (!runs) return nullptr;
  const AssumptionPlan& plan = runs->plan;
  AssumptionVerdicts verdicts;
  Json alternatives = Json::array();
  if (!runs->alternatives.empty()) {
    const StudyData& attempt = confirmations[plan.attempt - 1];
    verdicts = judge_assumptions(attempt, runs->runs, confirmation_rules(basis.study.plan, 0));
    const ToleranceChange tolerance(basis, tolerance_tried(attempt));
    for (std::size_t k = 0; k < runs->alternatives.size(); ++k)
      alternatives.push_back(
          alternative_json(plan, runs->alternatives[k], verdicts.alternatives[k], tolerance));
  }
  const std::string statement = statement_of(*runs, verdicts);
  verdict["statement"] = verdict["statement"].get<std::string>() + " " + statement;
  return {
      {"statement", statement},
      {"attempt", plan.attempt > 0 ? Json(fmt::format("confirm-{}", plan.attempt)) : Json()},
      {"planned", plan.alternatives.size()},
      {"judged", alternatives.size()},
      {"runs_each", plan.runs},
      {"confirming_runs", plan.confirming},
      {"settling_runs", plan.settling > 0 ? Json(plan.settling) : Json()},
      {"text", assumption_plan_text(plan)},
      {"lower_confidence", verdicts.lower_confidence},
      {"upper_confidence", verdicts.upper_confidence},
      {"holds", verdicts.holding},
      {"fails", verdicts.failing},
      {"not_resolved", verdicts.unresolved},
      {"measure_first",
       verdicts.threats.empty() ? Json() : Json(runs->alternatives[verdicts.threats.front()].key)},
      {"alternatives", alternatives}};
}

}  // namespace cagetol
