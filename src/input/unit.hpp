// Units that input files carry as the suffix of their keys ("cage.pocket_width_mm"): the only place
// where they become SI.
#pragma once

#include <string>
#include <string_view>

namespace cagetol {

struct Unit {
  std::string
      suffix;  ///< as in keys, without the leading underscore: "kg_m2"; empty for a pure number
  std::string text;       ///< as shown to people: "kg m^2"; "-" for a pure number
  std::string dimension;  ///< "length": units of one dimension can be converted into each other
  double to_si = 1;
};

/// The unit in which `key` is given: the longest known suffix after an underscore; a pure number if
/// there is none.
const Unit& unit_of(std::string_view key);

/// `key` without its unit: "cage.pocket_width" of "cage.pocket_width_mm".
std::string_view without_unit(std::string_view key);

/// The unit that people write as `text`, or nullptr: "mm", "N/mm^e", also "µm", "micron", "cm",
/// "inch" and others that keys do not know.
const Unit* find_unit(std::string_view text);

/// A value in SI, and back. Powers of ten move the decimal point instead of multiplying, so
/// that 7.65 mm has the bits of 7.65e-3 m.
double to_si(double value, double factor);
double from_si(double value, double factor);

/// The shortest decimal text that reads back as `value`.
std::string number_text(double value);

/// The shortest decimal in a unit whose conversion gives exactly `si` (the nearest one if no
/// decimal does).
double unit_value(double si, double factor);

}  // namespace cagetol
