#include "src/cage/solve/cyclic_cage.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/cage/solve/sector_carry.hpp"
#include "src/cage/solve/unsolved_cage.hpp"

namespace cagetol {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// A mode of one harmonic.
struct Found {
  double frequency = 0;
  std::size_t harmonic = 0;
  Index number = 0;
};

SparseMatrix lower_of(const SparseMatrix& spread, const SparseMatrix& lower) {
  const SparseMatrix full = lower.selfadjointView<Eigen::Lower>();
  const SparseMatrix product = full * spread;
  const SparseMatrix reduced = spread.transpose() * product;
  return reduced.triangularView<Eigen::Lower>();
}

/// Mass of all sectors; turning a sector does not change it.
SparseMatrix whole_mass(const CageMesh& mesh, const SparseMatrix& sector) {
  Triplets entries;
  entries.reserve(mesh.sector_node.size() * static_cast<std::size_t>(sector.nonZeros()));
  for (const auto& node : mesh.sector_node)
    for (Index j = 0; j < sector.outerSize(); ++j)
      for (SparseMatrix::InnerIterator it(sector, j); it; ++it) {
        const auto of = [&](Index i) {
          return 3 * node[static_cast<std::size_t>(i / 3)] + static_cast<int>(i % 3);
        };
        const int a = of(it.row()), b = of(j);
        entries.emplace_back(std::max(a, b), std::min(a, b), it.value());
      }
  const Index size = 3 * mesh.mesh.nodes.cols();
  SparseMatrix mass(size, size);
  mass.setFromTriplets(entries.begin(), entries.end());
  return mass;
}

bool behind(const SectorGrid& grid, std::size_t p) {
  return grid.column[p] == grid.columns;
}

}  // namespace

CyclicCage::CyclicCage(const CageMesh& mesh, const Material& material)
    : mesh_(mesh), mirror_(mirror_points(mesh.grid)) {
  const HexMesh sector{sector_nodes(mesh.cage, {}, mesh.grid), mesh.grid.elements};
  const BodyMatrices body = assemble_body(sector, material);
  mass_ = whole_mass(mesh, body.mass);
  for (long n = 0; n <= mesh.cage.pocket_count / 2; ++n)
    harmonics_.push_back(make_harmonic(n, body));
}

CyclicCage::Harmonic CyclicCage::make_harmonic(long n, const BodyMatrices& sector) const {
  const SectorGrid& grid = mesh_.grid;
  const double step = 2 * std::numbers::pi / static_cast<double>(mesh_.cage.pocket_count);
  Harmonic h;
  h.angle = static_cast<double>(n) * step;
  h.multiplicity = n == 0 || 2 * n == mesh_.cage.pocket_count ? 1 : 2;

  std::vector<int> unknown(grid.points.size(), -1);
  int count = 0;
  for (std::size_t p = 0; p < unknown.size(); ++p)
    if (!on_middle_plane(grid, p)) unknown[p] = count++;
  const int inside = count;
  for (std::size_t p = 0; p < unknown.size(); ++p)
    if (behind(grid, p)) unknown[p] = unknown[static_cast<std::size_t>(mirror_[p])] = count++;
  const double plus = std::cos(0.5 * h.angle) + std::sin(0.5 * h.angle);
  const double minus = std::cos(0.5 * h.angle) - std::sin(0.5 * h.angle);
  Triplets entries;
  for (std::size_t p = 0; p < unknown.size(); ++p) {
    const auto row = 3 * static_cast<int>(p), column = 3 * unknown[p];
    if (!on_middle_plane(grid, p)) {
      for (int d = 0; d < 3; ++d) entries.emplace_back(row + d, column + d, 1);
      continue;
    }
    const double side = behind(grid, p) ? 1 : -1;
    const double along = side > 0 ? plus : minus, normal = side > 0 ? minus : plus;
    const double c = std::cos(0.5 * step), s = side * std::sin(0.5 * step);
    entries.emplace_back(row, column, along);
    entries.emplace_back(row + 1, column + 1, c * along);
    entries.emplace_back(row + 1, column + 2, -s * normal);
    entries.emplace_back(row + 2, column + 1, s * along);
    entries.emplace_back(row + 2, column + 2, c * normal);
  }
  h.spread.resize(3 * static_cast<Index>(grid.points.size()), 3 * count);
  h.spread.setFromTriplets(entries.begin(), entries.end());
  h.body = {lower_of(h.spread, sector.stiffness), lower_of(h.spread, sector.mass)};

  // Rigid motions as w: along and about the axis in harmonic 0; in harmonic 1 those along and about
  // the complex axis (0, 1, i).
  MatrixXd w = MatrixXd::Zero(h.spread.rows(), n < 2 ? 2 : 0);
  for (std::size_t p = 0; p < grid.points.size() && n < 2; ++p) {
    const Eigen::Vector3d x = sector_position(mesh_.cage, {}, grid.points[p]);
    auto block = w.middleRows<3>(3 * static_cast<Index>(p));
    if (n == 0) {
      block << 1, 0, 0, -x[2], 0, x[1];
    } else {
      block << 0, x[1] + x[2], 1, -x[0], 1, -x[0];
    }
  }
  // Columns of `spread` that belong to a middle plane have the square length 2.
  h.rigid = h.spread.transpose() * w;
  h.rigid.bottomRows(3 * (count - inside)) *= 0.5;
  if (n < 2) h.rigid = mass_orthonormal(h.rigid, h.body.mass);
  h.factor = std::make_unique<HeldFactor>(h.body.stiffness, h.rigid);
  return h;
}

