#include "mc/commands/map_stages.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/report/python_run.hpp"
#include "analysis/report/report.hpp"
#include "analysis/study/refused.hpp"
#include "analysis/tolerance/map_cell.hpp"
#include "mc/commands/command.hpp"
#include "mc/commands/screen_stages.hpp"
#include "mc/commands/stage_study.hpp"
#include "mc/host/build_info.hpp"
#include "mc/host/file_write.hpp"
#include "mc/host/json_number.hpp"
#include "mc/study/map_axis.hpp"
#include "mc/study/operating_points.hpp"
#include "mc/sweep/sweep_directory.hpp"
#include "src/input/input_error.hpp"
#include "src/quantities/operating_point.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kLinePoints = 65;  ///< of a line across the map

struct Cell {
  std::vector<double> at = {};  ///< values of the axes
  std::string problem = {};     ///< why there is no answer
  std::optional<Study> study = {};
  StudyData runs = {};
  std::size_t lost = 0;
  std::vector<CellAnswer> answers = {};  ///< by dimension
};

struct Map {
  const Study& base;
  const std::vector<MapAxis>& axes;
  std::string directory;
  StagedSweeps& stages;
  std::vector<std::map<double, std::string>> candidates;  ///< grades by width in mm
  std::vector<Cell> cells;                                ///< rows upwards
};

Map make_map(const Study& base, const std::vector<MapAxis>& axes, const std::string& directory,
             StagedSweeps& stages) {
  Map map{base, axes, directory, stages, {}, {}};
  map.candidates.resize(base.tolerance.dimensions.size());
  for (const Candidate& each : base.candidates)
    for (std::size_t d = 0; d < map.candidates.size(); ++d) {
      const Candidate& first = base.candidates.front();
      if (const double away = each.middle(d) / each.scales[d] - first.middle(d) / first.scales[d];
          std::abs(away) > 1e-9)
        throw InputError({}, "tolerance.dimension.candidates", each.grades[d],
                         "a map orders the candidates of a dimension by their widths alone, and "
                         "the zones of these do not lie alike",
                         "give such as lie alike, all H or all js");
      map.candidates[d][each.tolerance_widths_mm[d]] = each.grades[d];
    }
  for (const double up : axes[0].values)
    for (const double across : axes[1].values) map.cells.emplace_back().at = {up, across};
  return map;
}

std::string folder_of(const Map& map, const Cell& cell) {
  return fmt::format("{}/{}-{}_{}-{}", map.directory, map.axes[0].key, cell.at[0], map.axes[1].key,
                     cell.at[1]);
}

/// Stored: finding its heat and its limits takes runs.
Study study_of(const Map& map, const Cell& cell) {
  const std::string file =
      fmt::format("{}/found-{}.toml", folder_of(map, cell),
                  text_hash(map.base.resolved_toml + map.base.hash + build_id(build_info())));
  if (const std::string text = file_text(file); !text.empty())
    return read_resolved_study(text, map.base.name);
  const Study study = study_at(map.base, map.axes, cell.at);
  make_directory(folder_of(map, cell));
  replace_file(file, study.resolved_toml);
  return study;
}

std::string grade_at(const Map& map, std::size_t dimension, long place) {
  if (place < 0) return "none";
  const auto& [width, grade] = *std::next(map.candidates[dimension].begin(), place);
  return grade.empty() ? fmt::format("{} mm", width) : grade;
}

Json row_of(const Map& map, const Cell& cell, std::size_t d) {
  const CellAnswer answer = cell.answers.empty() ? CellAnswer() : cell.answers[d];
  const CellCause next = answer.causes.size() > 1 ? answer.causes[1] : CellCause();
  Json row;
  const auto add_widths = [&row](const std::string& whose, const auto& of) {
    row[whose + "width_mm"] = json_number(of.width_mm.value_or(NAN));
    row[whose + "lower_mm"] = json_number(of.lower_mm.value_or(NAN));
    row[whose + "upper_mm"] = json_number(of.upper_mm.value_or(NAN));
  };
  for (std::size_t a = 0; a < map.axes.size(); ++a) row[map.axes[a].key] = cell.at[a];
  row["tolerance"] = map.base.tolerance.dimensions[d].key;
  row["problem"] = cell.problem;
  row["grade"] = grade_at(map, d, answer.candidate);
  row["lower_grade"] = grade_at(map, d, answer.lower);
  row["upper_grade"] = grade_at(map, d, answer.upper);
  row["candidate"] = answer.candidate;
  row["resolved"] = answer.resolved;
  row["decides"] = answer.decides;
  add_widths("", answer.reach);
  row["searched_mm"] = answer.reach.searched_mm;
  row["runner_up"] = next.name;
  add_widths("runner_up_", next);
  row["runs"] = cell.runs.size();
  row["lost"] = cell.lost;
  row["temperature_C"] = json_number(cell.study ? cell.study->scene.lubrication.temperature : NAN);
  row["may_decide"] = Json::array();
  for (const CellCause& cause : answer.causes)
    if (cause.may_decide) row["may_decide"].push_back(cause.name);
  return row;
}

