#include "distributions/designs/scrambled_sobol.hpp"

#include <algorithm>
#include <bit>
#include <boost/random/sobol.hpp>

#include "distributions/basics/require.hpp"

namespace cagetol {

namespace {

constexpr std::size_t most_dimensions = 3667;
constexpr std::uint64_t most_points = std::uint64_t{1} << 32;

// One Philox block holds the flips of a subtree of seven digits: node 1 is its first digit, and the
// children of a node are 2 node + digit. What follows the 32 digits of the net depends on all of
// them.
std::uint64_t scrambled(std::uint32_t digits, std::uint64_t scramble, PhiloxKey key) {
  constexpr unsigned word = 32, depth = 7;
  const auto random_block = [&](std::uint32_t prefix, std::uint32_t level) {
    return philox({prefix, level, static_cast<std::uint32_t>(scramble),
                   static_cast<std::uint32_t>(scramble >> 32)},
                  key);
  };
  std::uint32_t flips = 0;
  for (unsigned first = 0; first < word; first += depth) {
    const std::uint32_t prefix = first == 0 ? 0 : digits >> (word - first);
    const PhiloxCounter block = random_block(prefix, first);
    unsigned node = 1;
    for (unsigned i = first; i < std::min(first + depth, word); ++i) {
      const unsigned place = word - 1 - i;
      flips |= ((block[node / word] >> (node % word)) & 1u) << place;
      node = 2 * node + ((digits >> place) & 1u);
    }
  }
  const std::uint32_t tail = random_block(digits, word)[0];
  return (static_cast<std::uint64_t>(digits ^ flips) << word) | tail;
}

}  // namespace

ScrambledSobol::ScrambledSobol(const DesignSpec& spec)
    : scrambles_(spec.scrambles),
      points_(spec.rows / spec.scrambles),
      classes_(spec.classes),
      directions_(spec.columns.size()) {
  require(spec.columns.size() <= most_dimensions, "a sobol design has at most ", most_dimensions,
          " columns, not ", spec.columns.size(), "; use random or lhs");
  for (const DesignColumn& column : spec.columns) keys_.push_back(column_key(spec.seed, column));
  if (spec.columns.empty()) return;
  // The engine counts in Gray code from 1: its number 2^(k+1) - 1 is the direction number of bit k
  // alone.
  boost::random::sobol_engine<std::uint32_t, digits> engine(spec.columns.size());
  for (unsigned k = 0; k < digits; ++k) {
    engine.seed(static_cast<std::uint32_t>((std::uint64_t{2} << k) - 2));
    for (auto& directions : directions_) directions[k] = engine();
  }
}

std::uint64_t ScrambledSobol::complete_rows(const DesignSpec& spec) {
  const std::uint64_t unit = rows_of(spec.scrambles, spec.classes);
  const std::uint64_t length = std::bit_ceil(divided_up(spec.rows, unit));
  require(length <= most_points / spec.classes, "a scramble of ", length, " x ", spec.classes,
          " points is longer than the sequence, 2^32 points; ask for fewer rows");
  return rows_of(length, unit);
}

std::string ScrambledSobol::row_rule(const DesignSpec& spec) {
  return std::to_string(spec.scrambles) + " scrambles of " +
         (spec.classes > 1 ? std::to_string(spec.classes) + " classes of " : std::string()) +
         "a power of two";
}

void ScrambledSobol::point(std::uint64_t row, std::span<double> u) const {
  const std::uint64_t scramble = row / points_;
  const std::uint64_t step = row % points_;
  const std::uint64_t index = step % classes_ * (points_ / classes_) + step / classes_;
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    std::uint32_t x = 0;
    for (unsigned k = 0; k < digits; ++k) {
      if ((index >> k) & 1u) x ^= directions_[i][k];
    }
    u[i] = open_unit(scrambled(x, scramble, keys_[i]));
  }
}

}  // namespace cagetol
