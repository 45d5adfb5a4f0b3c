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
  return Bow(step, first, middle, last).before_last(step, last, time);
}

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
    const auto lack = bowed_.missing(step, first, middle, last, true);
    sum_ += lack.value;
    squares_ += lack.square;
    if (asked_ & kPeak)
      peak_ =
          std::max(peak_, Bow(step, std::abs(before_), std::abs(last_), std::abs(value)).top(step));
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
  auto& [before, last, bowed] = seen_[group];
  const State now{value, counts};
  const Pack first = before.value - shift_, middle = last.value - shift_, x = value - shift_;
  const Pack half = splat(step.length / 2);
  for (const auto& [counted, at] : {std::pair{last.counts, middle}, std::pair{counts, x}}) {
    const Pack weight = select(counted, half, Pack{});
    weight_ += weight;
    sum_ += weight * at;
    squares_ += weight * at * at;
  }
  const bool bows = step.length_before > 0;
  const Mask all = before.counts & last.counts & counts;
  if (bows) {
    const auto lack = bowed.missing(step, first, middle, x, all);
    sum_ += lack.value;
    squares_ += lack.square;
  }
  if (asked_ & kPeak) {
    peak_ = max(peak_, select(counts, abs(value), Pack{}));
    const Bow bow(step, abs(before.value), abs(last.value), abs(value));
    if (bows) peak_ = max(peak_, select(all, bow.top(step), Pack{}));
  }
  if (asked_ & kQuantiles) {
    const Mask known = step.length > 0 ? last.counts & counts : counts;
    each_instant(step, [&](double time) {
      const Pack at = value_before(step, before.value, last.value, value, time);
      for (int i = 0; i < kLanes; ++i)
        if (known[i]) record_.push_back(at[i]);
    });
  }
  before = last;
  last = now;
}

Series RollerSeries::all() const {
  const double peak = asked_ & kPeak ? largest(peak_) : kNone;
  return {{shifted_ ? 1 : 0, shift_, sum(weight_), sum(sum_), sum(squares_), peak}, record_};
}

void IntegratedVector::add(Plane vector, Plane integral, const SeenStep& step) {
  const auto square = [](double y, double z) { return y * y + z * z; };
  largest_square_ = std::max(largest_square_, square(vector.y, vector.z));
  if (step.length > 0) {
    // a(u) = a0 + (a1 - a0) u + bow u (1 - u), u = 0 to 1; its mean is (a0 + a1)/2 + bow/6.
    const auto bow = [&](double a0, double a1, double gained) {
      return 6 * (gained / step.length - (a0 + a1) / 2);
    };
    const auto mean_square = [](double a0, double a1, double c) {
      return (a0 * a0 + a0 * a1 + a1 * a1) / 3 + c * (a0 + a1) / 6 + c * c / 30;
    };
    const double bow_y = bow(last_.y, vector.y, integral.y - last_integral_.y),
                 bow_z = bow(last_.z, vector.z, integral.z - last_integral_.z);
    duration_ += step.length;
    squares_ += step.length *
                (mean_square(last_.y, vector.y, bow_y) + mean_square(last_.z, vector.z, bow_z));
    for (const double u : {0.25, 0.5, 0.75}) {
      const auto between = [&](double a0, double a1, double c) {
        return a0 + (a1 - a0) * u + c * u * (1 - u);
      };
      largest_square_ = std::max(largest_square_, square(between(last_.y, vector.y, bow_y),
                                                         between(last_.z, vector.z, bow_z)));
    }
  }
  last_ = vector;
  last_integral_ = integral;
}

double IntegratedVector::rms() const {
  return duration_ > 0 ? std::sqrt(squares_ / duration_) : kNone;
}

}  // namespace cagetol