/// Exit code of the sweep; what keeps the cell from an answer becomes its problem.
int run_cell(const Map& map, Cell& cell, const ScreenStage& stage) {
  cell.answers.clear();
  try {
    if (!cell.study) cell.study = study_of(map, cell);
    const ScreenDesign design = screen_design(*cell.study, stage);
    const std::string directory = folder_of(map, cell) + "/" + stage.name;
    if (const int code = map.stages.sweep(design.study, directory)) return code;
    add_runs(cell.runs, read_study_data(study_file_path(directory)));
    const Screen screen = screen_limits(cell.runs, design.dimensions, design.jams);
    cell.lost = screen.lost;
    for (std::size_t d = 0; d < map.candidates.size(); ++d)
      cell.answers.push_back(cell_answer(screen, d, map.candidates[d]));
    cell.problem.clear();
  } catch (const Refused& refusal) {
    cell.problem = refusal.what();
  } catch (const InputError& problem) {
    if (cell.study) throw;  // of the directory
    cell.problem = problem.what();
  }
  std::string text =
      fmt::format("{} {:g}, {} {:g}", map.axes[0].key, cell.at[0], map.axes[1].key, cell.at[1]);
  for (std::size_t d = 0; d < cell.answers.size(); ++d) {
    const Json of = row_of(map, cell, d);
    text +=
        fmt::format(": {} {} ({} to {}), by {}", of["tolerance"], of["grade"], of["lower_grade"],
                    of["upper_grade"], of["decides"] == "" ? "nothing" : of["may_decide"].dump());
  }
  print(text + (cell.problem.empty() ? "" : ": no answer: " + cell.problem) + "\n");
  return kDone;
}

/// Whether there is no answer, or it is in doubt and that of a neighbour is another one.
bool needs_more(const Map& map, std::size_t place) {
  const Cell& cell = map.cells[place];
  if (cell.answers.empty()) return cell.study.has_value();
  const std::size_t columns = map.axes[1].values.size();
  for (std::size_t d = 0; d < cell.answers.size(); ++d) {
    const CellAnswer& own = cell.answers[d];
    if (!own.resolved) return true;
    for (std::size_t other = 0; other < map.cells.size() && !own.certain; ++other) {
      const std::size_t step = std::max(other, place) - std::min(other, place);
      const bool beside = step == columns || (step == 1 && other / columns == place / columns);
      if (beside && !map.cells[other].answers.empty() &&
          !same_answer(own, map.cells[other].answers[d]))
        return true;
    }
  }
  return false;
}

int run_cells(Map& map) {
  for (Cell& cell : map.cells)
    if (const int code =
            run_cell(map, cell, {"screen", "map.budget_samples", map.base.map.budget_samples}))
      return code;
  std::vector<Cell*> more;
  for (std::size_t i = 0; i < map.cells.size(); ++i)
    if (needs_more(map, i)) more.push_back(&map.cells[i]);
  for (Cell* cell : more)
    if (const int code =
            run_cell(map, *cell, {"more", "map.border_samples", map.base.map.border_samples}))
      return code;
  return kDone;
}

/// Why no cell has an answer; empty where one has.
std::string nothing_known(const Map& map) {
  const auto answered = [](const Cell& cell) { return !cell.answers.empty(); };
  return std::ranges::none_of(map.cells, answered) ? map.cells.front().problem : "";
}

