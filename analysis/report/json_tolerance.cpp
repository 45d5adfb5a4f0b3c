// Yield against tolerance, and the verdict.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/json_parts.hpp"
#include "analysis/sensitivity/features.hpp"
#include "analysis/tolerance/jam_onset.hpp"
#include "mc/study_file/named_law.hpp"

namespace cagetol {
namespace {

/// "97.3 %": as many decimals as the distance to 100 % needs.
std::string percent(double share) {
  const double distance = std::min(std::abs(1 - share), std::abs(share));
  const int decimals = distance >= 0.1 || distance == 0 ? 0 : distance >= 0.01 ? 1 : 2;
  return fmt::format("{:.{}f} %", 100 * share, std::max(decimals, share > 0.9 ? 1 : 0));
}

/// A stated share as stated: "95 %".
std::string plain_percent(double share) {
  return fmt::format("{:.6g} %", 100 * share);
}

bool shown(const Yield& yield) {
  return yield.ess >= kMinimumEffectiveRuns;
}

/// Where the centre of a dimension is in question.
Json nominal_json(const ReportBasis& basis, std::size_t dimension) {
  const ToleranceDimension& plan = basis.study.plan.dimensions[dimension];
  const InputColumns* input = find_input(basis.study, plan.key);
  return plan.centres.empty() || input == nullptr ? Json() : Json(input->nominal.front());
}

/// Nominal values of a candidate; null where a dimension's is not in question.
Json candidate_centres(const ReportBasis& basis, const Candidate& candidate) {
  Json list = Json::array();
  for (std::size_t d = 0; d < basis.study.plan.dimensions.size(); ++d) {
    const Json nominal = nominal_json(basis, d);
    list.push_back(nominal.is_null() ? Json()
                                     : Json(nominal.get<double>() + candidate.centre_shift(d)));
  }
  return list;
}

Json candidates_json(const ReportBasis& basis, const YieldCurves& curves) {
  Json list = Json::array();
  for (std::size_t k = 0; k < curves.candidates.size(); ++k) {
    const Candidate& plan = basis.study.plan.candidates[k];
    const auto& jam = basis.study.jam.candidate;
    Json drawings = Json::array();
    for (std::size_t d = 0; d < plan.grades.size(); ++d)
      drawings.push_back(drawing_of(basis.study, d, plan.grades[d], plan.tolerance_widths_mm[d],
                                    plan.centre_shift(d)));
    list.push_back(
        {{"candidate", k},
         {"tolerance_widths_mm", plan.tolerance_widths_mm},
         {"shifts", plan.all_shifts()},
         {"grades", plan.grades},
         {"drawings", drawings},
         {"centres", candidate_centres(basis, plan)},
         {"shown", shown(curves.candidates[k])},
         {"pooled", curves.candidates[k].pooled},
         {"jam_share", k < jam.size() ? Json(jam[k]) : Json()},
         {"jam_text", k < jam.size() ? Json(jam_text(jam[k], basis.runs.jam.draws)) : Json()},
         {"yield", to_json(curves.candidates[k])}});
  }
  return list;
}

Json dimensions_json(const ReportBasis& basis, const YieldCurves& curves,
                     const std::vector<BindingTest>& tests) {
  Json list = Json::array();
  for (std::size_t d = 0; d < curves.dimensions.size(); ++d) {
    const BindingTest& test = tests[d];
    Json levels = Json::array();
    for (const LevelYield& level : curves.dimensions[d].levels)
      levels.push_back({{"tolerance_width_mm", level.tolerance_width_mm},
                        {"grade", level.grade},
                        {"name", tolerance_name(level.grade, level.tolerance_width_mm)},
                        {"shown", shown(level.yield)},
                        {"yield", to_json(level.yield)}});
    list.push_back({{"key", test.key},
                    {"name", plain_name(test.key)},
                    {"nominal", nominal_json(basis, d)},
                    {"levels", levels},
                    {"binding", binding_name(test.answer)},
                    {"largest_loss", number(test.largest_loss)},
                    {"largest_loss_bound", number(test.largest_loss_bound)},
                    {"allowed_loss", test.allowed_loss}});
  }
  return list;
}

/// By dimension; empty where the study file does not say.
Json jams_json(const ReportBasis& basis) {
  Json list = Json::array();
  const auto optional = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json();
  };
  for (const JamCurve& curve : basis.study.jam.curves) {
    const JamOnset onset = jam_onset(curve, basis.study.plan.target_yield);
    list.push_back({{"key", curve.key},
                    {"name", plain_name(curve.key)},
                    {"tolerance_width_mm", curve.tolerance_width_mm},
                    {"share", curve.share},
                    {"ppm_mm", optional(onset.ppm_mm)},
                    {"limit_mm", optional(onset.limit_mm)}});
  }
  return list;
}

/// Share of the variance of a dimension that is from cage to cage; null where it has but one part.
Json lot_share_json(const StudyPlan& plan, const std::string& key) {
  for (const InputPlan& input : plan.inputs) {
    if (input.key != key || input.lot.is_null() || input.pocket.is_null()) continue;
    if (!knows_law(input.lot) || !knows_law(input.pocket)) return nullptr;
    const double lot = standard_deviation(read_law(input.lot, key)),
                 pocket = standard_deviation(read_law(input.pocket, key));
    return lot * lot / (lot * lot + pocket * pocket);
  }
  return nullptr;
}

/// On what the share of cages that fit hangs, beside the tolerance of dimension d.
Json fit_json(const StudyData& runs, const Recommendation& result, std::size_t d) {
  const JamShares& jam = runs.jam;
  const std::size_t place = result.candidate * runs.plan.dimensions.size() + d;
  if (place >= jam.off_centre.size()) return nullptr;
  return {{"share", 1 - jam.candidate[result.candidate]},
          {"offset_mm", kOffCentre * result.tolerances[d].tolerance_width_mm},
          {"off_centre", 1 - jam.off_centre[place]},
          {"lot_share", lot_share_json(runs.plan, runs.plan.dimensions[d].key)},
          {"pockets_alone", 1 - jam.pockets_alone[place]},
          {"lots_alone", 1 - jam.lots_alone[place]}};
}

std::string drawing_of(const StudyData& runs, const Recommendation& result, std::size_t d) {
  const RecommendedTolerance& tolerance = result.tolerances[d];
  return drawing_of(runs, d, tolerance.grade, tolerance.tolerance_width_mm,
                    runs.plan.candidates[result.candidate].centre_shift(d));
}

Json tolerances_json(const StudyData& runs, const Recommendation& result) {
  Json widths = Json::array();
  for (std::size_t d = 0; d < result.tolerances.size(); ++d) {
    const RecommendedTolerance& tolerance = result.tolerances[d];
    widths.push_back({{"key", tolerance.key},
                      {"name", tolerance.name},
                      {"not_binding", tolerance.not_binding},
                      {"tolerance_width_mm", tolerance.tolerance_width_mm},
                      {"grade", tolerance.grade},
                      {"drawing", drawing_of(runs, result, d)},
                      {"centre", tolerance.centre ? Json(*tolerance.centre) : Json()},
                      {"widest_studied", tolerance.widest_studied},
                      {"fit", fit_json(runs, result, d)}});
  }
  return widths;
}

Json steps_json(const Recommendation& result) {
  Json steps = Json::array();
  for (const StepEffect& step : result.steps)
    steps.push_back({{"key", step.key},
                     {"name", plain_name(step.key)},
                     {"from", step.from},
                     {"to", step.to},
                     {"change", step.change},
                     {"lower", step.lower},
                     {"upper", step.upper}});
  return steps;
}

std::string list_of(const std::vector<std::string>& items) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i)
    text += (i == 0 ? "" : i + 1 == items.size() ? " and " : ", ") + items[i];
  return text;
}

