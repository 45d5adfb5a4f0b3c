// Fresh runs at the recommended tolerance, and what they make of the verdict; yield against centre.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/report/json_parts.hpp"
#include "analysis/sensitivity/features.hpp"
#include "analysis/study/refused.hpp"
#include "analysis/tolerance/centre_curve.hpp"
#include "analysis/tolerance/centre_response.hpp"
#include "analysis/tolerance/confirmation.hpp"
#include "analysis/tolerance/jam_onset.hpp"

namespace cagetol {
namespace {

/// Nominal value that an attempt gave a dimension; null where it is not in question.
Json centre_of(const StudyData& attempt, std::size_t dimension) {
  const auto& centres = attempt.plan.dimensions[dimension].centres;
  return centres.empty() ? Json() : Json(centres.front());
}

Json attempt_json(const StudyData& runs, const Confirmation& result, std::size_t number) {
  const auto rules = rules_for(confirmation_rules(runs.plan, 0), runs, 0);
  const auto planned = static_cast<std::size_t>(runs.design.samples_planned);
  const Candidate& tolerance = runs.plan.candidates.front();
  Json widths = Json::array();
  for (std::size_t d = 0; d < tolerance.tolerance_widths_mm.size(); ++d)
    widths.push_back(
        {{"key", runs.plan.dimensions[d].key},
         {"name", plain_name(runs.plan.dimensions[d].key)},
         {"tolerance_width_mm", tolerance.tolerance_widths_mm[d]},
         {"grade", tolerance.grades[d]},
         {"drawing", drawing_of(runs, d, tolerance.grades[d], tolerance.tolerance_widths_mm[d],
                                tolerance.centre_shift(d))},
         {"centre", centre_of(runs, d)}});
  const auto allowed = allowed_failures(std::max(planned, result.runs), rules);
  return {{"stage", fmt::format("confirm-{}", number)},
          {"tolerances", widths},
          {"runs", result.runs},
          {"planned_runs", std::max(planned, result.runs)},
          {"confidence", attempt_confidence(rules)},
          {"meeting_runs", result.meeting},
          {"unknown_runs", result.unknown},
          {"jammed_runs", std::count(runs.status.begin(), runs.status.end(), RunStatus::jammed)},
          {"allowed_failures", allowed ? Json(*allowed) : Json()},
          {"yield", to_json(result.yield)},
          {"passed", result.passed},
          {"judged_again", result.judged_again}};
}

/// " about 7.6", or nothing where the centre is not in question.
std::string centre_text(const StudyData& runs, const Candidate& candidate, std::size_t dimension) {
  const ToleranceDimension& plan = runs.plan.dimensions[dimension];
  const InputColumns* input = find_input(runs, plan.key);
  if (plan.centres.empty() || input == nullptr) return {};
  return fmt::format(" about {:.6g}", input->nominal.front() + candidate.centre_shift(dimension));
}

/// The command that would confirm a candidate that was passed over, in a directory of its own and
/// with other random numbers.
std::string confirming_command(const StudyData& runs, std::int64_t seed, const Candidate& candidate,
                               std::size_t count) {
  const StudyPlan& plan = runs.plan;
  std::string dimensions;
  for (std::size_t d = 0; d < candidate.tolerance_widths_mm.size(); ++d) {
    const std::string width = candidate.grades[d].empty()
                                  ? fmt::format("{}", candidate.tolerance_widths_mm[d])
                                  : '"' + candidate.grades[d] + '"';
    const InputColumns* input = find_input(runs, plan.dimensions[d].key);
    const std::string centre =
        plan.dimensions[d].centres.empty() || input == nullptr
            ? ""
            : fmt::format(", centres=[{:.12g}]",
                          input->nominal.front() + candidate.centre_shift(d));
    dimensions += fmt::format("{}{{key=\"{}\", tolerance_width_mm={}, candidates=[{}]{}}}",
                              d == 0 ? "" : ", ", plan.dimensions[d].key,
                              plan.dimensions[d].tolerance_width_mm, width, centre);
  }
  return fmt::format(
             "cagetol recommend STUDY -o OTHER_DIR --set seed={} --set samples=128 --set "
             "recommend.attempts=1 --set recommend.confirm_samples={} --set "
             "recommend.budget_samples=0 "
             "--set recommend.budget_h=0 --set 'tolerance.dimension=[{}]'",
             seed, count, dimensions) +
         (runs.judged_again ? judgement_settings(plan) : "");
}

/// A bound is rounded to its safe side.
std::string percent_down(double share) {
  return fmt::format("{:.1f} %", std::floor(1000 * share) / 10);
}

/// "pocket width 7.65 ±0.110 mm (IT13, js13)".
std::string tolerance_text(const Json& width) {
  return width["name"].get<std::string>() + " " + width["drawing"].get<std::string>();
}

/// Whether other random numbers might have decided otherwise about an attempt: it was not confirmed
/// although its yield may meet the target, or confirmed with failures that take up more than half
/// of what the target allows to cages that fit.
bool is_close(const Json& attempt, const StudyPlan& plan) {
  if (!attempt["passed"].get<bool>())
    return attempt["yield"]["upper_bound"].get<double>() >= plan.target_yield;
  const auto count = attempt["runs"].get<double>();
  const double failing = 1 - attempt["meeting_runs"].get<double>() / count;
  return failing > 0.5 * (1 - plan.target_yield / attempt["yield"]["fits"].get<double>());
}

/// Which other attempts than the decisive one confirmed nothing.
std::string failed_attempts_text(const Json& attempts, std::size_t decisive) {
  std::string text;
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    if (i == decisive || attempts[i]["passed"].get<bool>()) continue;
    std::string widths;
    for (const Json& width : attempts[i]["tolerances"])
      widths += (widths.empty() ? "" : ", ") + tolerance_text(width);
    const auto jammed = attempts[i]["jammed_runs"].get<std::int64_t>();
    text += fmt::format(" Not confirmed{}: {}; {} of {} fresh runs meet all limits{}.",
                        i < decisive ? " before" : "", widths,
                        attempts[i]["meeting_runs"].get<std::size_t>(),
                        attempts[i]["runs"].get<std::size_t>(),
                        jammed > 0 ? fmt::format(", {} jam", jammed) : std::string());
  }
  return text;
}

/// What a share of cages is by.
std::string judged_by(const StudyPlan& plan) {
  std::set<double> over;
  for (const Limit& limit : plan.limits) over.insert(limit.cage_revolutions);
  return over.size() == 1 && *over.begin() > 0
             ? fmt::format("each judged by one start over {:g} revolutions", *over.begin())
             : "each judged by one start";
}

std::string statement(const Json& attempt, double lower_bound, const Json& not_binding,
                      const StudyPlan& plan, std::size_t attempts, std::size_t planned) {
  std::string widths, free;
  for (const Json& width : attempt["tolerances"]) {
    const std::string text = tolerance_text(width);
    std::string& list =
        std::find(not_binding.begin(), not_binding.end(), width["key"]) != not_binding.end()
            ? free
            : widths;
    list += (list.empty() ? "" : ", ") + text;
  }
  const double jams = 1 - attempt["yield"]["fits"].get<double>();
  const bool again = attempt["judged_again"];
  const std::string counted =
      fmt::format("{} of {} {}runs{} meet all limits", attempt["meeting_runs"].get<std::size_t>(),
                  attempt["runs"].get<std::size_t>(), again ? "" : "fresh ",
                  jams > 0 ? " of cages that fit" : "") +
      (jams > 0 ? fmt::format(", and {} of the cages do not fit", jam_text(jams, 0)) : "");
  std::string text;
  if (attempt["passed"].get<bool>())
    text = fmt::format(
        "{}{}. {}: with {:.6g} % confidence at least {} "
        "of the cages {}, {}; the target is {:.6g} %.{}",
        again ? "Judged again, not confirmed" : "Confirmed",
        widths.empty() ? ", though no tolerance studied limits the yield" : ": " + widths, counted,
        100 * plan.confidence, percent_down(lower_bound), jams > 0 ? "fit and meet them" : "do",
        judged_by(plan), 100 * plan.target_yield,
        again ? " These runs had been seen before limits or target were stated: fresh ones alone "
                "confirm it."
              : "");
  else
    text = fmt::format(
        "No tolerance is confirmed after {} of {} planned attempts. The last was {}: {}, too few "
        "for the target of {:.6g} %.",
        attempts, planned, widths.empty() ? free : widths, counted, 100 * plan.target_yield);
  if (!free.empty() && !widths.empty())
    text += fmt::format(
        " Not binding within the range studied: {}; the yield holds with it at that width, which "
        "is no recommendation.",
        free);
  return text;
}

}  // namespace

