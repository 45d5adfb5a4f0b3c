#include "src/quantities/series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cagetol {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Calls `see` with the time from each of the step's instants to its end [s].
template <class See>
void each_instant(const SeenStep& step, const See& see) {
  for (int k = step.instants - 1; k >= 0; --k) see(step.last_instant + k * step.interval);
}

/// A value some time before the end of the step: on the parabola through three states, the chord
/// where there are two.
template <class T>
T value_before(const SeenStep& step, T first, T middle, T last, double time) {
  if (!(step.length > 0)) return last;
  if (!(step.length_before > 0)) return last - (last - middle) * (time * step.per_length);
  return Parabola(step, first, middle, last).before_last(step, last, time);
}

/// a(u) = first + (last - first) u + q u (1 - u) + c u (1 - u) (1 - 2u), u = 0 to 1 over a
/// step of which the integral and the integral's integral are known.
class Cubic {
 public:
  Cubic(const SeenStep& step, double first, double last, double gained, double moved)
      : first_(first), last_(last) {
    const double mean = gained * step.per_length;
    const double twice = moved * step.per_length * step.per_length;
    quadratic_ = 6 * (mean - (first + last) / 2);
    cubic_ = kCubicPerMove * (twice - (2 * first + last) / 6 - quadratic_ / 12);
  }
  static constexpr double kCubicPerMove = 60;
  double at(double u) const {
    return first_ + (last_ - first_) * u + u * (1 - u) * (quadratic_ + cubic_ * (1 - 2 * u));
  }
  /// Without the cubic term, to which a step's error adds (`convergence.src`, PocketForceRms).
  double mean_square() const {
    return (first_ * first_ + first_ * last_ + last_ * last_) / 3 +
           quadratic_ * (first_ + last_) / 6 + quadratic_ * quadratic_ / 30;
  }
  /// No smaller than its largest magnitude.
  double most() const {
    return std::max(std::abs(first_), std::abs(last_)) + std::abs(quadratic_) / 4 +
           std::abs(cubic_) / 10;
  }

 private:
  double first_, last_, quadratic_, cubic_;
};

constexpr int kParts = 8;  ///< of a step at whose ends an acceleration is looked at for its peak

}  // namespace

Series::Series(const Sums& sums, std::vector<double> record)
    : count_(sums.count),
      shift_(sums.shift),
      weight_(sums.weight),
      sum_(sums.values),
      squares_(sums.squares),
      peak_(sums.peak),
      record_(std::move(record)) {}

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
    distance.add(std::hypot(x.record_[i] - mean_x, y.record_[i] - mean_y), 1, 1);
  return distance.quantile(p);
}

SeenStep StepClock::advance(double t) {
  SeenStep step;
  step.length = started_ ? t - last_ : 0;
  step.length_before = length_;
  const auto per = [](double length) { return length > 0 ? 1 / length : 0; };
  step.per_length = per(step.length);
  step.per_length_before = per(step.length_before);
  step.per_both = per(step.length + step.length_before);
  step.interval = interval_;
  for (; next_ <= t; next_ += interval_) {
    ++step.instants;
    step.last_instant = t - next_;
  }
  started_ = true;
  last_ = t;
  length_ = step.length;
  return step;
}

StepSeries::StepSeries(unsigned asked) : asked_(asked) {
  if (!(asked & kPeak)) peak_ = kNone;
}

void StepSeries::add(double value, const SeenStep& step) {
  if (step.length > 0) Series::add(last_, step.length / 2);
  Series::add(value, step.length / 2);
  if (asked_ & kQuantiles)
    each_instant(step, [&](double time) {
      record_.push_back(value_before(step, before_, last_, value, time));
    });
  if (step.length_before > 0 && step.length > 0) {
    const double first = before_ - shift_, middle = last_ - shift_, last = value - shift_;
    const auto correction = correction_.next(step, first, middle, last, true);
    sum_ += correction.value;
    squares_ += correction.square;
    if (asked_ & kPeak)
      peak_ = std::max(
          peak_, Parabola(step, std::abs(before_), std::abs(last_), std::abs(value)).top(step));
  }
  before_ = last_;
  last_ = value;
}

