// A climbed ladder as JSON, CSV and tables for people.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/fidelity/model_ladder.hpp"
#include "analysis/report/json_parts.hpp"

namespace cagetol {
namespace {

std::string minimum_name(const ModelLadder& ladder, const QuantityLadder& quantity) {
  return quantity.minimum ? ladder.rungs[*quantity.minimum].name : "unresolved";
}

Json shift_json(const LadderRung& rung, const RungShift& shift) {
  return {{"rung", rung.name},
          {"shift", number(shift.shift.value)},
          {"lower", number(shift.shift.lower)},
          {"upper", number(shift.shift.upper)},
          {"upper_limit", number(shift.upper_limit)},
          {"correlation", number(shift.correlation)},
          {"pairs", shift.pairs},
          {"lost", shift.lost},
          {"pairs_needed", number(shift.pairs_needed)},
          {"wrong_share", number(shift.wrong_share)},
          {"verdict", rung_verdict_name(shift.verdict)}};
}

/// Whether there is anything to say: some quantities need a flexible cage, or never happen.
bool is_defined(const LadderQuantity& quantity) {
  return std::isfinite(quantity.ladder.budget);
}

Json limits_json(const std::vector<Limit>& limits) {
  Json list = Json::array();
  for (const Limit& limit : limits)
    list.push_back({{"minimum", limit.minimum ? Json(*limit.minimum) : Json()},
                    {"maximum", limit.maximum ? Json(*limit.maximum) : Json()}});
  return list;
}

/// "-" where there is none.
std::string shown(double value, int width, const char* format = "{:.3g}") {
  return fmt::format("{:>{}}", std::isnan(value) ? "-" : fmt::format(fmt::runtime(format), value),
                     width);
}

std::string verdict_text(const RungShift& rung) {
  if (rung.pairs == 0) return "no run has a value";
  std::string text = rung_verdict_name(rung.verdict);
  if (rung.verdict == RungVerdict::unusable)
    text += fmt::format(": {} runs without a value", rung.lost);
  if (rung.verdict == RungVerdict::unresolved && rung.pairs_needed > 0)
    text += fmt::format(", about {:.2g} samples would tell", rung.pairs_needed);
  if (rung.wrong_share < 1)
    text += fmt::format("{} at most {:.2g} % beyond the limit",
                        rung.verdict == RungVerdict::settled ? ":" : ",", 100 * rung.wrong_share);
  else if (rung.wrong_share == 1)
    text += ", runs on both sides of the limit, or too few";
  return text;
}

std::string quantity_table(const ModelLadder& ladder, const LadderQuantity& quantity) {
  const QuantityLadder& seen = quantity.ladder;
  std::string text =
      fmt::format("{}{}: mean {:.4g}, standard deviation {:.2g}, budget {:.2g}{}{}\n",
                  quantity.name, quantity.limited() ? " (limited)" : "", seen.mean, seen.deviation,
                  seen.budget, quantity.unit == "-" ? "" : " " + quantity.unit,
                  ladder.refining ? "" : "; minimum rung: " + minimum_name(ladder, seen));
  if (quantity.limited() && !ladder.refining)
    text += fmt::format("  {}; settled below {:.2g} % on the wrong side\n",
                        limits_text(quantity.limits), 100 * seen.allowed_wrong_share);
  for (std::size_t r = 0; r + 1 < ladder.rungs.size(); ++r) {
    const RungShift& shift = seen.rungs[r];
    text += fmt::format("  {:<16}{}  [{}, {}]{}{}  {}\n", ladder.rungs[r].name,
                        shown(shift.shift.value, 11), shown(shift.shift.lower, 10),
                        shown(shift.shift.upper, 10), shown(shift.correlation, 8, "{:.3f}"),
                        shown(ladder.rungs[r].cost_ratio, 8, "{:.2g}"), verdict_text(shift));
  }
  return text;
}

}  // namespace

std::string limits_text(const std::vector<Limit>& limits) {
  std::string text;
  const auto add = [&](const char* what, const std::optional<double>& bound) {
    if (bound) text += fmt::format("{}{} {:g}", text.empty() ? "limit " : ", ", what, *bound);
  };
  for (const Limit& limit : limits) {
    add("at least", limit.minimum);
    add("at most", limit.maximum);
  }
  return text;
}

Json ladder_json(const ModelLadder& ladder) {
  Json json = {{"kind", "ladder"},
               {"study", ladder.study},
               {"build", ladder.build},
               {"samples", ladder.samples},
               {"study_samples", ladder.rule.study_samples},
               {"budget_share", ladder.rule.budget_share},
               {"confidence", ladder.rule.confidence},
               {"target_yield", ladder.rule.target_yield},
               {"candidates", ladder.rule.candidates},
               {"settled_assumes", kSettledAssumption},
               {"reference", ladder.rungs.back().name}};
  json["refining"] = ladder.refining;
  if (!ladder.refining)
    for (const LadderQuantity& quantity : ladder.quantities)
      json["minimum_rung"][quantity.name] = minimum_name(ladder, quantity.ladder);
  json["rungs"] = Json::array();
  for (const LadderRung& rung : ladder.rungs)
    json["rungs"].push_back({{"name", rung.name},
                             {"meaning", rung.meaning},
                             {"settings", rung.settings},
                             {"cost_ratio", number(rung.cost_ratio)},
                             {"runs_ok", rung.ok}});
  json["rungs_not_run"] = ladder.not_run;
  json["quantities"] = Json::array();
  for (const LadderQuantity& quantity : ladder.quantities) {
    Json entry = {{"quantity", quantity.name},
                  {"unit", quantity.unit},
                  {"limited", quantity.limited()},
                  {"limits", limits_json(quantity.limits)},
                  {"mean", number(quantity.ladder.mean)},
                  {"standard_deviation", number(quantity.ladder.deviation)},
                  {"budget", number(quantity.ladder.budget)},
                  {"allowed_wrong_share", number(quantity.ladder.allowed_wrong_share)}};
    if (!ladder.refining) entry["minimum_rung"] = minimum_name(ladder, quantity.ladder);
    entry["rungs"] = Json::array();
    for (std::size_t r = 0; r < ladder.rungs.size(); ++r)
      entry["rungs"].push_back(shift_json(ladder.rungs[r], quantity.ladder.rungs[r]));
    json["quantities"].push_back(std::move(entry));
  }
  json["resolved_study"] = ladder.resolved_study;
  return json;
}

std::string ladder_text(const ModelLadder& ladder) {
  std::string text = fmt::format(
      "{} samples on each of {} rungs; budget: {:g} standard errors of a {:g}-sample study\n\n"
      "{:<18}{:>11}{:>24}{:>10}{:>8}\n",
      ladder.samples, ladder.rungs.size(), ladder.rule.budget_share, ladder.rule.study_samples,
      "rung", "shift", fmt::format("{:g} % interval", 100 * ladder.rule.confidence), "correl.",
      "cost");
  for (const LadderQuantity& quantity : ladder.quantities)
    if (is_defined(quantity)) text += quantity_table(ladder, quantity);
  text += fmt::format("\n{:<18}{:>8}{:>6}  {}\n", "rung", "cost", "ok", "what it is");
  for (const LadderRung& rung : ladder.rungs)
    text += fmt::format("{:<18}{}{:>6}  {}\n", rung.name, shown(rung.cost_ratio, 8, "{:.2g}"),
                        rung.ok, rung.meaning);
  if (ladder.refining)
    return text +
           "\nshift: refined minus as-run. Positive: the scene as it is gives too small a mean.\n";
  const bool limited =
      std::any_of(ladder.quantities.begin(), ladder.quantities.end(),
                  [](const LadderQuantity& quantity) { return quantity.limited(); });
  if (limited) text += fmt::format("\n\"settled\" assumes {}.\n", kSettledAssumption);
  text += "\nleast rung of each quantity\n";
  for (const LadderQuantity& quantity : ladder.quantities)
    if (is_defined(quantity))
      text += fmt::format("  {:<31} {}\n", quantity.name, minimum_name(ladder, quantity.ladder));
  return text;
}

}  // namespace cagetol
