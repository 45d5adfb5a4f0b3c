#include "mc/study/pocket_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "src/input/input_error.hpp"
#include "tests/support/process.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;

TEST(PocketCsv, ReadsEveryColumnInSi) {
  const ScratchDirectory scratch;
  std::ofstream(scratch / "p.csv") << "# two pockets\n"
                                      "pitch_mrad, width_mm, squareness_mrad, length_mm\n"
                                      "1.5, 0.02, -0.5, 0.1\n"
                                      "0, -0.03, 0.25, -0.2\n";
  const auto pockets = read_pocket_deviations(scratch / "p.csv", 2);
  ASSERT_EQ(pockets.size(), 2U);
  EXPECT_DOUBLE_EQ(pockets[0].width, 0.02e-3);
  EXPECT_DOUBLE_EQ(pockets[0].length, 0.1e-3);
  EXPECT_DOUBLE_EQ(pockets[0].pitch, 1.5e-3);
  EXPECT_DOUBLE_EQ(pockets[0].squareness, -0.5e-3);
  EXPECT_DOUBLE_EQ(pockets[1].width, -0.03e-3);
  EXPECT_DOUBLE_EQ(pockets[1].squareness, 0.25e-3);
}

TEST(PocketCsv, ErrorsNameFileLineAndColumn) {
  const ScratchDirectory scratch;
  const auto message = [&](const std::string& text) -> std::string {
    std::ofstream(scratch / "p.csv") << text;
    try {
      read_pocket_deviations(scratch / "p.csv", 2);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  const std::string head = "width_mm,length_mm,pitch_mrad,squareness_mrad\n";
  EXPECT_THAT(message(head + "0,0,0,0\n0,0,x,0\n"),
              HasSubstr("p.csv:3: column 3 (pitch_mrad) = 'x'"));
  EXPECT_THAT(message(head + "0,0,0,0\n0,nan,0,0\n"),
              HasSubstr("p.csv:3: column 2 (length_mm) = 'nan'"));
  EXPECT_THAT(message(head + "0,0,0,0\n0,0,0\n"), HasSubstr("p.csv:3: 3 fields"));
  EXPECT_THAT(message("width_mm,length_mm,pitch_mrad\n0,0,0\n0,0,0\n"),
              HasSubstr("p.csv:1: there is no column 'squareness'"));
  EXPECT_THAT(message(head + "0,0,0,0\n"),
              HasSubstr("p.csv: width_mm: 1 rows, but the cage has 2 pockets"));
}

}  // namespace
}  // namespace cagetol
