#include "src/cage/stress/bar_stress.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "src/cage/mesh/held_strip.hpp"
#include "src/cage/mesh/hex20.hpp"
#include "src/cage/mesh/hex8_incompatible.hpp"
#include "src/cage/mesh/strip_stations.hpp"
#include "src/cage/solve/elastic_body.hpp"
#include "src/cage/solve/sector_carry.hpp"
#include "src/cage/solve/unsolved_cage.hpp"

namespace cagetol {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Rows in one piece of memory, where a loop runs over the nodes of many columns.
using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// All columns on sector k in its own frame.
MatrixXd on_sector(const SectorTurn& turn, const MatrixXd& fields, Index k) {
  MatrixXd out(fields.rows(), fields.cols());
  out.leftCols(turn.modes) = turn_modes(turn, fields, k);
  for (Index o = 0; o < turn.sectors; ++o)
    out.middleCols(turn.local_column(0, o), turn.per_sector) =
        fields.middleCols(turn.local_column(0, o - k + turn.sectors), turn.per_sector);
  return out;
}

}  // namespace

PocketDeviation mirrored(const PocketDeviation& deviation) {
  return {deviation.width, deviation.length, -deviation.pitch, -deviation.squareness};
}

struct BarStress::Parts {
  CageDimensions cage;
  CageStations stations;
  Material material;
  const SectorGrid& grid;
  const BarStrip& strip;
  const SectorFields& basis;
  std::vector<int> mirror;
  StripStations watched;
  Eigen::Matrix3d to_bar;  ///< from the sector's frame to one with the bar's middle plane at z = 0
  Eigen::Matrix3Xd nodes{};              ///< in the bar's frame
  std::vector<SectorReading> reading{};  ///< of the sector grid at each node
  std::vector<Hex20Matrix> stiffness{};
  SparseMatrix mass{};  ///< between nodes, one direction
  MatrixXd bar_load{};  ///< a column for each station of the face
  std::unique_ptr<HeldStrip> held{};
  std::array<MatrixXd, 2>
      drive{};  ///< per face: all columns, displacement beyond the sector mesh's at
                ///< cuts, and whole displacement on the middle plane

  void place(const PocketDeviation& deviation);
  RowMatrix read(const MatrixXd& fields, bool only_cuts = false) const;
  MatrixXd body_force(const MatrixXd& accelerations) const;
  std::vector<bool> hold(bool middle_normal, bool middle_along) const;
  Eigen::Vector3d cut_centre(int side) const;
  MatrixXd section_motions(bool coarse) const;
  void solve_undeviated();
  MatrixXd accelerations_of(const MatrixXd& fields, const Eigen::VectorXd& arm) const {
    MatrixXd a = fields.leftCols(basis.turn.modes) * basis.inertia;
    a += arm * basis.turning.transpose();
    return a;
  }
};

void BarStress::Parts::place(const PocketDeviation& deviation) {
  const Eigen::Matrix3Xd in_sector = strip_nodes(cage, deviation, strip);
  reading.clear();
  for (const SectorPoint& p : strip_places(cage, deviation, strip, in_sector))
    reading.push_back(read_at(grid, p));
  nodes = to_bar * in_sector;
  stiffness.resize(strip.elements.size());
  std::vector<Eigen::Triplet<double>> masses;
  masses.reserve(400 * strip.elements.size());
  for (std::size_t e = 0; e < strip.elements.size(); ++e) {
    const auto& element = strip.elements[e];
    const Hex20Nodes at = strip_element(nodes, element);
    try {
      stiffness[e] = hex20_stiffness(at, material);
    } catch (const std::domain_error&) {
      throw UnsolvedCage("the pockets' corner radius leaves no valid mesh of its bars");
    }
    const auto m = hex20_mass(at, material.density);
    for (std::size_t b = 0; b < 20; ++b)
      for (std::size_t a = 0; a < 20; ++a)
        masses.emplace_back(element[a], element[b],
                            m(static_cast<Index>(a), static_cast<Index>(b)));
  }
  mass.resize(nodes.cols(), nodes.cols());
  mass.setFromTriplets(masses.begin(), masses.end());
  const Eigen::Vector3d tangent =
      to_bar * Eigen::Vector3d(0, -std::sin(deviation.pitch), std::cos(deviation.pitch));
  bar_load.resize(nodes.size(), static_cast<Index>(stations.bar_x.size()));
  for (std::size_t i = 0; i < stations.bar_x.size(); ++i)
    bar_load.col(static_cast<Index>(i)) =
        strip_line_load(cage, stations, deviation, strip, nodes, tangent, i);
}

