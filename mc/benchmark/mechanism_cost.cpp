#include "mc/benchmark/mechanism_cost.hpp"

#include <algorithm>

#include "mc/benchmark/call_time.hpp"

namespace cagetol {
namespace {

/// A mechanism, whether a bearing has it, and that bearing without it.
struct Switch {
  const char* name;
  bool (*on)(const BearingModel&);
  void (*switch_off)(BearingModel&);
};
const Switch kSwitches[] = {
    {"traction of films", [](const BearingModel& m) { return m.lubricated && m.inner_line.shears; },
     [](BearingModel& m) {
       m.inner_line.shears = m.outer_line.shears = m.bar_line.shears = false;
     }},
    {"rolling resistance", [](const BearingModel& m) { return m.lubricated && m.inner_line.rolls; },
     [](BearingModel& m) { m.inner_line.rolls = m.outer_line.rolls = m.bar_line.rolls = false; }},
    {"squeeze", [](const BearingModel& m) { return m.lubricated && m.inner_line.squeeze; },
     [](BearingModel& m) {
       m.inner_line.squeeze = m.outer_line.squeeze = m.bar_line.squeeze = false;
     }},
    {"pocket films", [](const BearingModel& m) { return m.oiled_bars; },
     [](BearingModel& m) { m.oiled_bars = false; }},
    {"churning", [](const BearingModel& m) { return m.lubricated && m.churning.on; },
     [](BearingModel& m) { m.churning.on = false; }},
    {"elastic modes of the cage", [](const BearingModel& m) { return m.layout.modes > 0; },
     [](BearingModel& m) {
       m.layout.modes = 0;
       m.flexible = {};
     }},
};

/// The state of a bearing as that of one with fewer modes.
PackVector state_for(const StateLayout& to, const StateLayout& from, const double* y) {
  PackVector state(static_cast<std::size_t>(to.size()));
  const auto copy = [&](int at, int where, int count) {
    std::copy_n(y + where, count, state.begin() + at);
  };
  const int tilt = to.ring_tilt_slot(), tilt_from = from.ring_tilt_slot();
  copy(0, 0, kRollerPositions * to.padded());
  copy(to.positions(), from.positions(), kRollerVelocities * to.padded());
  copy(to.border_position(0), from.border_position(0), kModes + to.modes);
  copy(to.border_velocity(0), from.border_velocity(0), kModes + to.modes);
  copy(to.border_position(tilt), from.border_position(tilt_from), to.ring_tilt);
  copy(to.border_velocity(tilt), from.border_velocity(tilt_from), to.ring_tilt);
  return state;
}

}  // namespace

std::vector<CostPart> mechanism_parts(double t, const double* y, const System& system) {
  struct RightHandSide {
    System own;
    PackVector state, rate;
    double t;
    RightHandSide(const BearingModel& model, const System& of, double time, const double* y)
        : own(model),
          state(state_for(model.layout, of.model.layout, y)),
          rate(state.size()),
          t(time) {}
    void operator()() { own.rates(t, state.data(), rate.data()); }
  };
  RightHandSide whole(system.model, system, t, y);
  std::vector<CostPart> parts;
  for (const Switch& mechanism : kSwitches) {
    if (!mechanism.on(system.model)) continue;
    BearingModel without = system.model;
    mechanism.switch_off(without);
    RightHandSide part(without, system, t, y);
    parts.push_back({mechanism.name, 1 - time_ratio([&] { part(); }, [&] { whole(); })});
  }
  return parts;
}

}  // namespace cagetol
