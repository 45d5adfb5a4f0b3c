#include "mc/sweep/sample_motion.hpp"

#include "mc/run/cage_cache.hpp"
#include "mc/run/sample_run.hpp"

namespace cagetol {

SampleMotion record_motion(const StoredSample& stored,
                           const std::function<bool()>& stop_requested) {
  SimulateOptions options;
  if (is_flexible(stored.study.scene))
    options = CageTables(stored.study.scene).options_of(stored.sample.scene);
  options.stop_requested = stop_requested;
  SampleMotion motion{{}, MotionFrames(stored.sample.scene)};
  const auto record = [&motion](const Instant& at) { motion.frames.record(at); };
  motion.outcome = run_sample(stored.study, stored.sample, options, record);
  return motion;
}

}  // namespace cagetol