CyclicCage::Complex CyclicCage::complex_field(const MatrixXd& w) const {
  const MatrixXd image = mirror_field(mirror_, w);
  return {0.5 * (w + image), 0.5 * (w - image)};
}

void CyclicCage::add_to_cage(const Harmonic& h, const Complex& z, Eigen::Ref<MatrixXd> u) const {
  for (std::size_t j = 0; j < mesh_.sector_node.size(); ++j) {
    const double turned = h.angle * static_cast<double>(j);
    const Eigen::Matrix3d rotation = sector_rotation(mesh_.cage, static_cast<long>(j));
    const Eigen::Matrix3d cosine = std::cos(turned) * rotation, sine = std::sin(turned) * rotation;
    for (std::size_t p = 0; p < mirror_.size(); ++p) {
      if (behind(mesh_.grid, p)) continue;
      const Index from = 3 * static_cast<Index>(p);
      auto to = u.middleRows<3>(3 * mesh_.sector_node[j][p]);
      to.noalias() += cosine * z.real.middleRows<3>(from);
      to.noalias() -= sine * z.imaginary.middleRows<3>(from);
    }
  }
}

FreeModes CyclicCage::modes(long count) const {
  // Two modes more than asked for, so that a gap to count below and a split pair can be seen.
  const auto wanted = static_cast<std::size_t>(count + 2);
  const long sectors = mesh_.cage.pocket_count;
  std::vector<long> sought(harmonics_.size(), static_cast<long>(wanted) / sectors + 4);
  std::vector<FreeModes> own(harmonics_.size());
  for (int attempt = 0; attempt < 8; ++attempt) {
    std::vector<Found> found;
    for (std::size_t i = 0; i < own.size(); ++i) {
      const Harmonic& h = harmonics_[i];
      if (own[i].frequency.size() < sought[i])
        own[i] = lowest_modes(h.body, *h.factor, h.rigid, sought[i], 2 * sought[i] + 20);
      for (Index m = 0; m < sought[i]; ++m) found.push_back({own[i].frequency[m], i, m});
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Found& a, const Found& b) { return a.frequency < b.frequency; });
    std::vector<double> all;
    for (const Found& f : found)
      all.insert(all.end(), harmonics_[f.harmonic].multiplicity, f.frequency);
    const auto frequency =
        Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Index>(wanted));
    const Index kept = whole_pairs(frequency, count);
    const double between = 0.5 * (frequency[kept - 1] + frequency[kept]);
    bool complete = true;
    for (std::size_t i = 0; i < own.size(); ++i) {
      const Harmonic& h = harmonics_[i];
      const long below = (own[i].frequency.array() < between).count();
      if (own[i].frequency[sought[i] - 1] > frequency[static_cast<Index>(wanted) - 1] &&
          modes_below(h.body, between) == below + h.rigid.cols())
        continue;
      sought[i] += 4;
      complete = false;
    }
    if (!complete) continue;

    FreeModes modes;
    modes.rigid = mass_orthonormal(rigid_motions(mesh_.mesh.nodes), mass_);
    modes.frequency = frequency.head(kept);
    modes.shape = MatrixXd::Zero(mass_.rows(), kept);
    Index next = 0;
    for (std::size_t i = 0; next < kept; ++i) {
      const Harmonic& h = harmonics_[found[i].harmonic];
      const double scale =
          std::sqrt(static_cast<double>(h.multiplicity) / static_cast<double>(sectors));
      const MatrixXd w =
          scale * (h.spread * own[found[i].harmonic].shape.col(found[i].number)).eval();
      if (h.multiplicity == 1) {
        add_to_cage(h, {w, MatrixXd::Zero(w.rows(), 1)}, modes.shape.col(next++));
      } else {
        const Complex z = complex_field(w);
        add_to_cage(h, z, modes.shape.col(next++));
        add_to_cage(h, {z.imaginary, -z.real}, modes.shape.col(next++));
      }
    }
    return modes;
  }
  throw UnsolvedCage("the search for its modes leaves some out");
}

