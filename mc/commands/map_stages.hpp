// A grid of screens: each cell is the study with two keys of its operating points replaced, in
// DIR/map/KEY-VALUE_KEY-VALUE/screen, a sweep like any other; with `more` beside it where a
// neighbour has another answer or the runs resolve none. All cells draw the same cages. DIR/map
// holds map.json, map.csv, map.html and figures/.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "mc/host/progress.hpp"
#include "mc/sweep/staged_sweeps.hpp"

namespace cagetol {

struct MapOptions {
  std::string directory;
  std::vector<std::string> over;  ///< two axes (mc/study/map_axis.hpp): first up, second across
  bool pdf = false;               ///< map.pdf, too
  ProgressStyle progress = ProgressStyle::automatic;
};

/// Every rank calls it, as run_recommend. A cell without an answer is part of the map, with its
/// reason; kSamplesFailed where no cell has one.
int run_map(const std::function<Study()>& read, const MakePlan& make_plan,
            const MapOptions& options);

}  // namespace cagetol
