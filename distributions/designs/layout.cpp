#include "distributions/designs/layout.hpp"

namespace cagetol {

PhiloxKey column_key(std::uint64_t seed, const DesignColumn& column) {
  const PhiloxCounter block =
      philox({static_cast<std::uint32_t>(column.purpose), column.stream, column.draw, 0},
             stream_key(seed, Purpose::scramble));
  return {block[0], block[1]};
}

}  // namespace cagetol
