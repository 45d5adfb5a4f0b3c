// Sampling designs: which points of the unit cube [0,1]^d a study runs.
//
// A design is a pure function of its specification: point(row) can be called in any order, takes
// O(d) time and always gives the same bits.
//
//   random  up to 2^40 rows: independent points
//   lhs     up to 2^28 rows: a Latin hypercube (McKay, Beckman, Conover 1979,
//           doi:10.1080/00401706.1979.10489755). Each column divides [0,1] into as many equal cells
//           as there are rows and has one point at a random position in each cell, by a permutation
//           of its own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "distributions/basics/random_stream.hpp"

namespace cagetol {

enum class DesignKind { random, lhs };

/// A design and its name in study files.
struct DesignName {
  DesignKind value;
  const char* text;
};
constexpr std::array<DesignName, 2> spellings(DesignKind) {
  using enum DesignKind;
  return {{{random, "random"}, {lhs, "lhs"}}};
}
const char* design_name(DesignKind kind);

/// One coordinate: the address of its random numbers.
struct DesignColumn {
  Purpose purpose = Purpose::lot;
  std::uint32_t stream = 0;  ///< stream_address(name of the input)
  std::uint32_t draw = 0;    ///< pocket, for Purpose::pocket
};

struct DesignSpec {
  DesignKind kind = DesignKind::random;
  std::uint64_t rows = 0;
  std::uint64_t seed = 1;
  std::vector<DesignColumn> columns;

  /// random only: the rows of one lot share their columns of Purpose::lot.
  std::uint64_t cages_per_lot = 1;
};

class Design {
 public:
  /// Throws std::invalid_argument with reason and remedy if the specification is not valid.
  explicit Design(DesignSpec spec);

  const DesignSpec& spec() const { return spec_; }
  std::uint64_t rows() const { return spec_.rows; }
  std::size_t dimensions() const { return spec_.columns.size(); }

  /// Writes the point of a row to u, which has dimensions() elements.
  void point(std::uint64_t row, std::span<double> u) const;

  /// row / cages_per_lot.
  std::uint64_t lot_of(std::uint64_t row) const { return row / spec_.cages_per_lot; }

 private:
  DesignSpec spec_;
  std::vector<PhiloxKey> keys_;  ///< lhs: of each column, by its address
};

}  // namespace cagetol
