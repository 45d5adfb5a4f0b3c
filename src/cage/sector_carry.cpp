#include "src/cage/sector_carry.hpp"

#include <Eigen/CholmodSupport>
#include <cmath>
#include <numbers>
#include <vector>

namespace cagetol {

Eigen::MatrixXd carry_fields(const SectorGrid& grid, const BodyMatrices& body,
                             const Eigen::MatrixXd& fields, const FieldDrive& drive, int passes) {
  const Eigen::Index size = fields.rows();
  Eigen::VectorXi place = Eigen::VectorXi::Constant(size, -1);
  int inside = 0;
  for (std::size_t p = 0; p < grid.points.size(); ++p) {
    if (on_middle_plane(grid, p)) continue;
    for (int d = 0; d < 3; ++d) place[3 * static_cast<Eigen::Index>(p) + d] = inside++;
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index j = 0; j < size; ++j) {
    if (place[j] < 0) continue;
    for (SparseMatrix::InnerIterator it(body.stiffness, j); it; ++it) {
      if (place[it.row()] >= 0) entries.emplace_back(place[it.row()], place[j], it.value());
    }
  }
  SparseMatrix inner(inside, inside);
  inner.setFromTriplets(entries.begin(), entries.end());
  const Eigen::CholmodSupernodalLLT<SparseMatrix, Eigen::Lower> factor(inner);

  Eigen::MatrixXd carried = fields;
  Eigen::MatrixXd rest(inside, fields.cols());
  for (int pass = 0; pass < passes; ++pass) {
    const Eigen::MatrixXd driven = carried * drive.inertia;
    Eigen::MatrixXd force = drive.loads;
    force += body.mass.selfadjointView<Eigen::Lower>() * driven;
    force -= body.stiffness.selfadjointView<Eigen::Lower>() * carried;
    for (Eigen::Index i = 0; i < size; ++i) {
      if (place[i] >= 0) rest.row(place[i]) = force.row(i);
    }
    const Eigen::MatrixXd step = factor.solve(rest);
    for (Eigen::Index i = 0; i < size; ++i) {
      if (place[i] >= 0) carried.row(i) += step.row(place[i]);
    }
  }
  return carried;
}

Eigen::VectorXd half_bar_load(const CageDimensions& cage, const CageStations& stations,
                              const SectorGrid& grid, const PocketDeviation& deviation, double face,
                              double x) {
  const double middle = face * std::numbers::pi / static_cast<double>(cage.pocket_count);
  const Eigen::Vector3d tangent(0, -std::sin(middle), std::cos(middle));
  const SectorReading place = read_at(grid, bar_station(cage, stations, deviation, face, x));
  Eigen::VectorXd load = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(grid.points.size()));
  for (int a = 0; a < 8; ++a) {
    load.segment<3>(3 * place.point[static_cast<std::size_t>(a)]) += 0.5 * place.weight[a] * tangent;
  }
  return load;
}

}  // namespace cagetol
