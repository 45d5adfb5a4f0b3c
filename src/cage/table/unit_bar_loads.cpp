#include "src/cage/table/unit_bar_loads.hpp"

#include <numbers>

namespace cagetol {

std::vector<UnitBarLoad> unit_bar_loads(const CageTable& table, const CageModel& model,
                                        long pocket) {
  const long n = model.bar_stations;
  const Eigen::ArrayXd stiffness = (2 * std::numbers::pi * model.frequency.array()).square();
  std::vector<UnitBarLoad> loads;
  for (long i = 0; i < n; ++i) {
    UnitBarLoad load;
    load.x = table.stations.bar_x[static_cast<std::size_t>(i)];
    const Eigen::VectorXd row = model.contact.row(model.contact_row(pocket, n + i, 1)).transpose();
    const Eigen::VectorXd q = (row.array() / stiffness).matrix();
    load.kept_compliance = row.dot(q);
    load.other_compliance = model.residual_compliance(i, 2 * n * pocket + i);
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(2 * n * table.cage.pocket_count);
    forces[2 * n * pocket + n + i] = 1;
    const Eigen::VectorXd stress = station_stress(model, q, forces);
    Eigen::Index largest = 0;
    load.stress = stress.maxCoeff(&largest);
    load.place = station_name(
        table.stress_points[static_cast<std::size_t>(largest % model.stress_stations)]);
    loads.push_back(load);
  }
  return loads;
}

}  // namespace cagetol
