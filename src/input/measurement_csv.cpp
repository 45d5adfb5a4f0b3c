#include "src/input/measurement_csv.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "src/input/csv_heading.hpp"
#include "src/input/csv_records.hpp"
#include "src/input/key_table.hpp"
#include "src/input/printable.hpp"
#include "src/input/unit.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kLongestName = 60, kLongestField = 40;
constexpr const char* kCommaKey =
    "add decimal = \",\" beside file and column of a law (on the command line --decimal-comma), or "
    "write decimal points";

/// The field as std::from_chars reads it: no plus sign, a minus sign of ASCII, a decimal point.
std::string plain(std::string_view field, bool decimal_comma) {
  std::string text;
  if (field.starts_with("\xe2\x88\x92")) {  // U+2212
    text = "-";
    field.remove_prefix(3);
  } else if (field.starts_with('+') && !field.substr(1).starts_with('-')) {
    field.remove_prefix(1);
  }
  text += field;
  if (decimal_comma) std::replace(text.begin(), text.end(), ',', '.');
  return text;
}

std::optional<double> number(std::string_view field, bool decimal_comma) {
  if (decimal_comma && field.find('.') != std::string_view::npos) return std::nullopt;
  const std::string text = plain(field, decimal_comma);
  double value = 0;
  const auto* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ptr != end || result.ec == std::errc::invalid_argument) return std::nullopt;
  return result.ec == std::errc{} ? value : std::nan("");
}

/// Whether some field is a number in either style.
bool has_number(const std::vector<std::string_view>& fields) {
  return std::any_of(fields.begin(), fields.end(),
                     [](auto field) { return number(field, false) || number(field, true); });
}

/// Whether most of the first lines behind the header hold numbers: else this is some other file,
/// nothing of which is quoted.
bool holds_measurements(const std::string& text, bool decimal_comma) {
  constexpr int enough = 50;
  int lines = 0, with_numbers = 0;
  try {
    CsvRecords records(text, "", decimal_comma);
    if (!records.next()) return false;
    while (lines < enough && records.next()) ++lines, with_numbers += has_number(records.fields());
  } catch (const InputError&) {
  }
  return 2 * with_numbers > lines;
}

/// What all that reads one column needs to know of it.
struct Column {
  std::size_t position = 0;
  std::string heading;
  double factor = 1, wanted_factor = 1;  ///< to SI, of the unit given and of the one wanted

  std::string label() const {
    return fmt::format("column {} ({})", position + 1, excerpt(heading, kLongestName));
  }
};

/// The nearest heading, then the first ones.
std::string known_columns(const std::vector<std::string>& headings, const std::string& wanted) {
  constexpr std::size_t most = 12;
  std::vector<std::string> names;
  for (const std::string& heading : headings) names.push_back(excerpt(heading, kLongestName));
  std::string text = suggestion(excerpt(wanted, kLongestName), names, "the columns are: ");
  const auto shown = std::min(most, names.size());
  text +=
      fmt::format("{}", fmt::join(names.begin(), names.begin() + static_cast<long>(shown), ", "));
  if (names.size() > shown) text += fmt::format(" and {} more", names.size() - shown);
  return text;
}

Column find_column(const CsvRecords& records, const std::vector<std::string>& headings,
                   const std::string& text, const WantedColumn& wanted) {
  const auto found = named_columns(headings, wanted.name);
  const std::string name = excerpt(wanted.name, kLongestName);
  if (found.size() == 1) return {found[0], headings[found[0]]};
  if (found.size() > 1)
    throw InputError(
        records.place(), "", "",
        fmt::format("columns {} and {} are both called '{}'", found[0] + 1, found[1] + 1, name),
        "give each column a name of its own, or name it with its unit");
  const std::string problem = "there is no column '" + name + "'";
  if (!holds_measurements(text, wanted.decimal_comma))
    throw InputError(records.place(), "", "", problem + ", nor numbers in most lines below",
                     "check that this is a CSV file of measurements: names of columns, then one "
                     "line for each part");
  if (has_number(records.fields()))
    throw InputError(records.place(), "", "", problem + ": the first line holds numbers",
                     "put the names of the columns in the first line that is not a comment");
  throw InputError(records.place(), "", "", problem, known_columns(headings, wanted.name));
}

void choose_units(Column& column, const SourcePlace& place, const std::string& wanted_suffix) {
  const std::string unit = csv_heading(column.heading).unit;
  if (unit.empty()) return;
  const Unit* given = find_unit(unit);
  const Unit& wanted = unit_of("_" + wanted_suffix);
  if (given == nullptr || given->dimension != wanted.dimension)
    throw InputError(
        place, column.label(), "",
        fmt::format("the unit '{}' {}; values in {} are wanted", excerpt(unit, kLongestField),
                    given == nullptr ? "is not known" : "is one of " + given->dimension,
                    wanted.text == "-" ? "no unit (a pure number)" : wanted.text),
        "convert the column, and give its unit in brackets: [" + wanted.text + "]");
  column.factor = given->to_si;
  column.wanted_factor = wanted.to_si;
}