std::string candidate_name(const StudyData& runs, const Candidate& candidate) {
  std::string name;
  for (std::size_t d = 0; d < candidate.tolerance_widths_mm.size(); ++d)
    name += fmt::format("{}{} {}{}", d == 0 ? "" : ", ", plain_name(runs.plan.dimensions[d].key),
                        tolerance_name(candidate.grades[d], candidate.tolerance_widths_mm[d]),
                        centre_text(runs, candidate, d));
  return name;
}

std::string drawing_of(const StudyData& runs, std::size_t dimension, const std::string& grade,
                       double tolerance_width_mm, double centre_shift) {
  const InputColumns* input = find_input(runs, runs.plan.dimensions[dimension].key);
  const std::string text = drawing_text(grade, tolerance_width_mm);
  if (input == nullptr || std::set(input->nominal.begin(), input->nominal.end()).size() != 1)
    return text;
  const double nominal = input->nominal.front() + centre_shift;
  return input->unit == "mm" ? fmt::format("{:.6g} {}", nominal, text)
                             : fmt::format("{:.6g} {}, tolerance {}", nominal, input->unit, text);
}

Json passed_over_json(const ReportBasis& basis, const std::vector<PassedOver>& candidates) {
  Json list = Json::array();
  for (const PassedOver& passed : candidates) {
    const Candidate& candidate = basis.study.plan.candidates[passed.candidate];
    list.push_back(
        {{"name", candidate_name(basis.study, candidate)},
         {"reason", passed.reason},
         {"runs_needed", passed.runs_needed},
         {"chance", fmt::format("confirms it in about {:.0f} of 10 cases, if its yield is as "
                                "estimated, at another {:.6g} % risk",
                                10 * kWantedPower, 100 * (1 - basis.study.plan.confidence))},
         {"command", passed.runs_needed > 0
                         ? Json(confirming_command(basis.study, basis.study.provenance.seed + 1,
                                                   candidate, passed.runs_needed))
                         : Json()}});
  }
  return list;
}

