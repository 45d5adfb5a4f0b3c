#include "mc/host/sealed_bytes.hpp"

#include "mc/host/byte_stream.hpp"
#include "mc/study_file/checksum.hpp"

namespace cagetol {
namespace {

constexpr std::string_view kSealMagic = "CAGETOLT";
constexpr std::size_t kLengths = 16, kChecksum = 8;

std::string lengths(std::string_view head, std::string_view content) {
  ByteWriter out;
  out.put(static_cast<std::uint64_t>(head.size()));
  out.put(static_cast<std::uint64_t>(content.size()));
  return out.bytes();
}

}  // namespace

std::string sealed_bytes(std::string_view head, std::string_view content) {
  std::string bytes(kSealMagic);
  bytes += lengths(head, content);
  bytes += head;
  bytes += content;
  ByteWriter checksum;
  checksum.put(crc64(bytes));
  return bytes + checksum.bytes();
}

Unsealed unsealed_bytes(std::string_view bytes, std::string_view head) {
  constexpr std::size_t minimum = kSealMagic.size() + kLengths + kChecksum;
  if (bytes.size() < minimum || !bytes.starts_with(kSealMagic)) return {};
  const std::string_view body = bytes.substr(0, bytes.size() - kChecksum);
  ByteReader numbers(bytes.substr(kSealMagic.size(), kLengths));
  const auto head_size = numbers.get<std::uint64_t>(), content_size = numbers.get<std::uint64_t>();
  const std::uint64_t held = bytes.size() - minimum;
  if (head_size > held || content_size != held - head_size) return {};
  if (ByteReader(bytes.substr(body.size())).get<std::uint64_t>() != crc64(body)) return {};
  const std::string_view after = body.substr(kSealMagic.size() + kLengths);
  if (after.substr(0, head_size) != head) return {SealedState::other_head, {}};
  return {SealedState::whole, after.substr(head_size)};
}

}  // namespace cagetol
