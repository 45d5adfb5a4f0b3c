#include "mc/commands/operating_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "mc/commands/outcome_text.hpp"
#include "mc/host/json_number.hpp"
#include "src/input/unit.hpp"
#include "src/model/bearing_model.hpp"
#include "src/quantities/window_times.hpp"

namespace cagetol {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr std::size_t kMostRows = 20;  // of a duty; more are for its file

std::string row_text(const DutyCourse::Row& row) {
  std::string text = fmt::format("  at {:.6g} s: {:.6g} rpm", row.time, row.inner / kRpm);
  if (row.outer != 0) text += fmt::format(", outer ring {:.6g} rpm", row.outer / kRpm);
  text += fmt::format(", {:.6g} N", row.radial);
  if (row.direction != 0) text += fmt::format(" turned by {:.4g} deg", row.direction / kDegree);
  if (row.axial != 0) text += fmt::format(", axially {:.6g} N", row.axial);
  if (row.moment_y != 0 || row.moment_z != 0)
    text += fmt::format(", moments {:.6g} and {:.6g} N m", row.moment_y, row.moment_z);
  return text + "\n";
}

std::string course_text(const DutyCourse& course) {
  const auto& rows = course.rows();
  std::string text =
      fmt::format("  {} instants, straight lines between them, {}\n", rows.size(),
                  course.repeats() ? fmt::format("again every {:.6g} s", course.period())
                                   : "then as at the last one");
  for (std::size_t i = 0; i < std::min(rows.size(), kMostRows); ++i) text += row_text(rows[i]);
  if (rows.size() > kMostRows) text += fmt::format("  and {} more\n", rows.size() - kMostRows);
  return text;
}

}  // namespace

std::string duty_text(const Scene& scene) {
  if (!changes_over_time(scene.operation)) return "";
  const BearingModel model = make_bearing_model(scene);
  std::string text = "duty over time\n";
  text += course_text(model.duty.course);
  for (std::size_t p = 0; p < scene.phase.name.size(); ++p)
    text += fmt::format("  phase {}: {:.6g} to {:.6g} s\n", scene.phase.name[p],
                        scene.phase.from.values[p], scene.phase.to.values[p]);
  const WindowTimes times = window_times(scene, model);
  return text + fmt::format("  settles for {:.6g} s, then measures for {:.6g} s\n", times.settle,
                            times.measure);
}

std::string operating_table(const Scene& scene) {
  std::string text;
  for (const std::string& warning : operating_warnings(scene)) text += "warning: " + warning + "\n";
  text += "operating point\n";
  const OperatingPoint at = operating_point(scene);
  const bool changes = changes_in_operation(scene);
  for (const OperatingRow& row : operating_rows())
    if (changes || !row.of_change) text += value_line(row.key, row.value(at), row.unit);
  return text;
}

nlohmann::ordered_json operating_json(const Scene& scene, double slip) {
  auto values = nlohmann::ordered_json::object(), units = values, slipping = values;
  const OperatingPoint at = operating_point(scene);
  for (const OperatingRow& row : operating_rows()) {
    values[row.key] = json_number(row.value(at));
    units[row.key] = row.unit;
    if (is_order(row)) slipping[row.key] = json_number(row.value(with_slip(at, slip)));
  }
  return {{"warnings", operating_warnings(scene)},
          {"values", values},
          {"units", units},
          {"with_slip", slipping}};
}

bool is_order(const OperatingRow& row) {
  return std::string_view(row.key).ends_with("_order");
}

}  // namespace cagetol