/// Whether more runs give no judgement than the target lets fail.
bool unknown_runs_decide(const StudyPlan& plan, const Yield& yield) {
  return yield.upper_bound >= plan.target_yield &&
         yield.unknown_runs > (1 - plan.target_yield) * yield.runs;
}

std::string statement_of(const ReportBasis& basis, const Recommendation& result,
                         bool some_binding) {
  const StudyPlan& plan = basis.study.plan;
  std::vector<std::string> widths, free;
  for (std::size_t d = 0; d < result.tolerances.size(); ++d)
    (result.tolerances[d].not_binding ? free : widths)
        .push_back(result.tolerances[d].name + " " + drawing_of(basis.study, result, d));
  std::string text;
  if (widths.empty())
    text = "No tolerance studied limits the yield: the study gives no tolerance to print.";
  else if (result.meets_target)
    text = fmt::format("Recommended: {}.", list_of(widths));
  else if (unknown_runs_decide(plan, result.yield))
    text = fmt::format(
        "Not known whether a candidate tolerance meets the target: {:.0f} of {:.0f} runs give no "
        "judgement, and the yield lies between {} and {}, as they fail or pass. The best of those "
        "with enough runs is {}.",
        result.yield.unknown_runs, result.yield.runs, percent(result.yield.if_unknown_fail),
        percent(result.yield.if_unknown_pass), list_of(widths));
  else if (!result.none_can_meet)
    text = fmt::format(
        "Not known whether a candidate tolerance meets the target: the runs are too few. The best "
        "of those with enough is {}.",
        list_of(widths));
  else
    text = fmt::format(
        "No candidate tolerance meets the target. The best of those with enough runs is {}.{}",
        list_of(widths),
        some_binding ? ""
                     : " No difference between the widths studied is significant: "
                       "look at the contributors.");
  text += fmt::format(
      " The estimated yield is {}, at least {}{} with {} confidence{}; the target is {}.",
      percent(result.yield.if_unknown_fail), percent(result.yield.lower_bound),
      result.meets_target ? "" : " and at most " + percent(result.yield.upper_bound),
      plain_percent(plan.confidence),
      result.yield.unknown_runs > 0 ? ", runs without a result counted as failing" : "",
      plain_percent(plan.target_yield));
  if (!free.empty())
    text += fmt::format(
        " Not binding within the range studied: {}; the yield holds with it at that width, which "
        "is no "
        "recommendation.",
        list_of(free));
  if (result.yield.ess < kFewestEffectiveRuns)
    text += fmt::format(" Only {:.0f} effective runs support it: the bound is sound, but rough.",
                        result.yield.ess);
  if (result.meets_target && !widths.empty())
    text += " Unconfirmed: no fresh runs were made at this tolerance.";
  return text;
}

