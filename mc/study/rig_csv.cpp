#include "mc/study/rig_csv.hpp"

#include <algorithm>

#include "src/input/csv_heading.hpp"
#include "src/input/csv_records.hpp"
#include "src/input/key_table.hpp"
#include "src/input/measurement_csv.hpp"
#include "src/input/toml_file.hpp"

namespace cagetol {
namespace {

/// Throws for columns of other names. Whether the cage has a speed; else it has an order.
bool gives_cage_speed(const std::vector<std::string>& headings, const SourcePlace& place) {
  static const std::vector<std::string> known = {"radial_N", "speed_rpm", "cage_rpm", "cage_order"};
  const auto name = [](const std::string& heading) { return csv_heading(heading).name; };
  for (const std::string& heading : headings)
    if (!heading.empty() && std::ranges::count(known, name(heading), name) == 0)
      throw InputError(place, heading, "", "a rig's file has no such column",
                       suggestion(heading, known, "remove it"));
  const bool speed = !named_columns(headings, "cage").empty();
  if (speed == !named_columns(headings, known[3]).empty())
    throw InputError(place, "cage_rpm, cage_order", "", speed ? "both are given" : "none is given",
                     "give one: the cage's speed, or that over the inner ring's");
  return speed;
}

void check_measurement(const RigMeasurement& row, const std::string& path) {
  const auto hold = [&](bool right, const char* what, double value, const char* why,
                        const char* remedy) {
    if (!right) throw InputError({path, row.line}, what, number_text(value), why, remedy);
  };
  hold(row.radial_load >= 0, "radial_N", row.radial_load, "a load below 0", "give its amount");
  hold(row.speed > 0, "speed_rpm", row.speed, "the inner ring does not turn forwards",
       "give the amount of its speed, or remove the row");
  hold(row.cage_order >= 0 && row.cage_order <= 1, "cage order", row.cage_order,
       "the cage turns backwards, or faster than the ring that drives it",
       "check signs and units of both speeds, and which line of the spectrum is the cage's");
}

}  // namespace

std::vector<RigMeasurement> read_rig_csv(const std::string& path, bool decimal_comma) {
  const std::string bytes = read_text_file(path), text = csv_text(bytes, path);
  const auto column = [&](const std::string& name, const std::string& unit) {
    return csv_column(bytes, path, {name, unit, decimal_comma});
  };
  const auto loads = column("radial", "N"), speeds = column("speed", "rpm");
  CsvRecords records(text, path, decimal_comma);
  records.next();
  const bool as_speed =
      gives_cage_speed({records.fields().begin(), records.fields().end()}, records.place());
  const auto cage = as_speed ? column("cage", "rpm") : column("cage_order", "");
  std::vector<RigMeasurement> rows;
  for (std::size_t k = 0; records.next(); ++k) {
    rows.push_back(
        {records.place().line, loads[k], speeds[k], as_speed ? cage[k] / speeds[k] : cage[k]});
    check_measurement(rows.back(), path);
  }
  return rows;
}

}  // namespace cagetol
