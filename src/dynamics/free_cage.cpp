#include "src/dynamics/free_cage.hpp"

namespace cagetol {

FreeCage::FreeCage(const StateLayout& layout)
    : count_(layout.modes),
      rigid_(kCageRigid),
      modes_(layout.modes),
      to_spin_(layout.modes),
      from_spin_(layout.modes) {}

bool FreeCage::factor(const Linearisation& l, const Eigen::VectorXd& mass, double beta) {
  auto rigid = rigid_.matrix();
  rigid = -l.border_velocity.block<kCageRigid, kCageRigid>(kCageY, kCageY);
  rigid.diagonal() += mass.segment<kCageRigid>(kCageY) / beta;
  if (count_ == 0) return rigid_.invert();
  auto among = modes_.matrix();
  for (int k = 0; k < count_; ++k) {
    for (int i = 0; i < count_; i += kLanes)
      store_first(&among(i, k), -load_first(&l.border_velocity(kModes + i, kModes + k), count_ - i),
                  count_ - i);
    among(k, k) += mass[kModes + k] / beta - beta * l.border_position(kModes + k, kModes + k);
  }
  const bool sound = modes_.invert();
  to_spin_ = -l.border_velocity.row(kCagePhi).segment(kModes, count_).transpose();
  from_spin_ = -l.border_velocity.col(kCagePhi).segment(kModes, count_);
  modes_.solve(from_spin_.data(), from_spin_.data());
  constexpr int spin = kCagePhi - kCageY;
  rigid(spin, spin) -= to_spin_.dot(from_spin_);
  return rigid_.invert() && sound;
}

void FreeCage::solve(Eigen::VectorXd& rhs, Eigen::VectorXd& x) const {
  if (count_ > 0) {
    modes_.solve(rhs.data() + kModes, x.data() + kModes);
    rhs[kCagePhi] -= to_spin_.dot(x.segment(kModes, count_));
  }
  rigid_.solve(rhs.data() + kCageY, x.data() + kCageY);
  if (count_ > 0) x.segment(kModes, count_) -= from_spin_ * x[kCagePhi];
}

}  // namespace cagetol
