// What the readers ask of the physics, so that fuzzing them compiles no physics.
#include <sundials/sundials_version.h>

#include "mc/run/history_channels.hpp"
#include "src/quantities/window_times.hpp"

namespace cagetol {

// No sample is run here: of histories only the names of their columns are asked for.
const std::vector<BearingChannel>& bearing_channels() {
  static const std::vector<BearingChannel> channels = {{"ring_y", "um", "inner ring, y", nullptr}};
  return channels;
}
const std::vector<RollerChannel>& roller_channels() {
  static const std::vector<RollerChannel> channels = {{"roller_spin", "rpm", "spin", nullptr}};
  return channels;
}
WindowTimes window_times(const Scene&, const BearingModel&) {
  return {};
}

}  // namespace cagetol

int SUNDIALSGetVersion(char* version, int length) {
  if (length > 0) version[0] = '\0';
  return 0;
}
