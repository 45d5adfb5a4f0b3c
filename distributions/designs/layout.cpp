#include "distributions/designs/layout.hpp"

#include <algorithm>

#include "distributions/basics/require.hpp"

namespace cagetol {

std::uint32_t group_count(const DesignSpec& spec) {
  std::uint32_t count = 0;
  for (const DesignColumn& column : spec.columns) count = std::max(count, column.group + 1);
  return count;
}

std::uint64_t rows_of(std::uint64_t units, std::uint64_t unit) {
  std::uint64_t rows = 0;
  const bool overflows = __builtin_mul_overflow(units, unit, &rows);
  require(!overflows && rows <= most_rows, "the design has ", units, " x ", unit,
          " rows, more than 2^40; ask for fewer");
  return rows;
}

double level_value(std::uint64_t level, std::uint64_t levels, double trim) {
  if (levels == 1) return 0.5;
  const double share = static_cast<double>(level) / static_cast<double>(levels - 1);
  return level == levels - 1 ? 1 - trim : trim + (1 - 2 * trim) * share;
}

PhiloxKey column_key(std::uint64_t seed, const DesignColumn& column) {
  const PhiloxCounter block =
      philox({static_cast<std::uint32_t>(column.purpose), column.stream, column.draw, 0},
             stream_key(seed, Purpose::scramble));
  return {block[0], block[1]};
}

}  // namespace cagetol
