#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "src/reading/scene_check.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kMostRows = 10000;
constexpr double kMinimumSpacing = 1e-9;  // [s]: far below any step
constexpr std::size_t kLongestName = 40;

struct TableColumn {
  const char* key;
  const NumberList& values;
};

std::vector<TableColumn> columns_of(const DutyTable& t) {
  return {{"duty.inner_rpm", t.inner_speed}, {"duty.outer_rpm", t.outer_speed},
          {"duty.radial_N", t.radial_load},  {"duty.direction_deg", t.direction},
          {"duty.axial_N", t.axial_load},    {"duty.moment_y_N_m", t.moment_y},
          {"duty.moment_z_N_m", t.moment_z}};
}

void check_rows(const DutyTable& t, const SceneCheck& check) {
  bool any = false;
  for (const auto& [key, values] : columns_of(t)) {
    any = any || !values.empty();
    check.require(values.empty() || values.size() == t.time.size(), key,
                  std::to_string(values.size()) + " values for " + std::to_string(t.time.size()) +
                      " instants (duty.time_s)",
                  "give one value for each instant");
  }
  check.require(t.empty() || any, "duty.time_s", "nothing is given at these instants",
                "give at least one of duty.inner_rpm, duty.radial_N and the other columns");
  check.require(
      t.time.size() <= kMostRows, "duty.time_s",
      std::to_string(t.time.size()) + " instants are more than " + std::to_string(kMostRows),
      "leave out what lies between on straight lines");
  for (std::size_t i = 1; i < t.time.size(); ++i)
    check.require(t.time[i] - t.time[i - 1] >= kMinimumSpacing, "duty.time_s",
                  "instant " + std::to_string(i + 1) + ", " + number_text(t.time[i]) +
                      " s, does not come after the one before it, " + number_text(t.time[i - 1]) +
                      " s",
                  "give instants that increase, by 1 ns at least");
}

bool is_whole_turns(double angle) {
  return std::abs(std::remainder(angle, 2 * std::numbers::pi)) < 1e-9;
}

void check_period(const DutyTable& t, const SceneCheck& check) {
  if (std::isnan(t.repeat)) return;
  check.require(!t.empty(), "duty.repeat_s", "there is no duty to repeat",
                "give duty.time_s and what the duty imposes, or leave the period out");
  const double span = t.time.values.back() - t.time[0];
  const bool closed = t.repeat - span < kMinimumSpacing;
  check.require(t.repeat > span - kMinimumSpacing, "duty.repeat_s",
                "the period is shorter than the duty, " + number_text(span) + " s",
                "give at least this");
  check.require(!closed || t.time.size() > 1, "duty.repeat_s", "a single instant has no period",
                "give two instants or leave the period out");
  for (const auto& [key, values] : columns_of(t))
    check.require(!closed || values.empty() || values[0] == values.values.back() ||
                      (&values == &t.direction && is_whole_turns(values.values.back() - values[0])),
                  key,
                  "the last value differs from the first one, to which a duty that repeats after " +
                      number_text(t.repeat) + " s would jump",
                  "end with the first value, or give a longer duty.repeat_s");
}

void check_ramps(const Operation& o, const SceneCheck& check) {
  for (const auto& [key, from] : {std::pair{"speed.ramp_from_rpm", o.speed_ramp_from},
                                  std::pair{"speed.outer_ramp_from_rpm", o.outer_ramp_from}})
    check.require(std::isnan(from) || !changes_over_time(o), key,
                  "the duty over time says how the rings turn",
                  "leave the ramp out, and write it into the duty");
}

void check_phases(const Scene& scene, const SceneCheck& check) {
  const Phases& p = scene.phase;
  check.require(p.from.size() == p.name.size(), "phase.from_s",
                std::to_string(p.from.size()) + " values for " + std::to_string(p.name.size()) +
                    " phases (phase.name)",
                "give one for each");
  check.require(p.to.size() == p.name.size(), "phase.to_s",
                std::to_string(p.to.size()) + " values for " + std::to_string(p.name.size()) +
                    " phases (phase.name)",
                "give one for each");
  if (p.name.empty()) return;
  check.require(changes_over_time(scene.operation), "phase.name",
                "no phase differs from another: speed and load do not change over time",
                "give a duty over time (duty.*), or leave the phases out");
  check.require(!is_quasi_static(scene) || p.name.empty(), "phase.name",
                "equilibria tell nothing of phases (" + check.with_value("model.motion") + ")",
                "set model.motion = \"dynamic\", or leave the phases out");
  std::set<std::string> seen;
  const Window& w = scene.window;
  const double settle =
      given_or(w.settle_time, *std::min_element(p.from.values.begin(), p.from.values.end()));
  const double end = settle + w.measure_time;  // NaN: until the last phase ends
  for (std::size_t i = 0; i < p.name.size(); ++i) {
    const std::string& name = p.name[i];
    check.require(is_label(name), "phase.name", "'" + name + "' is no name of a phase",
                  "use up to 40 letters, digits, _ and -");
    check.require(seen.insert(name).second, "phase.name", "two phases are called " + name,
                  "give each a name of its own");
    check.require(p.to[i] - p.from[i] >= kMinimumSpacing, "phase.to_s",
                  "phase " + name + " ends before it begins, or within a nanosecond",
                  "give an end after phase.from_s, " + number_text(p.from[i]) + " s");
    check.require(!(p.to[i] > end * (1 + 1e-12)), "phase.to_s",
                  "phase " + name + " ends after the run, " + number_text(end) + " s",
                  "lengthen window.measure_time_s, or leave it to the phases (\"auto\")");
  }
}

void check_window_under_duty(const Scene& scene, const SceneCheck& check) {
  if (!changes_over_time(scene.operation)) return;
  check.require(std::isnan(scene.window.peak_revolutions), "window.peak_revolutions",
                "under a duty over time no cage revolution stands for another",
                "set window.peak_revolutions = \"auto\", and name phases");
}

}  // namespace

bool is_label(std::string_view text) {
  return !text.empty() && text.size() <= kLongestName &&
         std::all_of(text.begin(), text.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; });
}

void check_duty(const Scene& scene, const SceneCheck& check) {
  const Operation& o = scene.operation;
  check_rows(o.table, check);
  check_period(o.table, check);
  check_ramps(o, check);
  for (const auto& [key, moment] : {std::pair{"duty.moment_y_N_m", &o.table.moment_y},
                                    std::pair{"duty.moment_z_N_m", &o.table.moment_z}})
    check.require(moment->empty() || scene.model.ring_tilt == TiltModel::free, key,
                  "a ring whose tilt is prescribed hands any moment on to its shaft (" +
                      check.with_value("model.ring_tilt") + ")",
                  "set model.ring_tilt = \"free\", or leave the moment out");
  check_window_under_duty(scene, check);
  check_phases(scene, check);
}

}  // namespace cagetol
