// A random permutation of 0 .. size-1. Each element is computed on its own, without a table.
#pragma once

#include <cstdint>

#include "distributions/basics/random_stream.hpp"

namespace cagetol {

/// Generalised Feistel cipher on a x b >= size cells (Black & Rogaway 2002,
/// doi:10.1007/3-540-45760-7_9, method 3). The two parts of an index l + a r are shifted
/// alternately, each by a Philox number of the other part. A result >= size is encrypted again, so
/// that the map remains a bijection.
class Permutation {
 public:
  /// size < 2^64 / 4.
  Permutation(std::uint64_t size, PhiloxKey key);

  std::uint64_t operator()(std::uint64_t index) const;

 private:
  std::uint64_t shuffled(std::uint64_t index) const;

  std::uint64_t size_, a_, b_;
  PhiloxKey key_;
};

}  // namespace cagetol
