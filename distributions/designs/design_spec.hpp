// What a sampling design is made from (design.hpp).
#pragma once

#include <array>
#include <cstdint>
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

}  // namespace cagetol
