#include "src/input/unit.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <vector>

namespace cagetol {
namespace {

// Longer suffixes first where one ends in another: "N_s_mm" before "mm".
// clang-format off
const std::vector<Unit>& units() {
  static const std::vector<Unit> table = {
      {"N_mm_e", "N/mm^e", "contact stiffness", 1},
      {"N_s_mm", "N s/mm", "damping", 1e3},
      {"N_s_m", "N s/m", "damping", 1},
      {"N_m_rad", "N m/rad", "tilt stiffness", 1},
      {"N_m", "N m", "moment", 1},
      {"N_mm", "N mm", "moment", 1e-3},
      {"Pa_s", "Pa s", "viscosity", 1},
      {"mm2_s", "mm^2/s", "kinematic viscosity", 1},
      {"um_m_K", "um/(m K)", "thermal expansion", 1e-6},
      {"W_m_K", "W/(m K)", "conductivity", 1},
      {"W_K", "W/K", "heat conductance", 1},
      {"l_min", "l/min", "flow", 1e-3 / 60},
      {"1_GPa", "1/GPa", "pressure-viscosity", 1e-9},
      {"kg_mm2", "kg mm^2", "inertia", 1e-6},
      {"kg_m2", "kg m^2", "inertia", 1},
      {"g_mm", "g mm", "unbalance", 1e-6},
      {"g_mm2", "g mm^2", "inertia", 1e-9},
      {"kg_m3", "kg/m^3", "density", 1},
      {"g_cm3", "g/cm^3", "density", 1e3},
      {"m_s2", "m/s^2", "acceleration", 1},
      {"mm_s", "mm/s", "speed", 1e-3},
      {"m_s", "m/s", "speed", 1},
      {"rad_s", "rad/s", "rotational speed", 1},
      {"rpm", "rpm", "rotational speed", 0.10471975511965977},
      {"GPa", "GPa", "stress", 1e9},
      {"MPa", "MPa", "stress", 1e6},
      {"Pa", "Pa", "stress", 1},
      {"mrad", "mrad", "angle", 1e-3},
      {"urad", "urad", "angle", 1e-6},
      {"rad", "rad", "angle", 1},
      {"deg", "deg", "angle", std::numbers::pi / 180},
      {"kN", "kN", "force", 1e3},
      {"N", "N", "force", 1},
      {"C", "degC", "temperature", 1},
      {"K", "K", "temperature difference", 1},
      {"percent", "%", "share", 0.01},
      {"W", "W", "power", 1},
      {"kg", "kg", "mass", 1},
      {"g", "g", "mass", 1e-3},
      {"mm", "mm", "length", 1e-3},
      {"um", "um", "length", 1e-6},
      {"nm", "nm", "length", 1e-9},
      {"m", "m", "length", 1},
      {"Hz", "Hz", "frequency", 1},
      {"h", "h", "time", 3600},
      {"ms", "ms", "time", 1e-3},
      {"us", "us", "time", 1e-6},
      {"s", "s", "time", 1},
  };
  return table;
}
// clang-format on

// The power of ten that `factor` is, or 0: then there is nothing to shift.
int decimal_power(double factor) {
  const int power = static_cast<int>(std::lround(std::log10(factor)));
  return std::abs(factor * std::pow(10.0, -power) - 1) < 1e-12 ? power : 0;
}

// `value` times 10^power as people do it, by moving the decimal point of its shortest decimal text.
double shifted(double value, int power) {
  std::array<char, 40> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + 32, value, std::chars_format::scientific).ptr;
  char* exponent = std::find(text.data(), end, 'e') + 1;
  if (exponent > end) return value;  // not a finite number
  int given = 0;
  std::from_chars(*exponent == '+' ? exponent + 1 : exponent, end, given);
  const auto last = std::to_chars(exponent, text.data() + text.size(), given + power).ptr;
  double result = value * std::pow(10.0, power);  // stays where the text is out of range
  std::from_chars(text.data(), last, result);
  return result;
}

}  // namespace

const Unit& unit_of(std::string_view key) {
  static const Unit pure{"", "-", "pure number", 1};
  for (const auto& unit : units())
    if (key.ends_with("_" + unit.suffix)) return unit;
  return pure;
}

std::string_view without_unit(std::string_view key) {
  const auto& unit = unit_of(key);
  return unit.suffix.empty() ? key : key.substr(0, key.size() - unit.suffix.size() - 1);
}

const Unit* find_unit(std::string_view text) {
  // Micro sign and Greek mu, and units of workshops.
  static const std::vector<std::pair<std::string, Unit>> further = {
      {"\u00b5m", {"um", "um", "length", 1e-6}},
      {"\u03bcm", {"um", "um", "length", 1e-6}},
      {"micron", {"um", "um", "length", 1e-6}},
      {"microns", {"um", "um", "length", 1e-6}},
      {"cm", {"cm", "cm", "length", 1e-2}},
      {"inch", {"inch", "inch", "length", 0.0254}},
      {"in", {"inch", "inch", "length", 0.0254}},
      {"thou", {"thou", "thou", "length", 2.54e-5}},
      {"mil", {"thou", "thou", "length", 2.54e-5}},
      {"\u00b0", {"deg", "deg", "angle", std::numbers::pi / 180}},
      {"\u00b5rad", {"urad", "urad", "angle", 1e-6}},
      {"\u03bcrad", {"urad", "urad", "angle", 1e-6}},
      {"\u00b5s", {"us", "us", "time", 1e-6}},
      {"\u03bcs", {"us", "us", "time", 1e-6}},
  };
  for (const auto& unit : units())
    if (text == unit.text || text == unit.suffix) return &unit;
  for (const auto& [name, unit] : further)
    if (text == name) return &unit;
  return nullptr;
}

double to_si(double value, double factor) {
  const int power = decimal_power(factor);
  return power == 0 ? value * factor : shifted(value, power);
}

double from_si(double value, double factor) {
  const int power = decimal_power(factor);
  return power == 0 ? value / factor : shifted(value, -power);
}

std::string number_text(double value) {
  std::array<char, 40> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

double unit_value(double si, double factor) {
  const double direct = from_si(si, factor);
  for (int digits = 1; digits <= 17; ++digits) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.*g", digits, direct);
    const double candidate = std::strtod(text.data(), nullptr);
    if (to_si(candidate, factor) == si) return candidate;
  }
  // The last of 17 digits may be off by the rounding both ways.
  double below = direct, above = direct;
  for (int step = 0; step < 4; ++step) {
    below = std::nextafter(below, -std::numeric_limits<double>::infinity());
    above = std::nextafter(above, std::numeric_limits<double>::infinity());
    for (const double candidate : {below, above})
      if (to_si(candidate, factor) == si) return candidate;
  }
  return direct;
}

}  // namespace cagetol
