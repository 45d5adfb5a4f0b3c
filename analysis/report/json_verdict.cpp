// What the first page says beside the tolerance itself: its margins, what is missing for a verdict
// and the command that gets it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/json_parts.hpp"
#include "analysis/report/refining_ladder.hpp"
#include "analysis/tolerance/confirmation.hpp"
#include "analysis/tolerance/limit_margin.hpp"
#include "distributions/variance_parts.hpp"

namespace cagetol {
namespace {

constexpr const char* kStress = "cage_stress_peak_MPa";

/// Sentences of a text that follows full stops with a space and a capital letter or a figure.
std::vector<std::string> sentences_of(const std::string& text) {
  std::vector<std::string> list;
  std::size_t begin = 0;
  for (std::size_t at = text.find(". "); at != std::string::npos; at = text.find(". ", at + 1)) {
    if (at + 2 >= text.size() || !std::isalnum(static_cast<unsigned char>(text[at + 2])) ||
        std::islower(static_cast<unsigned char>(text[at + 2])))
      continue;
    list.push_back(text.substr(begin, at + 1 - begin));
    begin = at + 2;
  }
  if (begin < text.size()) list.push_back(text.substr(begin));
  return list;
}

Json step(const std::string& missing, const std::string& command) {
  return {{"missing", missing}, {"command", command.empty() ? Json() : Json(command)}};
}

bool is_staged(const ReportBasis& basis) {
  return basis.directory.find('/') != std::string::npos;
}

/// More runs of the same directory where its stages keep a budget, of another one for a sweep.
std::string more_runs(const ReportBasis& basis, double factor) {
  const double wanted = std::ceil(factor * static_cast<double>(basis.runs.size()) / 100) * 100;
  return is_staged(basis)
             ? fmt::format(
                   "cagetol recommend STUDY -o OTHER_DIR --set "
                   "recommend.budget_samples={:.0f}",
                   3 * wanted)
             : fmt::format("cagetol sweep STUDY -o OTHER_DIR --set samples={:.0f}", wanted);
}

/// Candidates narrower than any of the study's.
std::string narrower_command(const ReportBasis& basis) {
  const StudyPlan& plan = basis.study.plan;
  std::string dimensions;
  for (std::size_t d = 0; d < plan.dimensions.size(); ++d) {
    double narrowest = plan.candidates.front().tolerance_widths_mm[d];
    for (const Candidate& candidate : plan.candidates)
      narrowest = std::min(narrowest, candidate.tolerance_widths_mm[d]);
    dimensions += fmt::format(
        "{}{{key=\"{}\", tolerance_width_mm={}, candidates=[{:.3g}, {:.3g}, {:.3g}]}}",
        d == 0 ? "" : ", ", plan.dimensions[d].key, plan.dimensions[d].tolerance_width_mm,
        0.25 * narrowest, 0.5 * narrowest, narrowest);
  }
  return fmt::format("cagetol recommend STUDY -o OTHER_DIR --set 'tolerance.dimension=[{}]'",
                     dimensions);
}

bool some_dimension_binds(const Json& tolerance) {
  return std::any_of(tolerance["dimensions"].begin(), tolerance["dimensions"].end(),
                     [](const Json& dimension) { return dimension["binding"] == "binding"; });
}

/// Without a run that misses, this many confirm the target in one attempt.
std::size_t confirming_runs(const StudyPlan& plan) {
  return runs_without_miss(attempt_confidence(confirmation_rules(plan, 0)), plan.target_yield);
}

Json unconfirmed_step(const ReportBasis& basis) {
  const auto runs = confirming_runs(basis.study.plan);
  const std::string missing = fmt::format(
      "Fresh independent runs at this tolerance: {} of them confirm it if none misses a limit.",
      runs);
  if (!is_staged(basis)) return step(missing, "cagetol recommend STUDY -o OTHER_DIR");
  const std::size_t spent = basis.study.plan.campaign.budget_samples;
  return step(missing,
              fmt::format("cagetol recommend STUDY -o DIR --set recommend.budget_samples={}",
                          spent + 2 * runs));
}

Json unknown_step(const ReportBasis& basis) {
  for (std::size_t i = 0; i < basis.runs.size(); ++i)
    if (basis.joint[i] == Judgement::unknown)
      return step(
          "A judgement of the runs that gave none: their failures and replay commands are in the "
          "appendix, this is the first.",
          fmt::format("cagetol replay {} --sample {}", basis.directory, basis.runs.id[i]));
  return step("A judgement of the runs that gave none.", "");
}

/// The rest of a sweep that was stopped: what its runs say so far asks for no other step.
Json unfinished_step(const ReportBasis& basis) {
  return step(
      fmt::format("The rest of the sweep: {} of {} runs are there. The same command goes on.",
                  basis.study.size(), basis.study.design.samples_planned),
      fmt::format("cagetol {} STUDY -o DIR", is_staged(basis) ? "recommend" : "sweep"));
}

Json next_steps(const ReportBasis& basis, const Json& report) {
  const std::string status = report["verdict"]["status"];
  Json steps = Json::array();
  if (static_cast<std::int64_t>(basis.study.size()) < basis.study.design.samples_planned)
    return Json::array({unfinished_step(basis)});
  if (status == "recommended") steps.push_back(unconfirmed_step(basis));
  if (status == "not_known") steps.push_back(unknown_step(basis));
  if (status == "open")
    steps.push_back(
        step("Runs enough to tell, of which `recommend` makes as many as it needs.",
             is_staged(basis) ? more_runs(basis, 3) : "cagetol recommend STUDY -o OTHER_DIR"));
  if (status == "too_few_runs")
    steps.push_back(
        step("More runs, so that every candidate has enough effective ones.", more_runs(basis, 3)));
  if (status == "judged_again")
    steps.push_back(step("Fresh runs at this tolerance: those of its attempt had been seen before.",
                         report["verdict"]["confirmation"]["command"]));
  if (status == "not_confirmed" && basis.study.judged_again)
    steps.push_back(step("Attempts decided by these limits: the directory goes on with its runs.",
                         "cagetol recommend STUDY -o DIR"));
  if (status == "none_meets" || status == "not_confirmed") {
    if (report["tolerance"].is_object() && some_dimension_binds(report["tolerance"]))
      steps.push_back(
          step("Narrower candidates than those studied. A limit of which more than 100 % are used "
               "at the narrowest width, too, asks for another design instead.",
               narrower_command(basis)));
    else
      steps.push_back(
          step("A dimension whose tolerance changes the yield: no difference between the widths "
               "studied is significant. The limits that runs miss, below, say what has to change "
               "in the design, or more runs tell widths apart.",
               more_runs(basis, 4)));
  }
  if (status == "no_limits")
    steps.push_back(step("A limit to judge by: [[limit]] in the study, on one of these quantities.",
                         "cagetol quantities"));
  if (status == "no_candidates")
    steps.push_back(
        step("Candidate tolerances: dimensions with WIDTH, the full width in mm that the scatter "
             "of the study belongs to.",
             fmt::format("cagetol recommend STUDY -o OTHER_DIR --set "
                         "'tolerance.dimension=[{{key=\"{}\", tolerance_width_mm=WIDTH, "
                         "candidates=[\"IT9\", \"IT10\", \"IT11\", \"IT12\"]}}]'",
                         "cage.pocket_width_mm")));
  if (status == "no_yield")
    steps.push_back(step("Rows that follow the laws of the inputs.",
                         "cagetol sweep STUDY -o OTHER_DIR --set design='\"random\"'"));
  if (status == "no_runs")
    steps.push_back(step("Runs with an outcome.", "cagetol sweep STUDY -o DIR"));
  return steps;
}

/// A command that reads STUDY judges by what the plan states now.
void add_settings(Json& command, const StudyPlan& plan) {
  const std::string text = command, settings = judgement_settings(plan);
  if (text.find(" STUDY ") != std::string::npos && text.find(settings) == std::string::npos)
    command = text + settings;
}

std::string convergence_statement(const Json& report) {
  const Json& limiting = report["convergence"]["limiting"];
  if (!limiting.is_object()) return "Too few runs for a statement on their number.";
  const double needed = limiting["runs_still_needed"];
  if (needed > 0) {
    const std::string statistic = limiting["statistic"], quantity = limiting["quantity"];
    return fmt::format(
        "About {:.0f} more runs until the {} of the scatter as sampled is known as well as wanted; "
        "everything else needs fewer.{}",
        needed, statistic == "yield" ? quantity : statistic + " of " + quantity,
        report["verdict"]["status"] == "confirmed"
            ? " The verdict does not wait for them: it rests on its own fresh runs."
            : "");
  }
  for (const char* open : {"not_known", "open", "too_few_runs", "not_confirmed"})
    if (report["verdict"]["status"] == open)
      return "The quantities below are known as well as wanted, the verdict is not: what it needs "
             "stands on the first page.";
  return "Every quantity is known as well as wanted.";
}

/// Median and largest of the cage's peak stress; null without.
Json stress_json(const StudyData& runs) {
  const Column* column = find_quantity(runs, kStress);
  if (column == nullptr) return {};
  Limit largest;
  largest.quantity = kStress;
  largest.maximum = 1;
  StudyData alone = results_of(runs);
  alone.plan.limits = {largest};
  const LimitMargin margin = limit_margins(alone).front();
  if (std::isnan(margin.median)) return {};
  return {{"quantity", kStress},
          {"unit", column->unit},
          {"median", margin.median},
          {"largest", margin.extreme}};
}

/// At each operating point the limit that is the fewest standard deviations from the runs' mean, as
/// a screen says it; empty where none is known.
std::string nearest_limits(const Json& capability) {
  std::vector<std::pair<std::string, const Json*>> points;  // in the order of the limits
  for (const Json& entry : capability) {
    if (!entry["cpk"]["value"].is_number()) continue;
    const std::string quantity = entry["quantity"];
    const std::string label = quantity.substr(std::min(quantity.find('@'), quantity.size()));
    auto point = std::find_if(points.begin(), points.end(),
                              [&](const auto& known) { return known.first == label; });
    if (point == points.end()) point = points.insert(points.end(), {label, &entry});
    if (entry["cpk"]["value"] < (*point->second)["cpk"]["value"]) point->second = &entry;
  }
  std::string text;
  for (const auto& [label, entry] : points)
    text += fmt::format(
        "{}{}, {:.1f}", text.empty() ? "Nearest limit, in standard deviations of the runs: " : "; ",
        (*entry)["quantity"].get<std::string>(), 3 * (*entry)["cpk"]["value"].get<double>());
  return text.empty() ? text : text + ".";
}

/// Why no capability index is given of a limited quantity; empty: it is.
std::string no_index(const Json& report, const Json& entry) {
  constexpr double kFar = 3.3;  // ten standard deviations
  const Json& cpk = entry["cpk"]["value"];
  if (cpk.is_number() && cpk.get<double>() > kFar)
    return fmt::format(
        "the limit lies {:.0f} standard deviations of the scatter beyond the mean{}",
        3 * cpk.get<double>(),
        entry["outside_ppm"] == 0 ? "" : "; what counts as outside are cages that jam");
  for (const Json& quantity : report["quantities"]) {
    if (quantity["quantity"] != entry["quantity"]) continue;
    const Json& share = quantity["noise"]["share"]["value"];
    if (share.is_number() && share.get<double>() > 0.5)
      return "more than half of its variance is noise of the start: the share of runs beyond the "
             "limit says it all";
  }
  return {};
}

}  // namespace

Json margins_json(const ReportBasis& basis, const std::vector<StudyData>& confirmations,
                  const Json& ladder) {
  const StudyData& runs =
      confirmations.empty() ? basis.runs : confirmations[judge_attempts(confirmations).decisive];
  std::vector<double> errors;
  for (const Limit& limit : runs.plan.limits)
    errors.push_back(known_bias(ladder, basis.study, limit.quantity));
  Json each = Json::array();
  for (const LimitMargin& margin : limit_margins(runs, errors)) {
    const Column* column = find_quantity(runs, margin.limit.quantity);
    each.push_back({{"quantity", margin.limit.quantity},
                    {"unit", column == nullptr ? "" : column->unit},
                    {"text", limit_text(margin.limit, column == nullptr ? "" : column->unit)},
                    {"source", margin.limit.source},
                    {"cage_revolutions", margin.limit.cage_revolutions},
                    {"min", margin.limit.minimum ? number(*margin.limit.minimum) : Json()},
                    {"max", margin.limit.maximum ? number(*margin.limit.maximum) : Json()},
                    {"median", number(margin.median)},
                    {"median_margin", number(margin.median_margin)},
                    {"extreme", number(margin.extreme)},
                    {"extreme_margin", number(margin.extreme_margin)},
                    {"relative", margin.limit.maximum.value_or(1) != 0 &&
                                     margin.limit.minimum.value_or(1) != 0},
                    {"judged", margin.judged},
                    {"missed", margin.missed},
                    {"unknown", margin.unknown},
                    {"missed_alone", margin.alone},
                    {"missed_share_lower", number(margin.missed_lower)},
                    {"missed_share_upper", number(margin.missed_upper)},
                    {"model_error", number(margin.model_error)},
                    {"runs_needed", margin.runs_needed},
                    {"role", limit_role_name(margin.role)}});
  }
  const auto jammed = std::count(runs.status.begin(), runs.status.end(), RunStatus::jammed);
  return {{"runs", runs.size()},
          {"jammed", jammed},
          {"at", confirmations.empty()                 ? "all runs of the study"
                 : basis.study.plan.candidates.empty() ? "all runs"
                                                       : "the fresh runs of the last attempt"},
          {"each", each},
          {"stress", stress_json(runs)}};
}

void finish_verdict(const ReportBasis& basis, Json& report) {
  Json& verdict = report["verdict"];
  if (basis.runs.size() == 0) verdict["status"] = "no_runs";
  std::vector<std::string> sentences =
      sentences_of(verdict.value("judgement", verdict["statement"].get<std::string>()));
  verdict.erase("judgement");
  std::int64_t runs = report["outcomes"]["samples"];
  if (report["confirmation"].is_object())
    for (const Json& attempt : report["confirmation"]["attempts"])
      runs += attempt["runs"].get<std::int64_t>();
  report["outcomes"]["samples_with_attempts"] = runs;
  verdict["headline"] = sentences.empty() ? "" : sentences.front();
  if (!sentences.empty()) sentences.erase(sentences.begin());
  const Json& judged =
      report["confirmation"].is_object() ? report["confirmation"] : std::as_const(report);
  if (const std::string nearest = nearest_limits(judged["capability"]); !nearest.empty())
    sentences.push_back(nearest);
  for (const Json& measured : report["measured"])
    if (measured["group"] != "" && measured["names"].size() < kFewGroups) {
      sentences.push_back(fmt::format(
          "The {} was measured of {} cages: fewer than {} say little of how cages differ.",
          measured["name"].get<std::string>(), measured["names"].size(), kFewGroups));
      verdict["statement"] = verdict["statement"].get<std::string>() + " " + sentences.back();
    }
  verdict["grounds"] = sentences;
  verdict["next"] = next_steps(basis, report);
  if (basis.study.judged_again) {
    const std::string text = judgement_text(basis.study);
    verdict["statement"] = text + " " + verdict["statement"].get<std::string>();
    verdict["grounds"].insert(verdict["grounds"].begin(), text);
    for (Json& next : verdict["next"])
      if (next["command"].is_string()) add_settings(next["command"], basis.study.plan);
  }
  report["convergence"]["statement"] = convergence_statement(report);
  const auto judge_indices = [&](Json& capability) {
    for (Json& entry : capability) entry["no_index"] = no_index(report, entry);
  };
  judge_indices(report["capability"]);
  if (report["confirmation"].is_object()) judge_indices(report["confirmation"]["capability"]);
}

}  // namespace cagetol
