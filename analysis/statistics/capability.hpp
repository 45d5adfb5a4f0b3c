// Process capability of a quantity against its limits (ISO 22514-2).
//
//   as if normal:
//     Cp  = (USL - LSL) / (6 s)
//     Cpk = min(USL - mean, mean - LSL) / (3 s)
//   percentile form, any law:
//     Pp  = (USL - LSL) / (X99.865 - X0.135)
//     Ppk = min((USL - X50) / (X99.865 - X50), (X50 - LSL) / (X50 - X0.135))
//
// Cp and Pp need both limits. With one limit, Cpk and Ppk use that side only. The outer percentiles
// are read from the sorted runs. They need at least 1 / 0.00135 = 741 runs; with fewer, Pp and Ppk
// are refused. A quantity that does not vary has no capability.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "analysis/statistics/resampling.hpp"

namespace cagetol {

inline constexpr std::size_t kFewestForPercentiles = 741;

struct ProcessCapability {
  std::size_t defined = 0;
  Estimate cp, cpk, pp, ppk;
  std::string percentile_refused;  ///< why Pp and Ppk, or all four, are missing
};

ProcessCapability process_capability(std::span<const double> values, std::optional<double> minimum,
                                     std::optional<double> maximum, const Resampling& resampling,
                                     double confidence, std::span<const double> weights = {});

}  // namespace cagetol
