#include "mc/study/measured_parts.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "distributions/basics/random_stream.hpp"
#include "distributions/variance_parts.hpp"

namespace cagetol {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kKey = "cage.pocket_width_mm.pocket";
const std::string kShop =
    "cage,pocket,width\nA,1,7.66\nA,2,7.68\nA,3,7.67\nB,1,7.64\nB,2,7.62\nB,3,7.63\n";

StatedFile stated(const std::string& group) {
  StatedFile file;
  file.file = "shop.csv";
  file.column = "width";
  file.group = group;
  return file;
}

MeasuredParts read(const std::string& text, const StatedFile& file, std::size_t pockets = 3,
                   const std::string& key = kKey) {
  return read_measured_parts(text, "shop.csv", file, key, "mm", {7.65, pockets});
}

std::string problem(const std::string& text, const StatedFile& file, std::size_t pockets = 3,
                    const std::string& key = kKey) {
  try {
    read(text, file, pockets, key);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(MeasuredParts, AreDeviationsByCage) {
  const MeasuredParts parts = read(kShop, stated("Cage"));
  EXPECT_THAT(parts.names, ElementsAre("A", "B"));
  const auto cages = parts.by_cage();
  ASSERT_EQ(cages.size(), 2u);
  EXPECT_NEAR(cages[0][1], 0.03, 1e-12);
  EXPECT_NEAR(cages[1][2], -0.02, 1e-12);
  EXPECT_NEAR(parts.offset, 0, 1e-12);
}

TEST(MeasuredParts, KeepTheirMeanOffsetUnlessCentred) {
  const std::string wide = "cage,width\nA,7.70\nA,7.71\nB,7.69\nB,7.70\n";
  StatedFile file = stated("cage");
  EXPECT_NEAR(read(wide, file, 2).by_cage()[0][0], 0.05, 1e-12);
  EXPECT_THAT(
      measured_notes(read(wide, file, 2), "KEY", "mm"),
      testing::Contains(AllOf(HasSubstr("4 parts of 2 cages"), HasSubstr("+0.05 mm, is kept"))));
  file.centred = true;
  EXPECT_NEAR(read(wide, file, 2).by_cage()[0][0], 0, 1e-12);
  EXPECT_NEAR(read(wide, file, 2).offset, 0.05, 1e-12);
}

TEST(MeasuredParts, MustSayWhichAreOfOneCageWhereTheFileMay) {
  EXPECT_THAT(problem(kShop, stated("")),
              AllOf(HasSubstr("shop.csv: " + kKey), HasSubstr("one cage (cage, pocket)"),
                    HasSubstr("group = \"cage\""), HasSubstr("group = false")));
  StatedFile apart = stated("");
  apart.ungrouped = true;
  EXPECT_EQ(problem(kShop, apart), "no error");
  EXPECT_EQ(problem("note,width,length [um]\n,7.66,3\nx,7.65,4\n", stated("")), "no error");
  EXPECT_EQ(problem(kShop, stated(""), 3, "cage.pocket_width_mm.lot"), "no error");
  EXPECT_THAT(problem(kShop, stated("cage"), 3, "cage.pocket_width_mm.lot"),
              HasSubstr("only a law of pockets has groups"));
}

TEST(MeasuredParts, OfCagesWithOtherPocketsAreRefusedOrGoRound) {
  StatedFile file = stated("cage");
  EXPECT_THAT(problem(kShop, file, 4),
              AllOf(HasSubstr("shop.csv:2: cage.pocket_width_mm.pocket.group = A"),
                    HasSubstr("3 parts"), HasSubstr("4 pockets"), HasSubstr("resample = true")));
  file.resample = true;
  const auto cages = read(kShop, file, 4).by_cage();
  EXPECT_THAT(cage_at(cages, 0.4, 4),
              ElementsAre(cages[0][1], cages[0][2], cages[0][0], cages[0][1]));
  EXPECT_THAT(cage_at(cages, 1.9, 2), ElementsAre(cages[1][2], cages[1][0]));
  EXPECT_THAT(cage_at(cages, 1.9, 3), testing::ElementsAreArray(cages[1]));
}

TEST(MeasuredParts, NameMissingOnesAndOutliersByLine) {
  std::string text = "cage,width\n";
  for (int i = 0; i < 40; ++i) text += fmt::format("{},{}\n", i / 4, 7.65 + 0.001 * (i % 4));
  const std::string hole = text + "10,7.65\n10,\n10,7.651\n10,7.95\n";
  StatedFile file = stated("cage");
  EXPECT_THAT(problem(hole, file, 4),
              AllOf(HasSubstr("shop.csv:43"), HasSubstr("missing = \"skip\"")));
  file.missing = "skip";
  const MeasuredParts parts = read(hole, file, 4);
  EXPECT_THAT(parts.remarks,
              ElementsAre("line 43 is left out", HasSubstr("line 45 is an outlier")));
  EXPECT_TRUE(std::isnan(parts.by_cage()[10][1]));
  // In its place stands the next pocket of the cage; the others keep theirs.
  EXPECT_EQ(cage_at(parts.by_cage(), 10, 4)[1], cage_at(parts.by_cage(), 10, 4)[2]);
  EXPECT_NEAR(cage_at(parts.by_cage(), 10, 4)[3], 0.3, 1e-12);
  file.exclude = {45};
  EXPECT_THAT(read(hole, file, 4).remarks,
              ElementsAre("line 43 is left out", "line 45 is left out"));
  file.exclude = {1};
  EXPECT_THAT(problem(hole, file, 4), HasSubstr("shop.csv:1: " + kKey + ".exclude = 1"));
  EXPECT_THAT(read(text, stated("cage"), 4).remarks, IsEmpty());
}

TEST(MeasuredParts, OfFewCagesSaySo) {
  EXPECT_THAT(read(kShop, stated("cage")).remarks, ElementsAre(HasSubstr("fewer than 10 cages")));
}

TEST(MeasuredParts, LawsAreListsOfBothPartsOrFitted) {
  StatedFile file = stated("cage");
  const MeasuredLaws lists = laws_of(read(kShop, file));
  EXPECT_NEAR(quantile(lists.lot, 1), 0.02, 1e-12);
  EXPECT_NEAR(quantile(lists.pocket, 1), 0.01, 1e-12);
  file.fitted = true;
  const MeasuredLaws fitted = laws_of(read(kShop, file));
  EXPECT_NEAR(standard_deviation(fitted.pocket), 0.01, 1e-12);
  EXPECT_NEAR(standard_deviation(fitted.lot), std::sqrt(8e-4 - 1e-4 / 3), 1e-12);
  EXPECT_EQ(mean(fitted.pocket), 0);
}

/// 24 cages of 14 pockets, as a shop writes them.
std::string drawn_file(std::uint64_t id) {
  RandomStream stream(2024, Purpose::noise, id);
  std::string text =
      "K\xe4"
      "fig;Tasche;Breite [mm]\n";
  for (int cage = 1; cage <= 24; ++cage) {
    const double shared = quantile(Normal{7.66, 0.00965}, stream.next());
    for (int pocket = 1; pocket <= 14; ++pocket) {
      std::string value =
          fmt::format("{:.4f}", shared + quantile(Normal{0, 0.00629}, stream.next()));
      value[1] = ',';
      text += fmt::format("K{:02};{};{}\n", cage, pocket, value);
    }
  }
  return text;
}

TEST(MeasuredParts, IntervalsOfBothSigmasHoldThoseOfNineOfTenFiles) {
  StatedFile file = stated(
      "K\xc3\xa4"
      "fig");
  file.column = "Breite";
  file.decimal = ",";
  int cages = 0, pockets = 0;
  for (std::uint64_t id = 0; id < 200; ++id) {
    const auto allowed = variance_parts(read(drawn_file(id), file, 14).by_cage()).allowed;
    const Interval cage = interval_of(
        allowed, [](const auto& of) { return of.group_sigma; }, 0.95);
    const Interval pocket = interval_of(
        allowed, [](const auto& of) { return of.own_sigma; }, 0.95);
    cages += cage.lower <= 0.00965 && 0.00965 <= cage.upper;
    pockets += pocket.lower <= 0.00629 && 0.00629 <= pocket.upper;
  }
  EXPECT_GE(cages, 180);
  EXPECT_GE(pockets, 180);
  EXPECT_LT(cages + pockets, 400);  // intervals of 95 % miss some
}

}  // namespace
}  // namespace cagetol
