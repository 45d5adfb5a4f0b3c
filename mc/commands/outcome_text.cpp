#include "mc/commands/outcome_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mc/host/json_number.hpp"
#include "src/quantities/centre_path.hpp"
#include "src/quantities/quantity_labels.hpp"
#include "src/quantities/quantity_table.hpp"

namespace cagetol {
namespace {

std::string class_of(const Outcome& outcome) {
  const auto value = [&](const char* key) {
    const auto row = static_cast<std::size_t>(quantity_index(key));
    return row < outcome.quantities.size() ? outcome.quantities[row] : std::nan("");
  };
  return whirl_class(value("whirl_ratio"), value("whirl_load_line_ratio"),
                     value("whirl_circling_ratio"));
}

}  // namespace

std::string value_line(const std::string& key, double value, const std::string& unit) {
  const std::string number = std::isfinite(value) ? fmt::format("{:.6g}", value) : "-";
  return fmt::format("  {:<36}{:>14}  {}\n", key, number, unit == "-" ? "" : unit);
}

nlohmann::ordered_json outcome_json(const Outcome& outcome) {
  nlohmann::ordered_json json = {{"status", status_name(outcome.status)},
                                 {"reason", outcome.reason}};
  auto& quantities = json["qoi"] = nlohmann::ordered_json::object();
  const std::vector<LabelledQuantity> columns = labelled_quantities(outcome.labels);
  for (std::size_t i = 0; i < columns.size(); ++i)
    quantities[columns[i].name] =
        i < outcome.quantities.size() ? json_number(outcome.quantities[i]) : nullptr;
  json["whirl_class"] = class_of(outcome);
  auto& units = json["units"] = nlohmann::ordered_json::object();
  for (const LabelledQuantity& quantity : columns) units[quantity.name] = quantity.unit;
  for (const RunField& field : run_fields()) units[field.key] = field.unit;
  units["wall_s"] = "s";
  auto& run = json["run"] = nlohmann::ordered_json::object();
  const auto values = run_values(outcome.run);
  for (std::size_t i = 0; i < values.size(); ++i) run[run_fields()[i].key] = json_number(values[i]);
  run["wall_s"] = outcome.run.wall_s;
  return json;
}

std::string outcome_table(const Outcome& outcome) {
  std::string text = "quantities of interest\n";
  const std::vector<LabelledQuantity> columns = labelled_quantities(outcome.labels);
  for (std::size_t i = 0; i < outcome.quantities.size(); ++i)
    // What a label leaves undefined says nothing anew.
    if (i < quantity_table().size() || std::isfinite(outcome.quantities[i]))
      text += value_line(columns[i].name, outcome.quantities[i], columns[i].unit);
  if (class_of(outcome) != "unknown")
    text += fmt::format("  the cage's centre is {}\n", class_of(outcome));
  text += "run\n";
  const auto values = run_values(outcome.run);
  for (std::size_t i = 0; i < values.size(); ++i)
    text += value_line(run_fields()[i].key, values[i], run_fields()[i].unit);
  text += value_line("wall_s", outcome.run.wall_s, "s");
  return text;
}

}  // namespace cagetol
