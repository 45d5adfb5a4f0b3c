#pragma once

#include <cstdint>

#include "distributions/designs/design_spec.hpp"

namespace cagetol {

/// How the rows of a design are divided into blocks of equal size.
struct Layout {
  std::uint64_t blocks = 1;
  std::uint64_t bases = 0;
  bool blocks_inside_base =
      false;  ///< row = base * blocks + block, instead of block * bases + base

  std::uint64_t block_of(std::uint64_t row) const {
    return blocks_inside_base ? row % blocks : row / bases;
  }
  std::uint64_t base_of(std::uint64_t row) const {
    return blocks_inside_base ? row / blocks : row % bases;
  }
  std::uint64_t row_of(std::uint64_t block, std::uint64_t base) const {
    return blocks_inside_base ? base * blocks + block : block * bases + base;
  }
};

/// Most rows that any design may have. Products of two counts of rows and blocks below it fit into
/// 64 bits.
inline constexpr std::uint64_t most_rows = std::uint64_t{1} << 40;

/// Groups of a specification, with and without columns.
std::uint32_t group_count(const DesignSpec& spec);

/// Value of level 0 .. levels-1, equally spaced over [trim, 1 - trim]. A single level is at 1/2.
double level_value(std::uint64_t level, std::uint64_t levels, double trim);

inline std::uint64_t divided_up(std::uint64_t value, std::uint64_t unit) {
  return value / unit + (value % unit == 0 ? 0 : 1);
}

/// units * unit rows. Throws std::invalid_argument beyond most_rows.
std::uint64_t rows_of(std::uint64_t units, std::uint64_t unit);

/// Key of a column's random numbers (permutation, scramble, jitter, trajectories). It depends on
/// the address of the column, not on its position.
PhiloxKey column_key(std::uint64_t seed, const DesignColumn& column);

/// Key of random numbers of the design as a whole.
PhiloxKey design_key(std::uint64_t seed);

}  // namespace cagetol
