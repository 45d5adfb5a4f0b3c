// Responses of a grid in report.json and on the page.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "analysis/report/report.hpp"
#include "analysis/response/grid_cells.hpp"
#include "tests/support/synthetic_grid.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(GridCells, SortRunsByLevelAndSetting) {
  const auto cells = grid_cells(make_synthetic_grid(3), "cage.pocket_length_mm");
  ASSERT_TRUE(cells);
  EXPECT_THAT(cells->levels, ElementsAre(-0.25, -0.125, 0, 0.125, 0.25));
  EXPECT_THAT(cells->settings,
              ElementsAre("bearing misalignment z 0 mrad", "bearing misalignment z 2 mrad"));
  EXPECT_THAT(cells->samples(1, 4), ElementsAre(9, 19, 29));
}

TEST(GridCells, AreNothingWithoutAGridOrALevel) {
  StudyData study = make_synthetic_grid(1);
  EXPECT_FALSE(grid_cells(study, "cage.pocket_width_mm"));
  study.design.kind = "random";
  EXPECT_FALSE(grid_cells(study, "cage.pocket_length_mm"));
}

TEST(Response, SaysHowAQuantityGoesOverTheLevels) {
  const auto response = make_report(make_synthetic_grid()).at("response");
  EXPECT_EQ(response.at("confidence"), 0.95);
  ASSERT_EQ(response.at("quantities").size(), 2u);  // stress has no values
  const auto& slip = response.at("quantities").at(0);
  // Falls by 4 per mm where misaligned; aligned runs that start alike are identical.
  EXPECT_THAT(slip.at("course"), ElementsAre("unchanged", "falls"));
  const auto& mean = slip.at("cells").at(1).at(0).at("mean");
  EXPECT_NEAR(mean.at("value").get<double>(), 3, 0.1);
  EXPECT_LT(mean.at("lower").get<double>(), mean.at("value").get<double>());
  EXPECT_NEAR(mean.at("upper").get<double>() - mean.at("lower").get<double>(), 0.11, 0.05);
  EXPECT_EQ(response.at("quantities").at(1).at("quantity"), "orbit");  // noise
  EXPECT_THAT(response.at("quantities").at(1).at("course"), ElementsAre("undecided", "undecided"));
}

TEST(Response, IsNotMonotoneWhereStepsGoBothWays) {
  StudyData study = make_synthetic_grid();
  for (std::size_t i = 0; i < study.size(); ++i)
    study.quantities[0].values[i] += 40 * std::abs(study.inputs[1].lot[i]);
  const auto slip = make_report(study).at("response").at("quantities").at(0);
  EXPECT_THAT(slip.at("course"), ElementsAre("not monotone", "not monotone"));
}

TEST(Response, HoldsTolerancesOverTheRunsOfEachCell) {
  const auto response = make_report(make_synthetic_grid()).at("response");
  EXPECT_EQ(response.at("name"), "pocket length");
  const auto& slip = response.at("quantities").at(0);
  EXPECT_EQ(slip.at("quantity"), "slip");
  const auto& cell = slip.at("cells").at(1).at(4);
  EXPECT_EQ(cell.at("runs"), 15);
  EXPECT_NEAR(cell.at("median").get<double>(), 1, 0.15);
  EXPECT_LT(cell.at("low"), cell.at("median"));
  EXPECT_LT(cell.at("median"), cell.at("high"));
  EXPECT_TRUE(make_report(make_synthetic_study({.rows = 50})).at("response").is_null());
}

class ResponsePage : public testing::Test {
 protected:
  std::string page_of(const StudyData& study) {
    std::filesystem::create_directories(directory_);
    write_synthetic_study(study, directory_ / "study.h5");
    testing::internal::CaptureStdout();
    run_report(directory_);
    testing::internal::GetCapturedStdout();
    std::ifstream stream(directory_ / "report.html");
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }
  std::filesystem::path directory_ = std::filesystem::path(testing::TempDir()) /
                                     ("cagetol-response-page-" + std::to_string(::getpid()));
};

TEST_F(ResponsePage, ShowsMeansAndCourses) {
  const std::string html = page_of(make_synthetic_grid());
  EXPECT_THAT(html, HasSubstr("Response to the pocket length, 5 levels"));
  EXPECT_THAT(html, HasSubstr("With bearing misalignment z 2 mrad"));
  EXPECT_THAT(html, HasSubstr("<td>falls</td>"));
  EXPECT_THAT(html, HasSubstr("alt=\"response_quantities\""));
  EXPECT_THAT(html, Not(HasSubstr("Figures are missing")));
}

}  // namespace
}  // namespace cagetol
