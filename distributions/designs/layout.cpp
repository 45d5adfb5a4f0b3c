#include "distributions/designs/layout.hpp"

#include "distributions/basics/require.hpp"

namespace cagetol {

std::uint64_t rows_of(std::uint64_t units, std::uint64_t unit) {
  std::uint64_t rows = 0;
  const bool overflows = __builtin_mul_overflow(units, unit, &rows);
  require(!overflows && rows <= most_rows, "the design has ", units, " x ", unit,
          " rows, more than 2^40; ask for fewer");
  return rows;
}

PhiloxKey column_key(std::uint64_t seed, const DesignColumn& column) {
  const PhiloxCounter block =
      philox({static_cast<std::uint32_t>(column.purpose), column.stream, column.draw, 0},
             stream_key(seed, Purpose::scramble));
  return {block[0], block[1]};
}

}  // namespace cagetol
