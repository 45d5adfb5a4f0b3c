#include "src/cage/table/cage_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "src/cage/solve/cage_modes.hpp"
#include "src/cage/stress/field_recovery.hpp"
#include "src/cage/table/cage_check.hpp"
#include "src/cage/table/cage_recovery.hpp"
#include "src/cage/table/cage_table_bytes.hpp"
#include "tests/support/checked_modes.hpp"
#include "tests/support/flexible_cage.hpp"

namespace cagetol {
namespace {

using test::scattered_pockets;
using Deviations = std::vector<PocketDeviation>;

const Material& kSteel = test::kCageSteel;

const CageTable& table() {
  return test::coarse_table();
}

struct FullCage {
  CageMesh mesh;
  BodyMatrices body;
  HeldFactor factor;
  explicit FullCage(const Deviations& deviations)
      : mesh(std::get<CageMesh>(make_cage_mesh(table().cage, deviations, table().counts))),
        body(assemble_body(mesh.mesh, kSteel)),
        factor(body.stiffness, rigid_motions(mesh.mesh.nodes)) {}
};

CageModel model_of(const Deviations& deviations, const CageModelOptions& options = {}) {
  return std::get<CageModel>(make_cage_model(table(), deviations, options));
}

double frequency_error(const Deviations& deviations) {
  return check_cage_model(table(), deviations, model_of(deviations)).largest_error;
}

TEST(CageModel, UndeviatedCageIsExact) {
  EXPECT_LT(frequency_error(Deviations(13)), 1e-8);
}

TEST(CageModel, ScatteredPocketsWithinTwoPermille) {
  for (unsigned seed = 1; seed <= 6; ++seed)
    EXPECT_LT(frequency_error(scattered_pockets(seed)), 0.002) << seed;
}

TEST(CageModel, UniformExtremesWithinHalfAPermille) {
  for (const PocketDeviation& d :
       {PocketDeviation{.width = -0.20e-3}, PocketDeviation{.length = -0.25e-3},
        PocketDeviation{.width = -0.20e-3, .length = -0.25e-3}, PocketDeviation{.width = 0.20e-3},
        PocketDeviation{.width = 0.20e-3, .length = 0.25e-3}}) {
    const GridPoint point = nearest_point({}, Deviations(13, d));
    const CageTable near = make_cage_table({}, kSteel, {}, {.density = 2, .point = point});
    const Deviations deviations = test::deviations_from(near, Deviations(13, d));
    const CageModel model = std::get<CageModel>(make_cage_model(near, deviations));
    const double error = check_cage_model(near, deviations, model).largest_error;
    std::printf("width %+.2f, length %+.2f mm: frequencies within %.3f %%\n", 1e3 * d.width,
                1e3 * d.length, 100 * error);
    EXPECT_LT(error, 0.0005);
  }
}

TEST(CageModel, APointOfTheGridIsExactOnTheElementsOfTheScenesCage) {
  const CageTable far = make_cage_table({}, kSteel, {}, {.density = 3, .point = {4, 0}});
  EXPECT_EQ(far.counts.length, mesh_counts({}, 3).length);
  EXPECT_NE(far.counts.length, mesh_counts(far.cage, 3).length);
  const CageModel model = std::get<CageModel>(make_cage_model(far, Deviations(13)));
  EXPECT_LT(check_cage_model(far, Deviations(13), model).largest_error, 1e-8);
}

TEST(CageModel, MassCentreAndInertiaAreThoseOfTheMesh) {
  const Deviations deviations = scattered_pockets(3);
  const FullCage full(deviations);
  const RigidMotions rigid = rigid_motions(full.mesh.mesh.nodes);
  const MassProperties exact =
      mass_properties(rigid.transpose() * (full.body.mass.selfadjointView<Eigen::Lower>() * rigid));
  const MassProperties got = model_of(deviations).body;
  EXPECT_NEAR(got.mass / exact.mass, 1, 1e-6);
  EXPECT_GT(exact.centre.norm(), 1e-5);
  EXPECT_LT((got.centre - exact.centre).norm(), 1e-3 * exact.centre.norm());
  EXPECT_LT((got.inertia - exact.inertia).norm(), 1e-5 * exact.inertia.norm());
}

/// Lengthening one pocket takes material from its place: the mass centre moves away from the
/// pocket.
TEST(CageModel, MassCentreMovesAwayFromTheLongPocket) {
  Deviations deviations(13);
  deviations[4].length = 0.3e-3;
  const double theta = 2 * std::numbers::pi * 4 / 13;
  const Eigen::Vector3d centre = model_of(deviations).body.centre;
  EXPECT_LT(centre[1] * std::cos(theta) + centre[2] * std::sin(theta), -1e-7);
  EXPECT_NEAR(centre[0], 0, 1e-12);
}

/// Compliance at contact points by the kept modes and the residual, against a full static solve of
/// the deviated cage; and the stress at all stations.
TEST(CageModel, StaticForcesOnABarAgainstFullSolve) {
  const CageStations& stations = table().stations;
  for (unsigned seed : {1U, 2U, 3U}) {
    const Deviations deviations = seed == 3 ? Deviations(13, {.width = -0.2e-3, .length = -0.25e-3})
                                            : scattered_pockets(seed);
    const FullCage full(deviations);
    const CageModel model = model_of(deviations, {.modes = 20});
    const RigidMotions rigid =
        mass_orthonormal(rigid_motions(full.mesh.mesh.nodes), full.body.mass);
    const long pocket = 5;
    const long n = model.bar_stations;
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(2 * n * 13);
    forces[2 * n * pocket + n] = 1;           // leading face, first station
    forces[2 * n * pocket + n + 1] = 2;       // leading face, middle
    forces[2 * n * (pocket + 1) + 2] = -1.5;  // trailing face of the next pocket, last station

    const Eigen::VectorXd load = bar_forces_on_nodes(full.mesh, stations, deviations, forces);
    const Eigen::MatrixXd u = free_static_response(full.body, full.factor, rigid, load);

    Eigen::VectorXd modal_force = Eigen::VectorXd::Zero(model.frequency.size());
    for (long j = 0; j < 13; ++j) {
      for (long i = 0; i < 2 * n; ++i) {
        modal_force +=
            forces[2 * n * j + i] * model.contact.row(model.contact_row(j, i, 1)).transpose();
      }
    }
    const Eigen::ArrayXd omega = 2 * std::numbers::pi * model.frequency.array();
    const Eigen::VectorXd q = (modal_force.array() / omega.square()).matrix();

    const double work = u.col(0).dot(load);
    double reduced = modal_force.dot(q);
    Eigen::VectorXd on_bar(2 * n);
    on_bar << forces.segment(2 * n * pocket + n, n), forces.segment(2 * n * (pocket + 1), n);
    reduced += on_bar.dot(model.residual_compliance.middleCols(2 * n * pocket, 2 * n) * on_bar);
    EXPECT_NEAR(reduced / work, 1, 0.03) << seed;

    const Eigen::VectorXd stress = station_stress(model, q, forces);
    double worst = 0;
    double peak = 0;
    for (long j = 0; j < 13; ++j) {
      std::vector<int> watched;
      for (int p : stress_stations(table().cage, table().stations, full.mesh.grid)) {
        watched.push_back(
            full.mesh.sector_node[static_cast<std::size_t>(j)][static_cast<std::size_t>(p)]);
      }
      const Eigen::MatrixXd exact = nodal_stress(full.mesh.mesh, kSteel, u, watched);
      for (long s = 0; s < model.stress_stations; ++s) {
        const double value = von_mises(exact.col(0).segment<6>(6 * s));
        peak = std::max(peak, value);
        worst = std::max(worst, std::abs(stress[model.stress_stations * j + s] - value));
      }
    }
    EXPECT_NEAR(stress.maxCoeff() / peak, 1, 0.03) << seed;
    EXPECT_LT(worst, 0.07 * peak) << seed;
    // No node of the whole cage is stressed more than the stations.
    std::vector<int> everywhere(static_cast<std::size_t>(full.mesh.mesh.nodes.cols()));
    for (std::size_t i = 0; i < everywhere.size(); ++i) everywhere[i] = static_cast<int>(i);
    const Eigen::MatrixXd field = nodal_stress(full.mesh.mesh, kSteel, u, everywhere);
    double highest = 0;
    Eigen::Vector3d where = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < field.rows() / 6; ++i) {
      const double value = von_mises(field.col(0).segment<6>(6 * i));
      if (value > highest) where = full.mesh.mesh.nodes.col(i);
      highest = std::max(highest, value);
    }
    EXPECT_LT(highest, 1.001 * peak) << seed << " at " << where.transpose();
  }
}

/// What the kept modes do not carry the residual does: the compliance of a bar does not depend on
/// how many modes are kept, none or all, but for what their rows leave out beyond the reach.
TEST(CageModel, ComplianceDoesNotDependOnTheNumberOfModes) {
  const Deviations deviations = scattered_pockets(7);
  const auto compliance = [&](long modes) {
    const CageModel model = model_of(deviations, {.modes = modes, .stress = false});
    const long n = model.bar_stations;
    Eigen::MatrixXd rows(2 * n, model.frequency.size());  // bar 12, between pockets 12 and 0
    for (long i = 0; i < n; ++i) {
      rows.row(i) = model.contact.row(model.contact_row(12, n + i, 1));
      rows.row(n + i) = model.contact.row(model.contact_row(0, i, 1));
    }
    const Eigen::ArrayXd omega = 2 * std::numbers::pi * model.frequency.array();
    return Eigen::MatrixXd(rows * omega.square().inverse().matrix().asDiagonal() *
                               rows.transpose() +
                           model.residual_compliance.middleCols(2 * n * 12, 2 * n));
  };
  const Eigen::MatrixXd usual = compliance(20);
  EXPECT_LT((compliance(0) - usual).norm(), 2e-3 * usual.norm());
  EXPECT_LT((compliance(1000) - usual).norm(), 2e-3 * usual.norm());
}

/// Renaming the pockets turns the cage: same frequencies, contact rows with the pockets renamed.
TEST(CageModel, ResultsDoNotDependOnTheAngleOrigin) {
  const Deviations deviations = scattered_pockets(5);
  Deviations turned(13);
  for (std::size_t j = 0; j < 13; ++j) turned[(j + 4) % 13] = deviations[j];
  const CageModel a = model_of(deviations);
  const CageModel b = model_of(turned);
  for (Eigen::Index i = 0; i < a.frequency.size(); ++i) {
    EXPECT_NEAR(a.frequency[i] / b.frequency[i], 1, 1e-9);
    for (long j = 0; j < 13; ++j) {
      const double x = a.contact(a.contact_row(j, 1, 1), i);
      const double y = b.contact(b.contact_row((j + 4) % 13, 1, 1), i);
      EXPECT_NEAR(std::abs(x), std::abs(y), 1e-5 * a.contact.cwiseAbs().maxCoeff());
    }
  }
}

TEST(CageModel, SpinIntegralsAreSkewAndBounded) {
  const CageModel model = model_of(scattered_pockets(2));
  EXPECT_LT((model.gyroscopic + model.gyroscopic.transpose()).norm(), 1e-10);
  for (Eigen::Index i = 0; i < model.frequency.size(); ++i) {
    EXPECT_GE(model.in_plane(i, i), 0);
    EXPECT_LE(model.in_plane(i, i), 1.03);  // integrals of the undeviated cage
  }
}

TEST(CageModel, FaultsNameThePocket) {
  Deviations deviations(13);
  deviations[7].width = 2e-3;
  auto result = make_cage_model(table(), deviations);
  ASSERT_TRUE(std::holds_alternative<CageFault>(result));
  EXPECT_EQ(std::get<CageFault>(result).kind, CageFaultKind::geometry);
  EXPECT_EQ(std::get<CageFault>(result).pocket, 7);
  deviations[7].width = 0;
  deviations[9].length = 1.01 * table().range.length;
  result = make_cage_model(table(), deviations);
  ASSERT_TRUE(std::holds_alternative<CageFault>(result));
  EXPECT_EQ(std::get<CageFault>(result).kind, CageFaultKind::outside_table);
  EXPECT_EQ(std::get<CageFault>(result).pocket, 9);
  EXPECT_EQ(std::get<CageFault>(result).reason.find("pocket length deviates by 0.47"), 0U)
      << std::get<CageFault>(result).reason;
  EXPECT_NE(std::get<CageFault>(result).reason.find(" mm from 9.25, "), std::string::npos);
  deviations[9].length = std::nan("");
  EXPECT_TRUE(std::holds_alternative<CageFault>(make_cage_model(table(), deviations)));
}

TEST(CageModel, EvenPocketCountsHaveSingleModesOfAlternatingSign) {
  const CageDimensions cage{.pocket_count = 8, .pocket_width = 9e-3};
  const CageTable even = make_cage_table(cage, kSteel, {}, {.density = 1, .basis_modes = 24});
  const CageModel model = std::get<CageModel>(make_cage_model(even, Deviations(8), {.modes = 12}));
  for (Eigen::Index i = 0; i < 12; ++i) {
    EXPECT_NEAR(model.frequency[i] / even.frequency[i], 1, 1e-8);
  }
}

/// Term by term: a product of Eigen's here, compiled without optimisation, would stand in for the
/// program's own when both are linked.
double modal_mass(const SparseMatrix& lower, const Eigen::VectorXd& shape) {
  double mass = 0;
  for (Eigen::Index column = 0; column < lower.cols(); ++column)
    for (SparseMatrix::InnerIterator entry(lower, column); entry; ++entry)
      mass += (entry.row() == entry.col() ? 1 : 2) * entry.value() * shape[entry.row()] *
              shape[entry.col()];
  return mass;
}

/// Frequencies of a free body go with the square root of 1 / density, whatever the density: a
/// search with an absolute tolerance would lose modes of light cages.
TEST(CheckedFreeModes, LightCagesHaveThoseOfHeavyOnes) {
  const auto meshed = make_cage_mesh(table().cage, Deviations(13), mesh_counts(table().cage, 1));
  const HexMesh& mesh = std::get<CageMesh>(meshed).mesh;
  const auto frequencies = [&](double lighter) {
    Material material = kSteel;
    material.density /= lighter;
    const BodyMatrices body = assemble_body(mesh, material);
    const HeldFactor factor(body.stiffness, rigid_motions(mesh.nodes));
    const FreeModes modes = checked_free_modes(mesh, body, factor, 36);
    for (Eigen::Index i = 0; i < modes.shape.cols(); ++i)
      EXPECT_NEAR(modal_mass(body.mass, modes.shape.col(i)), 1, 1e-8) << lighter;
    return modes.frequency;
  };
  const Eigen::VectorXd steel = frequencies(1);
  for (const double lighter : {224.0, 1e6, 1e12}) {
    const Eigen::VectorXd light = frequencies(lighter);
    ASSERT_EQ(light.size(), steel.size()) << lighter;
    EXPECT_LT((light.array() / (std::sqrt(lighter) * steel.array()) - 1).abs().maxCoeff(), 1e-8)
        << lighter;
  }
}

TEST(CageTableBytes, GiveTheSameModel) {
  const CageTableOptions options{.density = 1, .basis_modes = 20};
  const CageTable made = make_cage_table({}, kSteel, {}, options);
  CageTable read;
  ASSERT_TRUE(read_cage_table_bytes(cage_table_bytes(made), read));
  complete_cage_table(read, {}, kSteel, {}, options);
  EXPECT_EQ(made.seconds_table, read.seconds_table);
  const Deviations deviations(13, {.width = 0.05e-3});
  const CageModel a = std::get<CageModel>(make_cage_model(made, deviations));
  const CageModel b = std::get<CageModel>(make_cage_model(read, deviations));
  EXPECT_TRUE(a.frequency == b.frequency);
  EXPECT_TRUE(a.stress_residual == b.stress_residual);
}

TEST(CageTableBytes, OfAnotherLengthAreRefused) {
  const std::string bytes = cage_table_bytes(table());
  CageTable read;
  ASSERT_TRUE(read_cage_table_bytes(bytes, read));
  for (const std::size_t part :
       {std::size_t{0}, std::size_t{7}, bytes.size() / 2, bytes.size() - 1})
    EXPECT_FALSE(read_cage_table_bytes(std::string_view(bytes).substr(0, part), read)) << part;
  EXPECT_FALSE(read_cage_table_bytes(bytes + "x", read));
  EXPECT_FALSE(read_cage_table_bytes(std::string(bytes.size(), '\xff'), read));
}

}  // namespace
}  // namespace cagetol
