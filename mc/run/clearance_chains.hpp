// Clearances of a cage as chains of dimensions: at worst, by the root of the sum of squares (RSS),
// and as the study's laws have them. In operation, least of all operating points.
//
//   gap = base + sum_i c_i x_i   c_i measured on the study's scene, x_i from m_i - h_i to m_i + h_i
//   worst case   base + sum c_i m_i -+ sum |c_i| h_i
//   RSS          base + sum c_i m_i -+ sqrt(sum (c_i h_i)^2)
//   sampled      quantiles kChainTail and 1 - kChainTail of the gaps of kChainCages drawn cages
//
// The ends of x_i are those of its tolerance_width_mm, or of its laws; of a law without ends three
// standard deviations about its mean.
#pragma once

#include <string>
#include <vector>

#include "mc/study/study.hpp"

namespace cagetol {

inline constexpr long kChainCages = 20000;
/// A normal law has as much beyond three standard deviations on one side.
inline constexpr double kChainTail = 0.00135;

struct ClearanceChain {
  std::string name;
  std::vector<std::string> keys;  ///< of the inputs that move it
  double nominal = 0;             ///< [m], as all below, of the tightest pocket
  Interval worst = {}, rss = {}, sampled = {};
};

/// The same whatever the study's seed, design and number of samples.
std::vector<ClearanceChain> clearance_chains(const Study& study);

/// As a table in um, a line for each chain.
std::string chains_text(const std::vector<ClearanceChain>& chains);

}  // namespace cagetol
