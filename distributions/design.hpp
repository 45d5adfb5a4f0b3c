// Sampling designs: which points of the unit cube [0,1]^d a study runs.
//
// A design is a pure function of its specification: point(row) can be called in any order, takes
// O(d) time and always gives the same bits.
//
//   kind    rows
//   random  any
//   lhs     any up to 2^28
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "distributions/designs/design_spec.hpp"

namespace cagetol {

const char* design_name(DesignKind kind);

class Design {
 public:
  /// Throws std::invalid_argument with reason and remedy if the specification is not valid.
  explicit Design(DesignSpec spec);

  const DesignSpec& spec() const;
  std::uint64_t rows() const;
  std::size_t dimensions() const;

  /// Writes the point of a row to u, which has dimensions() elements.
  void point(std::uint64_t row, std::span<double> u) const;

  /// row / cages_per_lot.
  std::uint64_t lot_of(std::uint64_t row) const;

 private:
  struct Implementation;
  std::shared_ptr<const Implementation> implementation_;
};

}  // namespace cagetol
