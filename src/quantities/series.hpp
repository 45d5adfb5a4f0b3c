// A quantity seen at the accepted steps of a window, each value weighted with the time it stands
// for. Means and peaks use every step; quantiles use a thinner record, one value per `thin`
// seconds, which is what a quantile over time needs.
#pragma once

#include <vector>

namespace cagetol {

class Series {
 public:
  /// `keep`: the value also enters the record for quantiles.
  void add(double value, double weight, bool keep = false) {
    if (count_++ == 0) shift_ = value;
    const double x = value - shift_;
    weight_ += weight;
    sum_ += weight * x;
    squares_ += weight * x * x;
    const double size = value < 0 ? -value : value;
    if (size > peak_) peak_ = size;
    if (keep) record_.push_back(value);
  }
  bool empty() const { return count_ == 0; }
  double mean() const;
  double rms() const;
  double standard_deviation() const;
  double peak() const;  ///< largest magnitude
  /// Smallest recorded value with at least the share `p` of the record at or below it.
  double quantile(double p) const;

 private:
  friend double distance_quantile(const Series& x, const Series& y, double p);
  long count_ = 0;
  double shift_ = 0;  ///< the first value: keeps the variance of nearly constant series
  double weight_ = 0, sum_ = 0, squares_ = 0, peak_ = 0;
  std::vector<double> record_;
};

/// Quantile of the distance of the recorded points (x, y) from their mean.
double distance_quantile(const Series& x, const Series& y, double p);

/// Integral of a function known with its derivative at the accepted steps: Hermite's corrected
/// trapezium, order 4 within each step.
class HermiteQuadrature {
 public:
  void add(double t, double f, double slope) {
    if (points_++ > 0) {
      const double h = t - t_;
      sum_ += h / 2 * (f_ + f) + h * h / 12 * (slope_ - slope);
    }
    t_ = t, f_ = f, slope_ = slope;
  }
  double integral() const { return sum_; }

 private:
  long points_ = 0;
  double t_ = 0, f_ = 0, slope_ = 0, sum_ = 0;
};

/// Integral of a function known at the accepted steps: parabolas through neighbouring points,
/// averaged; order 4 where smooth.
class StepQuadrature {
 public:
  void add(double t, double f);
  /// Integral from the first to the last point added.
  double integral() const;

 private:
  int points_ = 0;
  double t_[3] = {}, f_[3] = {};
  double done_ = 0;  ///< all intervals but the last, corrected
  double bend_ = 0;  ///< second divided difference of the last three points
};

}  // namespace cagetol