/// Fields of the sector grid at the nodes, in the bar's frame. `only_cuts`: zero at all others.
RowMatrix BarStress::Parts::read(const MatrixXd& fields, bool only_cuts) const {
  const RowMatrix from = fields;
  RowMatrix at = RowMatrix::Zero(3 * static_cast<Index>(reading.size()), fields.cols());
  for (std::size_t n = 0; n < reading.size(); ++n) {
    if (only_cuts && !strip.on_cut(n)) continue;
    auto rows = at.middleRows<3>(3 * static_cast<Index>(n));
    for (std::size_t a = 0; a < 8; ++a)
      if (const double w = reading[n].weight[static_cast<Index>(a)]; w != 0)
        rows += w * from.middleRows<3>(3 * reading[n].point[a]);
    rows = (to_bar * rows).eval();
  }
  return at;
}

/// From accelerations of the sector grid.
MatrixXd BarStress::Parts::body_force(const MatrixXd& accelerations) const {
  const RowMatrix at = read(accelerations);
  RowMatrix force = RowMatrix::Zero(at.rows(), at.cols());
  for (Index j = 0; j < mass.outerSize(); ++j)
    for (SparseMatrix::InnerIterator it(mass, j); it; ++it)
      force.middleRows<3>(3 * it.row()) += it.value() * at.middleRows<3>(3 * j);
  return force;
}

std::vector<bool> BarStress::Parts::hold(bool middle_normal, bool middle_along) const {
  std::vector<bool> held_unknowns(3 * strip.place.size(), false);
  for (std::size_t n = 0; n < strip.place.size(); ++n)
    for (std::size_t d = 0; d < 3; ++d)
      held_unknowns[3 * n + d] =
          strip.on_cut(n) || (strip.on_middle_plane(n) && (d == 2 ? middle_normal : middle_along));
  return held_unknowns;
}

/// Middle of a cut in the bar's frame of the undeviated strip.
Eigen::Vector3d BarStress::Parts::cut_centre(int side) const {
  const double radius = 0.5 * (cage.inner_radius + cage.outer_radius);
  return to_bar * Eigen::Vector3d(side * 0.25 * (cage.width + cage.pocket_length), radius, 0);
}

/// Rigid motions of both cuts, on the nodes of the strip or (coarse) on the points of the grid:
/// columns 6 (side x > 0) + (translations, rotations times half the section's height).
MatrixXd BarStress::Parts::section_motions(bool coarse) const {
  const auto count = coarse ? grid.points.size() : strip.place.size();
  const double lever = 0.25 * (cage.width - cage.pocket_length);
  MatrixXd motions = MatrixXd::Zero(3 * static_cast<Index>(count), 12);
  for (std::size_t n = 0; n < count; ++n) {
    if (coarse ? grid.points[n].around != 0 : !strip.on_cut(n)) continue;
    const Eigen::Vector3d at =
        coarse ? Eigen::Vector3d(to_bar * sector_position(cage, {}, grid.points[n]))
               : Eigen::Vector3d(nodes.col(static_cast<Index>(n)));
    const int side = at[0] < 0 ? -1 : 1;
    const Eigen::Vector3d d = (at - cut_centre(side)) / lever;
    auto block = motions.block<3, 6>(3 * static_cast<Index>(n), side < 0 ? 0 : 6);
    block.leftCols<3>().setIdentity();
    block.rightCols<3>() << 0, d[2], -d[1], -d[2], 0, d[0], d[1], -d[0], 0;
  }
  return motions;
}

