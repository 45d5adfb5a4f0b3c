#include "mc/measurement_csv.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

namespace cagetol {
namespace {

std::string trimmed(const std::string& text) {
  const char* blank = " \t\r\"";
  const auto first = text.find_first_not_of(blank);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

std::vector<std::string> fields(const std::string& line, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(line);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(trimmed(part));
  if (!line.empty() && line.back() == separator) parts.emplace_back();
  return parts;
}

double number(const std::string& field, const SourcePlace& place, const std::string& column) {
  double value = 0;
  const auto* end = field.data() + field.size();
  const auto result = std::from_chars(field.data(), end, value);
  if (field.empty())
    throw InputError(place, column, "", "the field is empty", "give a number or remove the line");
  if (result.ec != std::errc{} || result.ptr != end)
    throw InputError(place, column, "'" + field.substr(0, 40) + "'", "this is not a number",
                     "give a number with a decimal point, or remove the line");
  if (!std::isfinite(value))
    throw InputError(place, column, field, "not a finite number", "remove the line");
  return value;
}

}  // namespace

std::vector<double> csv_column(const std::string& text, const std::string& file,
                               const std::string& column) {
  std::istringstream stream(text);
  std::vector<double> values;
  std::vector<std::string> header;
  std::size_t position = 0;
  char separator = ',';
  int line_number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++line_number;
    const std::string content = trimmed(line);
    if (content.empty() || content[0] == '#') continue;
    const SourcePlace place{file, line_number};
    if (header.empty()) {
      if (content.find(';') != std::string::npos) separator = ';';
      header = fields(content, separator);
      const auto found = std::find(header.begin(), header.end(), column);
      if (found == header.end())
        throw InputError(
            place, "", "", "there is no column '" + column + "'",
            "the columns are: " + fmt::format("{}", fmt::join(header, ", ")).substr(0, 400));
      position = static_cast<std::size_t>(found - header.begin());
      continue;
    }
    const auto parts = fields(line, separator);
    if (parts.size() != header.size())
      throw InputError(place, "", "",
                       std::to_string(parts.size()) + " fields, but the header names " +
                           std::to_string(header.size()) + " columns",
                       "give one field for each of: " +
                           fmt::format("{}", fmt::join(header, ", ")).substr(0, 400));
    values.push_back(number(parts[position], place, column));
  }
  if (header.empty())
    throw InputError({file, 0}, "", "", "the file has no header line",
                     "put the names of the columns in the first line that is not a comment");
  if (values.empty())
    throw InputError({file, 0}, column, "", "the column holds no measurements",
                     "add one line for each measured part");
  return values;
}

}  // namespace cagetol
