#include "mc/commands/operating_text.hpp"

#include <cmath>

#include "mc/commands/outcome_text.hpp"
#include "mc/json_number.hpp"
#include "src/quantities/operating_point.hpp"

namespace cagetol {

std::string operating_table(const Scene& scene) {
  std::string text;
  for (const std::string& warning : operating_warnings(scene)) text += "warning: " + warning + "\n";
  text += "operating point\n";
  const OperatingPoint at = operating_point(scene);
  const bool changes = changes_in_operation(scene);
  for (const OperatingRow& row : operating_rows())
    if ((changes || !row.of_change) && !(row.of_some && std::isnan(row.value(at))))
      text += value_line(row.key, row.value(at), row.unit);
  return text;
}

nlohmann::ordered_json operating_json(const Scene& scene) {
  auto values = nlohmann::ordered_json::object(), units = nlohmann::ordered_json::object();
  const OperatingPoint at = operating_point(scene);
  for (const OperatingRow& row : operating_rows()) {
    values[row.key] = json_number(row.value(at));
    units[row.key] = row.unit;
  }
  return {{"warnings", operating_warnings(scene)}, {"values", values}, {"units", units}};
}

}  // namespace cagetol
