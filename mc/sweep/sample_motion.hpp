// A stored sample run again for its frames.
#pragma once

#include "mc/run/motion_frames.hpp"
#include "mc/sweep/replay.hpp"
#include "src/quantities/outcome.hpp"

namespace cagetol {

struct SampleMotion {
  Outcome outcome;
  MotionFrames frames;
};

/// `stop_requested` as in SimulateOptions.
SampleMotion record_motion(const StoredSample& stored,
                           const std::function<bool()>& stop_requested = {});

}  // namespace cagetol
