// Sampling designs: which points of the unit cube [0,1]^d a study runs.
//
// A design is a pure function of its specification: point(row) can be called in any order, takes
// O(d) time and always gives the same bits.
//
//   kind         rows                         block_of(row)                base_of(row)
//   random       any                          0                            row
//   lhs          any up to 2^28               0                            row
//   sobol        scrambles * classes * 2^m    scramble                     index in the scramble
//   grid         product of grid_levels       0                            row
//   pick-freeze  bases * (groups + 2)         0: A, 1: B, 2+g: A, g of B   base point
//   morris       trajectories * (groups + 1)  step of the trajectory       trajectory
//
// In pick-freeze and morris designs the rows of a base follow each other, so that an interrupted
// study contains complete bases.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "distributions/designs/design_spec.hpp"

namespace cagetol {

const char* design_name(DesignKind kind);

/// The smallest number of rows >= spec.rows of a complete design. A grid has exactly one such
/// number.
std::uint64_t complete_rows(const DesignSpec& spec);

class Design {
 public:
  /// Throws std::invalid_argument with reason and remedy if the specification is not valid.
  explicit Design(DesignSpec spec);

  const DesignSpec& spec() const;
  std::uint64_t rows() const;
  std::size_t dimensions() const;
  std::uint32_t groups() const;

  /// Writes the point of a row to u, which has dimensions() elements.
  void point(std::uint64_t row, std::span<double> u) const;

  std::uint64_t blocks() const;
  std::uint64_t block_of(std::uint64_t row) const;
  std::uint64_t base_of(std::uint64_t row) const;
  std::uint64_t row_of(std::uint64_t block, std::uint64_t base) const;

  /// row / cages_per_lot.
  std::uint64_t lot_of(std::uint64_t row) const;

  /// Rows with equal sources have equal values in the columns of the group. For noise, a group
  /// without columns, the source is the id of the draw.
  std::uint64_t source_of(std::uint64_t row, std::uint32_t group) const;

  /// morris: the group that changes from row - 1 to row. Empty for the first row of a trajectory
  /// and for other designs.
  std::optional<std::uint32_t> moved_group(std::uint64_t row) const;

 private:
  struct Implementation;
  std::shared_ptr<const Implementation> implementation_;
};

}  // namespace cagetol
