// A page that plays the motion of one run; needs nothing but a browser (analysis/pages/motion.js).
#pragma once

#include <string>

#include "mc/run/motion_frames.hpp"

namespace cagetol {

/// Writes the page; a second heading line names what is seen. Throws InputError where the run left
/// no frames, WriteError.
void write_motion_page(const std::string& file, const std::string& title,
                       const MotionFrames& frames);

}  // namespace cagetol
