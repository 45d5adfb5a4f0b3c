#include "src/quantities/cage_stress.hpp"

#include <algorithm>
#include <cmath>

#include "src/quantities/von_mises.hpp"

namespace cagetol {
namespace {

/// Largest von Mises stress of each column, its rows those of whole sectors.
Eigen::VectorXd norms(const Eigen::MatrixXf& stress, long stations) {
  Eigen::VectorXd norm(stress.cols());
  const Eigen::Index rows = 6 * stations;
  for (Eigen::Index column = 0; column < stress.cols(); ++column) {
    float most = 0;
    for (Eigen::Index first = 0; first < stress.rows(); first += rows)
      most = std::max(most, von_mises_squared(stress.col(column).segment(first, rows)).maxCoeff());
    norm[column] = std::sqrt(static_cast<double>(most));
  }
  return norm;
}

}  // namespace

CageStress::CageStress(const CageModel& model)
    : model_(model),
      stations_(model.stress_stations),
      sectors_(model.stress.rows() / (6 * stations_)),
      per_pocket_(2 * model.bar_stations),
      mode_norm_(norms(model.stress, stations_)) {
  const Eigen::VectorXd near_norm = norms(model.stress_residual, stations_),
                        far_norm = norms(model.far_residual, stations_);
  force_norm_ = near_norm.reshaped(per_pocket_, 2 * model.span + 1)
                    .rowwise()
                    .maxCoeff()
                    .cwiseMax(far_norm.reshaped(per_pocket_, sectors_).rowwise().maxCoeff());
  acting_.reserve(static_cast<std::size_t>(per_pocket_ * sectors_));
  q_.resize(model.stress.cols());
  last_q_.setZero(model.stress.cols() - 1);
  last_force_.setZero(per_pocket_ * sectors_);
}

const Eigen::VectorXf& CageStress::components(const double* q, const Eigen::VectorXd& bar_force,
                                              double spin) {
  const Eigen::Index modes = q_.size() - 1;
  q_.head(modes) = Eigen::Map<const Eigen::VectorXd>(q, modes).cast<float>();
  q_[modes] = static_cast<float>(spin * spin);
  acting_.clear();
  for (long j = 0; j < sectors_; ++j)
    for (long i = 0; i < per_pocket_; ++i)
      if (const double force = bar_force[j * per_pocket_ + i]; force != 0)
        acting_.push_back({j, i, static_cast<float>(force)});
  components_.noalias() = model_.stress * q_;
  const long rows = 6 * stations_;
  for (long k = 0; k < sectors_; ++k) {
    auto here = components_.segment(k * rows, rows);
    for (const ActingForce& force : acting_) {
      const long offset = (force.pocket - k + sectors_) % sectors_;
      const long near = near_place(offset, sectors_, model_.span);
      if (near >= 0)
        here +=
            force.value *
            model_.stress_residual.col(near * per_pocket_ + force.place).segment(k * rows, rows);
      else
        here += force.value * model_.far_residual.col(offset * per_pocket_ + force.place);
    }
  }
  return components_;
}

CageStress::Largest CageStress::largest(const double* q, const Eigen::VectorXd& bar_force,
                                        double spin) {
  components(q, bar_force, spin);
  last_q_ = Eigen::Map<const Eigen::VectorXd>(q, last_q_.size());
  last_force_ = bar_force;
  last_spin_ = spin;
  return last_ = largest_of_components();
}

CageStress::Largest CageStress::largest_of_components() const {
  const long rows = 6 * stations_;
  Largest largest;
  float most = -1;
  for (long k = 0; k < sectors_; ++k) {
    const auto here = components_.segment(k * rows, rows);
    const float here_most = von_mises_squared(here).maxCoeff();
    if (here_most > most) {
      most = here_most;
      largest.sector = k;
    }
  }
  Eigen::Index at = 0;
  von_mises_squared(components_.segment(largest.sector * rows, rows)).maxCoeff(&at);
  largest.station = at;
  largest.stress = std::sqrt(static_cast<double>(most));
  return largest;
}

template <class Modes, class Forces>
double CageStress::bound_of(const Modes& q, const Forces& force, double spin_squared) const {
  const Eigen::Index modes = last_q_.size();
  double sum = mode_norm_[modes] * std::abs(spin_squared);
  for (Eigen::Index k = 0; k < modes; ++k) sum += mode_norm_[k] * std::abs(q[k]);
  for (Eigen::Index f = 0; f < force.size(); ++f)
    if (const double x = force[f]; x != 0) sum += force_norm_[f % per_pocket_] * std::abs(x);
  return sum;
}

double CageStress::bound(const double* q, const Eigen::VectorXd& bar_force, double spin) const {
  return bound_of(q, bar_force, spin * spin);
}

double CageStress::change_bound(const double* q, const Eigen::VectorXd& bar_force,
                                double spin) const {
  return bound_of(Eigen::Map<const Eigen::VectorXd>(q, last_q_.size()) - last_q_,
                  bar_force - last_force_, spin * spin - last_spin_ * last_spin_);
}

}  // namespace cagetol
