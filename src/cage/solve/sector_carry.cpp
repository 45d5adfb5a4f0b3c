#include "src/cage/solve/sector_carry.hpp"

#include <Eigen/CholmodSupport>
#include <cmath>
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
    force += symmetric_product(body.mass, driven);
    force -= symmetric_product(body.stiffness, carried);
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

Eigen::MatrixXd bar_loads(const CageDimensions& cage, const CageStations& stations,
                          const SectorGrid& grid, const PocketDeviation& deviation) {
  const auto n = static_cast<Eigen::Index>(stations.bar_x.size());
  const Eigen::Vector3d tangent(0, -std::sin(deviation.pitch), std::cos(deviation.pitch));
  Eigen::MatrixXd loads =
      Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(grid.points.size()), 2 * n);
  for (Eigen::Index i = 0; i < 2 * n; ++i) {
    for (const SectorReading& place :
         read_bar(cage, stations, grid, i < n ? -1 : 1, static_cast<std::size_t>(i % n)))
      for (int a = 0; a < 8; ++a)
        loads.block<3, 1>(3 * place.point[static_cast<std::size_t>(a)], i) +=
            place.weight[a] * tangent;
  }
  return loads;
}

}  // namespace cagetol
