// Sobol' points with the direction numbers of Joe & Kuo (2008, doi:10.1137/070709359; from
// Boost.Random) and Owen's nested uniform scrambling (1995, doi:10.1007/978-1-4612-2552-2_19): each
// binary digit is flipped by a random bit that depends on all digits before it. The points of a
// scramble are still a net, each point is uniform on the cube, and the scatter between scrambles is
// a valid error estimate. The first point, zero before scrambling, is used: without it the points
// are not a net.
//
// Rows r, r + classes, r + 2 classes, ... of a scramble are consecutive points of one aligned part
// of the sequence, so they form a net of their own. A study with K candidates, in which row r has
// the candidate r modulo K, sets classes = K. In the natural order, if K is a power of two, the
// candidate would be determined by the leading digits of the first column.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "distributions/designs/layout.hpp"

namespace cagetol {

class ScrambledSobol {
 public:
  explicit ScrambledSobol(const DesignSpec& spec);

  static std::uint64_t complete_rows(const DesignSpec& spec);
  static std::string row_rule(const DesignSpec& spec);

  void point(std::uint64_t row, std::span<double> u) const;

 private:
  static constexpr unsigned digits = 32;

  std::uint64_t scrambles_, points_, classes_;
  std::vector<PhiloxKey> keys_;
  std::vector<std::array<std::uint32_t, digits>>
      directions_;  ///< for each column, low index bit first
};

}  // namespace cagetol
