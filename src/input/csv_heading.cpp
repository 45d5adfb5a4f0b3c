#include "src/input/csv_heading.hpp"

#include <functional>

#include "src/input/csv_records.hpp"
#include "src/input/unit.hpp"

namespace cagetol {
namespace {

/// The unit behind the last `mark`, where what stands there is one.
bool take_unit_behind(std::string_view text, std::string_view mark, CsvHeading& heading) {
  const auto at = text.rfind(mark);
  if (at == std::string_view::npos || at == 0) return false;
  const std::string_view unit = trimmed_field(text.substr(at + mark.size()));
  if (find_unit(unit) == nullptr) return false;
  heading = {std::string(trimmed_field(text.substr(0, at))), std::string(unit)};
  return true;
}

bool take_bracketed(std::string_view text, char open, char close, CsvHeading& heading) {
  const auto at = text.rfind(open);
  if (!text.ends_with(close) || at == std::string_view::npos || at == 0) return false;
  const std::string_view unit = trimmed_field(text.substr(at + 1, text.size() - at - 2));
  if (unit.empty() || (open == '(' && find_unit(unit) == nullptr)) return false;
  heading = {std::string(trimmed_field(text.substr(0, at))), std::string(unit)};
  return true;
}

bool take_suffix(std::string_view text, CsvHeading& heading) {
  const Unit& unit = unit_of(text);
  if (unit.suffix.empty()) return !text.ends_with("_in") && take_unit_behind(text, "_", heading);
  heading = {std::string(without_unit(text)), unit.suffix};
  return !heading.name.empty();
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

bool same_unit(const std::string& a, const std::string& b) {
  const Unit *first = find_unit(a), *second = find_unit(b);
  return first != nullptr && second != nullptr ? first->text == second->text : a == b;
}

}  // namespace

CsvHeading csv_heading(std::string_view text) {
  text = trimmed_field(text);
  CsvHeading heading{std::string(text), ""};
  if (take_bracketed(text, '[', ']', heading) || take_bracketed(text, '(', ')', heading) ||
      take_unit_behind(text, "/", heading) || take_unit_behind(text, ",", heading) ||
      take_unit_behind(text, " in ", heading) || take_suffix(text, heading))
    return heading;
  return {std::string(text), ""};
}

std::vector<std::size_t> named_columns(const std::vector<std::string>& headings,
                                       std::string_view column) {
  std::vector<CsvHeading> parts;
  for (const std::string& heading : headings) parts.push_back(csv_heading(heading));
  const CsvHeading wanted = csv_heading(column);
  std::vector<std::size_t> found;
  const auto search = [&](const std::function<bool(std::size_t)>& matches) {
    if (!found.empty()) return;
    for (std::size_t i = 0; i < headings.size(); ++i)
      if (matches(i)) found.push_back(i);
  };
  const auto unit_fits = [&](std::size_t i) {
    return wanted.unit.empty() || same_unit(wanted.unit, parts[i].unit);
  };
  search([&](std::size_t i) { return headings[i] == column; });
  search([&](std::size_t i) { return parts[i].name == wanted.name && unit_fits(i); });
  search([&](std::size_t i) { return lower_case(headings[i]) == lower_case(column); });
  search([&](std::size_t i) {
    return lower_case(parts[i].name) == lower_case(wanted.name) && unit_fits(i);
  });
  return found;
}

}  // namespace cagetol
