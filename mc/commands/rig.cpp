// cagetol rig SCENE CSV -o DIR: the model held against what a rig has measured.
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <filesystem>
#include <memory>

#include "analysis/report/report.hpp"
#include "mc/commands/command.hpp"
#include "mc/commands/output_path.hpp"
#include "mc/commands/rig_stages.hpp"
#include "mc/host/build_info.hpp"
#include "mc/host/log.hpp"
#include "src/input/input_error.hpp"

namespace cagetol {
namespace {

using Json = nlohmann::ordered_json;

struct RigArguments {
  std::string file, measured, directory;
  std::vector<std::string> settings;
  long starts = 6;
  bool decimal_comma = false, starts_only = false;
};

Study read_rig_scene(const RigArguments& options) {
  Study given = read_study(options.file, options.settings);
  require_dynamic(given.scene, "SCENE", options.file, "slip of the cage");
  if (changes_over_time(given.scene.operation) || given.scene.operation.outer_speed != 0)
    throw InputError({}, "SCENE", options.file, "the outer ring turns, or duty changes over time",
                     "leave speed.outer_rpm and [duty] out: rows give one load and one speed");
  return given;
}

constexpr const char* kHead =
    "cage slip in %: measured; predicted: mean, interval over starts, and over assumptions too\n"
    "   load N    r/min measured     mean          over starts     over assumptions\n";

std::string line_text(const Json& row) {
  const auto percent = [&](const char* name) { return 100 * row[name].get<double>(); };
  const std::string reason = row["reason"];
  return fmt::format(
      "{:>9.6g}{:>9.6g}{:>9.2f}{:>9.2f}{:>10.2f} to {:>6.2f}{:>10.2f} to {:>6.2f}  {}\n{}",
      row["radial_N"].get<double>(), row["speed_rpm"].get<double>(), percent("measured_slip"),
      percent("slip"), percent("starts_lower"), percent("starts_upper"), percent("lower"),
      percent("upper"), row["standing"].get<std::string>(),
      reason.empty() ? "" : "           " + reason + "\n");
}

int run_rig(const RigArguments& options) {
  spdlog::set_level(spdlog::level::warn);  // the table shows how far dozens of sweeps a row are
  return run_staged(make_sweep_plan, ProgressStyle::off, [&](StagedSweeps& stages) {
    const auto measured = read_rig_csv(options.measured, options.decimal_comma);
    const Study given = read_rig_scene(options);
    const auto ends = options.starts_only ? std::vector<Alternative>() : alternatives_of(given);
    Json rig = {{"kind", "rig"},
                {"report_version", kReportVersion},
                {"scene", given.name},
                {"file", std::filesystem::path(options.measured).filename().string()},
                {"starts", options.starts},
                {"ends", ends.size()},
                {"runs_of_an_end", kRunsOfAnEnd},
                {"build", build_id(build_info())}};
    say("{} rows, each {} starts and {} ends of assumptions with {} runs\n", measured.size(),
        options.starts, ends.size(), kRunsOfAnEnd);
    print(kHead);
    for (const RigMeasurement& row : measured) {
      const Study base = rig_study(given, row, options.starts);
      if (const int code = run_rig_row(base, row, ends, options.directory, stages, rig["rows"]))
        return code;
      print(line_text(rig["rows"].back()));
    }
    write_result(rig, rig["rows"], options.directory);
    return static_cast<int>(kDone);
  });
}

}  // namespace

Chosen rig_command(CLI::App& command) {
  command.footer(
      "CSV: radial_N, speed_rpm and one of cage_rpm and cage_order (cage over inner ring).\n"
      "Each row runs from several starts, and at each end of the assumptions' ranges, one at a\n"
      "time, in sweeps below DIR/rows; the same command goes on.\n\n"
      "Examples:\n  cagetol rig inputs/scenes/nu205.toml rig.csv -o out/rig\n"
      "  mpirun cagetol rig nu206.toml rig.csv -o out/rig --starts 12");
  auto options = std::make_shared<RigArguments>();
  command.add_option("SCENE", options->file, "Scene of the bearing in the rig")->required();
  command.add_option("CSV", options->measured, "What the rig has measured")->required();
  add_output_directory(command, options->directory,
                       "Directory of rig.html, rig.json, rig.csv, figures/ and rows/");
  command.add_option("--starts", options->starts, "Runs of each row from starts of their own")
      ->check(CLI::Range(kRunsOfAnEnd, 1000000L))
      ->capture_default_str();
  command.add_flag("--starts-only", options->starts_only, "Leave assumptions as they are");
  command.add_flag("--decimal-comma", options->decimal_comma,
                   "The numbers in the CSV file have decimal commas");
  add_settings_option(command, options->settings);
  return [options] { return run_rig(*options); };
}

}  // namespace cagetol
