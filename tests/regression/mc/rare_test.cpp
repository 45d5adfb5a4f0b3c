// `cagetol rare` on a study whose share of bad cages is known from its own response.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "analysis/statistics/pareto_bound.hpp"
#include "analysis/study/study_data.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;

/// Equilibria of the study of the shaft's displacement, the tolerance of a pocket beside it.
std::vector<std::string> displacement(const std::string& command,
                                      const std::vector<std::string>& settings) {
  std::vector<std::string> words = {CAGETOL_BINARY_DIR "/cagetol", command,
                                    shipped("studies/nu205-displacement.toml")};
  for (const char* setting :
       {"scene.model.motion=quasi-static", "cage.pocket_width_mm.lot={law='normal', sigma=0.009}",
        "tolerance.dimension=[{key='cage.pocket_width_mm', tolerance_width_mm=0.1, "
        "candidates=[0.1]}]"})
    words.insert(words.end(), {"--set", setting});
  for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
  return words;
}

std::string ended_well(std::vector<std::string> words, const std::string& directory) {
  if (!directory.empty())
    for (const std::string& word : {std::string("-o"), directory, std::string("--progress=off")})
      words.push_back(word);
  Process process(words);
  EXPECT_EQ(process.wait(), 0) << process.output();
  return process.output();
}

/// Constant, four standard normal numbers, their products.
Eigen::VectorXd terms(const Eigen::Vector4d& x) {
  std::vector<double> values = {1, x[0], x[1], x[2], x[3]};
  for (int i = 0; i < 4; ++i)
    for (int k = i; k < 4; ++k) values.push_back(x[i] * x[k]);
  return Eigen::Map<Eigen::VectorXd>(values.data(), static_cast<long>(values.size()));
}

/// Displacement that 63 in a million exceed: by 2e6 draws of a parabola in clearance, load, lot and
/// mean of the rollers' diameters.
double level_of_63_ppm(const StudyData& runs) {
  const InputColumns &clearance = *find_input(runs, "bearing.internal_clearance_um"),
                     &load = *find_input(runs, "load.radial_N"),
                     &roller = *find_input(runs, "roller.diameter_mm");
  const auto& y = find_quantity(runs, "ring_displacement_mean_um")->values;
  const auto n = static_cast<long>(runs.size()), z = static_cast<long>(runs.pockets);
  Eigen::MatrixXd x(n, 15);
  for (long i = 0; i < n; ++i) {
    const auto s = static_cast<std::size_t>(i);
    const double mean =
        Eigen::Map<const Eigen::VectorXd>(&roller.pocket[s * runs.pockets], z).mean();
    x.row(i) = terms({clearance.lot[s] / 2.5, load.lot[s] / 100, roller.lot[s] / 0.0005,
                      mean / 0.0003 * std::sqrt(z)});
  }
  const Eigen::Map<const Eigen::VectorXd> target(y.data(), n);
  const Eigen::VectorXd response = x.colPivHouseholderQr().solve(target);
  const double rest =
      std::sqrt((target - x * response).squaredNorm() / static_cast<double>(n - 15));
  EXPECT_LT(rest, 0.01);
  std::mt19937_64 random(1);
  std::normal_distribution<> normal;
  std::vector<double> drawn(2000000);
  for (double& value : drawn) {
    const double a = normal(random), b = normal(random), c = normal(random), d = normal(random);
    value = terms({a, b, c, d}).dot(response) + rest * normal(random);
  }
  std::nth_element(drawn.begin(), drawn.begin() + 126, drawn.end(), std::greater<>());
  return drawn[126];
}

TEST(RareCommand, NightlyAgreesWithTwoMillionDrawsOfTheStudysOwnResponse) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1 to run";
  const ScratchDirectory scratch;
  ended_well(displacement("sweep", {"samples=1000"}), scratch / "sweep");
  const double level = level_of_63_ppm(read_study_data(scratch / "sweep/study.h5"));
  EXPECT_NEAR(level, 26.27, 0.05);
  const std::string limit =
      "limit=[{quantity='ring_displacement_mean_um', max=" + std::to_string(level) +
      ", source='test'}]";
  // 15,000 runs count down to 200 ppm.
  ended_well(displacement("rare", {limit, "rare.target_ppm=200", "rare.budget_samples=15100"}),
             scratch / "rare");
  std::ifstream file(scratch / "rare/rare/rare.json");
  const auto row = nlohmann::json::parse(file).at("rows").at(1);
  EXPECT_THAT(row.at("how").get<std::string>(), HasSubstr("runs miss it (Clopper-Pearson)"));
  EXPECT_LE(row.at("lower").get<double>(), 63e-6);
  EXPECT_GE(row.at("upper").get<double>(), 63e-6);
  const StudyData tail = read_study_data(scratch / "rare/rare/tail/study.h5");
  auto values = find_quantity(tail, "ring_displacement_mean_um")->values;
  const double all = extrapolated_bound(values, level, 0.95);
  EXPECT_GE(all, 63e-6);
  EXPECT_LE(all, 300e-6);
  values.resize(1000);
  EXPECT_GE(extrapolated_bound(values, level, 0.95), 63e-6);
}

TEST(RareCommand, CheckSaysWhatABudgetCanShow) {
  EXPECT_THAT(ended_well(displacement("check", {}), ""),
              HasSubstr("1000 fresh runs can show at most 2991 ppm by counting"));
  EXPECT_THAT(ended_well(displacement("check", {"rare.budget_samples=47650"}), ""),
              HasSubstr("47550 fresh runs can show at most 63 ppm by counting"));
}

}  // namespace
}  // namespace cagetol
