// The stress that a run reports against the whole stress field, recovered on the full mesh with
// static correction, at instants of that run.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "src/cage/table/cage_recovery.hpp"
#include "src/cage/table/scene_cage.hpp"
#include "src/integration/system.hpp"
#include "src/simulate.hpp"
#include "tests/support/peak_comparison.hpp"

namespace cagetol {
namespace {

/// Peaks both ways at instants of a run with contact; `all`: what every pocket deviates by,
/// `measured`: length of the run, `apart`: time between instants [s].
std::vector<PeakStress> peaks(Scene scene, const PocketDeviation& all = {}, double measured = 50e-3,
                              double apart = 1e-3) {
  scene.cage.model = CageKind::flexible;
  scene.cage.corner_radius = 0;  // as the whole field has it
  scene.window.settle_time = 1e-3;
  scene.window.measure_time = measured;
  scene.watch.static_consistency_max = 1;
  const Scene nominal = scene;
  for (double& width : scene.cage.pocket_width) width += all.width;
  for (double& length : scene.cage.pocket_length) length += all.length;
  const auto table = make_scene_cage_table(nominal, table_point(nominal, scene));
  std::vector<Eigen::VectorXd> q, force;
  std::vector<double> spin;
  SimulateOptions options{.cage_table = table};
  double next = scene.window.settle_time;
  options.on_state = [&](double t, const double* y, const System& system) {
    if (t < next || system.seen.bar_force.isZero()) return;
    next = t + apart;
    const StateLayout& l = system.model.layout;
    q.emplace_back(Eigen::Map<const Eigen::VectorXd>(y + l.border_position(kModes), l.modes));
    force.push_back(system.seen.bar_force);
    spin.push_back(system.seen.centrifugal_spin);
  };
  EXPECT_EQ(simulate(scene, options).status, Status::ok);
  CageStates states{Eigen::MatrixXd(q[0].size(), q.size()),
                    Eigen::MatrixXd(force[0].size(), q.size()),
                    Eigen::Map<const Eigen::VectorXd>(spin.data(), std::ssize(spin))};
  for (std::size_t i = 0; i < q.size(); ++i) {
    states.q.col(static_cast<Eigen::Index>(i)) = q[i];
    states.bar_force.col(static_cast<Eigen::Index>(i)) = force[i];
  }
  return compare_peak_stress(*table, pocket_deviations(scene, table->cage), states);
}

/// Relative errors of the reported peaks, rising.
std::vector<double> errors_of(const std::vector<PeakStress>& peaks) {
  std::vector<double> errors;
  for (const PeakStress& peak : peaks) {
    const double error = peak.stations / peak.full - 1;
    errors.push_back(std::abs(error));
    std::printf("  %.4f MPa by stations, %.4f MPa by the whole field: %+.2f %%\n",
                1e-6 * peak.stations, 1e-6 * peak.full, 100 * error);
  }
  std::sort(errors.begin(), errors.end());
  return errors;
}

std::vector<double> peak_errors(const Scene& scene, const PocketDeviation& all = {},
                                double measured = 50e-3) {
  return errors_of(peaks(scene, all, measured));
}

double part(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size()))];
}

TEST(RunPeakStress, IsThatOfTheWholeField) {
  const auto errors = peak_errors(Scene{});
  ASSERT_GE(errors.size(), 30U);
  EXPECT_LT(part(errors, 0.5), 0.002);
  EXPECT_LT(part(errors, 0.9), 0.01);
  EXPECT_LT(errors.back(), 0.03);
}

