#include "src/model/observation.hpp"

#include <algorithm>

namespace cagetol {

Observation::Observation(const BearingModel& model)
    : bar_force(Eigen::VectorXd::Zero(2 * model.flexible.stations * model.layout.rollers)) {
  for (auto* v : {&inner_force, &outer_force, &inner_sliding, &inner_rubbing, &leading_force,
                  &trailing_force, &wall_force, &flange_force})
    v->assign(static_cast<std::size_t>(model.layout.padded()), 0.0);
}

void Observation::clear() {
  for (auto* v : {&inner_force, &outer_force, &inner_sliding, &inner_rubbing, &leading_force,
                  &trailing_force, &wall_force, &flange_force})
    std::fill(v->begin(), v->end(), 0.0);
  bar_force.setZero();
  land_force[0] = land_force[1] = 0;
  land_touching[0] = land_touching[1] = false;
  ring_elastic_y = ring_elastic_z = 0;
  drive_power = load_power = friction_power = damping_power = net_power_rate = elastic_energy = 0;
  lost.fill(0);
  inner_slice = outer_slice = 0;
  thinnest_film = kNoFilm;
}

}  // namespace cagetol
