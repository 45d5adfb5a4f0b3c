// How long a window must be to tell whirl of the cage.
#pragma once

#include "src/scene/scene.hpp"

namespace cagetol {

/// Turns of the cage; more where whirl has to be told from a load that turns.
inline constexpr double kWhirlTurns = 20, kWhirlTurnsBesideLoad = 40;

inline bool load_turns(const Scene& scene) {
  return scene.operation.rotating_load != 0 || scene.operation.unbalance != 0;
}

inline bool is_whirl_window(const Scene& scene) {
  return std::isnan(scene.window.measure_time) &&
         scene.window.measure_revolutions >=
             (load_turns(scene) ? kWhirlTurnsBesideLoad : kWhirlTurns);
}

}  // namespace cagetol
