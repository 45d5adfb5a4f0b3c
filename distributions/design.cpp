#include "distributions/design.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "distributions/basics/permutation.hpp"
#include "distributions/basics/require.hpp"

namespace cagetol {

namespace {

constexpr std::uint64_t most_rows = std::uint64_t{1} << 40, most_strata = std::uint64_t{1} << 28;

void check_numbers(const DesignSpec& spec) {
  require(spec.rows >= 1, "a design needs at least one row");
  require(spec.rows <= most_rows, spec.rows, " rows are more than 2^40; ask for fewer");
  require(spec.kind == DesignKind::random || spec.rows <= most_strata, "a latin hypercube of ",
          spec.rows, " rows has too many: at most 2^28 = ", most_strata,
          "; use random, or fewer rows");
  require(spec.cages_per_lot >= 1, "a lot holds at least one cage");
  require(spec.cages_per_lot == 1 || spec.kind == DesignKind::random,
          "cages_per_lot = ", spec.cages_per_lot, " needs design random: ", design_name(spec.kind),
          " spreads each column over all rows");
}

void check_addresses(const DesignSpec& spec) {
  using Address = std::tuple<Purpose, std::uint32_t, std::uint32_t>;
  std::vector<Address> addresses;
  for (const DesignColumn& column : spec.columns) {
    addresses.emplace_back(column.purpose, column.stream, column.draw);
  }
  std::sort(addresses.begin(), addresses.end());
  const auto twin = std::adjacent_find(addresses.begin(), addresses.end());
  if (twin == addresses.end()) return;
  const auto& [purpose, stream, draw] = *twin;
  require(false, "two columns have one address (purpose ", static_cast<unsigned>(purpose),
          ", stream ", stream, ", draw ", draw,
          ") and would always be equal; give every input a stream of its own");
}

/// It depends on the address of the column, not on its position.
PhiloxKey column_key(std::uint64_t seed, const DesignColumn& column) {
  const PhiloxCounter block =
      philox({static_cast<std::uint32_t>(column.purpose), column.stream, column.draw, 0},
             stream_key(seed, Purpose::scramble));
  return {block[0], block[1]};
}

// 24 bits: with at most 2^28 cells, cell + jitter is exact and never rounds into the next cell.
double jitter(std::uint64_t cell, PhiloxKey key) {
  const PhiloxCounter block = philox({static_cast<std::uint32_t>(cell), 0, 0, 1}, key);
  return (static_cast<double>(block[0] >> 8) + 0.5) * 0x1p-24;
}

}  // namespace

const char* design_name(DesignKind kind) {
  return spellings(kind)[static_cast<std::size_t>(kind)].text;
}

Design::Design(DesignSpec spec) : spec_(std::move(spec)) {
  check_numbers(spec_);
  check_addresses(spec_);
  if (spec_.kind == DesignKind::lhs)
    for (const DesignColumn& column : spec_.columns)
      keys_.push_back(column_key(spec_.seed, column));
}

void Design::point(std::uint64_t row, std::span<double> u) const {
  require(row < rows(), "row ", row, " lies beyond the ", rows(), " rows of the design");
  require(u.size() == dimensions(), "a point of ", dimensions(), " coordinates does not fit into ",
          u.size());
  for (std::size_t i = 0; i < u.size(); ++i) {
    if (spec_.kind == DesignKind::lhs) {
      const std::uint64_t cell = Permutation(rows(), keys_[i])(row);
      u[i] = (static_cast<double>(cell) + jitter(cell, keys_[i])) / static_cast<double>(rows());
    } else {
      const auto& [purpose, stream, draw] = spec_.columns[i];
      u[i] =
          uniform(spec_.seed, purpose, purpose == Purpose::lot ? lot_of(row) : row, stream, draw);
    }
  }
}

}  // namespace cagetol
