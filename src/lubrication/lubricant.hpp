// What a lubricant is to the contacts: viscosity at the operating temperature and the constants of
// its films and traction.
//
//   log10 log10(nu + 0.7) = A - B log10 T      nu kinematic viscosity [mm2/s], T temperature [K]
//   beta = -d ln nu/dT = B (nu + 0.7) ln(nu + 0.7)/(nu T)
//   rho  = rho_15 (1 - 0.00065 (t - 15)),   eta = nu rho       t [degC]
//
// A and B follow from the viscosities at 40 and 100 degC. Valid for mineral oils and esters between
// their pour point and about 150 degC, nu above 2 mm2/s. Source: Walther's equation as in ASTM
// D341; thermal expansion of mineral oil 0.00065 1/K.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace cagetol {

/// Viscosity over temperature of one oil.
struct ViscosityCurve {
  double a = 0, b = 0;  ///< A, B of Walther's equation
};

inline constexpr double kThinnestOil = 0.3;  ///< above which Walther's equation holds [mm2/s]

/// Throws std::domain_error unless viscosity_40 > viscosity_100 > kThinnestOil [mm2/s].
ViscosityCurve viscosity_curve(double viscosity_40, double viscosity_100);

/// Kinematic viscosity [mm2/s] at `temperature` [degC].
double kinematic_viscosity(const ViscosityCurve& curve, double temperature);

/// -d ln nu/dT [1/K] at `temperature` [degC].
double viscosity_fall(const ViscosityCurve& curve, double temperature);

/// Density [kg/m3] at `temperature` [degC] from that at 15 degC.
double oil_density(double density_15, double temperature);

/// What a base stock makes of pressure: alpha = s nu^t 1e-8 1/Pa, nu in mm2/s where the film forms
/// (Gold and others 2001, as public programs give it), and the largest shear stress over pressure.
/// FEUP's friction of full films of synthetic oils is some 0.6 of that of mineral ones; a limiting
/// ratio of 0.035 (0.025 to 0.05) for them is an assumption.
struct BaseStock {
  double s, t;
  double limiting_shear = 0.035;
};

/// An oil, or the base oil of a grease, as a catalogue describes it. Pressure-viscosity
/// coefficients scatter by a quarter between oils of one grade.
struct Oil {
  double viscosity_40 = 68, viscosity_100 = 8.7;  ///< [mm2/s]
  double density_15 = 870;                        ///< [kg/m3]
  double pressure_viscosity = 1.8e-8;             ///< alpha where there is no `stock` [1/Pa]
  std::optional<BaseStock> stock = {};

  double limiting_shear() const { return stock ? stock->limiting_shear : 0.06; }
};

/// alpha [1/Pa] at the kinematic viscosity `nu` [mm2/s].
double pressure_viscosity(const Oil& oil, double nu);

/// A named oil: ISO VG 10 to 460 as mineral oils of viscosity index about 95, synthetic ones, an
/// ester for gas turbines, and greases. lubricant.cpp names the makers' sheets that viscosities
/// agree with; densities of synthetic oils are typical ones.
struct LubricantPreset {
  std::string name;
  Oil oil;
};
const std::vector<LubricantPreset>& lubricant_presets();

/// Throws std::domain_error where no preset has this name.
const LubricantPreset& lubricant_named(const std::string& name);

}  // namespace cagetol
