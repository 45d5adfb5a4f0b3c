// After the verdict of a recommendation: the same cages and starts again, once for each end of the
// range of an assumption, as sweeps in DIR/assume-ATTEMPT-RUNS/KEY-VALUE.
#pragma once

#include <string>

#include "analysis/tolerance/campaign.hpp"
#include "mc/sweep/staged_sweeps.hpp"

namespace cagetol {

/// In the directory of a recommendation: attempts and alternatives as decided by other limits,
/// target or confidence. Their runs are taken where they are asked for again.
inline constexpr const char* kEarlierFolder = "earlier";

/// Writes DIR/assumptions.json, says what is run and how long it takes, and runs what is missing,
/// on the tolerance of the attempt that confirmed, or of the surest one. Where
/// recommend.assumption_samples is 0 it says how to have it run. Exit code of the sweep that ended
/// early, or 0.
int run_assumptions(const Study& base, const std::string& directory, const Campaign& campaign,
                    const CampaignPlan& plan, StagedSweeps& stages);

}  // namespace cagetol
