#include "src/lubrication/lubricant.hpp"

#include <cmath>
#include <stdexcept>

namespace cagetol {
namespace {

constexpr double kZeroCelsius = 273.15;  ///< [K]
constexpr double kExpansion = 0.00065;   ///< of the density [1/K]

constexpr BaseStock kMineral{0.9904, 0.1390, 0.06}, kPolyalphaolefin{0.7382, 0.1335},
    kEster{0.6605, 0.1360}, kPolyglycol{0.5489, 0.1485};

}  // namespace

ViscosityCurve viscosity_curve(double viscosity_40, double viscosity_100) {
  if (!(viscosity_40 > viscosity_100) || !(viscosity_100 > kThinnestOil))
    throw std::domain_error(
        "lubricant: the viscosity at 40 degC must be above that at 100 degC, both in mm2/s");
  const auto log_log = [](double nu) { return std::log10(std::log10(nu + 0.7)); };
  const double x40 = std::log10(40 + kZeroCelsius), x100 = std::log10(100 + kZeroCelsius);
  const double b = (log_log(viscosity_40) - log_log(viscosity_100)) / (x100 - x40);
  return {log_log(viscosity_40) + b * x40, b};
}

double kinematic_viscosity(const ViscosityCurve& curve, double temperature) {
  const double exponent = curve.a - curve.b * std::log10(temperature + kZeroCelsius);
  return std::pow(10.0, std::pow(10.0, exponent)) - 0.7;
}

double viscosity_fall(const ViscosityCurve& curve, double temperature) {
  const double nu = kinematic_viscosity(curve, temperature);
  return curve.b * (nu + 0.7) * std::log(nu + 0.7) / (nu * (temperature + kZeroCelsius));
}

double oil_density(double density_15, double temperature) {
  return density_15 * (1 - kExpansion * (temperature - 15));
}

double pressure_viscosity(const Oil& oil, double nu) {
  return oil.stock ? oil.stock->s * std::pow(nu, oil.stock->t) * 1e-8 : oil.pressure_viscosity;
}

const std::vector<LubricantPreset>& lubricant_presets() {
  // Mineral oils of viscosity index 95 to 100: viscosities at 100 degC as data sheets give them.
  static const std::vector<LubricantPreset> presets = {
      {"iso-vg-10", {10, 2.6, 845, 1.5e-8}},
      {"iso-vg-15", {15, 3.4, 850, 1.6e-8}},
      {"iso-vg-22", {22, 4.3, 858, 1.65e-8}},
      {"iso-vg-32", {32, 5.4, 865, 1.7e-8}},
      {"iso-vg-46", {46, 6.8, 868, 1.75e-8}},
      {"iso-vg-68", {68, 8.7, 870, 1.8e-8}},
      {"iso-vg-100", {100, 11.3, 880, 1.9e-8}},
      {"iso-vg-150", {150, 14.8, 885, 2.0e-8}},
      {"iso-vg-220", {220, 19.0, 890, 2.1e-8}},
      {"iso-vg-320", {320, 24.0, 895, 2.2e-8}},
      {"iso-vg-460", {460, 30.4, 900, 2.3e-8}},
      // Polyol ester of 5 mm2/s at 100 degC (MIL-PRF-23699 asks for 4.9 to 5.4, and 23 at 40 degC).
      // Mobil Jet Oil II has 27.6, 5.1 and 1003.5 (ExxonMobil's data sheet as others quote it).
      {"ester-turbine-oil", {25.5, 5.1, 995, 1.2e-8}},
      // ExxonMobil, Mobil SHC 624, 626 and 629 (product page, October 2013): these viscosities.
      {"pao-vg-32", {32, 6.3, 850, 0, kPolyalphaolefin}},
      {"pao-vg-68", {68, 11.6, 860, 0, kPolyalphaolefin}},
      {"pao-vg-150", {150, 21.1, 860, 0, kPolyalphaolefin}},
      // ExxonMobil, Mobil EAL Arctic 32 and 68, polyol esters (product page, September 2014): 34.2
      // and 5.8, 68 and 8.7 mm2/s.
      {"ester-vg-32", {32, 5.7, 985, 0, kEster}},
      {"ester-vg-68", {68, 9.5, 980, 0, kEster}},
      // No maker's sheet was at hand. The viscosity index of the second is 240; lists of equivalent
      // oils give 220 (Mobil Glygoyle 220) to 235 (Shell Omala S4 WE 220).
      {"pag-vg-100", {100, 19, 1050, 0, kPolyglycol}},
      {"pag-vg-220", {220, 41, 1050, 0, kPolyglycol}},
      // Base oils of greases. Polyurea: ExxonMobil, Mobil Polyrex EM (product page, September
      // 2014). Of lithium soap in mineral oil and in polyalphaolefin no maker's sheet was at hand:
      // typical of greases of bearing makers.
      {"grease-lithium-mineral", {110, 11, 890, 0, kMineral}},
      {"grease-polyurea-mineral", {115, 12.2, 890, 0, kMineral}},
      {"grease-lithium-pao", {18, 4.5, 840, 0, kPolyalphaolefin}},
  };
  return presets;
}

const LubricantPreset& lubricant_named(const std::string& name) {
  for (const LubricantPreset& preset : lubricant_presets())
    if (preset.name == name) return preset;
  throw std::domain_error("lubricant: there is none called '" + name + "'");
}

}  // namespace cagetol
