#include "src/catalogue/catalogue.hpp"

#include <algorithm>
#include <cctype>
#include <limits>
#include <map>
#include <sstream>

#include "src/catalogue/catalogue_table.hpp"
#include "src/input/input_error.hpp"
#include "src/input/key_table.hpp"
#include "src/input/unit.hpp"

namespace cagetol {
namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream rest(line);
  for (std::string field; std::getline(rest, field, ',');) fields.push_back(field);
  if (line.ends_with(',')) fields.emplace_back();
  return fields;
}

/// One row by the names of its columns.
class Fields {
 public:
  Fields(const std::vector<std::string>& heading, const std::vector<std::string>& fields,
         const SourcePlace& place)
      : place_(place) {
    if (fields.size() != heading.size())
      throw InputError(place, "", "",
                       "the row has " + std::to_string(fields.size()) + " fields, the heading " +
                           std::to_string(heading.size()),
                       "give every column, empty where a value is not known");
    for (std::size_t k = 0; k < heading.size(); ++k) of_[heading[k]] = fields[k];
  }

  const std::string& text(const std::string& column) const {
    const auto found = of_.find(column);
    if (found == of_.end()) throw InputError(place_, column, "", "no such column", "add it");
    return found->second;
  }
  /// In SI, by the unit at the end of the column's name; NaN where the field is empty.
  double number(const std::string& column) const {
    const std::string& field = text(column);
    if (field.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::size_t read = 0;
    double value = 0;
    try {
      value = std::stod(field, &read);
    } catch (const std::exception&) {
    }
    if (read != field.size())
      throw InputError(place_, column, field, "not a number", "correct the field");
    return to_si(value, unit_of(column).to_si);
  }
  BearingType type() const {
    const std::string& field = text("type");
    const auto known = choice_texts<BearingType>();
    if (std::find(known.begin(), known.end(), field) == known.end())
      throw InputError(place_, "type", field, "no such type of bearing", "NU, NJ, NUP or N");
    return choice_of<BearingType>(field);
  }

 private:
  std::map<std::string, std::string> of_;
  SourcePlace place_;
};

CatalogueRow row_of(const Fields& of) {
  CatalogueRow row;
  row.designation = of.text("designation");
  row.type = of.type();
  row.bore = of.number("d_mm");
  row.outside = of.number("D_mm");
  row.width = of.number("B_mm");
  row.inner_raceway = of.number("F_mm");
  row.outer_raceway = of.number("E_mm");
  row.inner_shoulder = of.number("d1_mm");
  row.outer_shoulder = of.number("D1_mm");
  row.dynamic_rating = of.number("C_kN");
  row.static_rating = of.number("C0_kN");
  row.reference_speed = of.number("n_ref_rpm");
  row.limiting_speed = of.number("n_lim_rpm");
  row.minimum_load_factor = of.number("kr");
  row.uprated = of.number("uprated") == 1;
  row.outer_raceway_from = of.text("E_from");
  return row;
}

/// Capitals and digits alone: "nu 208" and "NU-208" are the same.
std::string plain(std::string_view designation) {
  std::string text;
  for (const char c : designation)
    if (c != ' ' && c != '-' && c != '.' && c != '_')
      text += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

/// Without the suffix behind the number: "NU208" of "NU208ECP".
std::string_view stem(std::string_view plain_text) {
  return plain_text.substr(0, plain_text.find_last_of("0123456789") + 1);
}

/// Bearings that the table leaves out, because no scene or no rule of a cage says what they are.
void refuse_unmodelled(std::string_view designation) {
  const std::string asked = plain(designation);
  const auto begins = [&](const auto&... with) { return (asked.starts_with(with) || ...); };
  if (begins("NN", "SL01", "SL02", "SL04", "SL11", "SL14", "SL15", "SL1850"))
    throw InputError({}, "DESIGNATION", std::string(designation),
                     "a bearing with rows of rollers beside each other: only one row is modelled",
                     "write the scene of one row (inputs/README.md), under its share of the load");
  if (begins("NCF", "NJG", "RNU", "RN", "SL18", "SL19"))
    throw InputError({}, "DESIGNATION", std::string(designation),
                     begins("RN")
                         ? "a bearing without one of its rings is not in the table"
                         : "a full complement bearing: only bearings with a cage are modelled",
                     begins("RN") ? "write its scene with the raceway of shaft or housing"
                                  : "choose a bearing with a cage, as NU and NJ have one");
}

}  // namespace

std::vector<CatalogueRow> read_catalogue(std::string_view text, const std::string& name) {
  std::vector<CatalogueRow> rows;
  std::vector<std::string> heading;
  std::istringstream lines{std::string(text)};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    if (heading.empty())
      heading = split(line);
    else
      rows.push_back(row_of({heading, split(line), {name, number}}));
  }
  return rows;
}

const std::vector<CatalogueRow>& catalogue() {
  static const std::vector<CatalogueRow> rows =
      read_catalogue(catalogue_table(), "inputs/catalogue.csv");
  return rows;
}

const CatalogueRow& catalogue_row(std::string_view designation) {
  const std::string asked = plain(designation);
  for (const CatalogueRow& row : catalogue())
    if (plain(row.designation) == asked) return row;
  for (const CatalogueRow& row : catalogue())
    if (stem(plain(row.designation)) == asked) return row;
  refuse_unmodelled(designation);
  for (const CatalogueRow& row : catalogue())
    if (const std::string known{stem(plain(row.designation))}; asked.starts_with(known))
      if (const std::string rest = asked.substr(known.size());
          std::isdigit(static_cast<unsigned char>(rest[0])) == 0)
        throw InputError({}, "DESIGNATION", std::string(designation),
                         "the table has this bearing with another suffix",
                         "near ones: " + row.designation + "; leave '" + rest +
                             "' out and say what it means by --cage, --guidance and --clearance");
  std::string near;
  for (const std::string& name : nearest_designations(designation, 5))
    near += (near.empty() ? "" : ", ") + name;
  throw InputError({}, "DESIGNATION", std::string(designation),
                   "the table has no bearing of this designation",
                   "near ones: " + near + "; `cagetol scene --list` prints all");
}

std::vector<std::string> nearest_designations(std::string_view designation, std::size_t count) {
  const std::string asked = plain(designation);
  std::vector<std::string> names, near;
  std::map<std::string, std::string> of;
  for (const CatalogueRow& row : catalogue()) {
    const std::string name = plain(row.designation);
    names.emplace_back(stem(name));
    of[names.back()] = row.designation;
  }
  while (near.size() < count && !names.empty()) {
    const std::string name = nearest_name(asked, names);
    near.push_back(of[name]);
    std::erase(names, name);
  }
  return near;
}

std::vector<const CatalogueRow*> matching_rows(std::string_view part) {
  const std::string asked = plain(part);
  std::vector<const CatalogueRow*> rows;
  for (const CatalogueRow& row : catalogue())
    if (plain(row.designation).find(asked) != std::string::npos) rows.push_back(&row);
  return rows;
}

}  // namespace cagetol
