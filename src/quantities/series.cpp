#include "src/quantities/series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace cagetol {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

template <class F>
double weighted_mean(const std::vector<double>& values, const std::vector<double>& weights, F f) {
  double sum = 0, total = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += weights[i] * f(values[i]);
    total += weights[i];
  }
  return total > 0 ? sum / total : kNone;
}

}  // namespace

double Series::mean() const {
  return weighted_mean(values_, weights_, [](double x) { return x; });
}

double Series::rms() const {
  return std::sqrt(weighted_mean(values_, weights_, [](double x) { return x * x; }));
}

double Series::standard_deviation() const {
  const double centre = mean();
  return std::sqrt(weighted_mean(values_, weights_, [centre](double x) { return (x - centre) * (x - centre); }));
}

double Series::peak() const {
  double largest = values_.empty() ? kNone : 0;
  for (double x : values_) largest = std::max(largest, std::abs(x));
  return largest;
}

double Series::quantile(double p) const {
  if (values_.empty()) return kNone;
  std::vector<std::size_t> order(values_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [this](auto a, auto b) { return values_[a] < values_[b]; });
  const double total = std::accumulate(weights_.begin(), weights_.end(), 0.0);
  double below = 0;
  for (std::size_t i : order) {
    below += weights_[i];
    if (below >= p * total) return values_[i];
  }
  return values_[order.back()];
}

double distance_quantile(const Series& x, const Series& y, double p) {
  Series distance;
  const double mean_x = x.mean(), mean_y = y.mean();
  for (std::size_t i = 0; i < x.values_.size(); ++i)
    distance.add(std::hypot(x.values_[i] - mean_x, y.values_[i] - mean_y), x.weights_[i]);
  return distance.quantile(p);
}

void StepQuadrature::add(double t, double f) {
  if (points_ >= 1) {
    const double h = t - t_[2];
    if (points_ >= 2) {
      // Second divided difference over the last two intervals; the earlier interval gets the mean of its two parabolas.
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
