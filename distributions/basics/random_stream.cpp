#include "distributions/basics/random_stream.hpp"

#include <Random123/philox.h>

namespace cagetol {

namespace {

std::uint32_t low_word(std::uint64_t value) {
  return static_cast<std::uint32_t>(value);
}

std::uint32_t high_word(std::uint64_t value) {
  return static_cast<std::uint32_t>(value >> 32);
}

}  // namespace

PhiloxCounter philox(PhiloxCounter counter, PhiloxKey key) {
  const auto block = r123::Philox4x32_R<10>{}({{counter[0], counter[1], counter[2], counter[3]}},
                                              {{key[0], key[1]}});
  return {block[0], block[1], block[2], block[3]};
}

PhiloxKey stream_key(std::uint64_t seed, Purpose purpose) {
  const PhiloxCounter block =
      philox({static_cast<std::uint32_t>(purpose), 0, 0, 0}, {low_word(seed), high_word(seed)});
  return {block[0], block[1]};
}

std::uint32_t stream_address(std::string_view name) {
  std::uint32_t hash = 2166136261u;
  for (const char letter : name) hash = (hash ^ static_cast<unsigned char>(letter)) * 16777619u;
  return hash;
}

std::uint64_t bits_of(const PhiloxCounter& block) {
  return block[0] | (static_cast<std::uint64_t>(block[1]) << 32);
}

std::uint64_t index_of(std::uint64_t bits, std::uint64_t count) {
  return static_cast<std::uint64_t>((static_cast<unsigned __int128>(bits) * count) >> 64);
}

double open_unit(std::uint64_t bits) {
  return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

double uniform(std::uint64_t seed, Purpose purpose, std::uint64_t id, std::uint32_t stream,
               std::uint32_t draw) {
  return open_unit(
      bits_of(philox({low_word(id), high_word(id), stream, draw}, stream_key(seed, purpose))));
}

RandomStream::RandomStream(std::uint64_t seed, Purpose purpose, std::uint64_t id,
                           std::uint32_t stream)
    : key_(stream_key(seed, purpose)), counter_{low_word(id), high_word(id), stream, 0} {}

double RandomStream::next() {
  const double value = open_unit(bits_of(philox(counter_, key_)));
  ++counter_[3];
  return value;
}

std::uint64_t RandomStream::next_index(std::uint64_t count) {
  const std::uint64_t value = index_of(bits_of(philox(counter_, key_)), count);
  ++counter_[3];
  return value;
}

}  // namespace cagetol
