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

class MapLeader {
 public:
  MapLeader(const Study& base, const std::vector<MapAxis>& axes, const std::string& directory,
            StagedSweeps& stages)
      : base_(base), axes_(axes), directory_(directory), stages_(stages) {
    candidates_.resize(base.tolerance.dimensions.size());
    for (const Candidate& each : base.candidates)
      for (std::size_t d = 0; d < candidates_.size(); ++d) {
        const Candidate& first = base.candidates.front();
        if (const double away = each.middle(d) / each.scales[d] - first.middle(d) / first.scales[d];
            std::abs(away) > 1e-9)
          throw InputError({}, "tolerance.dimension.candidates", each.grades[d],
                           "a map orders the candidates of a dimension by their widths alone, and "
                           "the zones of these do not lie alike",
                           "give such as lie alike, all H or all js");
        candidates_[d][each.tolerance_widths_mm[d]] = each.grades[d];
      }
    for (const double up : axes_[0].values)
      for (const double across : axes_[1].values) cells_.emplace_back().at = {up, across};
  }
  int lead();
  Json json() const;
  /// Why no cell has an answer; empty where one has.
  std::string nothing() const;

 private:
  std::string folder(const Cell& cell) const {
    return fmt::format("{}/{}-{}_{}-{}", directory_, axes_[0].key, cell.at[0], axes_[1].key,
                       cell.at[1]);
  }
  Study study_of(const Cell& cell) const;
  int run(Cell& cell, const ScreenStage& stage);
  bool needs_more(std::size_t place) const;
  std::string grade_at(std::size_t dimension, long place) const;
  Json row(const Cell& cell, std::size_t dimension) const;
  Json lines() const;
  Json points() const;

  const Study& base_;
  std::vector<MapAxis> axes_;
  std::string directory_;
  StagedSweeps& stages_;
  std::vector<std::map<double, std::string>> candidates_;  ///< grades by width in mm
  std::vector<Cell> cells_;                                ///< rows upwards
};

/// Stored: finding its heat and its limits takes runs.
Study MapLeader::study_of(const Cell& cell) const {
  const std::string file =
      fmt::format("{}/found-{}.toml", folder(cell),
                  text_hash(base_.resolved_toml + base_.hash + build_id(build_info())));
  if (const std::string text = file_text(file); !text.empty())
    return read_resolved_study(text, base_.name);
  const Study study = study_at(base_, axes_, cell.at);
  make_directory(folder(cell));
  replace_file(file, study.resolved_toml);
  return study;
}

/// Exit code of the sweep; what keeps the cell from an answer becomes its problem.
int MapLeader::run(Cell& cell, const ScreenStage& stage) {
  cell.answers.clear();
  try {
    if (!cell.study) cell.study = study_of(cell);
    const ScreenDesign design = screen_design(*cell.study, stage);
    const std::string directory = folder(cell) + "/" + stage.name;
    if (const int code = stages_.sweep(design.study, directory)) return code;
    add_runs(cell.runs, read_study_data(study_file_path(directory)));
    const Screen screen = screen_limits(cell.runs, design.dimensions, design.jams);
    cell.lost = screen.lost;
    for (std::size_t d = 0; d < candidates_.size(); ++d)
      cell.answers.push_back(cell_answer(screen, d, candidates_[d]));
    cell.problem.clear();
  } catch (const Refused& refusal) {
    cell.problem = refusal.what();
  } catch (const InputError& problem) {
    if (cell.study) throw;  // of the directory
    cell.problem = problem.what();
  }
  std::string text =
      fmt::format("{} {:g}, {} {:g}", axes_[0].key, cell.at[0], axes_[1].key, cell.at[1]);
  for (std::size_t d = 0; d < cell.answers.size(); ++d) {
    const Json of = row(cell, d);
    text +=
        fmt::format(": {} {} ({} to {}), by {}", of["tolerance"], of["grade"], of["lower_grade"],
                    of["upper_grade"], of["decides"] == "" ? "nothing" : of["may_decide"].dump());
  }
  print(text + (cell.problem.empty() ? "" : ": no answer: " + cell.problem) + "\n");
  return kDone;
}

/// Whether there is no answer, or it is in doubt and that of a neighbour is another one.
bool MapLeader::needs_more(std::size_t place) const {
  const Cell& cell = cells_[place];
  if (cell.answers.empty()) return cell.study.has_value();
  const std::size_t columns = axes_[1].values.size();
  for (std::size_t d = 0; d < cell.answers.size(); ++d) {
    const CellAnswer& own = cell.answers[d];
    if (!own.resolved) return true;
    for (std::size_t other = 0; other < cells_.size() && !own.certain; ++other) {
      const std::size_t step = std::max(other, place) - std::min(other, place);
      const bool beside = step == columns || (step == 1 && other / columns == place / columns);
      if (beside && !cells_[other].answers.empty() && !same_answer(own, cells_[other].answers[d]))
        return true;
    }
  }
  return false;
}

