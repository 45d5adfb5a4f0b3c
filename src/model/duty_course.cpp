#include "src/model/duty_course.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cagetol {
namespace {

/// Instants this close are one [s].
constexpr double kSame = 1e-10;

double linear(double from, double to, double share) {
  return from + share * (to - from);
}

}  // namespace

DutyCourse::DutyCourse(const Operation& o) {
  const DutyTable& table = o.table;
  const auto value = [](const NumberList& column, std::size_t i, double constant) {
    return column.empty() ? constant : column[i];
  };
  for (std::size_t i = 0; i < table.time.size(); ++i) {
    Row row;
    row.time = table.time[i];
    row.inner = value(table.inner_speed, i, o.inner_speed);
    row.outer = value(table.outer_speed, i, o.outer_speed);
    row.radial = value(table.radial_load, i, o.radial_load);
    row.direction = value(table.direction, i, o.load_direction);
    row.axial = value(table.axial_load, i, o.axial_load);
    row.moment_y = value(table.moment_y, i, o.tilting_moment_y);
    row.moment_z = value(table.moment_z, i, o.tilting_moment_z);
    rows_.push_back(row);
  }
  if (rows_.empty()) return;
  if (!std::isnan(table.repeat)) {
    const double end = rows_.front().time + table.repeat;
    if (end > rows_.back().time + kSame) {
      rows_.push_back(rows_.front());
      rows_.back().time = end;
    }
    period_ = rows_.back().time - rows_.front().time;
  }
  Row* before = &rows_.front();
  before->inner_turned = before->inner * before->time;
  before->outer_turned = before->outer * before->time;
  for (Row& row : rows_) {
    const double half = (row.time - before->time) / 2;
    row.inner_turned = before->inner_turned + half * (before->inner + row.inner);
    row.outer_turned = before->outer_turned + half * (before->outer + row.outer);
    drives_ = drives_ || row.inner != before->inner || row.outer != before->outer;
    before = &row;
  }
}

DutyCourse::Row DutyCourse::at(double t) const {
  const Row &first = rows_.front(), &last = rows_.back();
  const double periods = repeats() && t > first.time ? std::floor((t - first.time) / period_) : 0;
  const double local = t - periods * period_;
  const auto after = std::upper_bound(rows_.begin(), rows_.end(), local,
                                      [](double time, const Row& row) { return time < row.time; });
  const bool before_all = after == rows_.begin(), after_all = after == rows_.end();
  Row now = before_all ? first : *(after - 1);
  if (before_all || after_all) {
    now.inner_turned += now.inner * (local - now.time);
    now.outer_turned += now.outer * (local - now.time);
  } else {
    const Row from = now;
    const double share = (local - from.time) / (after->time - from.time);
    for (double Row::*value : {&Row::inner, &Row::outer, &Row::radial, &Row::direction, &Row::axial,
                               &Row::moment_y, &Row::moment_z})
      now.*value = linear(from.*value, (*after).*value, share);
    const double half = (local - from.time) / 2;
    now.inner_turned = from.inner_turned + half * (from.inner + now.inner);
    now.outer_turned = from.outer_turned + half * (from.outer + now.outer);
  }
  now.time = t;
  now.inner_turned += periods * (last.inner_turned - first.inner_turned);
  now.outer_turned += periods * (last.outer_turned - first.outer_turned);
  return now;
}

double DutyCourse::next_corner(double t) const {
  const double first = rows_.front().time;
  const double periods = repeats() && t > first ? std::floor((t - first) / period_) : 0;
  // The next period too: `t` may be the end of this one but for rounding.
  for (double shift = periods * period_; shift <= (periods + 1) * period_;
       shift += std::max(period_, kSame)) {
    for (const Row& row : rows_)
      if (row.time + shift > t + kSame) return row.time + shift;
    if (!repeats()) break;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace cagetol
