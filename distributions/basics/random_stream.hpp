// Addressed random numbers: every draw is a pure function of its address and does not depend on
// earlier draws.
//
// The generator is Philox4x32-10 (Salmon, Moraes, Dror, Shaw: Parallel random numbers: as easy as
// 1, 2, 3. SC11, doi:10.1145/2063384.2063405), a keyed bijection of 128-bit counters. Words, least
// significant first:
//
//   key      2 words  words 0 and 1 of Philox(counter = {purpose, 0, 0, 0}, key = seed)
//   counter  4 words  {id low, id high, stream, draw}
//   result   4 words  words 0 and 1 make one uniform number; words 2 and 3 stay unused
//
// All 64 bits of seed and id are used. Two draws with the same seed and purpose but different id,
// stream or draw have different counters. Adding a pocket, an input or an output therefore does not
// change any existing draw.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace cagetol {

using PhiloxCounter = std::array<std::uint32_t, 4>;
using PhiloxKey = std::array<std::uint32_t, 2>;

/// Ten rounds of Philox4x32.
PhiloxCounter philox(PhiloxCounter counter, PhiloxKey key);

/// Purpose of a draw. Stored studies depend on these numbers: new ones may be added, existing ones
/// must not change.
enum class Purpose : std::uint32_t {
  lot = 1,        ///< deviations shared by the cages of a lot; id = lot
  pocket = 2,     ///< deviations of single pockets; id = design row, draw = pocket
  noise = 3,      ///< initial state and noise inputs of one run; id = sample
  scramble = 4,   ///< permutations and jitter of designs
  bootstrap = 5,  ///< resampling in analysis; id = resample
  check = 6,      ///< which samples are checked more closely; id = sample
};

PhiloxKey stream_key(std::uint64_t seed, Purpose purpose);

/// Words 0 and 1 as one 64-bit number.
std::uint64_t bits_of(const PhiloxCounter& block);

/// 32-bit FNV-1a hash of a name: the stream of an input does not depend on the other inputs of the
/// study. Designs refuse two columns with the same address, so a collision (probability 1e-7 for 30
/// inputs) is an error and not silent.
std::uint32_t stream_address(std::string_view name);

/// Maps 64 random bits to 0 .. count-1, count > 0. Probabilities are equal within count/2^64.
std::uint64_t index_of(std::uint64_t bits, std::uint64_t count);

/// The upper 52 bits as an odd multiple of 2^-53: in the open interval (0,1), exact in double,
/// symmetric about 1/2.
double open_unit(std::uint64_t bits);

/// The uniform number in (0,1) at an address.
double uniform(std::uint64_t seed, Purpose purpose, std::uint64_t id, std::uint32_t stream,
               std::uint32_t draw);

/// The draws 0, 1, 2, ... of one address: next() equals uniform(seed, purpose, id, stream, draw++).
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, Purpose purpose, std::uint64_t id, std::uint32_t stream = 0);

  /// Uniform in (0,1).
  double next();

  /// Uniform in 0 .. count-1; count > 0.
  std::uint64_t next_index(std::uint64_t count);

 private:
  PhiloxKey key_;
  PhiloxCounter counter_;
};

}  // namespace cagetol
