#include "mc/commands/rig_stages.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/compare/rig_verdict.hpp"
#include "analysis/study/study_data.hpp"
#include "mc/study/study_inputs.hpp"
#include "mc/study_file/exit_code.hpp"
#include "mc/sweep/sweep_directory.hpp"
#include "src/input/unit.hpp"
#include "src/model/bearing_model.hpp"
#include "src/quantities/operating_point.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

using Json = nlohmann::ordered_json;

/// Of each run, in the order of its starts; NaN without a result.
std::vector<double> slips_in(const std::string& directory) {
  const StudyData runs = read_study_data(study_file_path(directory));
  return ok_values(runs, find_quantity(runs, "cage_slip_ratio")->values);
}

/// What would explain a measurement beyond the interval over starts, in words.
std::string reason_of(const RigVerdict& verdict, const std::vector<Alternative>& ends) {
  constexpr std::size_t most = 3;
  std::string explains;
  const auto add = [&](std::size_t k) {
    explains += fmt::format("{}{} = {} ({:.2f} %)", explains.empty() ? "" : ", ", ends[k].key,
                            ends[k].value, 100 * (verdict.starts.value + verdict.shifts[k]));
  };
  if (verdict.within_starts || verdict.shifts.empty()) return "";
  for (std::size_t i = 0; i < std::min(most, verdict.covering.size()); ++i)
    add(verdict.covering[i]);
  if (!explains.empty()) return "explained on the way to " + explains;
  if (verdict.nearest < 0) return "no assumption explains it";
  add(static_cast<std::size_t>(verdict.nearest));
  return "no assumption alone explains it; nearest: " + explains;
}

/// Numbers that are not known are NaN, which JSON files have as null.
Json row_json(const RigMeasurement& row, const OperatingPoint& at, const RigVerdict& verdict) {
  const auto order = [&](double slip) { return cage_order(with_slip(at, slip)); };
  const double predicted = order(verdict.starts.value);
  return {{"line", row.line},
          {"radial_N", row.radial_load},
          {"speed_rpm", row.speed},
          {"kinematic_order", cage_order(at)},
          {"measured_order", row.cage_order},
          {"order", predicted},
          {"order_lower", order(verdict.all.upper)},
          {"order_upper", order(verdict.all.lower)},
          {"inner_passing_order", at.rollers * (1 - predicted)},
          {"outer_passing_order", at.rollers * predicted},
          {"measured_slip", 1 - row.cage_order / cage_order(at)},
          {"slip", verdict.starts.value},
          {"starts_lower", verdict.starts.lower},
          {"starts_upper", verdict.starts.upper},
          {"lower", verdict.all.lower},
          {"upper", verdict.all.upper},
          {"wide", verdict.is_wide},
          {"runs", verdict.runs},
          {"standing", verdict.runs < 2        ? "no result"
                       : verdict.within_starts ? "within starts"
                       : verdict.within_all    ? "within assumptions"
                                               : "outside"}};
}

}  // namespace

Study rig_study(const Study& given, const RigMeasurement& row, long starts) {
  return changed_study({}, [&](Study& study) {
    study.name =
        fmt::format("{} at {:.6g} N, {:.6g} r/min", given.name, row.radial_load, row.speed);
    study.seed = given.seed;
    study.samples = starts;
    study.allowed_failure_share = 1;  // a row without result says so
    Scene& scene = study.scene = given.scene;
    scene.operation.radial_load = row.radial_load;
    scene.operation.inner_speed = row.speed * kRpm;
    scene.temperature.found = kAuto;
    // Ranges may change: each end is a sweep of its own.
    for (Assumption& assumption : scene.assumptions) assumption = {assumption.key, assumption.note};
    const double sigma_um = 1e5 * make_bearing_model(OperatingScene(scene)).guide_clearance;
    const auto add_noise = [&](const char* name, const Law& law) {
      const auto& key = *find_key(scene_keys(), name);
      study.inputs.push_back({key.name, key.unit, key_numbers(key, scene), false, {}, {}, law});
    };
    add_noise("start.cage_offset_y_um", Normal{0, sigma_um});
    add_noise("start.cage_offset_z_um", Normal{0, sigma_um});
    add_noise("start.cage_phase_deg", Uniform{0, 360});
  });
}

int run_rig_row(const Study& base, const RigMeasurement& row,
                const std::vector<Alternative>& alternatives, const std::string& directory,
                StagedSweeps& stages, Json& rows) {
  const std::string folder =
      fmt::format("{}/rows/{}N-{}rpm/", directory, row.radial_load, row.speed);
  if (const int code = stages.sweep(base, folder + "base")) return code;
  std::vector<AssumedSlips> ends;
  for (const Alternative& end : alternatives) {
    const std::string place = fmt::format("{}{}-{}", folder, end.key, end.value);
    const Study study = changed_study(base, [&](Study& changed) {
      changed.name += fmt::format(", {} = {}", end.key, end.value);
      changed.samples = kRunsOfAnEnd;
      apply_alternative(end, changed);
    });
    if (const int code = stages.sweep(study, place)) return code;
    ends.push_back({end.key, slips_in(place)});
  }
  const OperatingPoint at = operating_point(base.scene);
  const RigVerdict verdict =
      hold_against(1 - row.cage_order / cage_order(at), slips_in(folder + "base"), ends);
  Json& json = rows.emplace_back(row_json(row, at, verdict));
  json["reason"] = reason_of(verdict, alternatives);
  for (std::size_t k = 0; k < verdict.shifts.size(); ++k)
    json["shifts"][alternatives[k].key][fmt::format("{}", alternatives[k].value)] =
        verdict.shifts[k];
  return kDone;
}

}  // namespace cagetol