CyclicCage::Complex CyclicCage::in_harmonic(const Harmonic& h, const MatrixXd& loads) const {
  const Index size = 3 * static_cast<Index>(mirror_.size());
  Complex g{MatrixXd::Zero(size, loads.cols()), MatrixXd::Zero(size, loads.cols())};
  const double share = 1 / static_cast<double>(mesh_.cage.pocket_count);
  for (std::size_t j = 0; j < mesh_.sector_node.size(); ++j) {
    const double turned = h.angle * static_cast<double>(j);
    const Eigen::Matrix3d back =
        share * sector_rotation(mesh_.cage, static_cast<long>(j)).transpose();
    const Eigen::Matrix3d cosine = std::cos(turned) * back, sine = std::sin(turned) * back;
    for (std::size_t p = 0; p < mirror_.size(); ++p) {
      const auto force = loads.middleRows<3>(3 * mesh_.sector_node[j][p]);
      if (behind(mesh_.grid, p) || force.isZero(0)) continue;
      g.real.middleRows<3>(3 * static_cast<Index>(p)).noalias() += cosine * force;
      g.imaginary.middleRows<3>(3 * static_cast<Index>(p)).noalias() -= sine * force;
    }
  }
  return g;
}

MatrixXd CyclicCage::static_response(const MatrixXd& loads) const {
  MatrixXd response = MatrixXd::Zero(loads.rows(), loads.cols());
  const Index count = loads.cols();
  for (const Harmonic& h : harmonics_) {
    // g = g_1 + i g_2, each with P conj(g) = g.
    const Complex g = in_harmonic(h, loads);
    const MatrixXd real = mirror_field(mirror_, g.real);
    const MatrixXd imaginary = mirror_field(mirror_, g.imaginary);
    MatrixXd w(g.real.rows(), 2 * count);
    w.leftCols(count) = 0.5 * (g.real + real + g.imaginary - imaginary);
    w.rightCols(count) = 0.5 * (g.imaginary + imaginary - g.real + real);
    const MatrixXd u =
        h.spread * free_static_response(h.body, *h.factor, h.rigid, h.spread.transpose() * w);
    const Complex first = complex_field(u.leftCols(count));
    const Complex second = complex_field(u.rightCols(count));
    const auto twice = static_cast<double>(h.multiplicity);
    add_to_cage(h,
                {twice * (first.real - second.imaginary), twice * (first.imaginary + second.real)},
                response);
  }
  return response;
}

}  // namespace cagetol