void BarStress::Parts::solve_undeviated() {
  place({});
  const SectorTurn& turn = basis.turn;
  const auto per_face = static_cast<Index>(stations.bar_x.size());

  // Half of the sector mesh, for its resultants at the cuts.
  HexMesh half{sector_nodes(cage, {}, grid), {}};
  for (const auto& element : grid.elements) {
    double around = 0;
    for (int p : element) around += grid.points[static_cast<std::size_t>(p)].around;
    if (around > 0) half.elements.push_back(element);
  }
  const BodyMatrices coarse = assemble_body(half, material);
  Eigen::VectorXd arm = Eigen::VectorXd::Zero(half.nodes.size());
  for (Index n = 0; n < half.nodes.cols(); ++n)
    arm.segment<2>(3 * n + 1) = half.nodes.col(n).tail<2>();
  const MatrixXd coarse_loads = bar_loads(cage, stations, grid, {}).rightCols(per_face);
  const MatrixXd coarse_motions = section_motions(true), motions = section_motions(false);

  std::array<std::unique_ptr<HeldStrip>, 2> part{
      std::make_unique<HeldStrip>(strip, hold(true, false)),
      std::make_unique<HeldStrip>(strip, hold(false, true))};
  for (auto& each : part) each->factorise(stiffness);
  const auto reactions = [&](const MatrixXd& u, const MatrixXd& force) -> MatrixXd {
    MatrixXd resultants = -motions.transpose() * force;
    for (std::size_t e = 0; e < strip.elements.size(); ++e) {
      const auto& element = strip.elements[e];
      if (std::none_of(element.begin(), element.end(),
                       [&](int n) { return strip.on_cut(static_cast<std::size_t>(n)); }))
        continue;
      resultants.noalias() += element_values(element, motions).transpose() *
                              (stiffness[e] * element_values(element, u));
    }
    return resultants;
  };

  for (const int face : {-1, 1}) {
    const MatrixXd beside = on_sector(turn, basis.fields, face);
    const MatrixXd own = face < 0 ? mirror_field(mirror, basis.fields) : basis.fields;
    const MatrixXd next = face < 0 ? beside : mirror_field(mirror, beside);
    MatrixXd whole = MatrixXd::Zero(3 * static_cast<Index>(strip.place.size()), turn.all());
    for (const int symmetry : {1, -1}) {
      const MatrixXd fields = 0.5 * (own + symmetry * next);
      const MatrixXd accelerations = accelerations_of(fields, arm * (0.5 * (1 + symmetry)));
      MatrixXd load = body_force(accelerations);
      MatrixXd coarse_load = MatrixXd::Zero(fields.rows(), fields.cols());
      // On the mirror image of a trailing face the force is reversed.
      const auto add = [&](Index sector, bool leading, double sign) {
        const Index column = turn.local_column(0, sector) + (leading ? per_face : 0);
        load.middleCols(column, per_face) += 0.5 * sign * bar_load;
        coarse_load.middleCols(column, per_face) += 0.5 * sign * coarse_loads;
      };
      add(0, face > 0, face);
      add(face < 0 ? turn.sectors - 1 : 1, face < 0, -face * symmetry);

      MatrixXd wanted = symmetric_product(coarse.stiffness, coarse_motions).transpose() * fields;
      wanted -= symmetric_product(coarse.mass, coarse_motions).transpose() * accelerations;
      wanted -= coarse_motions.transpose() * coarse_load;

      const auto& held_part = part[symmetry > 0 ? 0 : 1];
      const MatrixXd first = held_part->solve(load, read(fields, true));
      const MatrixXd unit = held_part->solve(MatrixXd::Zero(load.rows(), 12), motions);
      const MatrixXd found = reactions(first, load);
      const MatrixXd influence = reactions(unit, MatrixXd::Zero(load.rows(), 12));
      Eigen::CompleteOrthogonalDecomposition<MatrixXd> inverse;
      inverse.setThreshold(1e-7);
      inverse.compute(influence);
      const MatrixXd missing = wanted - found;
      const MatrixXd fit = inverse.solve(missing);
      whole += first + unit * fit;
    }
    // Columns whose loads act on middle planes: displacements of the sector mesh.
    const MatrixXd coarse_field = read(own);
    for (Index o = 0; o < turn.sectors; ++o)
      for (Index c = 2 * per_face; c < turn.per_sector; ++c)
        whole.col(turn.local_column(0, o) + c) = coarse_field.col(turn.local_column(0, o) + c);
    MatrixXd& out = drive[face < 0 ? 0 : 1];
    out = MatrixXd::Zero(whole.rows(), whole.cols());
    for (std::size_t n = 0; n < strip.place.size(); ++n) {
      const Index at = 3 * static_cast<Index>(n);
      if (strip.on_cut(n))
        out.middleRows<3>(at) = whole.middleRows<3>(at) - coarse_field.middleRows<3>(at);
      if (strip.on_middle_plane(n)) out.middleRows<3>(at) = whole.middleRows<3>(at);
    }
  }
  held = std::make_unique<HeldStrip>(strip, hold(true, true));
}

