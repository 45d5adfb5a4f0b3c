#include "distributions/basics/random_stream.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>

namespace cagetol {
namespace {

// kat_vectors of Random123 1.14, lines "philox4x32 10": counter, key, result.
TEST(Philox, AgreesWithThePublishedVectors) {
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}),
            (PhiloxCounter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
            (PhiloxCounter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (PhiloxCounter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

// The documented layout, written out word by word.
TEST(Uniform01, UsesTheDocumentedCounterWords) {
  const std::uint64_t seed = 0x0123456789abcdef, id = 0xfedcba9876543210;
  const PhiloxCounter derived = philox({2, 0, 0, 0}, {0x89abcdef, 0x01234567});
  const PhiloxCounter block = philox({0x76543210, 0xfedcba98, 77, 5}, {derived[0], derived[1]});
  const double expected = open_unit(block[0] | (std::uint64_t{block[1]} << 32));
  EXPECT_EQ(uniform(seed, Purpose::pocket, id, 77, 5), expected);
}

TEST(OpenUnit, IsOpenSymmetricAndExact) {
  EXPECT_EQ(open_unit(0), 0x1p-53);
  EXPECT_EQ(open_unit(~std::uint64_t{0}), 1 - 0x1p-53);
  EXPECT_EQ(open_unit(std::uint64_t{1} << 63), 0.5 + 0x1p-53);
  for (const std::uint64_t bits : {0x0123456789abcdefull, 0xdeadbeefdeadbeefull}) {
    EXPECT_EQ(open_unit(bits) + open_unit(~bits), 1);
  }
}

TEST(StreamAddress, IsFnv1a) {
  EXPECT_EQ(stream_address(""), 0x811c9dc5u);
  EXPECT_EQ(stream_address("a"), 0xe40c292cu);
  EXPECT_EQ(stream_address("foobar"), 0xbf9cf968u);
}

// Each bit of each part of the address changes about half of the result's bits.
TEST(Uniform01, DependsOnEveryBitOfItsAddress) {
  const std::uint64_t seed = 42, id = 1000;
  const auto bits = [](double u) { return static_cast<std::uint64_t>(u * 0x1p52); };
  const std::uint64_t base = bits(uniform(seed, Purpose::lot, id, 3, 4));
  int changed = 0, flips = 0;
  const auto count = [&](double other) {
    EXPECT_NE(bits(other), base);
    changed += std::popcount(bits(other) ^ base);
    ++flips;
  };
  for (int k = 0; k < 64; ++k) {
    const std::uint64_t bit = std::uint64_t{1} << k;
    count(uniform(seed ^ bit, Purpose::lot, id, 3, 4));
    count(uniform(seed, Purpose::lot, id ^ bit, 3, 4));
  }
  for (int k = 0; k < 32; ++k) {
    count(uniform(seed, Purpose::lot, id, 3 ^ (1u << k), 4));
    count(uniform(seed, Purpose::lot, id, 3, 4 ^ (1u << k)));
  }
  for (const Purpose purpose :
       {Purpose::pocket, Purpose::noise, Purpose::scramble, Purpose::bootstrap}) {
    count(uniform(seed, purpose, id, 3, 4));
  }
  // 196 flips of 52 fair bits: mean 26, standard error sqrt(13 / 196) = 0.26.
  EXPECT_NEAR(static_cast<double>(changed) / flips, 26, 1.1);
}

TEST(Uniform01, FillsTheUnitIntervalEvenly) {
  constexpr int draws = 1 << 16, cells = 64;
  std::array<int, cells> counts{};
  double sum = 0;
  for (int i = 0; i < draws; ++i) {
    const double u = uniform(7, Purpose::noise, static_cast<std::uint64_t>(i), 0, 0);
    ++counts[static_cast<std::size_t>(u * cells)];
    sum += u;
  }
  EXPECT_NEAR(sum / draws, 0.5, 4 / std::sqrt(12.0 * draws));
  double chi_squared = 0;
  for (const int count : counts) {
    const double expected = static_cast<double>(draws) / cells;
    chi_squared += (count - expected) * (count - expected) / expected;
  }
  EXPECT_LT(chi_squared, 103.4);  // chi2(63).ppf(.999)
  EXPECT_GT(chi_squared, 34.0);   // chi2(63).ppf(.001)
}

// Neighbouring addresses of every kind are uncorrelated: |r| < 4 / sqrt(n).
TEST(Uniform01, NeighboursAreUncorrelated) {
  constexpr std::uint64_t n = 1 << 14;
  const auto correlation = [&](auto neighbour) {
    double sum = 0;
    for (std::uint64_t i = 0; i < n; ++i) {
      sum += (uniform(5, Purpose::lot, i, 9, 0) - 0.5) * (neighbour(i) - 0.5);
    }
    return 12 * sum / n;
  };
  const double bound = 4 / std::sqrt(static_cast<double>(n));
  EXPECT_LT(std::abs(correlation([](auto i) { return uniform(6, Purpose::lot, i, 9, 0); })), bound);
  EXPECT_LT(std::abs(correlation([](auto i) { return uniform(5, Purpose::pocket, i, 9, 0); })),
            bound);
  EXPECT_LT(std::abs(correlation([](auto i) { return uniform(5, Purpose::lot, i + 1, 9, 0); })),
            bound);
  EXPECT_LT(std::abs(correlation([](auto i) { return uniform(5, Purpose::lot, i, 10, 0); })),
            bound);
  EXPECT_LT(std::abs(correlation([](auto i) { return uniform(5, Purpose::lot, i, 9, 1); })), bound);
}

TEST(RandomStream, StepsThroughTheDrawsOfItsAddress) {
  RandomStream stream(11, Purpose::bootstrap, 12, 13);
  for (std::uint32_t draw = 0; draw < 5; ++draw) {
    EXPECT_EQ(stream.next(), uniform(11, Purpose::bootstrap, 12, 13, draw));
  }
}

TEST(RandomStream, IndicesAreInRangeAndEven) {
  RandomStream stream(1, Purpose::bootstrap, 0);
  std::array<int, 7> counts{};
  for (int i = 0; i < 7000; ++i) ++counts.at(stream.next_index(7));
  for (const int count : counts) EXPECT_NEAR(count, 1000, 4 * std::sqrt(1000 * 6.0 / 7));
}

TEST(RandomStream, IndexAndNumberTakeOneDrawEach) {
  RandomStream stream(1, Purpose::bootstrap, 0), other(1, Purpose::bootstrap, 0);
  stream.next_index(10);
  other.next();
  EXPECT_EQ(stream.next(), other.next());
}

}  // namespace
}  // namespace cagetol