/// Which instants a run visits hangs on its last bits; one in a thousand is more than 3 % off
/// (tests/ACCURACY.md). What a run reports of them is better.
TEST(NightlyRunPeakStress, OfScatteredPocketsToo) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1";
  Scene scene;
  scene.cage.pocket_width.resize(13, scene.cage.pocket_width[0]);
  scene.cage.pocket_length.resize(13, scene.cage.pocket_length[0]);
  for (long j = 0; j < scene.bearing.roller_count; ++j) {
    const double place = static_cast<double>(j);
    scene.cage.pocket_width[static_cast<std::size_t>(j)] += 75e-6 * std::sin(1 + 5 * place);
    scene.cage.pocket_length[static_cast<std::size_t>(j)] += 75e-6 * std::sin(2 + 3 * place);
  }
  const auto found = peaks(scene, {}, 100e-3, 0.4e-3);
  const auto errors = errors_of(found);
  ASSERT_GE(errors.size(), 150U);
  EXPECT_LT(part(errors, 0.5), 0.01);
  EXPECT_LT(part(errors, 0.99), 0.03);
  EXPECT_LT(errors.back(), 0.04);
  // The largest of a run is one instant's luck, 0.9 % of scatter; the mean of those of its tenths
  // has a third of that.
  constexpr std::size_t kParts = 10;
  PeakStress square, largest[kParts];
  for (std::size_t i = 0; i < found.size(); ++i) {
    const PeakStress& peak = found[i];
    square.stations += peak.stations * peak.stations;
    square.full += peak.full * peak.full;
    PeakStress& of_part = largest[i * kParts / found.size()];
    of_part.stations = std::max(of_part.stations, peak.stations);
    of_part.full = std::max(of_part.full, peak.full);
  }
  EXPECT_NEAR(std::sqrt(square.stations / square.full), 1, 0.003);
  double mean = 0;
  for (const PeakStress& tenth : largest) {
    mean += tenth.stations / tenth.full / kParts;
    EXPECT_NEAR(tenth.stations / tenth.full, 1, 0.04);
  }
  EXPECT_NEAR(mean, 1, 0.015);
}

/// Of cages of the scene whose pockets are all wider and longer [m].
void expect_within_three_percent(const Scene& scene, double width, double length) {
  const auto errors = peak_errors(scene, {.width = width, .length = length}, 100e-3);
  ASSERT_GE(errors.size(), 50U);
  std::printf(
      "width %+.3f, length %+.3f mm: half within %.1f %%, 90 %% within %.1f %%, all %.1f %%\n",
      1e3 * width, 1e3 * length, 100 * part(errors, 0.5), 100 * part(errors, 0.9),
      100 * errors.back());
  EXPECT_LT(part(errors, 0.5), 0.01);
  EXPECT_LT(errors.back(), 0.03);
}

Scene wide_pockets() {
  Scene scene;
  scene.cage.pocket_width = {7.80e-3};
  scene.cage.pocket_length = {9.40e-3};
  return scene;
}

/// Pockets half way from the scene's table to its neighbours in width and length, up (1) or down.
void expect_half_way_between_tables(const std::vector<std::pair<int, int>>& corners) {
  const Scene scene = wide_pockets();
  const CageDimensions cage = cage_dimensions(scene);
  const CageDimensions next = cage_at(cage, {1, 1});
  const double width = 0.4999 * (next.pocket_width - cage.pocket_width);
  const double length = 0.4999 * (next.pocket_length - cage.pocket_length);
  for (const auto& [w, l] : corners) expect_within_three_percent(scene, w * width, l * length);
}

/// As far as Xin et al. go.
TEST(NightlyRunPeakStress, OfACageThatDeviatesAsAWhole) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1 to run";
  expect_within_three_percent(wide_pockets(), -0.2e-3, 0);
}

TEST(NightlyRunPeakStress, OfCagesThatDeviateAsAWhole) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1";
  expect_within_three_percent(wide_pockets(), 0, -0.25e-3);
  expect_within_three_percent(wide_pockets(), 0, 0.25e-3);
  expect_within_three_percent(wide_pockets(), 0.2e-3, 0);
}

TEST(NightlyRunPeakStress, HalfWayBetweenThePocketsOfFourTables) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1";
  expect_half_way_between_tables({{-1, -1}, {-1, 1}, {1, -1}, {1, 1}});
}

}  // namespace
}  // namespace cagetol
