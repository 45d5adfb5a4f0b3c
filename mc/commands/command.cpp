#include "mc/commands/command.hpp"

#include <sched.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <map>

#include "analysis/report/page_writer.hpp"
#include "analysis/report/python_run.hpp"
#include "analysis/report/report.hpp"
#include "mc/host/file_write.hpp"
#include "mc/host/log.hpp"
#include "mc/ranks/launch.hpp"
#include "mc/study/operating_points.hpp"
#include "mc/study/study.hpp"
#include "src/heat_balance.hpp"
#include "src/input/input_error.hpp"
#include "src/quantities/operating_point.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

/// One process leaves the other cores of the machine, or of a batch system's task, idle.
void log_idle_cores() {
  cpu_set_t allowed;
  if (launch_from_environment().under_mpi || ::sched_getaffinity(0, sizeof allowed, &allowed) != 0)
    return;
  if (const int cores = CPU_COUNT(&allowed); cores > 1)
    spdlog::info("one process on {0} cores: `mpirun -n {0} cagetol ...` runs {0} samples at a time",
                 cores);
}

}  // namespace

std::vector<std::string> heat_doubts(const Study& study) {
  std::vector<std::string> doubts;
  const auto add = [&](const Scene& scene, const std::string& where) {
    if (const std::string doubt = temperature_doubt(scene); !doubt.empty())
      doubts.push_back(where + doubt);
  };
  if (study.points.empty()) add(study.scene, "");
  for (const OperatingPointPlan& point : study.points)
    add(at_operating_point(study.scene, point), "at " + point.name + ": ");
  return doubts;
}

void log_notes(const Study& study, const std::vector<std::string>& notes) {
  log_idle_cores();
  for (const std::string& doubt : heat_doubts(study)) spdlog::warn("{}", doubt);
  for (const std::string& warning : operating_warnings(study.scene)) spdlog::warn("{}", warning);
  for (const OperatingPointPlan& point : study.points)
    for (const std::string& warning : operating_warnings(at_operating_point(study.scene, point)))
      spdlog::warn("at {}: {}", point.name, warning);
  const auto doubts = scene_doubts(study.scene);
  for (const std::string& note : notes)
    spdlog::log(std::ranges::count(doubts, note) > 0 ? spdlog::level::warn : spdlog::level::info,
                "{}", note);
}

std::function<Study()> reading_study(const std::string& file,
                                     const std::vector<std::string>& settings) {
  return [file, settings] {
    const Study study = read_study(file, settings);
    log_notes(study, study_notes(study));
    return study;
  };
}

void add_settings_option(CLI::App& command, std::vector<std::string>& settings) {
  command
      .add_option("--set", settings,
                  "Set a key, written as in the file: --set load.radial_N=300 (repeatable)")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_progress_option(CLI::App& command, ProgressStyle& style) {
  const std::map<std::string, ProgressStyle> styles = {{"auto", ProgressStyle::automatic},
                                                       {"line", ProgressStyle::line},
                                                       {"plain", ProgressStyle::plain},
                                                       {"off", ProgressStyle::off}};
  command
      .add_option("--progress", style,
                  "line: one line that rewrites itself; plain: for logs; auto: line on a terminal")
      ->transform(CLI::Transformer(styles))
      ->transform(CLI::IsMember(styles))  // runs before the other
      ->type_name("auto|line|plain|off")
      ->option_text("auto|line|plain|off");
}

void add_methods_option(CLI::App& command, std::vector<IntegrationMethod>& methods) {
  const auto set = [&methods](const std::vector<std::string>& names) {
    methods.clear();
    for (const std::string& name : names) methods.push_back(choice_of<IntegrationMethod>(name));
  };
  command
      .add_option_function<std::vector<std::string>>(
          "--methods", set, "Integration methods, separated by commas; all if absent")
      ->delimiter(',')
      ->check(CLI::IsMember(choice_texts<IntegrationMethod>()))
      ->type_name("NAME,NAME")
      ->allow_extra_args(false);
}

void require_dynamic(const Scene& scene, const std::string& option, const std::string& value,
                     const std::string& what) {
  if (is_quasi_static(scene))
    throw InputError({}, option, value, "a quasi-static run has no " + what,
                     "set model.motion = \"dynamic\"");
}

void print(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw InputError({}, "", "", std::string("cannot write the output: ") + std::strerror(errno),
                     "free space on the disk or choose another place");
}

std::string draw_beside(const std::filesystem::path& json) {
  const ReportOptions drawing;
  const auto folder = json.parent_path() / "figures";
  std::error_code ignored;
  std::filesystem::remove_all(folder, ignored);
  std::filesystem::create_directories(folder, ignored);
  const PythonRun run = run_python(drawing.python, drawing.figures_dir / "draw.py",
                                   {json.string(), folder.string()}, folder / "draw.log");
  if (!run.problem.empty()) say("figures are missing or incomplete: {}\n", run.problem);
  return folder.string();
}

void write_result(const nlohmann::ordered_json& result, const nlohmann::ordered_json& rows,
                  const std::filesystem::path& directory, bool pdf) {
  const std::string kind = result["kind"];
  std::string head, text;
  for (const auto& row : rows) {
    head.clear();
    for (const auto& [name, value] : row.items())
      if (!value.is_structured())
        head += name + ",", text += (value.is_null() ? "" : value.dump()) + ",";
    head.back() = text.back() = '\n';
  }
  const auto json = directory / (kind + ".json");
  replace_file(json, result.dump(1) + "\n");
  replace_file(directory / (kind + ".csv"), head + text);
  const ReportOptions pages;
  const auto problem =
      write_pages({pages.pages_dir, pages.figures_dir, pages.python, true, pdf}, json);
  if (!problem.empty()) say("{}\n", problem);
  print(kind + ": " + (directory / (kind + ".html")).string() + "\n");
}

}  // namespace cagetol
