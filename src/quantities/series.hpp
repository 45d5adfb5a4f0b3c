// Mean, rms, peak and quantiles of a quantity over a window, from samples at instants or at the
// accepted steps of a run, and integrals over these steps.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "src/numerics/pack.hpp"

namespace cagetol {

/// Weighted values. Means and peaks use all values, quantiles only those in the record.
class Series {
 public:
  Series() = default;
  /// From sums over values less `shift`: weights, weighted values, weighted squares.
  struct Sums {
    long count;
    double shift, weight, values, squares, peak;
    double integral() const { return values + shift * weight; }
  };
  Series(const Sums& sums, std::vector<double> record);
  Sums sums() const { return {count_, shift_, weight_, sum_, squares_, peak_}; }

  /// Adds a value, `recorded` times to the record.
  void add(double value, double weight, int recorded = 0) {
    if (count_++ == 0) shift_ = value;
    const double x = value - shift_;
    weight_ += weight;
    sum_ += weight * x;
    squares_ += weight * x * x;
    const double size = value < 0 ? -value : value;
    if (size > peak_) peak_ = size;
    record_.insert(record_.end(), static_cast<std::size_t>(recorded), value);
  }

  bool empty() const { return count_ == 0; }
  double mean() const;
  double rms() const;
  double standard_deviation() const;
  double peak() const;  ///< largest magnitude
  /// Smallest recorded value such that at least the fraction `p` of the record is not above it.
  double quantile(double p) const;

 protected:
  friend double distance_quantile(const Series& x, const Series& y, double p);
  long count_ = 0;
  double shift_ = 0;  ///< the first value, subtracted from all: accurate variances of small scatter
  double weight_ = 0, sum_ = 0, squares_ = 0, peak_ = 0;
  std::vector<double> record_;
};

/// Quantile of the distance of the recorded points (x, y) from their mean.
double distance_quantile(const Series& x, const Series& y, double p);

/// A step between two accepted states.
struct SeenStep {
  double length = 0;         ///< 0 at the first state [s]
  double length_before = 0;  ///< length of the previous step, 0 if there is none [s]
  /// Reciprocals of the two lengths and of their sum; 0 for a length of 0.
  double per_length = 0, per_length_before = 0, per_both = 0;
  int instants = 0;         ///< instants of the record in (start, end]
  double last_instant = 0;  ///< time from the last of them to the end of the step [s]
  double interval = 0;      ///< time between two instants [s]
};

/// Divides time into steps and into the instants of a record, one every `interval` seconds. Values
/// at an instant are interpolated. Values of the nearest state would be biased: forces that grow
/// while steps grow would be too low.
class StepClock {
 public:
  StepClock(double begin, double interval) : next_(begin), interval_(interval) {}
  SeenStep advance(double t);

 private:
  bool started_ = false;
  double last_ = 0, length_ = 0, next_, interval_;
};

/// Parabola through three consecutive states: the last step and the one before it.
template <class T>
class Parabola {
 public:
  Parabola(const SeenStep& step, T first, T middle, T last)
      : middle_(middle),
        before_((middle - first) * step.per_length_before),
        after_((last - middle) * step.per_length),
        curvature_((after_ - before_) * step.per_both) {}
  /// Half the second derivative.
  T curvature() const { return curvature_; }
  /// Value at a time before the last state [s].
  T before_last(const SeenStep& step, T last, double time) const {
    return last - time * (after_ + (step.length - time) * curvature_);
  }
  /// Maximum, if the middle state is the largest of the three; otherwise the middle state.
  T top(const SeenStep& step) const {
    const auto inside = (before_ > 0.0) & (after_ < 0.0);
    const T slope = (before_ * step.length + after_ * step.length_before) * step.per_both;
    return middle_ -
           select(inside, slope * slope / (4 * select(inside, curvature_, T{} - 1.0)), T{});
  }

