#include "mc/study_file/checksum.hpp"

#include <boost/crc.hpp>

namespace cagetol {

std::uint64_t crc64(std::string_view bytes) {
  constexpr std::uint64_t kOnes = ~std::uint64_t{0};
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693, kOnes, kOnes, true, true> crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

}  // namespace cagetol
