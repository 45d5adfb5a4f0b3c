// The cages nearest to a limit, as `cagetol worst` prints them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "analysis/report/csv_tables.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

std::vector<std::vector<std::string>> cells_of(const std::string& csv) {
  std::vector<std::vector<std::string>> lines;
  for (std::istringstream text(csv); std::getline(text, lines.emplace_back().emplace_back());) {
    std::istringstream line(lines.back().front());
    lines.back().clear();
    for (std::string cell; std::getline(line, cell, ',');) lines.back().push_back(cell);
  }
  lines.pop_back();
  return lines;
}

TEST(WorstCsv, HasJamsFirstAndThenTheSmallestMarginsWithEveryPocket) {
  StudyData study = make_synthetic_study({.rows = 60, .replicate_share = 0, .failed_share = 0});
  for (RunStatus& status : study.status) status = RunStatus::ok;
  study.status[7] = RunStatus::jammed;
  const auto lines = cells_of(worst_csv(study, 6, ""));
  ASSERT_EQ(lines.size(), 7u);
  EXPECT_EQ(lines[1][0], std::to_string(study.id[7]));
  EXPECT_EQ(lines[1][2], "jam");
  const Limit& limit = study.plan.limits.front();
  const Column& column = *find_quantity(study, limit.quantity);
  const auto worst = std::max_element(column.values.begin(), column.values.end());
  const auto of_limit = cells_of(worst_csv(study, 60, limit.quantity));
  ASSERT_TRUE(limit.maximum);
  EXPECT_EQ(of_limit[2][0],
            std::to_string(study.id[static_cast<std::size_t>(worst - column.values.begin())]));
  EXPECT_NEAR(std::stod(of_limit[2][3]), (*limit.maximum - *worst) / *limit.maximum, 1e-12);
  for (std::size_t k = 3; k < of_limit.size(); ++k)
    EXPECT_LE(std::stod(of_limit[k - 1][3]), std::stod(of_limit[k][3]));
  std::size_t inputs = 0;
  for (const InputColumns& input : study.inputs) inputs += input.per_pocket ? study.pockets : 1;
  EXPECT_EQ(lines[0].size(), 4 + study.plan.limits.size() + inputs);
}

}  // namespace
}  // namespace cagetol