 private:
  T middle_, before_, after_, curvature_;
};

/// Corrections of the trapezium rule for the integrals of a value and of its square, of order 4 for
/// smooth values. Half of a step's correction comes from the parabola at either end of it. A step
/// that is kShorter times shorter than the previous one may begin a contact: if
/// the curvature between the two is kCorner times that before, the value has a corner there, and
/// the curvature is not used for the longer step.
template <class T>
class TrapeziumCorrection {
 public:
  struct Pair {
    T value, square;
  };
  /// From the parabola through `first`, `middle` and `last`; zero unless all three `count`.
  template <class M>
  Pair next(const SeenStep& step, T first, T middle, T last, M count) {
    const Pair curvature = {
        select(count, Parabola(step, first, middle, last).curvature(), T{}),
        select(count, Parabola(step, first * first, middle * middle, last * last).curvature(),
               T{})};
    const bool shorter = parabolas_++ > 0 && kShorter * step.length < step.length_before;
    const auto corner =
        abs(curvature.value) > (shorter ? kCorner * abs(before_.value) : T{} + kNever);
    const auto cube = [](double h) { return h * h * h / 12; };
    const double h1 = cube(step.length_before), h2 = cube(step.length);
    const auto due = [&](T before, T at) { return -h1 * select(corner, before, at) - h2 * at; };
    const Pair correction = {due(before_.value, curvature.value),
                             due(before_.square, curvature.square)};
    before_ = curvature;
    return correction;
  }

 private:
  // By measurement of energy residuals (src/DECISIONS.md, Watches).
  static constexpr double kShorter = 4, kCorner = 10, kNever = 1e300;
  Pair before_{};  ///< curvatures
  long parabolas_ = 0;
};

/// What a series computes besides its means. Anything else is NaN.
enum Asked : unsigned { kMeans = 0, kPeak = 1, kQuantiles = 2 };

/// A quantity at the accepted steps of a run. Means are integrals by the corrected trapezium rule,
/// for the rms of the squares. Peaks and recorded values between states lie on the parabola through
/// the last three states.
class StepSeries : public Series {
 public:
  explicit StepSeries(unsigned asked = kMeans);
  void add(double value, const SeenStep& step);

 private:
  unsigned asked_;
  double before_ = 0, last_ = 0;  ///< values at the two previous states
  TrapeziumCorrection<double> correction_;
};

/// The same for a quantity of every roller, one pack at a time. The values of all rollers form one
/// series.
class RollerSeries {
 public:
  explicit RollerSeries(unsigned asked = kMeans) : asked_(asked) {}
  /// `counts`: lanes in which the quantity exists now. It does not in padding, nor, for example,
  /// for the slip of an unloaded roller.
  void add(std::size_t group, Pack value, Mask counts, const SeenStep& step);
  /// For a quantity that exists while `gate` exceeds `threshold` (>= 0). Its peak may lie where the
  /// gate crosses the threshold: there it is interpolated between two states with gates above zero.
  void add_above(std::size_t group, Pack value, Pack gate, double threshold, Mask here,
                 const SeenStep& step);
  Series all() const { return {sums(), record_}; }
  Series::Sums sums() const;

 private:
  struct State {
    Pack value{};
    Mask counts{};
  };
  struct Seen {
    State before, last;  ///< the two previous states
    Pack gate{};         ///< at the last state
    TrapeziumCorrection<Pack> correction;
  };
  unsigned asked_;
  std::vector<Seen> seen_;  ///< of each pack
  double shift_ = 0;        ///< a first value, as in Series
  bool shifted_ = false;
  Pack weight_{}, sum_{}, squares_{}, peak_{};
  std::vector<double> record_;
};

/// Mean square and peak of a plane acceleration, from acceleration, velocity and position at the
/// accepted steps. Within a step each component is a parabola between its two end values that
/// integrates to the change of velocity. For the peak it is a cubic that also integrates to the
/// change of position.
class PlaneAcceleration {
 public:
  struct Plane {
    double y = 0, z = 0;
  };
  void add(Plane acceleration, Plane velocity, Plane position, const SeenStep& step);
  double rms() const;
  double peak() const { return std::sqrt(largest_square_); }

 private:
  Plane last_, last_velocity_, last_position_;
  double duration_ = 0, squares_ = 0, largest_square_ = 0;
};

/// Integral of a function from its values and derivatives at the accepted steps: trapezium rule
/// with Hermite's correction, order 4.
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

}  // namespace cagetol
