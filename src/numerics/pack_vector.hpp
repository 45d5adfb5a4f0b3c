// Numbers that are read and written in whole packs.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace cagetol {

/// Aligned as packs are: where each pack lies across two cache lines a run takes a third longer.
using PackVector = std::vector<double, Eigen::aligned_allocator<double>>;

}  // namespace cagetol
