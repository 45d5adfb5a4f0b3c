#pragma once

#include <cstdint>

#include "distributions/designs/design_spec.hpp"

namespace cagetol {

/// Most rows that any design may have.
inline constexpr std::uint64_t most_rows = std::uint64_t{1} << 40;

/// Key of a column's random numbers (permutation, jitter). It depends on
/// the address of the column, not on its position.
PhiloxKey column_key(std::uint64_t seed, const DesignColumn& column);

}  // namespace cagetol
