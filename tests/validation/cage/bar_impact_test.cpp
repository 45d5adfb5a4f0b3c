// A roller hits a bar: force and duration with the modes of a run against the transient motion of
// all unknowns of the finite elements.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "src/cage/table/cage_recovery.hpp"
#include "tests/support/flexible_cage.hpp"

namespace cagetol {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kStep = 0.05e-6;
constexpr Index kPocket = 4;

/// A mass that meets the leading face of a pocket along its stations, at 0.05 m/s.
struct Roller {
  double mass = 3.3e-3, speed = 0.05, place = 0;
  VectorXd stiffness;  ///< of each station [N/m^(10/9)]
};

Roller roller_for(const CageStations& stations) {
  Roller roller;
  double whole = 0;
  for (double half : stations.bar_half) whole += 2 * half;
  const double line = 77652 * std::pow(1e3 * whole, 8.0 / 9) * std::pow(1e3, 10.0 / 9);
  roller.stiffness.resize(std::ssize(stations.bar_half));
  for (Index i = 0; i < roller.stiffness.size(); ++i)
    roller.stiffness[i] = line * 2 * stations.bar_half[static_cast<std::size_t>(i)] / whole;
  return roller;
}

struct Impact {
  double peak = 0, duration = 0;
};

/// Steps a roller against a body whose stations move by `free` were there no force in this step,
/// and by `answer` more for a unit force on each. `advance` takes the forces.
template <class Free, class Advance>
Impact hit(Roller roller, const MatrixXd& answer, const Free& free, const Advance& advance) {
  Impact impact;
  double acceleration = 0;
  for (int step = 0; step < 4000; ++step) {
    // Newmark's trapezoidal rule on all; the force at the end of the step by Newton's method.
    const double ahead = roller.place + kStep * roller.speed + kStep * kStep / 4 * acceleration;
    const VectorXd gone = free();
    VectorXd force = VectorXd::Zero(roller.stiffness.size());
    MatrixXd compliance = answer;
    compliance.array() += kStep * kStep / (4 * roller.mass);
    for (int round = 0; round < 50; ++round) {
      const VectorXd p = VectorXd::Constant(force.size(), ahead) - gone - compliance * force;
      const VectorXd law = roller.stiffness.array() * p.array().max(0).pow(10.0 / 9);
      const VectorXd slope = 10.0 / 9 * roller.stiffness.array() * p.array().max(0).pow(1.0 / 9);
      MatrixXd system = slope.asDiagonal() * compliance;
      system.diagonal().array() += 1;
      const VectorXd change = system.lu().solve(law - force);
      force += change;
      if (change.norm() < 1e-10) break;
    }
    const double now = -force.sum() / roller.mass;
    roller.place = ahead + kStep * kStep / 4 * now;
    roller.speed += kStep / 2 * (acceleration + now);
    acceleration = now;
    advance(force);
    impact.peak = std::max(impact.peak, force.sum());
    if (force.sum() > 0.02) impact.duration += kStep;
    if (force.sum() == 0 && roller.speed < 0) break;
  }
  return impact;
}

/// With all unknowns of the finite elements.
Impact full_impact(const CageTable& table) {
  const std::vector<PocketDeviation> none(13);
  const CageMesh mesh = std::get<CageMesh>(make_cage_mesh(table.cage, none, table.counts));
  const BodyMatrices body = assemble_body(mesh.mesh, table.material);
  // K + 4/dt^2 M: the trapezoidal rule's matrix, and a shift far above all that matters here.
  const double shift = 4 / (kStep * kStep);
  const SparseMatrix dynamic = body.stiffness + shift * body.mass;
  const HeldFactor factor(dynamic, MatrixXd(dynamic.rows(), 0));
  const auto mass = body.mass.selfadjointView<Eigen::Lower>();
  const Index n = std::ssize(table.stations.bar_x), unknowns = 3 * mesh.mesh.nodes.cols();
  MatrixXd load(unknowns, n);
  for (Index i = 0; i < n; ++i) {
    VectorXd on_station = VectorXd::Zero(13 * 2 * n);
    on_station[2 * n * kPocket + n + i] = 1;
    load.col(i) = bar_forces_on_nodes(mesh, table.stations, none, on_station);
  }
  const MatrixXd response = factor.solve(load);
  VectorXd u = VectorXd::Zero(unknowns), v = u, a = u, ahead = u;
  return hit(
      roller_for(table.stations), load.transpose() * response,
      [&]() -> VectorXd {
        ahead = factor.solve(mass * (shift * u + 4 / kStep * v + a));
        return load.transpose() * ahead;
      },
      [&](const VectorXd& force) {
        const VectorXd next = ahead + response * force;
        const VectorXd acceleration = shift * (next - u - kStep * v) - a;
        v += kStep / 2 * (a + acceleration);
        a = acceleration;
        u = next;
      });
}

/// With rigid body and kept modes.
Impact modal_impact(const CageTable& table, const CageModelOptions& options) {
  const std::vector<PocketDeviation> none(13);
  const CageModel model = std::get<CageModel>(make_cage_model(table, none, options));
  const Index n = model.bar_stations, modes = model.frequency.size();
  MatrixXd rows = MatrixXd::Zero(n, 6 + modes);
  VectorXd mass = VectorXd::Ones(6 + modes), stiffness = VectorXd::Zero(6 + modes);
  mass.head<3>().setConstant(model.body.mass);
  mass.segment<3>(3) = model.body.inertia.diagonal();
  stiffness.tail(modes) = (2 * std::numbers::pi * model.frequency.array()).square();
  const double angle = 2 * std::numbers::pi * kPocket / 13;
  const Eigen::Vector3d along(0, -std::sin(angle), std::cos(angle));
  const double half = table.cage.pocket_width / 2, radius = table.stations.pitch_radius;
  for (Index i = 0; i < n; ++i) {
    const Eigen::Vector3d at = Eigen::Vector3d(table.stations.bar_x[static_cast<std::size_t>(i)],
                                               radius * std::cos(angle), radius * std::sin(angle)) +
                               half * along;
    rows.row(i).head<3>() = along.transpose();
    rows.row(i).segment<3>(3) = at.cross(along).transpose();
    rows.row(i).tail(modes) = model.contact.row(model.contact_row(kPocket, n + i, 1));
  }
  const VectorXd inverse = (stiffness + 4 / (kStep * kStep) * mass).cwiseInverse();
  VectorXd q = VectorXd::Zero(6 + modes), v = q, a = q, ahead = q;
  return hit(
      roller_for(table.stations), rows * inverse.asDiagonal() * rows.transpose(),
      [&]() -> VectorXd {
        ahead =
            inverse.cwiseProduct(mass.cwiseProduct(4 / (kStep * kStep) * q + 4 / kStep * v + a));
        return rows * ahead;
      },
      [&](const VectorXd& force) {
        const VectorXd next = ahead + inverse.cwiseProduct(rows.transpose() * force);
        const VectorXd acceleration = 4 / (kStep * kStep) * (next - q - kStep * v) - a;
        v += kStep / 2 * (a + acceleration);
        a = acceleration;
        q = next;
      });
}

/// What an impact excites reaches above 100 kHz: 90 elastic modes and the bars' have it, and show
/// that both ways to compute it agree. Static modes of the bars alone are too slow to answer by a
/// third, elastic modes alone too stiff by far.
TEST(BarImpact, HasForceAndDurationOfAllUnknowns) {
  const CageTable table =
      make_cage_table({}, test::kCageSteel, {}, {.density = 2, .basis_modes = 100});
  const Impact full = full_impact(table);
  std::printf("all unknowns: peak %.2f N, %.2f us\n", full.peak, 1e6 * full.duration);
  const auto ratio = [&](long modes, bool bars) {
    const Impact impact = modal_impact(table, {.modes = modes, .bar_modes = bars, .stress = false});
    const Impact to_full{impact.peak / full.peak, impact.duration / full.duration};
    std::printf("%ld elastic modes%s: peak %.2f N (%+.1f %%), %.2f us (%+.1f %%)\n", modes,
                bars ? " and the bars'" : "", impact.peak, 100 * (to_full.peak - 1),
                1e6 * impact.duration, 100 * (to_full.duration - 1));
    return to_full;
  };
  EXPECT_NEAR(ratio(90, true).peak, 1, 0.05);
  EXPECT_NEAR(ratio(90, true).duration, 1, 0.05);
  const Impact usual = ratio(CageModelOptions{}.modes, true);
  EXPECT_LT(usual.peak, 1.45);
  EXPECT_NEAR(usual.duration, 1, 0.1);
  const Impact stiff = ratio(20, false);
  EXPECT_GT(stiff.peak, 2);
  EXPECT_LT(stiff.duration, 0.6);
}

}  // namespace
}  // namespace cagetol
