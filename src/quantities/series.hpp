// What a quantity amounts to over a window, seen at instants or at the accepted steps of a run, and
// integrals over such steps.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "src/numerics/pack.hpp"

namespace cagetol {

/// Values with weights. Means and peaks use them all, quantiles those that were recorded.
class Series {
 public:
  Series() = default;
  /// Of sums over other values: their weights, weighted values and squares less `shift`.
  struct Sums {
    long count;
    double shift, weight, values, squares, peak;
    double integral() const { return values + shift * weight; }
    double square_integral() const { return squares + shift * (2 * values + shift * weight); }
  };
  Series(const Sums& sums, std::vector<double> record);
  Sums sums() const { return {count_, shift_, weight_, sum_, squares_, peak_}; }

  /// The value enters the record for quantiles so many times.
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
  /// Smallest recorded value with at least the share `p` of the record at or below it.
  double quantile(double p) const;

 protected:
  friend double distance_quantile(const Series& x, const Series& y, double p);
  long count_ = 0;
  double shift_ = 0;  ///< the first value: keeps the variance of nearly constant series
  double weight_ = 0, sum_ = 0, squares_ = 0, peak_ = 0;
  std::vector<double> record_;
};

/// Quantile of the distance of the recorded points (x, y) from their mean.
double distance_quantile(const Series& x, const Series& y, double p);

/// A step between two accepted states, as the series that follow a run see it.
struct SeenStep {
  double length = 0;         ///< [s], 0: there is no state before this one
  double length_before = 0;  ///< of the step before it [s], likewise
  /// 1 over each of these and over their sum, 0 where there is none.
  double per_length = 0, per_length_before = 0, per_both = 0;
  int instants = 0;         ///< of the record that lie in (start, end]
  double last_instant = 0;  ///< how far before the end the last of them lies [s]
  double interval = 0;      ///< between two of them [s]
};

/// Divides time into steps and the instants of a record, one every `interval` seconds. Values at an
/// instant are read between states: were they those of the nearest state, forces that grow while
/// steps do would be read too low (tests/ACCURACY.md).
class StepClock {
 public:
  StepClock(double begin, double interval) : next_(begin), interval_(interval) {}
  SeenStep advance(double t);

 private:
  bool started_ = false;
  double last_ = 0, length_ = 0, next_, interval_;
};

/// The parabola through three states on end, the last step's and the one's before it.
template <class T>
class Bow {
 public:
  Bow(const SeenStep& step, T first, T middle, T last)
      : middle_(middle),
        before_((middle - first) * step.per_length_before),
        after_((last - middle) * step.per_length),
        bend_((after_ - before_) * step.per_both) {}
  /// Half its second derivative.
  T bend() const { return bend_; }
  /// Its value a time before the last state [s].
  T before_last(const SeenStep& step, T last, double time) const {
    return last - time * (after_ + (step.length - time) * bend_);
  }
  /// Its top where the middle is the largest of the three, else the middle.
  T top(const SeenStep& step) const {
    const auto inside = (before_ > 0.0) & (after_ < 0.0);
    const T slope = (before_ * step.length + after_ * step.length_before) * step.per_both;
    return middle_ - select(inside, slope * slope / (4 * select(inside, bend_, T{} - 1.0)), T{});
  }

 private:
  T middle_, before_, after_, bend_;
};

/// What trapeziums lack of the integrals of a value and of its square: half of each step's is due
/// to the bow at either end, which makes them of order 4 where the value is smooth. Where a step is
/// kShorter times shorter than the one before it, it may begin a contact (step_limit.hpp): if the
/// bow between them is sharper than the one before by kCorner times, it is a corner and says
/// nothing of the longer step.
template <class T>
class BowedSteps {
 public:
  struct Lack {
    T value, square;
  };
  /// Due to the bow through `first`, `middle`, `last`; none where not all three `count`.
  template <class M>
  Lack missing(const SeenStep& step, T first, T middle, T last, M count) {
    const Lack bow = {
        select(count, Bow(step, first, middle, last).bend(), T{}),
        select(count, Bow(step, first * first, middle * middle, last * last).bend(), T{})};
    const bool shorter = bows_++ > 0 && kShorter * step.length < step.length_before;
    const auto corner = abs(bow.value) > (shorter ? kCorner * abs(before_.value) : T{} + kNever);
    const auto cube = [](double h) { return h * h * h / 12; };
    const double h1 = cube(step.length_before), h2 = cube(step.length);
    const auto due = [&](T before, T at) { return -h1 * select(corner, before, at) - h2 * at; };
    const Lack lack = {due(before_.value, bow.value), due(before_.square, bow.square)};
    before_ = bow;
    return lack;
  }

 private:
  // By measurement: tests/ACCURACY.md.
  static constexpr double kShorter = 4, kCorner = 10, kNever = 1e300;
  Lack before_{};  ///< halves of second derivatives
  long bows_ = 0;
};

/// What is asked of a series beside its means: the rest is not worked out, and is no number.
enum Asked : unsigned { kMeans = 0, kPeak = 1, kQuantiles = 2 };

/// A quantity seen at the accepted steps of a run: means are integrals over bowed steps, of squares
/// for the rms; a peak may lie between states, and so do the instants of the record, on the
/// parabola through the last three states.
class StepSeries : public Series {
 public:
  explicit StepSeries(unsigned asked = kMeans);
  void add(double value, const SeenStep& step);

 private:
  unsigned asked_;
  double before_ = 0, last_ = 0;  ///< values at the two states before
  BowedSteps<double> bowed_;
};

/// Likewise one of every roller, a pack of them at a time: all rollers' values are one series.
class RollerSeries {
 public:
  explicit RollerSeries(unsigned asked = kMeans) : asked_(asked) {}
  /// `counts`: lanes where the quantity exists just now, not padding, nor, say, the slip of an
  /// unloaded roller.
  void add(std::size_t group, Pack value, Mask counts, const SeenStep& step);
  /// Likewise one that exists while `gate` exceeds `threshold`, >= 0. It may be largest where the
  /// gate opens or closes: there it lies on the chord between states whose gates are both above
  /// zero.
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
    State before, last;  ///< the two states before
    Pack gate{};         ///< of the last state
    BowedSteps<Pack> bowed;
  };
  unsigned asked_;
  std::vector<Seen> seen_;  ///< of each pack
  double shift_ = 0;        ///< a first value, as in Series
  bool shifted_ = false;
  Pack weight_{}, sum_{}, squares_{}, peak_{};
  std::vector<double> record_;
};

/// Mean square and peak of an acceleration in the plane seen at the accepted steps with velocity
/// and position: over a step each component is the parabola between both ends that makes the
/// velocity's change, for the peak the cubic that makes the position's, too, however sharply the
/// step before it ended.
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

}  // namespace cagetol