/// Says why a field is no number; quotes it only in a file that holds measurements.
InputError not_a_number(std::string_view field, const SourcePlace& place, const Column& column,
                        const std::string& text, bool decimal_comma) {
  const std::string shown =
      holds_measurements(text, decimal_comma) ? "'" + excerpt(field, kLongestField) + "'" : "";
  if (!decimal_comma && number(field, true))
    return {place, column.label(), shown, "this number has a decimal comma", kCommaKey};
  if (decimal_comma && number(field, false))
    return {place, column.label(), shown,
            "this number has a decimal point, but decimal commas are asked for",
            "leave decimal = \",\" out, or write all numbers with decimal commas"};
  return {place, column.label(), shown, "this is not a number",
          decimal_comma ? "give a number with a decimal comma and nothing between thousands, or "
                          "remove the line"
                        : "give a number with a decimal point, or remove the line"};
}

double value_of(std::string_view field, const SourcePlace& place, const Column& column,
                const std::string& text, bool decimal_comma) {
  if (field.empty())
    throw InputError(place, column.label(), "", "the field is empty",
                     "give a number or remove the line; a law leaves the part out with missing = "
                     "\"skip\"");
  const auto read = number(field, decimal_comma);
  if (!read) throw not_a_number(field, place, column, text, decimal_comma);
  const double value = column.factor == column.wanted_factor
                           ? *read
                           : from_si(to_si(*read, column.factor), column.wanted_factor);
  if (!std::isfinite(value))
    throw InputError(place, column.label(), "'" + excerpt(field, kLongestField) + "'",
                     "not a finite number", "remove the line");
  return value;
}

/// Empty fields at the end of a line are what spreadsheets leave there.
std::size_t used_fields(const std::vector<std::string_view>& fields, std::size_t named) {
  std::size_t used = fields.size();
  while (used > named && fields[used - 1].empty()) --used;
  return used;
}

void check_width(const CsvRecords& records, std::size_t named, const WantedColumn& wanted) {
  const std::size_t used = used_fields(records.fields(), named);
  if (used == named) return;
  const auto& fields = records.fields();
  const bool commas = used > named && !wanted.decimal_comma &&
                      std::all_of(fields.begin(), fields.end(),
                                  [](auto field) { return field.empty() || number(field, false); });
  throw InputError(
      records.place(), "", "",
      fmt::format("{} fields, but the header names {} columns: column {} {}", used, named,
                  std::min(used, named) + 1, used > named ? "has no name" : "is missing"),
      commas ? std::string("give one field for each column; for decimal commas separate columns by "
                           "semicolons, and ") +
                   kCommaKey
             : "give one field for each column, in quotes where it holds a separator");
}

/// Whether a field numbers or names a part: a whole number without decimals, or a text.
bool names_part(std::string_view field) {
  const bool digits =
      std::all_of(field.begin(), field.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  return !field.empty() && (digits || !(number(field, false) || number(field, true)));
}

}  // namespace

MeasuredColumn measured_column(const std::string& bytes, const std::string& file,
                               const WantedColumn& wanted) {
  const std::string text = csv_text(bytes, file);
  CsvRecords records(text, file, wanted.decimal_comma);
  if (!records.next())
    throw InputError({file, 0}, "", "", "the file has no header line",
                     "put the names of the columns in the first line that is not a comment");
  std::vector<std::string> headings(records.fields().begin(), records.fields().end());
  headings.resize(used_fields(records.fields(), 1));
  Column column = find_column(records, headings, text, wanted), group;
  choose_units(column, records.place(), wanted.unit);
  if (!wanted.group.empty())
    group = find_column(records, headings, text, {wanted.group, "", wanted.decimal_comma});
  MeasuredColumn result;
  std::vector<bool> labels(headings.size(), true);
  while (records.next()) {
    check_width(records, headings.size(), wanted);
    const auto& fields = records.fields();
    const std::string_view field = fields[column.position];
    result.values.push_back(field.empty() && wanted.gaps ? std::nan("")
                                                         : value_of(field, records.place(), column,
                                                                    text, wanted.decimal_comma));
    result.lines.push_back(records.place().line);
    for (std::size_t c = 0; c < labels.size(); ++c) labels[c] = labels[c] && names_part(fields[c]);
    if (wanted.group.empty()) continue;
    if (fields[group.position].empty())
      throw InputError(records.place(), group.label(), "", "the field is empty",
                       "name the group of this part, or remove the line");
    result.labels.push_back(excerpt(std::string(fields[group.position]), kLongestField));
  }
  if (result.values.empty())
    throw InputError({file, 0}, column.label(), "", "the column holds no measurements",
                     "add one line for each measured part");
  for (std::size_t c = 0; c < labels.size(); ++c)
    if (labels[c] && c != column.position && csv_heading(headings[c]).unit.empty())
      result.label_columns.push_back(excerpt(headings[c], kLongestName));
  return result;
}

std::vector<double> csv_column(const std::string& bytes, const std::string& file,
                               const WantedColumn& wanted) {
  return measured_column(bytes, file, wanted).values;
}

}  // namespace cagetol