Json confirmation_json(const ReportBasis& basis, const std::vector<StudyData>& confirmations,
                       TolerancePart& tolerance) {
  if (confirmations.empty()) return nullptr;
  Json& verdict = tolerance.verdict;
  const StudyPlan& plan = basis.study.plan;
  Json attempts = Json::array();
  const JudgedAttempts judged = judge_attempts(confirmations);
  for (std::size_t i = 0; i < confirmations.size(); ++i)
    attempts.push_back(attempt_json(confirmations[i], judged.attempts[i], i + 1));
  const Json& last = attempts[judged.decisive];
  const StudyData& runs = confirmations[judged.decisive];
  const Confirmation& decisive = judged.attempts[judged.decisive];
  const bool passed = decisive.confirms();
  for (const Json& width : last["tolerances"]) {
    Json& entry = verdict["tolerances"][width["key"].get<std::string>()];
    const Json& free = verdict["not_binding"];
    if (std::find(free.begin(), free.end(), width["key"]) != free.end()) continue;
    entry = {{"tolerance_width_mm", passed ? width["tolerance_width_mm"] : Json()},
             {"grade", passed ? width["grade"] : Json()}};
    if (width["centre"].is_number()) entry["centre"] = passed ? width["centre"] : Json();
  }
  verdict["meets_target"] = passed;
  verdict["yield"] = last["yield"];
  verdict["yield"]["lower_bound"] = verdict["yield_lower_bound"] = judged.lower_bound;
  verdict["confirmation"] = {
      {"runs", last["runs"]},
      {"passed", passed},
      {"judged_again", decisive.judged_again},
      {"command", confirming_command(basis.study, basis.study.provenance.seed + 1,
                                     runs.plan.candidates.front(), last["planned_runs"])},
      {"meeting_runs", last["meeting_runs"]},
      {"attempts", judged.decisive + 1}};
  verdict["status"] = passed ? "confirmed" : decisive.passed ? "judged_again" : "not_confirmed";
  const std::string judgement = statement(last, judged.lower_bound, verdict["not_binding"], plan,
                                          attempts.size(), runs.plan.campaign.attempts);
  verdict["judgement"] = judgement;
  verdict["statement"] = judgement + failed_attempts_text(attempts, judged.decisive);
  const Json wider = passed_over_json(basis, tolerance.passed_over);
  for (const Json& candidate : wider)
    if (candidate["runs_needed"] > 0)
      verdict["statement"] =
          fmt::format("{} Passed over: {}; {}.", verdict["statement"].get<std::string>(),
                      candidate["name"].get<std::string>(), candidate["reason"].get<std::string>());
  verdict["close"] = Json::array();
  for (std::size_t i = 0; i < confirmations.size(); ++i) {
    if (!is_close(attempts[i], plan)) continue;
    std::string widths;
    for (const Json& width : attempts[i]["tolerances"])
      widths += (widths.empty() ? "" : ", ") + tolerance_text(width);
    verdict["close"].push_back(widths);
  }
  if (!verdict["close"].empty())
    for (const char* text : {"statement", "judgement"})
      verdict[text] = fmt::format(
          "{} Close to the target, so that other random numbers might decide otherwise "
          "about it: {}.",
          verdict[text].get<std::string>(), verdict["close"].back().get<std::string>());
  const auto joint = judge_all(runs);
  const Resampling resampling(runs, kUsualResamples);
  return {{"passed_over", wider},
          {"attempts_planned", runs.plan.campaign.attempts},
          {"confidence_each", attempt_confidence(confirmation_rules(runs.plan, 0))},
          {"attempts", attempts},
          {"capability", capability_json({runs, runs, joint, resampling, basis.confidence})}};
}

