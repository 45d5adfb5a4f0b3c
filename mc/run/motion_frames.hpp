// The motion of one run as frames of an animation: where cage and rollers are, what presses on
// races and bars, what stresses the cage. `cagetol animate` and the report show them
// (analysis/figures/motion.js).
#pragma once

#include <deque>
#include <nlohmann/json.hpp>
#include <vector>

#include "mc/run/history_channels.hpp"
#include "src/operation/operating_scene.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

class MotionFrames {
 public:
  /// Frames kept: the last ones of a run.
  static constexpr std::size_t kMost = 360;

  /// `scene` in operation (src/operation/operating_clearance.hpp): its cage is the one drawn.
  explicit MotionFrames(const OperatingScene& scene) : scene_(scene) {}

  /// To be called at every accepted state: keeps 180 in a cage revolution; of a duty over time, or
  /// at standstill, 360 of the whole run. A second run begins anew.
  void record(const Instant& at);

  /// Geometry and frames; null where no state was recorded. mc/RESULTS_FORMAT.md lists the keys.
  nlohmann::ordered_json json() const;

 private:
  struct Frame {
    double time, cage_y, cage_z, cage_angle, inner_angle, stress;  ///< [s], [m], [rad], [Pa]
    /// Of each roller: its place in the pocket along the circle [m], forces [N].
    std::vector<double> place, race_force, leading_force, trailing_force;
  };

  void begin(const Instant& at);

  OperatingScene scene_;
  double interval_ = 0, next_time_ = 0;
  std::deque<Frame> frames_;
  nlohmann::ordered_json geometry_;
  std::vector<double> pocket_angle_;  ///< [rad]
  double pitch_radius_ = 0;
};

}  // namespace cagetol
