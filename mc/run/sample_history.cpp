#include "mc/run/sample_history.hpp"

#include <algorithm>
#include <limits>
#include <string_view>

namespace cagetol {
namespace {

const RollerChannel& roller_spin() {
  const auto& channels = roller_channels();
  return *std::find_if(channels.begin(), channels.end(), [](const RollerChannel& channel) {
    return std::string_view(channel.name) == "roller_spin";
  });
}

}  // namespace

const std::vector<HistoryColumn>& history_columns() {
  static const std::vector<HistoryColumn> columns = [] {
    std::vector<HistoryColumn> all = {
        {"time", {"s", "time of the state since the start of the run"}}};
    for (const BearingChannel& channel : bearing_channels())
      all.push_back({channel.name, {channel.unit, channel.description}});
    all.push_back({roller_spin().name,
                   {roller_spin().unit, "absolute spin of roller history.roller about its axis"}});
    return all;
  }();
  return columns;
}

SampleHistory::SampleHistory(const HistoryPlan& plan, const Scene& scene)
    : scene_(scene),
      points_(static_cast<std::size_t>(plan.points)),
      roller_(static_cast<int>(plan.roller)),
      values_(points_ * history_columns().size(), std::numeric_limits<double>::quiet_NaN()) {}

double SampleHistory::instant(std::size_t i) const {
  // The last instant is that end without rounding.
  const double length = window_->measure;
  return window_->settle +
         (i + 1 == points_ ? length
                           : length * static_cast<double>(i + 1) / static_cast<double>(points_));
}

void SampleHistory::record(const Instant& at) {
  if (!window_) window_ = window_times(scene_, at.system.model);
  for (; next_ < points_ && instant(next_) <= at.t; ++next_) {
    double* value = values_.data() + next_;
    *value = at.t;
    for (const BearingChannel& channel : bearing_channels())
      *(value += points_) = channel.value(at);
    *(value += points_) = roller_spin().value(at, roller_);
  }
}

void SampleHistory::restart(double begin) {
  window_->settle = begin;
  next_ = 0;
  std::fill(values_.begin(), values_.end(), std::numeric_limits<double>::quiet_NaN());
}

}  // namespace cagetol