Json centre_responses_json(const ReportBasis& basis) {
  Json list = Json::array();
  for (std::size_t d = 0; d < basis.runs.plan.dimensions.size(); ++d) {
    const auto response = centre_response(basis.runs, d, basis.resampling, basis.confidence);
    if (!response) continue;
    Json means = Json::array();
    for (const CentreMean& mean : response->means)
      means.push_back({{"centre", mean.centre},
                       {"mean", number(mean.mean)},
                       {"standard_error", number(mean.standard_error)},
                       {"runs", mean.runs}});
    list.push_back({{"key", response->key},
                    {"name", plain_name(response->key)},
                    {"unit", response->unit},
                    {"quantity", kCentreQuantity},
                    {"quantity_unit", response->quantity_unit},
                    {"means", means},
                    {"at", response->at},
                    {"fitted", response->fitted},
                    {"optimum", to_json(response->optimum)},
                    {"at_end", response->at_end}});
  }
  return list;
}

Json centres_json(const ReportBasis& basis, const MixtureWeights& mixture,
                  const Tolerance& tolerance) {
  const auto point = [](const CentreYield& centre) {
    const bool shown = centre.ess >= kFewestEffectiveRuns;
    return Json{{"shifts_mm", centre.shifts_mm},
                {"effective_runs", centre.ess},
                {"shown", shown},
                {"yield", shown ? to_json(centre.yield) : Json()}};
  };
  try {
    const CentreCurves curves = centre_curves(basis.runs, mixture, tolerance, basis.joint,
                                              basis.resampling, basis.confidence);
    Json dimensions = Json::array(), map = Json::array();
    for (std::size_t d = 0; d < curves.dimensions.size(); ++d) {
      Json points = Json::array();
      for (const CentreYield& centre : curves.dimensions[d]) points.push_back(point(centre));
      dimensions.push_back({{"name", plain_name(basis.runs.plan.dimensions[d].key)},
                            {"tolerance_width_mm", tolerance.tolerance_widths_mm[d]},
                            {"points", points}});
    }
    for (const CentreYield& centre : curves.map) map.push_back(point(centre));
    return {{"dimensions", dimensions}, {"map", map}, {"note", ""}};
  } catch (const Refused& refusal) {
    return {{"dimensions", Json::array()}, {"map", Json::array()}, {"note", refusal.what()}};
  }
}

}  // namespace cagetol
