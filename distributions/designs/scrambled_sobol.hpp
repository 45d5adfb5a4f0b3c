// Sobol' points with the direction numbers of Joe & Kuo (2008, doi:10.1137/070709359; by
// Boost.Random), scrambled by Owen's nested uniform scrambling (1995,
// doi:10.1007/978-1-4612-2552-2_19): the flip of each binary digit is a random bit that depends on
// all digits before it. The points of a scramble remain a net, each is uniform on the cube, and the
// spread of the estimates of the scrambles is an honest error. The first point, zero before
// scrambling, is kept: without it there is no net.
//
// Rows r, r + classes, r + 2 classes, ... of a scramble walk through one aligned stretch of the
// sequence and are therefore a net of their own. A study that gives row r the candidate r modulo K
// sets classes = K: in the natural order the candidate would be the leading digits of the first
// column whenever K is a power of two.
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

  Layout layout() const { return {scrambles_, points_, false}; }
  void point(std::uint64_t row, std::span<double> u) const;

 private:
  static constexpr unsigned digits = 32;

  std::uint64_t scrambles_, points_, classes_;
  std::vector<PhiloxKey> keys_;
  std::vector<std::array<std::uint32_t, digits>>
      directions_;  ///< for each column, low index bit first
};

}  // namespace cagetol
