#include "distributions/designs/latin_hypercube.hpp"

#include "distributions/basics/require.hpp"
#include "distributions/designs/permutation.hpp"

namespace cagetol {

namespace {

constexpr std::uint64_t most_strata = std::uint64_t{1} << 28;

// 24 bits: with at most 2^28 cells, cell + jitter is exact and never rounds into the next cell.
double jitter(std::uint64_t cell, PhiloxKey key) {
  const PhiloxCounter block = philox({static_cast<std::uint32_t>(cell), 0, 0, 1}, key);
  return (static_cast<double>(block[0] >> 8) + 0.5) * 0x1p-24;
}

}  // namespace

LatinHypercube::LatinHypercube(const DesignSpec& spec) : rows_(spec.rows) {
  require(rows_ <= most_strata, "a latin hypercube of ", rows_,
          " rows has too many: at most 2^28 = ", most_strata, "; use random, or fewer rows");
  for (const DesignColumn& column : spec.columns) keys_.push_back(column_key(spec.seed, column));
}

void LatinHypercube::point(std::uint64_t row, std::span<double> u) const {
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    const std::uint64_t cell = Permutation(rows_, keys_[i])(row);
    u[i] = (static_cast<double>(cell) + jitter(cell, keys_[i])) / static_cast<double>(rows_);
  }
}

}  // namespace cagetol
