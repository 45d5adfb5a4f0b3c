#include "distributions/laws/triangular.hpp"

#include <algorithm>
#include <cmath>

#include "distributions/basics/require.hpp"
#include "distributions/laws/uniform.hpp"

namespace cagetol {

void check(const Triangular& law) {
  check(Uniform{law.lower, law.upper});
  require(law.lower <= law.mode && law.mode <= law.upper, "mode = ", law.mode,
          " lies outside lower = ", law.lower, " .. upper = ", law.upper,
          "; it is the most probable value and may equal either end");
}

double quantile(const Triangular& law, double p) {
  const double width = law.upper - law.lower;
  const double rising = law.mode - law.lower;
  const double falling = law.upper - law.mode;
  return p * width <= rising ? std::min(law.mode, law.lower + std::sqrt(p * width * rising))
                             : std::max(law.mode, law.upper - std::sqrt((1 - p) * width * falling));
}

double cdf(const Triangular& law, double x) {
  if (x <= law.lower) return 0;
  if (x >= law.upper) return 1;
  const double width = law.upper - law.lower;
  if (x < law.mode) return (x - law.lower) / width * ((x - law.lower) / (law.mode - law.lower));
  return 1 - (law.upper - x) / width * ((law.upper - x) / (law.upper - law.mode));
}

double pdf(const Triangular& law, double x) {
  if (x < law.lower || x > law.upper) return 0;
  const double peak = 2 / (law.upper - law.lower);
  if (x < law.mode) return peak * (x - law.lower) / (law.mode - law.lower);
  if (x > law.mode) return peak * (law.upper - x) / (law.upper - law.mode);
  return peak;
}

double mean(const Triangular& law) {
  return law.lower + ((law.mode - law.lower) + (law.upper - law.lower)) / 3;
}

double standard_deviation(const Triangular& law) {
  const double mode = law.mode - law.lower;
  const double width = law.upper - law.lower;
  return std::sqrt((width * width - mode * width + mode * mode) / 18);
}

Interval support(const Triangular& law) {
  return {law.lower, law.upper};
}

}  // namespace cagetol
