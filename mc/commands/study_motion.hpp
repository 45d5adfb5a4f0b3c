// The motion of a sweep's worst and median samples for the report: DIR/motion.json.
#pragma once

#include <filesystem>

namespace cagetol {

/// Runs both samples again and writes their frames (mc/run/motion_frames.hpp) beside study.h5;
/// leaves alone a file of this study, build and these samples. Worst: with the largest cage stress;
/// of rigid cages the largest pocket force.
/// What went wrong is a warning: the report does without.
void update_study_motion(const std::filesystem::path& sweep_directory);

}  // namespace cagetol