BarStress::BarStress(const CageDimensions& cage, const CageStations& stations,
                     const Material& material, const SectorGrid& grid, const BarStrip& strip,
                     const SectorFields& fields)
    : parts_(new Parts{
          .cage = cage,
          .stations = stations,
          .material = material,
          .grid = grid,
          .strip = strip,
          .basis = fields,
          .mirror = mirror_points(grid),
          .watched = strip_stations(cage, stations, strip),
          .to_bar = Eigen::AngleAxisd(-std::numbers::pi / static_cast<double>(cage.pocket_count),
                                      Eigen::Vector3d::UnitX())
                        .toRotationMatrix()}) {
  parts_->solve_undeviated();
  deviate({});
}

BarStress::~BarStress() = default;

void BarStress::deviate(const PocketDeviation& deviation) {
  parts_->place(deviation);
  parts_->held->factorise(parts_->stiffness);
}

MatrixXd BarStress::stress(int face, const std::vector<Index>& all, const MatrixXd& fields,
                           const MatrixXd& accelerations) const {
  const Parts& p = *parts_;
  const SectorTurn& turn = p.basis.turn;
  const auto per_face = static_cast<Index>(p.stations.bar_x.size());
  const MatrixXd own = face < 0 ? mirror_field(p.mirror, fields) : fields;
  MatrixXd load = p.body_force(face < 0 ? mirror_field(p.mirror, accelerations) : accelerations);
  const Index first = turn.local_column(0, 0) + (face > 0 ? per_face : 0);
  MatrixXd driven = p.read(own, true);
  const MatrixXd& beyond = p.drive[face < 0 ? 0 : 1];
  for (std::size_t n = 0; n < p.strip.place.size(); ++n) {
    auto rows = driven.middleRows<3>(3 * static_cast<Index>(n));
    if (p.strip.on_cut(n) || p.strip.on_middle_plane(n))
      for (std::size_t c = 0; c < all.size(); ++c)
        rows.col(static_cast<Index>(c)) += beyond.block<3, 1>(3 * static_cast<Index>(n), all[c]);
  }
  for (std::size_t c = 0; c < all.size(); ++c)
    if (const Index i = all[c] - first; i >= 0 && i < per_face)
      load.col(static_cast<Index>(c)) += face * p.bar_load.col(i);
  const MatrixXd u = p.held->solve(load, driven);

  const auto stations = static_cast<Index>(p.watched.node.size());
  MatrixXd stress = MatrixXd::Zero(6 * stations, u.cols());
  const Eigen::Matrix<double, 6, 6> d = elasticity(p.material);
  for (Index i = 0; i < stations; ++i) {
    int meeting = 0;
    for (const auto& element : p.strip.elements)
      for (int a = 0; a < 20; ++a)
        if (element[static_cast<std::size_t>(a)] == p.watched.node[static_cast<std::size_t>(i)]) {
          const Hex20Strain strain = hex20_node_strain(strip_element(p.nodes, element), a);
          stress.middleRows<6>(6 * i).noalias() += d * strain * element_values(element, u);
          ++meeting;
        }
    for (Index c = 0; c < u.cols(); ++c) {
      const auto s = (stress.block<6, 1>(6 * i, c) / meeting).eval();
      Eigen::Matrix3d tensor;
      tensor << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
      const Eigen::Matrix3d turned = p.to_bar.transpose() * tensor * p.to_bar;
      const double mirror = face;
      stress.block<6, 1>(6 * i, c) << turned(0, 0), turned(1, 1), turned(2, 2), turned(0, 1),
          mirror * turned(1, 2), mirror * turned(2, 0);
    }
  }
  return stress;
}

}  // namespace cagetol
