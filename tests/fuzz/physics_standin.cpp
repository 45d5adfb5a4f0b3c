// What the readers' neighbours ask of the physics, so that fuzzing compiles no physics: no sample
// is run here, and of tables only the names are asked for.
#include <sundials/sundials_version.h>

#include "mc/run/history_channels.hpp"
#include "mc/run/jam_shares.hpp"
#include "src/quantities/operating_point.hpp"
#include "src/quantities/quantity_rows.hpp"
#include "src/quantities/window_times.hpp"
#include "src/simulate.hpp"

namespace cagetol {

const std::vector<BearingChannel>& bearing_channels() {
  static const std::vector<BearingChannel> channels = {{"ring_y", "um", "inner ring, y", nullptr}};
  return channels;
}
const std::vector<RollerChannel>& roller_channels() {
  static const std::vector<RollerChannel> channels = {{"roller_spin", "rpm", "spin", nullptr}};
  return channels;
}
const std::vector<OperatingRow>& operating_rows() {
  static const std::vector<OperatingRow> rows = {
      {"equivalent_load_N", "N", "load", [](const OperatingPoint& at) { return at.load; }}};
  return rows;
}
OperatingPoint operating_point(const Scene&) {
  return {};
}
JamShares jam_shares(const Study&) {
  return {};
}
double whirl_clearance(const BearingModel&) {
  return 0;
}
WindowTimes window_times(const Scene&, const BearingModel&) {
  return {};
}
BearingModel make_bearing_model(const OperatingScene&, std::shared_ptr<const CageModel>) {
  return {};
}
Outcome simulate(const OperatingScene&, const SimulateOptions&) {
  return {};
}

namespace bound {
const Bound finite{}, not_negative{}, share{}, slip{}, circle{}, lean{}, whirl{}, axial{},
    ring_place{}, ring_orbit{}, ring_acceleration{}, loss{}, stress{}, pocket{}, station{};
}

}  // namespace cagetol

int SUNDIALSGetVersion(char* version, int length) {
  if (length > 0) version[0] = '\0';
  return 0;
}