int MapLeader::lead() {
  for (Cell& cell : cells_)
    if (const int code = run(cell, {"screen", "map.budget_samples", base_.map.budget_samples}))
      return code;
  std::vector<Cell*> more;
  for (std::size_t i = 0; i < cells_.size(); ++i)
    if (needs_more(i)) more.push_back(&cells_[i]);
  for (Cell* cell : more)
    if (const int code = run(*cell, {"more", "map.border_samples", base_.map.border_samples}))
      return code;
  return kDone;
}

std::string MapLeader::nothing() const {
  const auto answered = [](const Cell& cell) { return !cell.answers.empty(); };
  return std::ranges::none_of(cells_, answered) ? cells_.front().problem : "";
}

std::string MapLeader::grade_at(std::size_t dimension, long place) const {
  if (place < 0) return "none";
  const auto& [width, grade] = *std::next(candidates_[dimension].begin(), place);
  return grade.empty() ? fmt::format("{} mm", width) : grade;
}

Json MapLeader::row(const Cell& cell, std::size_t d) const {
  const CellAnswer answer = cell.answers.empty() ? CellAnswer() : cell.answers[d];
  const CellCause next = answer.causes.size() > 1 ? answer.causes[1] : CellCause();
  Json row;
  const auto add_widths = [&row](const std::string& whose, const auto& of) {
    row[whose + "width_mm"] = json_number(of.width_mm.value_or(NAN));
    row[whose + "lower_mm"] = json_number(of.lower_mm.value_or(NAN));
    row[whose + "upper_mm"] = json_number(of.upper_mm.value_or(NAN));
  };
  for (std::size_t a = 0; a < axes_.size(); ++a) row[axes_[a].key] = cell.at[a];
  row["tolerance"] = base_.tolerance.dimensions[d].key;
  row["problem"] = cell.problem;
  row["grade"] = grade_at(d, answer.candidate);
  row["lower_grade"] = grade_at(d, answer.lower);
  row["upper_grade"] = grade_at(d, answer.upper);
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

/// What the maker says of loads and speeds, where these are the axes: polylines of places on them.
Json MapLeader::lines() const {
  Json lines = Json::array();
  const std::size_t load = axes_[1].key == "load.radial_N", speed = 1 - load;
  if (axes_[load].key != "load.radial_N" || axes_[speed].key != "speed.inner_rpm") return lines;
  const auto &loads = axes_[load].values, &speeds = axes_[speed].values;
  const auto place = [&](double rpm, double newtons) {
    return load == 0 ? Json{newtons, rpm} : Json{rpm, newtons};
  };
  const auto add_speed = [&](const std::string& name, double rpm) {
    if (rpm >= speeds.front() && rpm <= speeds.back())
      lines.push_back(
          {{"name", name}, {"points", {place(rpm, loads.front()), place(rpm, loads.back())}}});
  };
  Json minimum = Json::array();
  Scene scene = base_.scene;
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
Json MapLeader::points() const {
  Json list = Json::array();
  const auto add = [&](const std::string& name, const Scene& scene) {
    Json& at = list.emplace_back(Json{{"name", name}, {"at", Json::array()}})["at"];
    for (const MapAxis& axis : axes_)
      at.push_back(key_numbers(*find_key(scene_keys(), axis.key), scene).front());
  };
  for (const OperatingPointPlan& point : base_.points)
    add(point.name, at_operating_point(base_.scene, point));
  if (base_.points.empty()) add("the study's own", base_.scene);
  return list;
}

Json MapLeader::json() const {
  Json map = {{"kind", "map"},
              {"report_version", kReportVersion},
              {"study", base_.name},
              {"build", build_id(build_info())},
              {"target_yield", base_.tolerance.target_yield},
              {"confidence", base_.tolerance.confidence},
              {"budget_samples", base_.map.budget_samples},
              {"border_samples", base_.map.border_samples},
              {"lines", lines()},
              {"points", points()}};
  for (const MapAxis& axis : axes_)
    map["axes"].push_back({{"key", axis.key},
                           {"unit", find_key(scene_keys(), axis.key)->unit},
                           {"logarithmic", axis.logarithmic},
                           {"values", axis.values}});
  for (std::size_t d = 0; d < candidates_.size(); ++d)
    map["dimensions"].push_back(
        {{"key", base_.tolerance.dimensions[d].key}, {"candidates", candidates_[d].size()}});
  for (const Cell& cell : cells_)
    for (std::size_t d = 0; d < candidates_.size(); ++d) map["rows"].push_back(row(cell, d));
  return map;
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
    MapLeader leader(base, axes, folder, stages);
    if (const int code = leader.lead()) return code;
    if (const std::string problem = leader.nothing(); !problem.empty()) {
      spdlog::error("no cell has an answer; the first: {}", problem);
      return kSamplesFailed;
    }
    const Json map = leader.json();
    write_result(map, map["rows"], folder, options.pdf);
    return kDone;
  };
  return run_staged_study(read_with_axes, make_plan, options.directory, options.progress, lead);
}

}  // namespace cagetol
