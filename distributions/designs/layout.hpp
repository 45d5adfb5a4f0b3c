#pragma once

#include <cstdint>

#include "distributions/designs/design_spec.hpp"

namespace cagetol {

/// Most rows that any design may have. Products of two counts of rows and blocks below it fit into
/// 64 bits.
inline constexpr std::uint64_t most_rows = std::uint64_t{1} << 40;

inline std::uint64_t divided_up(std::uint64_t value, std::uint64_t unit) {
  return value / unit + (value % unit == 0 ? 0 : 1);
}

/// units * unit rows. Throws std::invalid_argument beyond most_rows.
std::uint64_t rows_of(std::uint64_t units, std::uint64_t unit);

/// Key of a column's random numbers (permutation, scramble, jitter). It depends on
/// the address of the column, not on its position.
PhiloxKey column_key(std::uint64_t seed, const DesignColumn& column);

}  // namespace cagetol