void RollerSeries::add(std::size_t group, Pack value, Mask counts, const SeenStep& step) {
  if (!shifted_ && any(counts)) {
    for (int i = kLanes - 1; i >= 0; --i)
      if (counts[i]) shift_ = value[i];
    shifted_ = true;
  }
  if (group >= seen_.size()) seen_.resize(group + 1);
  auto& [before, last, gate, corrections] = seen_[group];
  const State now{value, counts};
  const Pack first = before.value - shift_, middle = last.value - shift_, x = value - shift_;
  const Pack half = splat(step.length / 2);
  for (const auto& [counted, at] : {std::pair{last.counts, middle}, std::pair{counts, x}}) {
    const Pack weight = select(counted, half, Pack{});
    weight_ += weight;
    sum_ += weight * at;
    squares_ += weight * at * at;
  }
  const bool has_parabola = step.length_before > 0;
  const Mask all = before.counts & last.counts & counts;
  if (has_parabola) {
    const auto correction = corrections.next(step, first, middle, x, all);
    sum_ += correction.value;
    squares_ += correction.square;
  }
  if (asked_ & kPeak) {
    peak_ = max(peak_, select(counts, abs(value), Pack{}));
    const Parabola parabola(step, abs(before.value), abs(last.value), abs(value));
    if (has_parabola) peak_ = max(peak_, select(all, parabola.top(step), Pack{}));
  }
  if (asked_ & kQuantiles) {
    const Mask known = step.length > 0 ? last.counts & counts : counts;
    each_instant(step, [&, &before = before, &last = last](double time) {
      const Pack at = value_before(step, before.value, last.value, value, time);
      for (int i = 0; i < kLanes; ++i)
        if (known[i]) record_.push_back(at[i]);
    });
  }
  before = last;
  last = now;
}

void RollerSeries::add_above(std::size_t group, Pack value, Pack gate, double threshold, Mask here,
                             const SeenStep& step) {
  const Mask counts = here & (gate > threshold);
  add(group, value, counts, step);
  Seen& seen = seen_[group];
  const Mask crosses = (counts != seen.before.counts) & (min(gate, seen.gate) > 0.0);
  if (any(crosses)) {
    const Pack share = (threshold - seen.gate) / select(crosses, gate - seen.gate, splat(1.0));
    const Pack at = seen.before.value + share * (value - seen.before.value);
    peak_ = max(peak_, select(crosses, abs(at), Pack{}));
  }
  seen.gate = gate;
}

Series::Sums RollerSeries::sums() const {
  const double peak = asked_ & kPeak ? largest(peak_) : kNone;
  return {shifted_ ? 1 : 0, shift_, sum(weight_), sum(sum_), sum(squares_), peak};
}

void PlaneAcceleration::add(Plane acceleration, Plane velocity, Plane position,
                            const SeenStep& step) {
  const auto square = [](double y, double z) { return y * y + z * z; };
  largest_square_ = std::max(largest_square_, square(acceleration.y, acceleration.z));
  if (step.length > 0) {
    const Cubic y(step, last_.y, acceleration.y, velocity.y - last_velocity_.y,
                  position.y - last_position_.y - last_velocity_.y * step.length);
    const Cubic z(step, last_.z, acceleration.z, velocity.z - last_velocity_.z,
                  position.z - last_position_.z - last_velocity_.z * step.length);
    duration_ += step.length;
    squares_ += step.length * (y.mean_square() + z.mean_square());
    // Of a step so short that rounding of the position outweighs the acceleration nothing is known
    // but its ends.
    const double rounding = std::numeric_limits<double>::epsilon() *
                            (std::abs(position.y) + std::abs(position.z)) * step.per_length *
                            step.per_length;
    const double known = std::max(square(last_.y, last_.z), square(acceleration.y, acceleration.z));
    if (square(y.most(), z.most()) > largest_square_ &&
        Cubic::kCubicPerMove * Cubic::kCubicPerMove * rounding * rounding <= known)
      for (int k = 1; k < kParts; ++k) {
        const double u = static_cast<double>(k) / kParts;
        largest_square_ = std::max(largest_square_, square(y.at(u), z.at(u)));
      }
  }
  last_ = acceleration;
  last_velocity_ = velocity;
  last_position_ = position;
}

double PlaneAcceleration::rms() const {
  return duration_ > 0 ? std::sqrt(squares_ / duration_) : kNone;
}

}  // namespace cagetol
