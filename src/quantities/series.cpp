#include "src/quantities/series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cagetol {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double Series::mean() const {
  return weight_ > 0 ? shift_ + sum_ / weight_ : kNone;
}

double Series::rms() const {
  const double spread = standard_deviation(), centre = mean();
  return std::sqrt(spread * spread + centre * centre);
}

double Series::standard_deviation() const {
  if (!(weight_ > 0)) return kNone;
  const double centre = sum_ / weight_;
  return std::sqrt(std::max(0.0, squares_ / weight_ - centre * centre));
}

double Series::peak() const {
  return count_ > 0 ? peak_ : kNone;
}

double Series::quantile(double p) const {
  if (record_.empty()) return kNone;
  std::vector<double> values = record_;
  const double rank = std::ceil(p * static_cast<double>(values.size()));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::max(rank, 1.0)) - 1;
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double distance_quantile(const Series& x, const Series& y, double p) {
  Series distance;
  const double mean_x = x.mean(), mean_y = y.mean();
  for (std::size_t i = 0; i < x.record_.size(); ++i)
    distance.add(std::hypot(x.record_[i] - mean_x, y.record_[i] - mean_y), 1, true);
  return distance.quantile(p);
}

void StepQuadrature::add(double t, double f) {
  if (points_ >= 1) {
    const double h = t - t_[2];
    if (points_ >= 2) {
      // Second divided difference over the last two intervals; the earlier interval gets the mean
      // of its two parabolas.
      const double before = t_[2] - t_[1];
      const double bend = ((f - f_[2]) / h - (f_[2] - f_[1]) / before) / (t - t_[1]);
      const double used = points_ >= 3 ? 0.5 * (bend_ + bend) : bend;
      done_ += before / 2 * (f_[1] + f_[2]) - before * before * before / 6 * used;
      bend_ = bend;
    }
  }
  t_[0] = t_[1], f_[0] = f_[1];
  t_[1] = t_[2], f_[1] = f_[2];
  t_[2] = t, f_[2] = f;
  ++points_;
}

double StepQuadrature::integral() const {
  if (points_ < 2) return 0;
  const double h = t_[2] - t_[1];
  const double bend = points_ >= 3 ? bend_ : 0;
  return done_ + h / 2 * (f_[1] + f_[2]) - h * h * h / 6 * bend;
}

}  // namespace cagetol
