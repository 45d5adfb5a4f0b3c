// Units of input files. The suffix of a key is its unit ("cage.pocket_width_mm"). Conversion to SI
// happens here and nowhere else.
#pragma once

#include <numbers>
#include <string>
#include <string_view>

namespace cagetol {

inline constexpr double kRpm = std::numbers::pi / 30;  ///< a revolution a minute [rad/s]

struct Unit {
  std::string
      suffix;  ///< as in keys, without the leading underscore: "kg_m2"; empty for a pure number
  std::string text;       ///< as shown to people: "kg m^2"; "-" for a pure number
  std::string dimension;  ///< "length": units of one dimension can be converted into each other
  double to_si = 1;
};

/// The unit of `key`: the longest known suffix after an underscore, or a pure number without one.
const Unit& unit_of(std::string_view key);

/// `key` without its unit: "cage.pocket_width" of "cage.pocket_width_mm".
std::string_view without_unit(std::string_view key);

/// The unit written as `text`, or nullptr: "mm", "N/mm^e", and units that no key has, such as "µm",
/// "micron", "cm" and "inch".
const Unit* find_unit(std::string_view text);

/// Converts a value to SI, and back. Powers of ten move the decimal point instead of multiplying:
/// 7.65 mm has the same bits as 7.65e-3 m.
double to_si(double value, double factor);
double from_si(double value, double factor);

/// The shortest decimal text that reads back as `value`.
std::string number_text(double value);

/// The shortest decimal number in a unit that converts to exactly `si`, or to the nearest value if
/// none does.
double unit_value(double si, double factor);

}  // namespace cagetol