std::string statement_without_candidates(const ReportBasis& basis, bool too_few) {
  if (too_few && static_cast<std::int64_t>(basis.study.size()) < basis.study.design.samples_planned)
    return fmt::format(
        "The runs are not finished: {} of {} are there, too few of every candidate to say more.",
        basis.study.size(), basis.study.design.samples_planned);
  if (too_few)
    return fmt::format(
        "No tolerance can be recommended: no combination of candidates has {:.0f} effective runs. "
        "Run more samples, or fewer candidates, in another directory: a directory keeps the "
        "numbers of runs it was begun with (of `recommend`: raise recommend.budget_samples).",
        kMinimumEffectiveRuns);
  if (basis.study.plan.limits.empty())
    return "The study states no limits: there is nothing to judge a tolerance by.";
  if (std::string reason; !rows_follow_laws(basis.runs, &reason))
    return fmt::format("No yield and no tolerance: {}. Use the design random or lhs.", reason);
  return "The study has no candidate tolerances: the yield is that of the scatter as stated.";
}

/// What the statement amounts to, in a word.
const char* status_of(const StudyPlan& plan, const Recommendation& result) {
  if (std::all_of(result.tolerances.begin(), result.tolerances.end(),
                  [](const RecommendedTolerance& t) { return t.not_binding; }))
    return "no_tolerance";
  if (result.meets_target) return "recommended";
  if (result.none_can_meet) return "none_meets";
  return unknown_runs_decide(plan, result.yield) ? "not_known" : "open";
}

const char* status_without_candidates(const ReportBasis& basis, bool too_few) {
  if (too_few) return "too_few_runs";
  if (basis.study.plan.limits.empty()) return "no_limits";
  return rows_follow_laws(basis.runs) ? "no_candidates" : "no_yield";
}

Json tolerance_verdict(const RecommendedTolerance& tolerance) {
  if (tolerance.not_binding) return {{"tolerance_width_mm", nullptr}, {"grade", nullptr}};
  Json verdict{{"tolerance_width_mm", tolerance.tolerance_width_mm}, {"grade", tolerance.grade}};
  if (tolerance.centre) verdict["centre"] = *tolerance.centre;
  return verdict;
}

}  // namespace

void add_limits_of_size(const Json& bearing, Json& tolerance) {
  if (!bearing.is_object() || !bearing.contains("dimensions") || !tolerance.is_object()) return;
  for (Json& printed : tolerance.at("tolerances"))
    for (const Json& dimension : bearing.at("dimensions")) {
      if (dimension.at("key") != printed.at("key")) continue;
      const Json& middle =
          printed.at("centre").is_null() ? dimension.at("nominal_mm") : printed.at("centre");
      if (!middle.is_number()) continue;
      const double width = printed.at("tolerance_width_mm"), nominal = middle,
                   minimum = nominal + zone_middle(printed.at("grade"), width) - width / 2;
      const Json& fit = dimension.at("counterpart_mm");
      printed["size"] = {{"nominal_mm", nominal},
                         {"minimum_mm", minimum},
                         {"maximum_mm", minimum + width},
                         {"capability", dimension.at("capability")},
                         {"mean_mm", dimension.at("mean_share").get<double>() * width},
                         {"counterpart", dimension.at("counterpart")},
                         {"counterpart_mm", fit},
                         {"takes_counterpart", !fit.is_number() || minimum >= fit}};
    }
}

