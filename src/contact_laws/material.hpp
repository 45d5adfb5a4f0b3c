// Elastic constants of a material.
#pragma once

namespace cagetol {

struct Material {
  double young = 208e9;   ///< E [Pa]
  double poisson = 0.30;  ///< nu
  double density = 7810;  ///< rho [kg/m^3]
};

}  // namespace cagetol
