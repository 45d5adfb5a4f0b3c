#include "analysis/report/html_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace cagetol {
namespace {

/// Decimals that show `digits` significant digits of a number of this size.
int decimals_for(double size, int digits) {
  if (!(size > 0)) return 0;
  return std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(size))), 0, 9);
}

std::string fixed(double value, int decimals) {
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  return text.find_first_not_of("-0.") == std::string::npos && text.starts_with("-")
             ? text.substr(1)
             : text;
}

/// The value and, below it in small print, its interval; as many decimals as the first digit of the
/// interval's half width.
std::string interval_text(double value, double lower, double upper) {
  const double half = 0.5 * (upper - lower);
  if (std::max({std::abs(value), std::abs(upper), half}) < 1e-3)
    return fmt::format("{}<br><small>{} to {}</small>", fmt::format("{:.3g}", value),
                       fmt::format("{:.2g}", lower), fmt::format("{:.2g}", upper));
  const int decimals = half > 0 ? decimals_for(half, 1) : decimals_for(std::abs(value), 3);
  return fmt::format("{}<br><small>{} to {}</small>", fixed(value, decimals),
                     fixed(lower, decimals), fixed(upper, decimals));
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '"')
      safe += "&quot;";
    else if (c == '\'')
      safe += "&#39;";
    else
      safe += c;
  }
  return safe;
}

std::string code(const std::string& text) {
  return "<code>" + escaped(text) + "</code>";
}

std::string rounded(const Json& value) {
  if (!value.is_number()) return "-";
  const double x = value.get<double>();
  if (x == std::floor(x) && std::abs(x) < 1e7) return fmt::format("{:.0f}", x);
  if (std::abs(x) < 1e-3 || std::abs(x) >= 1e7) return fmt::format("{:.2e}", x);
  return fixed(x, decimals_for(std::abs(x), 3));
}

std::string with_interval(const Json& estimate) {
  if (!estimate.at("value").is_number()) return "-";
  if (!estimate.at("lower").is_number() || !estimate.at("upper").is_number())
    return rounded(estimate.at("value"));
  return interval_text(estimate.at("value"), estimate.at("lower"), estimate.at("upper"));
}

std::string percent(const Json& share) {
  if (!share.is_number()) return "-";
  const double x = 100 * share.get<double>();
  const double distance = std::min(std::abs(x), std::abs(100 - x));
  if (x < 100 && x >= 99.995) return "> 99.99 %";
  return fixed(x, distance > 0 && distance < 0.1 ? 2 : 1) + " %";
}

std::string percent_interval(const Json& estimate) {
  if (!estimate.at("value").is_number()) return "-";
  if (!estimate.at("lower").is_number()) return percent(estimate.at("value"));
  return fmt::format("{} % ({} to {})", fixed(100 * estimate.at("value").get<double>(), 0),
                     fixed(100 * estimate.at("lower").get<double>(), 0),
                     fixed(100 * estimate.at("upper").get<double>(), 0));
}

std::string unit_suffix(const std::string& unit) {
  return unit.empty() || unit == "-" ? "" : " " + escaped(unit);
}

std::string readable(const std::string& quantity) {
  static const std::set<std::string> units = {"MPa", "N", "J", "um", "mrad", "W",
                                              "Nmm", "s", "m", "s2", "mm",   "deg"};
  // "KEY@LABEL": of an operating point or a phase.
  if (const std::size_t at = quantity.find('@'); at != std::string::npos)
    return readable(quantity.substr(0, at)) + " @ " + quantity.substr(at + 1);
  std::string words = quantity;
  for (std::size_t last = words.rfind('_');
       last != std::string::npos && units.count(words.substr(last + 1)) > 0;
       last = words.rfind('_'))
    words.resize(last);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string table(const std::string& columns, const std::vector<std::string>& headers,
                  const std::vector<std::vector<std::string>>& rows) {
  const auto cell = [&](const char* tag, std::size_t column, const std::string& html) {
    const bool numbers = column < columns.size() && columns[column] == 'n';
    return fmt::format("<{}{}>{}</{}>", tag, numbers ? " class=\"n\"" : "", html, tag);
  };
  std::string html = "<table><thead><tr>";
  for (std::size_t c = 0; c < headers.size(); ++c) html += cell("th", c, headers[c]);
  html += "</tr></thead><tbody>\n";
  for (const auto& row : rows) {
    html += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) html += cell("td", c, row[c]);
    html += "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string chapter(const std::string& id, const std::string& title, const std::string& body) {
  return fmt::format("<section id=\"{}\"><h2>{}</h2>\n{}</section>\n", id, title, body);
}

std::string paragraph(const std::string& html) {
  return "<p>" + html + "</p>\n";
}

std::string note(const std::string& html) {
  return "<p class=\"note\">" + html + "</p>\n";
}

}  // namespace cagetol
