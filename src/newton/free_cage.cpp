#include "src/newton/free_cage.hpp"

#include <cmath>

namespace cagetol {

FreeCage::FreeCage(const StateLayout& layout)
    : count_(layout.modes),
      modes_(layout.modes),
      to_spin_(layout.modes),
      from_spin_(layout.modes) {}

bool FreeCage::factor(const Linearisation& l, const Eigen::VectorXd& mass, double beta) {
  const Eigen::MatrixXd& own = l.border_velocity;
  place_ = beta / mass[kCageY];
  const double inertia = mass[kCageAxisY] / beta, gyro = own(kCageAxisZ, kCageAxisY);
  const double per = 1 / (inertia * inertia + gyro * gyro);
  axis_[0] = per * inertia;
  axis_[1] = per * gyro;
  to_axis_[0] = own(kCageAxisY, kCagePhi);
  to_axis_[1] = own(kCageAxisZ, kCagePhi);
  double spin = mass[kCagePhi] / beta;
  bool sound = std::isfinite(per);
  if (count_ > 0) {
    auto among = modes_.matrix();
    for (int k = 0; k < count_; ++k) {
      for (int i = 0; i < count_; i += kLanes)
        store_first(&among(i, k), -load_first(&own(kModes + i, kModes + k), count_ - i),
                    count_ - i);
      among(k, k) += mass[kModes + k] / beta - beta * l.border_position(kModes + k, kModes + k);
    }
    if (!modes_.invert()) sound = false;
    to_spin_ = -own.row(kCagePhi).segment(kModes, count_).transpose();
    from_spin_ = -own.col(kCagePhi).segment(kModes, count_);
    modes_.solve(from_spin_.data(), from_spin_.data());
    spin -= to_spin_.dot(from_spin_);
  }
  spin_ = 1 / spin;
  return sound && std::isfinite(spin_);
}

void FreeCage::solve(Eigen::VectorXd& rhs, Eigen::VectorXd& x) const {
  if (count_ > 0) {
    modes_.solve(rhs.data() + kModes, x.data() + kModes);
    rhs[kCagePhi] -= to_spin_.dot(x.segment(kModes, count_));
  }
  for (const Border slot : {kCageY, kCageZ, kCageX}) x[slot] = place_ * rhs[slot];
  x[kCagePhi] = spin_ * rhs[kCagePhi];
  const double y = rhs[kCageAxisY] + to_axis_[0] * x[kCagePhi],
               z = rhs[kCageAxisZ] + to_axis_[1] * x[kCagePhi];
  x[kCageAxisY] = axis_[0] * y - axis_[1] * z;
  x[kCageAxisZ] = axis_[1] * y + axis_[0] * z;
  if (count_ > 0) x.segment(kModes, count_) -= from_spin_ * x[kCagePhi];
}

}  // namespace cagetol