TolerancePart tolerance_json(const ReportBasis& basis,
                             const std::vector<StudyData>& confirmations) {
  const StudyPlan& plan = basis.study.plan;
  TolerancePart part;
  Json& verdict = part.verdict;
  verdict["tolerances"] = Json::object();
  const std::vector<double> equal(basis.runs.size(), 1.0);
  Yield overall = estimate_yield(basis.runs, basis.joint, equal, basis.resampling, plan.confidence);
  Recommendation result;
  Json not_binding = Json::array(), undecided = Json::array();
  bool some_binding = false;
  const bool candidates = !plan.candidates.empty() && !plan.dimensions.empty() &&
                          !plan.limits.empty() && basis.runs.size() > 0 &&
                          rows_follow_laws(basis.runs);
  if (candidates) {
    const auto [mixture, curves, tests] =
        study_tolerances(basis.runs, basis.joint, basis.resampling);
    if (confirmations.empty()) {
      result =
          recommend_tolerance(basis.runs, mixture, curves, tests, basis.joint, basis.resampling);
    } else {
      std::vector<Tolerance> tried;
      for (const StudyData& attempt : confirmations) tried.push_back(tolerance_tried(attempt));
      std::swap(tried[judge_attempts(confirmations).decisive], tried.back());
      result = recommend_allowed(
          basis.runs, mixture, curves, tests, basis.joint, basis.resampling, [&](std::size_t k) {
            return same_tolerance(snapped_tolerance(basis.runs, plan.candidates[k]), tried.back());
          });
      part.passed_over = passed_over(basis.runs, curves, tried);
    }
    for (std::size_t d = 0; d < tests.size(); ++d) {
      const bool held = result.possible ? result.tolerances[d].not_binding
                                        : tests[d].answer == Binding::not_binding;
      some_binding = some_binding || tests[d].answer == Binding::binding;
      if (held)
        not_binding.push_back(tests[d].key);
      else if (tests[d].answer != Binding::binding)
        undecided.push_back(tests[d].key);
    }
    part.tolerance = {{"candidates", candidates_json(basis, curves)},
                      {"dimensions", dimensions_json(basis, curves, tests)},
                      {"fewest_effective_runs", kMinimumEffectiveRuns},
                      {"confidence", basis.confidence},
                      {"jams", jams_json(basis)},
                      {"width_curves", width_curves_json(basis)},
                      {"note", mixture.note},
                      {"chosen_candidate", result.possible ? Json(result.candidate) : Json()},
                      {"tolerances", tolerances_json(basis.study, result)},
                      {"steps", steps_json(result)},
                      {"cost", result.cost ? Json(*result.cost) : Json()}};
    Tolerance chosen;
    for (const RecommendedTolerance& tolerance : result.tolerances)
      chosen.tolerance_widths_mm.push_back(tolerance.tolerance_width_mm);
    if (result.possible) chosen.shifts = plan.candidates[result.candidate].all_shifts();
    if (confirmations.empty() && result.possible && result.meets_target)
      part.passed_over = passed_over(
          basis.runs, curves, {snapped_tolerance(basis.runs, plan.candidates[result.candidate])});
    part.tolerance["centres"] = result.possible ? centres_json(basis, mixture, chosen) : Json();
    part.tolerance["centre_responses"] = centre_responses_json(basis);
  }
  for (const RecommendedTolerance& tolerance : result.tolerances)
    verdict["tolerances"][tolerance.key] = tolerance_verdict(tolerance);
  const Yield& yield = result.possible ? result.yield : overall;
  verdict["meets_target"] = candidates ? result.possible && result.meets_target
                                       : overall.lower_bound >= plan.target_yield;
  verdict["yield"] = to_json(yield);
  verdict["yield_lower_bound"] = plan.limits.empty() ? Json() : number(yield.lower_bound);
  verdict["target_yield"] = plan.target_yield;
  verdict["confidence"] = plan.confidence;
  verdict["confirmation"] = nullptr;
  verdict["not_binding"] = not_binding;
  verdict["undecided"] = undecided;
  verdict["status"] =
      result.possible ? status_of(plan, result) : status_without_candidates(basis, candidates);
  verdict["statement"] = result.possible ? statement_of(basis, result, some_binding)
                                         : statement_without_candidates(basis, candidates);
  return part;
}

}  // namespace cagetol
