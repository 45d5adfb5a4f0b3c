#include "src/reading/duty_file.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "src/input/csv_heading.hpp"
#include "src/input/csv_records.hpp"
#include "src/input/measurement_csv.hpp"
#include "src/input/printable.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kLongestField = 40;

/// Keys that a column may fill: "duty.time_s", ...
std::vector<const Key<Scene>*> column_keys() {
  std::vector<const Key<Scene>*> keys;
  for (const auto& key : scene_keys())
    if (key.name.starts_with("duty.") && key.kind == KeyKind::list) keys.push_back(&key);
  return keys;
}

std::string heading_of(const KeyInfo& key) {
  return key.name.substr(std::string("duty.").size());
}

std::string known_headings() {
  std::string text;
  for (const auto* key : column_keys()) text += (text.empty() ? "" : ", ") + heading_of(*key);
  return text;
}

/// The key that a column fills.
const Key<Scene>& key_of(std::string_view heading, const SourcePlace& place) {
  const CsvHeading given = csv_heading(heading);
  const std::string shown = excerpt(std::string(heading), kLongestField);
  std::vector<std::string> names;
  for (const auto* key : column_keys()) {
    names.push_back(heading_of(*key));
    const std::string stem(without_unit(names.back()));
    if (given.name != stem && !(given.unit.empty() && given.name.starts_with(stem + "_"))) continue;
    const Unit* unit = find_unit(given.unit);
    const Unit& wanted = unit_of(key->name);
    if (!unit || unit->dimension != wanted.dimension)
      throw InputError(place, "duty.file", shown,
                       "this heading ends in no unit of a " + wanted.dimension + " that is known",
                       "convert the column where needed, and write " + names.back());
    return *key;
  }
  const std::string all = "columns are " + known_headings();
  if (std::string_view("+-.0123456789").find(shown[0]) != std::string_view::npos)
    throw InputError(place, "duty.file", shown, "the first line must name the columns", all);
  throw InputError(place, "duty.file", shown, "no column of a duty has this name",
                   suggestion(shown, names, all));
}

}  // namespace

void read_duty_file(const toml::node& node, const std::string& file, DutyTable& table) {
  namespace fs = std::filesystem;
  const SourcePlace from = place_of(node, file);
  const std::string name = table.file;
  const fs::path folder = from.line > 0 ? fs::path(from.file).parent_path() : fs::path();
  const std::string path = (folder / name).string();
  Scene filled;
  filled.operation.table = table;
  for (const auto* key : column_keys())
    if (!key_numbers(*key, filled).empty())
      throw InputError(from, "duty.file", name,
                       "the scene gives " + key->name + " beside a file that holds all columns",
                       "leave one of the two out");
  std::string bytes, text;
  try {
    bytes = read_text_file(path);
    text = csv_text(bytes, path);
  } catch (const InputError& problem) {
    throw InputError(from, "duty.file", name, problem.what(),
                     "name a CSV file, its path relative to the file that names it");
  }
  CsvRecords records(text, path, false);
  if (!records.next())
    throw InputError({path, 0}, "duty.file", name, "the file is empty",
                     "write a header (" + known_headings() + "), then a line for each instant");
  const std::vector<std::string> headings(records.fields().begin(), records.fields().end());
  std::set<std::string> seen;
  for (const std::string& heading : headings)
    if (const std::string& key = key_of(heading, records.place()).name; !seen.insert(key).second)
      throw InputError(records.place(), key, "", "a second column of this name",
                       "leave one of them out");
  if (!seen.contains("duty.time_s"))
    throw InputError(records.place(), "duty.file", name, "no column tells the time",
                     "add a column time_s");
  for (const std::string& heading : headings) {
    const Key<Scene>& key = key_of(heading, records.place());
    const MeasuredColumn column = measured_column(bytes, path, {heading, unit_of(key.name).suffix});
    const std::vector<double>& values = column.values;
    auto& place = std::get<std::function<NumberList&(Scene&)>>(key.place)(filled);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const auto refuse = [&](const char* problem, const std::string& remedy) {
        throw InputError({path, column.lines[k]}, key.name, number_text(values[k]), problem,
                         remedy);
      };
      if (!allows(key, values[k]))
        refuse("outside the range of this column", "give values " + range_text(key));
      if (key.name == "duty.time_s" && k > 0 && !(values[k] > values[k - 1]))
        refuse("times must increase from line to line",
               values[k] < values[k - 1] ? "sort the lines by time"
                                         : "a step needs two different times, 1 ns apart or more");
      place.values.push_back(to_si(values[k], key.to_si));
    }
  }
  table = filled.operation.table;
  table.file.clear();
}

void read_phases(const toml::node& node, const std::string& file, Phases& phases) {
  static const std::vector<std::string> known = {"name", "from_s", "to_s"};
  for (const auto& element : *node.as_array()) {
    const auto* entry = element.as_table();
    if (!entry || !entry->contains("name") || !entry->contains("from_s") ||
        !entry->contains("to_s"))
      throw InputError(place_of(element, file), "phase", shown(element),
                       "a phase has a name, a beginning and an end",
                       "write [[phase]] with name = \"braking\", from_s = 0.1, to_s = 0.2");
    for (const auto& [key, value] : *entry)
      if (std::find(known.begin(), known.end(), key.str()) == known.end())
        throw InputError(place_of(value, file), "phase." + std::string(key.str()), shown(value),
                         "no such key", suggestion(key.str(), known));
    const auto number = [&](const char* name) {
      const Key<Scene>& key = *find_key(scene_keys(), std::string("phase.") + name);
      return number_value(key, *entry->get(name), file);
    };
    phases.name.push_back(
        text_value(*find_key(scene_keys(), "phase.name"), *entry->get("name"), file));
    phases.from.values.push_back(number("from_s"));
    phases.to.values.push_back(number("to_s"));
  }
}

}  // namespace cagetol
