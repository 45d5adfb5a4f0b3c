#include "src/quantities/series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cagetol {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

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
  const double middle = t - step.length / 2;
  for (; next_ <= t; next_ += interval_)
    ++(next_ < middle ? step.recorded_at_start : step.recorded_at_end);
  started_ = true;
  last_ = t;
  length_ = step.length;
  return step;
}

void StepSeries::add(double value, const SeenStep& step) {
  if (step.length > 0) Series::add(last_, step.length / 2, step.recorded_at_start);
  Series::add(value, step.length / 2, step.recorded_at_end);
  if (step.length_before > 0 && step.length > 0) {
    const double first = before_ - shift_, middle = last_ - shift_, last = value - shift_;
    const auto lack = bowed_.missing(step, first, middle, last, true);
    sum_ += lack.value;
    squares_ += lack.square;
    peak_ = std::max(peak_, Bow(step, std::abs(before_), std::abs(last_), std::abs(value)).top());
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
  Pack top = select(counts, abs(value), Pack{});
  if (step.length_before > 0) {
    const Mask all = before.counts & last.counts & counts;
    const auto lack = bowed.missing(step, first, middle, x, all);
    sum_ += lack.value;
    squares_ += lack.square;
    const Bow bow(step, abs(before.value), abs(last.value), abs(value));
    top = max(top, select(all, bow.top(), Pack{}));
  }
  peak_ = max(peak_, top);
  record(last, step.recorded_at_start);
  record(now, step.recorded_at_end);
  before = last;
  last = now;
}

void RollerSeries::record(const State& state, int times) {
  for (; times > 0; --times)
    for (int i = 0; i < kLanes; ++i)
      if (state.counts[i]) record_.push_back(state.value[i]);
}

Series RollerSeries::all() const {
  return {{shifted_ ? 1 : 0, shift_, sum(weight_), sum(sum_), sum(squares_), largest(peak_)},
          record_};
}

}  // namespace cagetol
