// Replicas of a scene: the same bearing, started a little differently, many times.
#pragma once

#include <vector>

#include "mc/study/study.hpp"
#include "src/simulate.hpp"

namespace cagetol {

/// Replica k: the study's first row with fresh noise, its cage started off by normal draws of a
/// tenth of the pocket clearance in y and z. A pure function of (study, k).
std::vector<Scene> replica_scenes(const Study& study, int count);

/// Simulates all scenes on all cores (`threads` at a time); outcomes in the scenes' order, whatever
/// the number of threads.
std::vector<Outcome> simulate_all(const std::vector<Scene>& scenes, int threads,
                                  const SimulateOptions& options = {});

}  // namespace cagetol
