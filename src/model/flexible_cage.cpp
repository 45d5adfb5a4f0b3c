#include "src/model/flexible_cage.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "src/scene/materials.hpp"

namespace cagetol {
namespace {

using Coordinates = Eigen::Map<const Eigen::VectorXd>;

}  // namespace

FlexibleCage make_flexible_cage(const std::shared_ptr<const CageModel>& model,
                                const CageGeometry& geometry, int groups) {
  FlexibleCage f;
  f.model = model;
  f.modes = static_cast<int>(model->frequency.size());
  if (f.modes > kMostModes) throw std::domain_error("flexible cage: too many modes");
  f.stations = static_cast<int>(model->bar_stations);
  f.points = 2 * f.stations + 4;
  f.centrifugal = geometry.centrifugal;
  f.coriolis = geometry.coriolis;
  f.gyroscopic = PackMatrix(model->gyroscopic);
  f.centrifugal_force = PackMatrix(model->centrifugal);
  const long pockets = model->contact.rows() / (3 * model->points);
  f.corners = static_cast<int>(2 * pockets);
  f.rows.assign(static_cast<std::size_t>(groups * f.points * 3 * f.modes), Pack{});
  f.land_rows.resize(static_cast<std::size_t>(2 * f.corners * 3 * f.modes));
  f.scale.assign(static_cast<std::size_t>(f.modes), 0.0);
  for (int k = 0; k < f.modes; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const double omega = 2 * std::numbers::pi * model->frequency[k];
    f.stiffness.push_back(omega * omega);
    f.damping.push_back(2 * mode_damping(geometry) * omega);
    f.scale[at] = model->contact.col(k).cwiseAbs().maxCoeff();
    for (long j = 0; j < pockets; ++j)
      for (int direction = 0; direction < 3; ++direction) {
        for (int point = 0; point < f.points; ++point)
          const_cast<Pack*>(f.row(static_cast<int>(j) / kLanes, point, direction))[k][j % kLanes] =
              model->contact(model->contact_row(j, point, direction), k);
        for (int land = 0; land < 2; ++land)
          for (int bar = 0; bar < 2; ++bar)
            const_cast<double*>(f.land_row(land, static_cast<int>(2 * j) + bar, direction))[k] =
                model->contact(model->contact_row(j, f.points + 2 * bar + land, direction), k);
      }
  }
  return f;
}

double farthest_displacement(const FlexibleCage& cage, const double* q) {
  if (cage.modes == 0) return 0;
  const double moved = with_packs(packs_for(cage.modes), [&]<int packs>() {
    Pack scale[packs], at[packs], total{};
    load_padded(cage.scale.data(), cage.modes, scale);
    load_padded(q, cage.modes, at);
    for (int p = 0; p < packs; ++p) total += scale[p] * abs(at[p]);
    return sum(total);
  });
  return (1 + 1e-12) * moved;  // rounding must not make it less
}

namespace {

template <int packs>
void couple_spin_in(const FlexibleCage& cage, double polar, double spin, const double* q,
                    const double* rate, double* acceleration, double& spin_acceleration) {
  const auto product = [](const Pack(&x)[packs], const Pack(&y)[packs]) {
    Pack total{};
    for (int p = 0; p < packs; ++p) total += x[p] * y[p];
    return sum(total);
  };
  Pack a[packs];
  load_padded(acceleration, cage.modes, a);
  double inertia = polar, torque = polar * spin_acceleration;
  if (cage.centrifugal) {
    Pack at[packs], velocity[packs], c[packs];
    load_padded(q, cage.modes, at);
    load_padded(rate, cage.modes, velocity);
    std::copy(cage.centrifugal_force.column(0), cage.centrifugal_force.column(1), c);
    for (int p = 0; p < packs; ++p) a[p] += spin * spin * c[p];
    inertia += 2 * product(c, at);
    torque -= 2 * spin * product(c, velocity);
  }
  if (cage.coriolis) {
    Pack Gq[packs] = {}, Gv[packs] = {};
    for (int k = 0; k < cage.modes; ++k) {
      const Pack* column = cage.gyroscopic.column(k);
      for (int p = 0; p < packs; ++p) {
        Gq[p] += q[k] * column[p];
        Gv[p] += rate[k] * column[p];
      }
    }
    for (int p = 0; p < packs; ++p) a[p] -= 2 * spin * Gv[p];
    spin_acceleration = (torque - product(Gq, a)) / (inertia - product(Gq, Gq));
    for (int p = 0; p < packs; ++p) a[p] -= spin_acceleration * Gq[p];
  } else {
    spin_acceleration = torque / inertia;
  }
  for (int p = 0; p < packs; ++p)
    store_first(acceleration + p * kLanes, a[p], cage.modes - p * kLanes);
}

}  // namespace

void couple_spin(const FlexibleCage& cage, double polar, double spin, const double* q,
                 const double* rate, double* acceleration, double& spin_acceleration) {
  with_packs(cage.gyroscopic.packs(), [&]<int packs>() {
    couple_spin_in<packs>(cage, polar, spin, q, rate, acceleration, spin_acceleration);
  });
}

double modal_energy(const FlexibleCage& cage, double spin, const double* q, const double* rate) {
  const Coordinates at(q, cage.modes), velocity(rate, cage.modes);
  double energy = velocity.squaredNorm() / 2;
  for (int k = 0; k < cage.modes; ++k)
    energy += cage.stiffness[static_cast<std::size_t>(k)] * q[k] * q[k] / 2;
  if (cage.centrifugal) energy += spin * spin * cage.model->centrifugal.dot(at);
  if (cage.coriolis) energy += spin * velocity.dot(cage.model->gyroscopic * at);
  return energy;
}

}  // namespace cagetol
