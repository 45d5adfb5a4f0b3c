// What becomes of the verdict under alternatives of assumptions.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

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

/// Mean of a quantity with these tolerances less that with the narrowest: the sum over the
/// dimensions of each one's change, all others taken from all of their candidates, for single
/// candidates have few runs. Nothing where a tolerance has too few effective runs.
class ToleranceChange {
 public:
  ToleranceChange(const ReportBasis& basis, const Candidate& tolerance) : basis_(basis) {
    const auto& candidates = basis.runs.plan.candidates;
    if (candidates.empty()) return;
    const MixtureWeights mixture = mixture_weights(basis.runs);
    for (std::size_t d = 0; d < tolerance.tolerance_widths_mm.size(); ++d) {
      double narrowest = std::numeric_limits<double>::infinity();
      for (const Candidate& candidate : candidates)
        narrowest = std::min(narrowest, candidate.tolerance_widths_mm[d]);
      Step step{weights_with(mixture, tolerance, d, tolerance.tolerance_widths_mm[d]),
                weights_with(mixture, tolerance, d, narrowest)};
      known_ = known_ && effective_sample_size(step.wide) >= kMinimumEffectiveRuns &&
               effective_sample_size(step.narrow) >= kMinimumEffectiveRuns;
      steps_.push_back(std::move(step));
    }
  }

  Json of(const std::string& quantity) const {
    const Column* column = find_quantity(basis_.runs, quantity);
    if (steps_.empty() || !known_ || column == nullptr) return nullptr;
    const auto values = ok_values(basis_.runs, column->values);
    const auto mean = [&](std::span<const double> drawn, const std::vector<double>& weights) {
      std::vector<double> product(drawn.begin(), drawn.end());
      for (std::size_t i = 0; i < product.size(); ++i) product[i] *= weights[i];
      return weighted_mean(values, product);
    };
    return to_json(basis_.resampling.estimate(
        [&](std::span<const double> drawn) {
          double change = 0;
          for (const Step& step : steps_)
            change += mean(drawn, step.wide) - mean(drawn, step.narrow);
          return change;
        },
        basis_.confidence));
  }

 private:
  /// Weights of the runs with a dimension's tolerance as it is and as the narrowest.
  struct Step {
    std::vector<double> wide, narrow;
  };

  /// All candidates with this tolerance of a dimension, at the centres of the tolerance; as wide as
  /// it, in the same zone.
  std::vector<double> weights_with(const MixtureWeights& mixture, const Candidate& tolerance,
                                   std::size_t dimension, double tolerance_width_mm) const {
    const auto& candidates = basis_.runs.plan.candidates;
    std::vector<std::size_t> with;
    for (std::size_t k = 0; k < candidates.size(); ++k) {
      const Candidate& own = candidates[k];
      const double snapped = snapped_tolerances(basis_.runs, own)[dimension],
                   width = own.tolerance_widths_mm[dimension];
      const bool other_zone = tolerance_width_mm == tolerance.tolerance_widths_mm[dimension] &&
                              own.middle(dimension) != tolerance.middle(dimension);
      if (!other_zone &&
          same_centres({own.tolerance_widths_mm, own.shifts},
                       {tolerance.tolerance_widths_mm, tolerance.shifts}) &&
          (same_tolerances({snapped}, {tolerance_width_mm}) ||
           same_tolerances({width}, {tolerance_width_mm})))
        with.push_back(k);
    }
    if (with.empty()) return std::vector<double>(basis_.runs.size(), 0.0);
    return average_weights(mixture, with);
  }

  const ReportBasis& basis_;
  std::vector<Step> steps_;
  bool known_ = true;
};

Json change_json(const AlternativeVerdict& verdict) {
  Json change = to_json(verdict.change.change);
  change["gained"] = verdict.change.gained;
  change["lost"] = verdict.change.lost;
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

/// Each assumption once, with its value in the study; null where that is no number.
Json ranges_json(const AssumptionPlan& plan) {
  Json list = Json::array();
  for (const AssumedValue& each : plan.alternatives)
    if (list.empty() || list.back()["key"] != each.key)
      list.push_back({{"key", each.key},
                      {"name", plain_name(each.key)},
                      {"unit", each.unit},
                      {"value", number(each.nominal)},
                      {"low", each.low},
                      {"high", each.high}});
  return list;
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

void add_used_values(const Json& bearing, const char* list, const char* name, Json& chapter) {
  const Json assumed = bearing.is_object() ? bearing.value("assumed", Json::object()) : Json();
  for (Json& entry : chapter.is_null() ? chapter : chapter[list]) {
    const auto used = assumed.find(entry["key"].get<std::string>());
    if (used == assumed.end() || !entry[name].is_null()) continue;
    entry[name] = (*used)["value"], entry["automatic"] = (*used)["automatic"];
  }
}

Json assumption_verdicts_json(const ReportBasis& basis, const std::vector<StudyData>& confirmations,
                              const std::optional<AssumptionRuns>& runs, Json& verdict) {
  if (!runs) return nullptr;
  const AssumptionPlan& plan = runs->plan;
  AssumptionVerdicts verdicts;
  Json alternatives = Json::array();
  if (!runs->alternatives.empty()) {
    const StudyData& attempt = confirmations[plan.attempt - 1];
    verdicts = judge_assumptions(attempt, runs->runs, confirmation_rules(attempt.plan, 0));
    const ToleranceChange tolerance(basis, attempt.plan.candidates.front());
    for (std::size_t k = 0; k < runs->alternatives.size(); ++k)
      alternatives.push_back(
          alternative_json(plan, runs->alternatives[k], verdicts.alternatives[k], tolerance));
  }
  const std::string statement = statement_of(*runs, verdicts);
  verdict["statement"] = verdict["statement"].get<std::string>() + " " + statement;
  return {
      {"statement", statement},
      {"attempt", plan.attempt > 0 ? Json(fmt::format("confirm-{}", plan.attempt)) : Json()},
      {"judged", alternatives.size()},
      {"runs_in_all",
       plan.alternatives.size() * (plan.runs > 0 ? plan.runs : automatic_runs(plan))},
      {"command", alternatives.empty() && plan.attempt > 0
                      ? Json("cagetol recommend STUDY -o DIR --set "
                             "recommend.assumption_samples=auto")
                      : Json()},
      {"ranges", ranges_json(plan)},
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
