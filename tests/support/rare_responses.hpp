// Test responses of rare failures: y = sqrt(1 - s) g + sqrt(s) e of 70 standard normal deviations,
// the level that one in a hundred thousand exceeds known by integration over e.
//
//   smooth   g = .55 x3 + .45 x4 + .40 x0 + .15 x2 + .10 sum x5..17 + .06 sum x57..69
//                + .04 sum x44..56 + .12 (x3^2 - 1) + .10 x3 x4, standardised
//   peak     g = .45 x0 + .35 x4 + .60 max x5..17, standardised
//   e        normal, Gumbel of maxima or Student of five degrees of freedom, of variance 1; where
//            its spread changes, times exp(.25 x3 - .0625)
#pragma once

#include <cstdint>
#include <vector>

namespace cagetol {

enum class RareNoise { normal, gumbel, student };

struct RareResponse {
  const char* name;
  bool smooth;
  double noise_share;  ///< s
  RareNoise noise;
  bool spread;
  double level;
};

inline constexpr RareResponse kRareResponses[] = {
    {"smooth", true, 0.1, RareNoise::normal, false, 5.786},
    {"smooth, changing spread", true, 0.3, RareNoise::normal, true, 6.502},
    {"peak", false, 0.1, RareNoise::normal, false, 4.458},
    {"peak, Gumbel", false, 0.5, RareNoise::gumbel, false, 6.496},
    {"noise alone, nearly", true, 0.85, RareNoise::normal, false, 4.378},
    {"peak, changing spread", false, 0.3, RareNoise::normal, true, 4.618},
    {"Gumbel of changing spread", true, 0.5, RareNoise::gumbel, true, 9.054},
    {"Student", true, 0.5, RareNoise::student, false, 8.71}};

std::vector<double> response_values(const RareResponse& response, std::uint64_t seed,
                                    std::size_t runs);

std::vector<double> normal_values(std::uint64_t seed, std::size_t runs);

}  // namespace cagetol
