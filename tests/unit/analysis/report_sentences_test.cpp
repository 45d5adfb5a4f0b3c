// Sentences of reports against the numbers beside them, over studies of every kind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "analysis/report/report.hpp"
#include "tests/support/tolerance_standin.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Studies from far too few runs to many, that nothing, everything or the width decides.
std::vector<StudyData> all_kinds() {
  std::vector<StudyData> studies;
  std::mt19937_64 random(7);
  for (const std::int64_t rows : {6, 40, 150, 400})
    for (const double target : {0.5, 0.95, 0.999})
      for (const double edge : {-1.0, 0.012, 0.02, 0.026, 1.0})
        studies.push_back(tolerance_standin(
            rows, static_cast<std::int64_t>(random() % 1000), {kPrintedWidth, kPrintedLength},
            target, [&](const StandinCage& cage) { return widest_pocket(cage) + 0.026 - edge; }));
  return studies;
}

TEST(ReportSentences, AreTrueToTheirNumbers) {
  std::map<std::string, int> seen;
  for (const StudyData& study : all_kinds()) {
    const auto report = make_report(study);
    const auto& verdict = report.at("verdict");
    const std::string status = verdict.at("status"), statement = verdict.at("statement");
    ++seen[status];
    for (const auto& limit : report.at("margins").at("each"))
      if (limit.at("role") == "met by enough runs") {
        EXPECT_EQ(limit.at("missed"), 0);
      }
    if (!report.at("tolerance").is_object() || status == "too_few_runs") continue;
    const auto& candidates = report.at("tolerance").at("candidates");
    const auto& yield =
        candidates.at(report.at("tolerance").at("chosen_candidate").get<std::size_t>()).at("yield");
    const double target = study.plan.target_yield, lower = yield.at("lower_bound"),
                 upper = yield.at("upper_bound");
    if (status == "recommended") {
      EXPECT_GE(lower, target) << statement;
      EXPECT_THAT(statement, Not(HasSubstr("at most")));
    }
    if (status == "none_meets" || status == "open") {
      if (status == "none_meets") {
        EXPECT_LT(upper, target) << statement;
      }
      EXPECT_THAT(statement, testing::AllOf(HasSubstr("of those with enough"),
                                            HasSubstr("at least"), HasSubstr("at most")));
      for (const auto& candidate : candidates)
        if (candidate.at("shown") && !candidate.at("pooled")) {
          EXPECT_LE(candidate.at("yield").at("lower_bound").get<double>(), lower) << statement;
        } else if (status == "none_meets") {
          EXPECT_LT(candidate.at("yield").at("upper_bound").get<double>(), target) << statement;
        }
    }
  }
  for (const char* status : {"recommended", "none_meets", "open", "too_few_runs"})
    EXPECT_GT(seen[status], 0) << status;
}

}  // namespace
}  // namespace cagetol