/// What the maker says of loads and speeds, where these are the axes: polylines of places on them.
Json lines_of(const Map& map) {
  Json lines = Json::array();
  const std::size_t load = map.axes[1].key == "load.radial_N", speed = 1 - load;
  if (map.axes[load].key != "load.radial_N" || map.axes[speed].key != "speed.inner_rpm")
    return lines;
  const auto &loads = map.axes[load].values, &speeds = map.axes[speed].values;
  const auto place = [&](double rpm, double newtons) {
    return load == 0 ? Json{newtons, rpm} : Json{rpm, newtons};
  };
  const auto add_speed = [&](const std::string& name, double rpm) {
    if (rpm >= speeds.front() && rpm <= speeds.back())
      lines.push_back(
          {{"name", name}, {"points", {place(rpm, loads.front()), place(rpm, loads.back())}}});
  };
  Json minimum = Json::array();
  Scene scene = map.base.scene;
  for (int k = 0; k < kLinePoints; ++k) {
    const double rpm = std::lerp(speeds.front(), speeds.back(), k / (kLinePoints - 1.0));
    scene.operation.inner_speed = rpm * kRpm;
    minimum.push_back(place(rpm, minimum_load_of(scene)));
  }
  if (std::isfinite(minimum_load_of(scene)))
    lines.push_back({{"name", "minimum load"}, {"points", minimum}});
  add_speed("limiting speed", scene.bearing.limiting_speed / kRpm);
  for (double decade = 1e3; decade < 1e7; decade *= 10)
    for (const double step : {1, 2, 5})
      add_speed(fmt::format("n d_m {:g}", step * decade),
                step * decade / (2e3 * pitch_radius(scene.bearing)));
  return lines;
}

/// The study's own operating points.
Json points_of(const Map& map) {
  Json list = Json::array();
  const auto add = [&](const std::string& name, const Scene& scene) {
    Json& at = list.emplace_back(Json{{"name", name}, {"at", Json::array()}})["at"];
    for (const MapAxis& axis : map.axes)
      at.push_back(key_numbers(*find_key(scene_keys(), axis.key), scene).front());
  };
  for (const OperatingPointPlan& point : map.base.points)
    add(point.name, at_operating_point(map.base.scene, point));
  if (map.base.points.empty()) add("the study's own", map.base.scene);
  return list;
}

Json map_json(const Map& map) {
  Json json = {{"kind", "map"},
               {"report_version", kReportVersion},
               {"study", map.base.name},
               {"build", build_id(build_info())},
               {"target_yield", map.base.tolerance.target_yield},
               {"confidence", map.base.tolerance.confidence},
               {"budget_samples", map.base.map.budget_samples},
               {"border_samples", map.base.map.border_samples},
               {"lines", lines_of(map)},
               {"points", points_of(map)}};
  for (const MapAxis& axis : map.axes)
    json["axes"].push_back({{"key", axis.key},
                            {"unit", find_key(scene_keys(), axis.key)->unit},
                            {"logarithmic", axis.logarithmic},
                            {"values", axis.values}});
  for (std::size_t d = 0; d < map.candidates.size(); ++d)
    json["dimensions"].push_back(
        {{"key", map.base.tolerance.dimensions[d].key}, {"candidates", map.candidates[d].size()}});
  for (const Cell& cell : map.cells)
    for (std::size_t d = 0; d < map.candidates.size(); ++d)
      json["rows"].push_back(row_of(map, cell, d));
  return json;
}

std::vector<MapAxis> axes_of(const std::vector<std::string>& over, const Study& study) {
  std::vector<MapAxis> axes;
  for (const std::string& text : over) axes.push_back(read_map_axis(text, study));
  if (axes.size() != 2 || axes[0].key == axes[1].key)
    throw InputError({}, "--over", fmt::format("{}", fmt::join(over, " ")),
                     "a map is over two keys",
                     "give two, as --over load.radial_N=100..10000:6:log --over "
                     "speed.inner_rpm=1000..14000:6");
  return axes;
}

}  // namespace

int run_map(const std::function<Study()>& read, const MakePlan& make_plan,
            const MapOptions& options) {
  std::vector<MapAxis> axes;
  const auto read_with_axes = [&] {
    Study study = read();
    axes = axes_of(options.over, study);
    return study;
  };
  const auto lead = [&](const Study& base, StagedSweeps& stages) -> int {
    spdlog::set_level(spdlog::level::warn);  // a line for each cell shows how far its sweeps are
    const std::string folder = options.directory + "/map";
    Map map = make_map(base, axes, folder, stages);
    if (const int code = run_cells(map)) return code;
    if (const std::string problem = nothing_known(map); !problem.empty()) {
      spdlog::error("no cell has an answer; the first: {}", problem);
      return kSamplesFailed;
    }
    const Json json = map_json(map);
    write_result(json, json["rows"], folder, options.pdf);
    return kDone;
  };
  return run_staged_study(read_with_axes, make_plan, options.directory, options.progress, lead);
}

}  // namespace cagetol
