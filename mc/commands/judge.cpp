// cagetol judge DIR: what runs that are there say under other limits, another target or confidence:
// how quantities scatter, how far limits are, which decide; with --name a whole report.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>

#include "analysis/report/json_parts.hpp"
#include "analysis/report/refining_ladder.hpp"
#include "analysis/report/report.hpp"
#include "analysis/statistics/order_statistics.hpp"
#include "analysis/tolerance/limit_margin.hpp"
#include "mc/commands/bearing_facts.hpp"
#include "mc/commands/command.hpp"
#include "mc/commands/output_path.hpp"
#include "mc/host/json_number.hpp"
#include "src/input/input_error.hpp"
#include "src/quantities/quantity_labels.hpp"

namespace cagetol {
namespace {

constexpr double kLevels[] = {0.05, 0.5, 0.95, 0.99};

struct JudgeArguments {
  std::string directory, name;
  std::vector<std::string> limits;
  std::optional<double> target, confidence;
  bool json = false;
};

/// Names of a quantity in the study: at every operating point, unless it names one.
std::vector<std::string> names_of(const std::string& quantity, const StudyPlan& plan) {
  if (!labelled_key(quantity).label.empty() || !plan.whole.contains("operating_point"))
    return {quantity};
  std::vector<std::string> names;
  for (const auto& point : plan.whole.at("operating_point"))
    names.push_back(labelled_name(quantity, point.at("name").get<std::string>()));
  return names;
}

/// States a limit, KEY=VALUE, KEY.min=VALUE or KEY.max=VALUE: a bound that the study has, or a new
/// one.
void state_limit(const std::string& text, StudyData& runs) {
  const auto wrong = [&](const std::string& problem, const std::string& remedy) {
    return InputError({}, "--limit", text, problem, remedy);
  };
  std::string quantity = text.substr(0, text.find('=')), side;
  const char *begin = text.data() + std::min(quantity.size() + 1, text.size()),
             *end = text.data() + text.size();
  double value = 0;
  if (const auto read = std::from_chars(begin, end, value);
      read.ec != std::errc() || read.ptr != end || !std::isfinite(value))
    throw wrong("this is no quantity with a number", "write it as --limit driving_slip_ratio=0.05");
  if (quantity.ends_with(".min") || quantity.ends_with(".max")) {
    side = quantity.substr(quantity.size() - 3);
    quantity.resize(quantity.size() - 4);
  }
  for (const std::string& name : names_of(quantity, runs.plan)) {
    const Column* column = find_quantity(runs, name);
    if (!column || std::all_of(column->values.begin(), column->values.end(),
                               [](double each) { return std::isnan(each); }))
      throw wrong(
          column ? "no run gives " + name + " a value" : "the runs have no quantity " + name,
          "`cagetol judge DIR` lists what they have, that of an operating point or phase as "
          "KEY@NAME; `cagetol quantities` says what a quantity needs, for another sweep");
    std::vector<std::optional<double>*> bounds;
    for (Limit& limit : runs.plan.limits) {
      if (limit.quantity != name) continue;
      if (limit.minimum && side != "max") bounds.push_back(&limit.minimum);
      if (limit.maximum && side != "min") bounds.push_back(&limit.maximum);
    }
    if (bounds.size() != 1 && side.empty())
      throw wrong(
          bounds.empty() ? "the study has no limit on it" : "the study has two limits on it",
          "say which side: " + quantity + ".min=... or " + quantity + ".max=...");
    if (bounds.empty()) {
      Limit& added = runs.plan.limits.emplace_back(
          Limit{.quantity = name, .source = "stated to cagetol judge"});
      bounds.push_back(side == "min" ? &added.minimum : &added.maximum);
    }
    for (std::optional<double>* bound : bounds) *bound = value;
  }
}

Json distributions(const StudyData& runs) {
  auto list = Json::array();
  for (const Column& column : runs.quantities) {
    const auto values = ok_values(runs, column.values);
    const auto order = ascending_order(values);
    if (order.empty()) continue;
    Json entry{{"quantity", column.name}, {"unit", column.unit}, {"runs", order.size()}};
    for (const double level : kLevels)
      entry[fmt::format("p{:g}", 100 * level)] = json_number(
          weighted_quantile(values, order, std::vector<double>(values.size(), 1), level));
    list.push_back(std::move(entry));
  }
  return list;
}

std::string margin_text(const Json& m) {
  std::string text = "  " + m["quantity"].get<std::string>();
  if (m["min"].is_number()) text += fmt::format(", at least {:.6g}", known(m["min"]));
  if (m["max"].is_number()) text += fmt::format(", at most {:.6g}", known(m["max"]));
  const std::string role = m["role"];
  text += ": " + role;
  if (role == limit_role_name(LimitRole::open))
    text += fmt::format(" (none of {} runs misses it; {} without a miss would be enough)",
                        m["judged"].get<long>(), m["runs_needed"].get<long>());
  text += fmt::format("\n    median {:.4g}, margin {:.1f} %; extreme {:.4g}, margin {:.1f} %\n",
                      known(m["median"]), 100 * known(m["median_margin"]), known(m["extreme"]),
                      100 * known(m["extreme_margin"]));
  text += fmt::format("    missed by {} of {} runs ({:.1f} to {:.1f} %), by {} alone; {} unknown\n",
                      m["missed"].get<long>(), m["judged"].get<long>(),
                      100 * known(m["missed_share_lower"]), 100 * known(m["missed_share_upper"]),
                      m["missed_alone"].get<long>(), m["unknown"].get<long>());
  return text + (m["model_error"].is_number()
                     ? fmt::format("    known bias of the model {:.3g}\n", known(m["model_error"]))
                     : std::string("    error of the model not measured\n"));
}

std::string limits_text(const Json& all, const std::string& directory) {
  std::string text =
      fmt::format("{} runs, {} of them with results\n  {:<40}{:>12}{:>12}{:>12}{:>12}\n",
                  all["runs"].get<long>(), all["runs_ok"].get<long>(), "quantity", "5 %", "50 %",
                  "95 %", "99 %");
  for (const auto& q : all["quantities"])
    text += fmt::format("  {:<40}{:>12.5g}{:>12.5g}{:>12.5g}{:>12.5g}  {}\n",
                        q["quantity"].get<std::string>(), known(q["p5"]), known(q["p50"]),
                        known(q["p95"]), known(q["p99"]),
                        q["unit"] == "-" ? "" : q["unit"].get<std::string>());
  text += all["limits"].empty() ? "the study has no limits\n" : "limits\n";
  bool measured = true, missed = false;
  const Json* nearest = nullptr;
  for (const auto& limit : all["limits"]) {
    text += margin_text(limit);
    measured = measured && limit["model_error"].is_number();
    missed = missed || limit["missed"] > 0;
    const double margin = known(limit["extreme_margin"]);
    if (nearest == nullptr || margin < known((*nearest)["extreme_margin"])) nearest = &limit;
  }
  if (nearest != nullptr && !missed)
    text += fmt::format("no run misses a limit; the nearest is that of {}\n",
                        (*nearest)["quantity"].get<std::string>());
  if (!measured)
    text += "the error of the model: cagetol ladder " + directory + "/study.toml --refine -o " +
            directory + "/" + kRefiningLadderFolder + "\n";
  return text;
}

int run_judge(const JudgeArguments& options) {
  const auto file = study_file_in(options.directory);
  StudyData all = read_study_data(file);
  for (const std::string& text : options.limits) state_limit(text, all);
  const auto restate = [limits = all.plan.limits, &options](StudyPlan& plan) {
    plan.limits = limits;
    plan.target_yield = options.target.value_or(plan.target_yield);
    plan.confidence = options.confidence.value_or(plan.confidence);
  };
  if (!options.name.empty())
    return run_report(options.directory,
                      {.json_to_stdout = options.json,
                       .bearing = bearing_facts,
                       .into = std::filesystem::path(options.directory) / "judged" / options.name,
                       .restate = restate});
  restate(all.plan);
  const std::string directory = file.parent_path().string();
  const StudyData runs = select_samples(all, first_runs(all));
  const auto joint = judge_all(runs);
  const Resampling none(runs, 0);
  const ReportBasis basis{all, runs, joint, none};
  const Json ladder = read_refining_ladder(directory);
  const auto ok = std::count(runs.status.begin(), runs.status.end(), RunStatus::ok);
  const Json found{{"runs", runs.size()},
                   {"runs_ok", ok},
                   {"candidates", runs.plan.candidates.size()},
                   {"quantities", distributions(runs)},
                   {"limits", margins_json(basis, {}, ladder)["each"]}};
  print(options.json ? found.dump(2) + "\n" : limits_text(found, directory));
  return kDone;
}

std::string name_fault(const std::string& name) {
  const auto plain = [](unsigned char c) { return std::isalnum(c) || c == '-' || c == '_'; };
  return !name.empty() && std::all_of(name.begin(), name.end(), plain)
             ? ""
             : "letters, digits, - and _ make a name";
}

}  // namespace

Chosen judge_command(CLI::App& command) {
  command.footer(
      "Reads the runs of a sweep or a recommendation, finished or not, and changes none of them.\n"
      "--limit KEY=VALUE moves the bound that the study has, KEY.min= and KEY.max= state either, "
      "new\nones too; KEY@POINT is of one operating point. With --name DIR/judged/NAME gets a "
      "report,\nwith the yield over the value of each limit. `recommend` with these limits in its "
      "study\ngoes on in the same directory.\n\n"
      "Examples:\n  cagetol judge out/nu205\n"
      "  cagetol judge out/nu205 --limit driving_slip_ratio=0.05 --target 0.95 --name less-slip\n"
      "  cagetol judge out/nu205 --limit cage_slip_ratio.min=-0.01 --json");
  auto options = std::make_shared<JudgeArguments>();
  add_result_directory(command, "DIR", options->directory,
                       "Directory of a sweep or a recommendation");
  command
      .add_option("--limit", options->limits, "Another value of a limit, or a new one (repeatable)")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command.add_option("--target", options->target, "Share of cages that must meet all limits")
      ->check(CLI::Range(1e-6, 0.999999));
  command.add_option("--confidence", options->confidence, "Confidence of the bounds")
      ->check(CLI::Range(1e-6, 0.999999));
  command
      .add_option("--name", options->name, "Write a report to DIR/judged/NAME, replacing one there")
      ->check(name_fault);
  command.add_flag("--json", options->json,
                   "Print distributions and margins as JSON; with --name report.json");
  return [options] { return run_judge(*options); };
}

}  // namespace cagetol
