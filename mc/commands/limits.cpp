// cagetol limits STUDY -o DIR: what scatters under nominal scatter, how far each limit is, and
// which limits decide. `limits DIR` reads a sweep that is there.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "analysis/report/refining_ladder.hpp"
#include "analysis/statistics/order_statistics.hpp"
#include "analysis/tolerance/limit_margin.hpp"
#include "mc/commands/command.hpp"
#include "mc/commands/output_path.hpp"
#include "mc/host/json_number.hpp"
#include "mc/ranks/launch.hpp"
#include "mc/ranks/signals.hpp"
#include "mc/study/study.hpp"
#include "mc/study_file/study_file_error.hpp"
#include "mc/sweep/sweep.hpp"
#include "src/input/input_error.hpp"
#include "src/input/printable.hpp"
#include "src/input/unit.hpp"

namespace cagetol {
namespace {

constexpr double kLevels[] = {0.05, 0.5, 0.95, 0.99};

struct LimitsArguments {
  std::string file;
  std::vector<std::string> settings;
  SweepOptions sweep;
  std::optional<long> samples;
  bool json = false;
};

/// Runs that settle a limit when none of them misses it; for a target below 95 % as many as for 95 %.
long enough_samples(const Study& study) {
  const double target = std::max(0.95, study.tolerance.target_yield);
  return static_cast<long>(runs_without_miss(study.tolerance.confidence, target));
}

/// The study at nominal scatter: every dimension at the tolerance to which its laws belong.
Study nominal_study(const Study& given, long samples) {
  return changed_study(given, [&](Study& study) {
    study.name += ", nominal scatter";
    study.samples = samples;
    study.design = DesignKind::random;
    study.cages_per_lot = 1;
    study.extra_replicates = 0;
    study.allowed_failure_share = 1;
    study.fidelity = "pinned";
    for (auto& dimension : study.tolerance.dimensions) {
      dimension.cost.reset();
      dimension.candidates = {number_text(dimension.tolerance_width_mm)};
      dimension.centres.clear();
    }
  });
}

nlohmann::ordered_json distributions(const StudyData& runs) {
  auto list = nlohmann::ordered_json::array();
  for (const Column& column : runs.quantities) {
    const auto values = ok_values(runs, column.values);
    const auto order = ascending_order(values);
    if (order.empty()) continue;
    nlohmann::ordered_json entry{
        {"quantity", column.name}, {"unit", column.unit}, {"runs", order.size()}};
    for (const double level : kLevels)
      entry[fmt::format("p{:g}", 100 * level)] = json_number(
          weighted_quantile(values, order, std::vector<double>(values.size(), 1), level));
    list.push_back(std::move(entry));
  }
  return list;
}

nlohmann::ordered_json margins(const StudyData& runs, const std::string& directory) {
  const Json ladder = read_refining_ladder(directory);
  std::vector<double> errors;
  for (const Limit& limit : runs.plan.limits)
    errors.push_back(known_bias(ladder, runs, limit.quantity));
  auto list = nlohmann::ordered_json::array();
  for (const LimitMargin& m : limit_margins(runs, errors))
    list.push_back({{"quantity", m.limit.quantity},
                    {"min", m.limit.minimum ? json_number(*m.limit.minimum) : nullptr},
                    {"max", m.limit.maximum ? json_number(*m.limit.maximum) : nullptr},
                    {"median", json_number(m.median)},
                    {"median_margin", json_number(m.median_margin)},
                    {"extreme", json_number(m.extreme)},
                    {"extreme_margin", json_number(m.extreme_margin)},
                    {"judged", m.judged},
                    {"unknown", m.unknown},
                    {"missed", m.missed},
                    {"missed_alone", m.alone},
                    {"missed_share_lower", json_number(m.missed_lower)},
                    {"missed_share_upper", json_number(m.missed_upper)},
                    {"model_error", json_number(m.model_error)},
                    {"role", limit_role_name(m.role)},
                    {"runs_needed", m.runs_needed}});
  return list;
}

double real(const nlohmann::ordered_json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

std::string margin_text(const nlohmann::ordered_json& m) {
  std::string text = "  " + m["quantity"].get<std::string>();
  if (m["min"].is_number()) text += fmt::format(", at least {:.6g}", real(m["min"]));
  if (m["max"].is_number()) text += fmt::format(", at most {:.6g}", real(m["max"]));
  const std::string role = m["role"];
  text += ": " + role;
  if (role == limit_role_name(LimitRole::open))
    text += fmt::format(" (none of {} runs misses it; {} without a miss would be enough)",
                        m["judged"].get<long>(), m["runs_needed"].get<long>());
  text += fmt::format("\n    median {:.4g}, margin {:.1f} %; extreme {:.4g}, margin {:.1f} %\n",
                      real(m["median"]), 100 * real(m["median_margin"]), real(m["extreme"]),
                      100 * real(m["extreme_margin"]));
  text += fmt::format("    missed by {} of {} runs ({:.1f} to {:.1f} %), by {} alone; {} unknown\n",
                      m["missed"].get<long>(), m["judged"].get<long>(),
                      100 * real(m["missed_share_lower"]), 100 * real(m["missed_share_upper"]),
                      m["missed_alone"].get<long>(), m["unknown"].get<long>());
  return text + (m["model_error"].is_number()
                     ? fmt::format("    known bias of the model {:.3g}\n", real(m["model_error"]))
                     : std::string("    error of the model not measured\n"));
}

std::string limits_text(const nlohmann::ordered_json& all, const std::string& directory) {
  std::string text =
      fmt::format("{} runs, {} of them with results\n  {:<40}{:>12}{:>12}{:>12}{:>12}\n",
                  all["runs"].get<long>(), all["runs_ok"].get<long>(), "quantity", "5 %", "50 %",
                  "95 %", "99 %");
  for (const auto& q : all["quantities"])
    text +=
        fmt::format("  {:<40}{:>12.5g}{:>12.5g}{:>12.5g}{:>12.5g}  {}\n",
                    q["quantity"].get<std::string>(), real(q["p5"]), real(q["p50"]), real(q["p95"]),
                    real(q["p99"]), q["unit"] == "-" ? "" : q["unit"].get<std::string>());
  text += all["limits"].empty() ? "the study has no limits\n" : "limits\n";
  bool measured = true, missed = false;
  const nlohmann::ordered_json* nearest = nullptr;
  for (const auto& limit : all["limits"]) {
    text += margin_text(limit);
    measured = measured && limit["model_error"].is_number();
    missed = missed || limit["missed"] > 0;
    const double margin = real(limit["extreme_margin"]);
    if (nearest == nullptr || margin < real((*nearest)["extreme_margin"])) nearest = &limit;
  }
  if (nearest != nullptr && !missed)
    text += fmt::format("no run misses a limit; the nearest is that of {}\n",
                        (*nearest)["quantity"].get<std::string>());
  if (!measured)
    text += "the error of the model: cagetol ladder " + directory + "/study.toml --refine -o " +
            directory + "/" + kRefiningLadderFolder + "\n";
  for (const auto& [key, width] : all["tolerance_width_mm"].items())
    text += fmt::format("{} at a tolerance width of {:.6g} mm{}\n", key, real(width),
                        all["candidates"].get<long>() > 1 ? " times the candidates'" : "");
  return text;
}

int print_limits(const std::string& directory, bool json) {
  const StudyData all = read_study_data(study_file_path(directory));
  const StudyData runs = select_samples(all, first_runs(all));
  long ok = 0;
  for (const RunStatus status : runs.status) ok += status == RunStatus::ok;
  auto widths = nlohmann::ordered_json::object();
  for (const ToleranceDimension& each : runs.plan.dimensions)
    widths[each.key] = each.tolerance_width_mm;
  const nlohmann::ordered_json found{{"runs", runs.size()},
                                     {"runs_ok", ok},
                                     {"candidates", runs.plan.candidates.size()},
                                     {"tolerance_width_mm", widths},
                                     {"quantities", distributions(runs)},
                                     {"limits", margins(runs, directory)}};
  print(json ? found.dump(2) + "\n" : limits_text(found, directory));
  return kDone;
}

int run_limits(const LimitsArguments& options) {
  std::string directory = options.file;
  if (std::filesystem::is_directory(options.file)) {
    if (!options.settings.empty() || options.samples)
      throw InputError({}, options.samples ? "--samples" : "--set", options.file,
                       "the runs of a directory were made with the study's own settings",
                       "give the study in place of the directory, and -o for its runs");
  } else {
    if (!std::filesystem::exists(options.file))
      throw InputError({options.file, 0}, "", "", "no such file or directory", "check the path");
    if (options.sweep.directory.empty())
      throw InputError({}, "--output", "", "a study is swept into a directory",
                       "give -o DIR, or the directory of a sweep in place of the study");
    directory = options.sweep.directory;
    const SignalWatch signals;
    const int code = run_sweep(
        [&] {
          const Study study = read_study(options.file, options.settings);
          return make_sweep_plan(
              nominal_study(study, options.samples.value_or(enough_samples(study))));
        },
        options.sweep);
    if (code != kDone || launch_from_environment().rank != 0) return code;
  }
  try {
    return print_limits(directory, options.json);
  } catch (const StudyFileError& error) {
    std::fprintf(stderr, "cagetol: %s\n", printable(error.what(), LineBreaks::kept).c_str());
    return kBadInput;
  }
}

}  // namespace

Chosen limits_command(CLI::App& command) {
  command.footer(
      "Examples:\n  cagetol limits inputs/studies/nu205.toml -o out/nu205-limits\n"
      "  mpirun -n 2 cagetol limits inputs/studies/nu205.toml --samples 300 -o out/nu205-limits\n"
      "  cagetol limits out/nu205-limits --json");
  auto options = std::make_shared<LimitsArguments>();
  command.add_option("STUDY", options->file, "Study file, or the directory of a sweep")->required();
  add_output_directory(command, options->sweep.directory,
                       "Directory of the sweep at nominal scatter; an earlier one goes on")
      ->required(false);
  command
      .add_option("--samples", options->samples,
                  "Runs of that sweep; left out: enough to settle a limit that none of them misses "
                  "(target 99 %, confidence 95 %: 299)")
      ->check(CLI::Range(2L, 1000000L));
  command.add_flag("--json", options->json, "Print distributions and margins as JSON");
  add_settings_option(command, options->settings);
  add_progress_option(command, options->sweep.progress);
  return [options] { return run_limits(*options); };
}

}  // namespace cagetol
