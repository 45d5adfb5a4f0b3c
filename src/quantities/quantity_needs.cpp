
#include "src/quantities/quantity_rows.hpp"
#include "src/scene/whirl_window.hpp"

namespace cagetol {
namespace {

bool moves(const Scene& s) {
  return !is_quasi_static(s);
}
bool turns(const Scene& s) {
  return moves(s) &&
         (largest_inner_speed(s.operation) != 0 || largest_outer_speed(s.operation) != 0);
}
bool measures_whirl(const Scene& s) {
  return turns(s) && !changes_over_time(s.operation) && is_whirl_window(s);
}

}  // namespace

// clang-format off
namespace need {
const Need any{"any model", [](const Scene&) { return true; }};
const Need motion{"model.motion = \"dynamic\"", moves};
const Need loaded{"model.motion = \"dynamic\"; loaded contacts", moves, Given::perhaps};
const Need turning{"model.motion = \"dynamic\"; speed.inner_rpm not zero", turns, Given::where_the_cage_turns};
const Need turning_loaded{"model.motion = \"dynamic\"; speed.inner_rpm not zero; loaded contacts", turns, Given::perhaps};
const Need whole_turns{"model.motion = \"dynamic\"; at least one whole cage revolution measured", [](const Scene& s) { return turns(s) && s.window.measure_revolutions >= 1; }, Given::perhaps};
const Need whirl{"model.motion = \"dynamic\"; window.measure_revolutions of 20 or more, of 40 or more where a load turns", measures_whirl, Given::perhaps};
const Need tilting{"model.motion = \"dynamic\"; model.ring_tilt = \"free\"", [](const Scene& s) { return moves(s) && has_free_ring_tilt(s); }};
const Need flexible{"cage.model = \"flexible\"", is_flexible};
const Need oil{"model.motion = \"dynamic\"; lubrication.model = \"film\"; loaded contacts", [](const Scene& s) { return moves(s) && is_lubricated(s); }, Given::perhaps};
const Need heat{"model.motion = \"dynamic\"; temperature.balance", [](const Scene& s) { return moves(s) && s.temperature.balance; }};
}  // namespace need
// clang-format on

}  // namespace cagetol
