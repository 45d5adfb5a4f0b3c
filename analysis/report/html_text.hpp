// Small pieces of HTML and numbers as people read them.
#pragma once

#include <string>
#include <vector>

#include "analysis/report/json_parts.hpp"

namespace cagetol {

/// &, <, > and quotes made harmless.
std::string escaped(const std::string& text);

/// Escaped text in <code>.
std::string code(const std::string& text);

/// Three significant digits, without exponent where it can be avoided; "-" for null.
std::string rounded(const Json& value);

/// 83.4 and, below it in small print, 82.9 to 83.9: as many digits as the interval deserves; "-"
/// for null.
std::string with_interval(const Json& estimate);

/// "97.3 %" of a share; "-" for null.
std::string percent(const Json& share);

/// "97.3 % (96.1 to 98.2)" of an estimated share.
std::string percent_interval(const Json& estimate);

/// "1 mrad"; nothing behind the number for "-".
std::string unit_suffix(const std::string& unit);

/// "cage_stress_peak_MPa" -> "cage stress peak".
std::string readable(const std::string& quantity);

/// Headers and cells are HTML. Columns marked 'n' hold numbers, 't' text.
std::string table(const std::string& columns, const std::vector<std::string>& headers,
                  const std::vector<std::vector<std::string>>& rows);

std::string chapter(const std::string& id, const std::string& title, const std::string& body);
std::string paragraph(const std::string& html);
/// Small print below a table or heading.
std::string note(const std::string& html);

}  // namespace cagetol
