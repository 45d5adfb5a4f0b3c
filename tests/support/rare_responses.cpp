#include "tests/support/rare_responses.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace cagetol {
namespace {

double smooth_part(const std::vector<double>& x) {
  const auto sum = [&](std::ptrdiff_t first, std::ptrdiff_t last) {
    return std::accumulate(x.begin() + first, x.begin() + last + 1, 0.0);
  };
  const double g = 0.55 * x[3] + 0.45 * x[4] + 0.40 * x[0] + 0.15 * x[2] + 0.10 * sum(5, 17) +
                   0.06 * sum(57, 69) + 0.04 * sum(44, 56) + 0.12 * (x[3] * x[3] - 1) +
                   0.10 * x[3] * x[4];
  return g / std::sqrt(0.9239);
}

double peak_part(const std::vector<double>& x) {
  const double g = 0.45 * x[0] + 0.35 * x[4] + 0.60 * *std::max_element(&x[5], &x[18]);
  return (g - 1.00079) / std::sqrt(0.43848);
}

double noise(RareNoise kind, std::mt19937_64& random) {
  if (kind == RareNoise::gumbel)
    return (std::extreme_value_distribution<>()(random) - 0.57722) / 1.28255;
  if (kind == RareNoise::student)
    return std::student_t_distribution<>(5)(random) / std::sqrt(5.0 / 3);
  return std::normal_distribution<>()(random);
}

}  // namespace

std::vector<double> normal_values(std::uint64_t seed, std::size_t runs) {
  std::mt19937_64 random(seed + 1);
  std::normal_distribution<> normal;
  std::vector<double> values(runs);
  for (double& value : values) value = normal(random);
  return values;
}

std::vector<double> response_values(const RareResponse& response, std::uint64_t seed,
                                    std::size_t runs) {
  std::mt19937_64 random(1000 * seed + 17);
  std::normal_distribution<> normal;
  std::vector<double> values, x(70);
  for (std::size_t run = 0; run < runs; ++run) {
    for (double& deviation : x) deviation = normal(random);
    const double g = response.smooth ? smooth_part(x) : peak_part(x);
    const double spread = response.spread ? std::exp(0.25 * x[3] - 0.0625) : 1;
    values.push_back(std::sqrt(1 - response.noise_share) * g +
                     std::sqrt(response.noise_share) * spread * noise(response.noise, random));
  }
  return values;
}

}  // namespace cagetol
