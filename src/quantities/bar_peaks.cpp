#include "src/quantities/bar_peaks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace cagetol {

bool BarPeaks::pass(const double* modes, const Eigen::VectorXd& bar_force, double spin) {
  const Eigen::Index faces = bar_force.size() / stations_;
  force_.resize(static_cast<std::size_t>(faces));
  largest_.resize(force_.size());
  bool peaked = false, rises = false;
  for (std::size_t face = 0; face < force_.size(); ++face) {
    const double force =
        std::abs(bar_force.segment(static_cast<Eigen::Index>(face) * stations_, stations_).sum());
    peaked = peaked || (rose_ && force < force_[face] && force_[face] == largest_[face]);
    if (force > 0 && force >= largest_[face]) {
      largest_[face] = force;
      rises = true;
    }
    force_[face] = force;
  }
  if (peaked) std::swap(peak_, before_);
  if (rises) {
    before_.modes = Eigen::Map<const Eigen::VectorXd>(modes, before_.modes.size());
    before_.bar_force = bar_force;
    before_.spin = spin;
  }
  rose_ = rises;
  return peaked;
}

void BarPeaks::begin_revolution() {
  std::fill(largest_.begin(), largest_.end(), 0.0);
}

}  // namespace cagetol
