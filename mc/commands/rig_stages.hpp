// One load and speed of a rig as sweeps: DIR/rows/LOADN-SPEEDrpm/base from several starts, and
// KEY-VALUE beside it for each end of the range of an assumption, from the first of these starts.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mc/study/assumption_ranges.hpp"
#include "mc/study/rig_csv.hpp"
#include "mc/sweep/staged_sweeps.hpp"

namespace cagetol {

/// Runs under each end of an assumption, as few as show how sure a shift is; and fewest starts.
inline constexpr long kRunsOfAnEnd = 3;

/// The scene of `given` at the measured load and speed, run from `starts` starts: noise on the
/// cage's place, normal with a tenth of its guide's clearance, and on the angle of the rollers. No
/// other distribution of `given` is drawn.
Study rig_study(const Study& given, const RigMeasurement& row, long starts);

/// Runs what is missing of the row in DIR and adds to `rows` what rig.json has of it: orders and
/// slips, measured and predicted, and what they say (rig_verdict.hpp). Exit code of the sweep that
/// ended early, or 0.
int run_rig_row(const Study& base, const RigMeasurement& row,
                const std::vector<Alternative>& alternatives, const std::string& directory,
                StagedSweeps& stages, nlohmann::ordered_json& rows);

}  // namespace cagetol
