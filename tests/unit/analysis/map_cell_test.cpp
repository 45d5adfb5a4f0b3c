#include "analysis/tolerance/map_cell.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

using testing::ElementsAre;

using Width = std::optional<double>;

/// One dimension; limits with the widths at which they are reached.
Screen screen_of(LimitReach together, std::vector<std::pair<std::string, LimitReach>> limits) {
  Screen screen;
  screen.together = {std::move(together)};
  for (auto& [name, reach] : limits) {
    screen.limits.emplace_back().quantity = name;
    screen.limits.back().reach = {std::move(reach)};
  }
  return screen;
}

LimitReach reach(Width width, Width lower, Width upper, Width jam = {}) {
  return {"width", width, lower, upper, jam, 1};
}

std::vector<std::string> names(const CellAnswer& answer, bool deciding) {
  std::vector<std::string> list;
  for (const CellCause& cause : answer.causes)
    if (cause.may_decide || !deciding) list.push_back(cause.name);
  return list;
}

const std::map<double, std::string> kWidths = {{0.1, ""}, {0.2, ""}, {0.4, ""}, {0.8, ""}};

TEST(MapCell, TheWidestCandidateBelowTheWidthAndWhatEndsIt) {
  const CellAnswer answer =
      cell_answer(screen_of(reach(0.29, 0.22, 0.35, 0.5), {{"slip", reach(0.3, 0.25, 0.4)},
                                                           {"whirl", reach({}, 0.6, {})},
                                                           {"heat", reach({}, {}, {})}}),
                  0, kWidths);
  EXPECT_EQ(answer.candidate, 1);
  EXPECT_EQ(answer.lower, 1);
  EXPECT_EQ(answer.upper, 1);
  EXPECT_TRUE(answer.resolved);
  EXPECT_TRUE(answer.certain);
  EXPECT_EQ(answer.decides, "slip");
  EXPECT_THAT(names(answer, false), ElementsAre("slip", "jams", "whirl"));
  EXPECT_THAT(names(answer, true), ElementsAre("slip"));
}

TEST(MapCell, JamsAreExactAndOverlapWithALimitsInterval) {
  const CellAnswer answer = cell_answer(
      screen_of(reach(0.5, 0.19, 0.5, 0.5), {{"slip", reach(0.6, 0.3, {})}}), 0, kWidths);
  EXPECT_EQ(answer.decides, "jams");
  EXPECT_THAT(names(answer, true), ElementsAre("jams", "slip"));
  EXPECT_EQ(answer.lower, 0);
  EXPECT_EQ(answer.upper, 2);
  EXPECT_FALSE(answer.resolved);
  EXPECT_FALSE(answer.certain);
  const CellAnswer apart = cell_answer(
      screen_of(reach(0.5, 0.3, 0.5, 0.5), {{"slip", reach(0.6, 0.5, {})}}), 0, kWidths);
  EXPECT_THAT(names(apart, true), ElementsAre("jams"));
  EXPECT_TRUE(apart.resolved);
}

TEST(MapCell, NothingDecidesBeyondTheCandidatesAndNoCandidateIsAnAnswerToo) {
  const CellAnswer wide = cell_answer(screen_of(reach(0.9, 0.85, {}, 0.9), {}), 0, kWidths);
  EXPECT_EQ(wide.candidate, 3);
  EXPECT_EQ(wide.decides, "");
  EXPECT_THAT(names(wide, false), ElementsAre("jams"));
  const CellAnswer none = cell_answer(
      screen_of(reach(0.0, 0.0, 0.0, 0.9), {{"slip", reach(0.0, 0.0, 0.0)}}), 0, kWidths);
  EXPECT_EQ(none.candidate, -1);
  EXPECT_EQ(none.decides, "slip");
  // A width that is a candidate's own misses the target there.
  EXPECT_EQ(cell_answer(screen_of(reach(0.2, 0.2, 0.2), {}), 0, kWidths).candidate, 0);
}

TEST(MapCell, RunsOfBothStagesKeepTheirRowsApart) {
  StudyData first = plain_study(4), second = plain_study(3);
  first.inputs = {{"width", "mm", {1}, {1, 2, 3, 4}, {}, {}, {1, 2, 3, 4}, false}};
  second.inputs = {{"width", "mm", {1}, {5, 6, 7}, {}, {}, {5, 6, 7}, false}};
  first.quantities = {{"y", "-", "", {1, 2, 3, 4}}};
  second.quantities = {{"y", "-", "", {5, 6, 7}}};
  first.row = {0, 1, 2, 0}, second.row = {0, 1, 0};
  second.status[1] = RunStatus::failed;
  StudyData both;
  add_runs(both, first);
  add_runs(both, second);
  EXPECT_EQ(both.size(), 7U);
  EXPECT_THAT(both.row, ElementsAre(0, 1, 2, 0, 3, 4, 3));
  EXPECT_EQ(both.status[5], RunStatus::failed);
  EXPECT_THAT(both.inputs[0].value, ElementsAre(1, 2, 3, 4, 5, 6, 7));
  EXPECT_THAT(both.inputs[0].lot, ElementsAre(1, 2, 3, 4, 5, 6, 7));
  EXPECT_THAT(both.quantities[0].values, ElementsAre(1, 2, 3, 4, 5, 6, 7));
}

}  // namespace
}  // namespace cagetol
