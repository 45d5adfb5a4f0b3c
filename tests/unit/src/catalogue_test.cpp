// The table of bearings: how designations are found, and rollers that give the ratings of each row.
#include "src/catalogue/catalogue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "src/catalogue/clearance_class.hpp"
#include "src/catalogue/rated_rollers.hpp"
#include "src/input/input_error.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;

std::string refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Catalogue, HasTheRowsOfItsTable) {
  EXPECT_EQ(catalogue().size(), 340u);
  const CatalogueRow& row = catalogue_row("NU 208 ECP");
  EXPECT_EQ(row.type, BearingType::NU);
  EXPECT_DOUBLE_EQ(row.bore, 40e-3);
  EXPECT_DOUBLE_EQ(row.outside, 80e-3);
  EXPECT_DOUBLE_EQ(row.width, 18e-3);
  EXPECT_DOUBLE_EQ(row.inner_raceway, 49.5e-3);
  EXPECT_DOUBLE_EQ(row.outer_raceway, 71.5e-3);
  EXPECT_DOUBLE_EQ(row.outer_shoulder, 67.9e-3);
  EXPECT_DOUBLE_EQ(row.dynamic_rating, 62e3);
  EXPECT_NEAR(row.limiting_speed, 11000 * std::numbers::pi / 30, 1e-9);
  EXPECT_TRUE(row.uprated);
  EXPECT_TRUE(std::isnan(catalogue_row("NU1005").outer_raceway));
}

TEST(Catalogue, NupHasTheRingsOfTheNjOfItsSize) {
  const CatalogueRow &row = catalogue_row("NUP 2308"), &nj = catalogue_row("NJ 2308");
  EXPECT_EQ(row.designation, "NUP 2308 ECP");
  EXPECT_EQ(row.type, BearingType::NUP);
  EXPECT_TRUE(has_outer_flanges(row.type) && has_inner_flanges(row.type));
  EXPECT_EQ(row.inner_shoulder, nj.inner_shoulder);
  EXPECT_EQ(row.dynamic_rating, nj.dynamic_rating);
}

TEST(Catalogue, FindsDesignationsHoweverTheyAreSpelled) {
  for (const char* spelling : {"NU208", "nu 208", "NU 208 ECP", "nu-208-ecp", "Nu208ECP"})
    EXPECT_EQ(catalogue_row(spelling).designation, "NU 208 ECP") << spelling;
  EXPECT_EQ(catalogue_row("N 208").designation, "N 208 ECP");
  EXPECT_EQ(catalogue_row("NU1005").designation, "NU 1005");
}

TEST(Catalogue, NamesNearOnesForUnknownDesignations) {
  const auto message = [](const char* name) { return refusal([name] { catalogue_row(name); }); };
  EXPECT_THAT(message("NU 20"), HasSubstr("NU 202 ECP, NU 203 ECP"));
  EXPECT_THAT(message("NUP 1005"), HasSubstr("near ones: NU 1005"));
  EXPECT_THAT(message(""), HasSubstr("no bearing of this designation"));
  EXPECT_EQ(matching_rows("nu 100").size(), 5u);
}

TEST(Catalogue, RefusesRowsThatDoNotFitTheHeading) {
  const auto message = [](const char* text) {
    return refusal([text] { read_catalogue(text, "table.csv"); });
  };
  EXPECT_THAT(message("designation,type\n# a comment\nNU 1\n"),
              AllOf(HasSubstr("table.csv:3"), HasSubstr("1 fields, the heading 2")));
  EXPECT_THAT(message("designation,type\nNU 1,NX\n"), HasSubstr("no such type"));
  EXPECT_THAT(message("designation,type\nNU 1,NU\n"), HasSubstr("no such column"));
  EXPECT_THAT(message("designation,type,d_mm\nNU 1,NU,12x\n"), HasSubstr("not a number"));
}

std::vector<std::string> designations() {
  std::vector<std::string> names;
  for (const CatalogueRow& row : catalogue()) names.push_back(row.designation);
  return names;
}

class EveryRow : public testing::TestWithParam<std::string> {};

// The formulas are those of load_rating.hpp, here with the factor b_m of the row.
TEST_P(EveryRow, HasRollersThatGiveBothRatings) {
  const CatalogueRow& row = catalogue_row(GetParam());
  const RollerDiameter roller = roller_diameter(row);
  const RatedRollers rollers = rated_set(row, roller, most_rollers(roller)).rollers;
  const double factor = row.uprated ? 1.15 : 1;
  EXPECT_NEAR(factor * dynamic_rating(rollers) / row.dynamic_rating, 1, 0.03);
  EXPECT_NEAR(static_rating(rollers) / row.static_rating, 1, 0.03);
  EXPECT_LT(rollers.length, 0.78 * row.width);
  EXPECT_GE(rollers.length, 0.86 * rollers.diameter);
  // Between neighbours a bar of a tenth of the diameter at least.
  EXPECT_GT(rollers.pitch_diameter * std::sin(std::numbers::pi / rollers.count),
            1.1 * rollers.diameter);
  EXPECT_NEAR(rollers.diameter, (roller.outer_raceway - row.inner_raceway) / 2, 1e-12);
  EXPECT_LT(roller.outer_raceway, row.outside);
  if (!std::isnan(row.outer_raceway)) {
    EXPECT_EQ(roller.outer_raceway, row.outer_raceway);
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, EveryRow, testing::ValuesIn(designations()), [](const auto& test) {
  std::string name = test.param;
  std::erase(name, ' ');
  return name;
});

// Rollers of NU 205 are 7.5 mm thick and 9 mm long with their chamfers, and there are 13.
TEST(RatedRollers, OfNu205AreThirteen) {
  const CatalogueRow& row = catalogue_row("NU205");
  const RollerDiameter roller = roller_diameter(row);
  const RatedRollers rollers = rated_set(row, roller, most_rollers(roller)).rollers;
  EXPECT_EQ(rollers.count, 13);
  EXPECT_DOUBLE_EQ(rollers.diameter, 7.5e-3);
  EXPECT_NEAR(rollers.length, 7.8e-3, 0.1e-3);
}

// N 1005, N 1007 and N 202 of other makers: E = 41.5, 55 (of lighter rollers) and 30.3 mm.
TEST(RatedRollers, RatingsTellADiameterThatTheCatalogueLacks) {
  EXPECT_NEAR(roller_diameter(catalogue_row("NU 1005")).outer_raceway, 41.5e-3, 1e-9);
  EXPECT_NEAR(roller_diameter(catalogue_row("NU 202")).outer_raceway, 30.3e-3, 1e-9);
  EXPECT_TRUE(roller_diameter(catalogue_row("NU 202")).from_ratings);
}

TEST(RatedRollers, RefusesRatingsThatNoRollersGive) {
  CatalogueRow row = catalogue_row("NU208");
  const RollerDiameter roller = roller_diameter(row);
  EXPECT_THAT(refusal([&] { rated_set(row, roller, 6); }),
              AllOf(HasSubstr("6 rollers would have to be"), HasSubstr("18 mm wide")));
  row.static_rating *= 1.2;
  EXPECT_THAT(refusal([&] { rated_set(row, roller, 14); }), HasSubstr("are off by up to"));
}

TEST(Catalogue, SaysWhyDoubleRowsAndFullComplementsAreNotInIt) {
  for (const char* double_row : {"NN3010", "nnu 4920", "SL04 5010", "NNCF 5010 CV"})
    EXPECT_THAT(refusal([&] { catalogue_row(double_row); }), HasSubstr("rows of rollers"))
        << double_row;
  for (const char* full : {"NCF 3008 CV", "NJG2308", "SL18 2208"})
    EXPECT_THAT(refusal([&] { catalogue_row(full); }),
                AllOf(HasSubstr("full complement"), HasSubstr("choose a bearing with a cage")))
        << full;
  EXPECT_THAT(
      refusal([&] { catalogue_row("NU209X"); }),
      AllOf(HasSubstr("near ones: NU 209 ECP;"), HasSubstr("leave 'X' out"), HasSubstr("--cage")));
}

TEST(ClearanceClass, IsThatOfTheStandard) {
  const auto um = [](ClearanceClass which, double bore) {
    const ClearanceRange range = clearance_range(which, bore);
    return std::pair{std::lround(1e6 * range.minimum), std::lround(1e6 * range.most)};
  };
  using enum ClearanceClass;
  EXPECT_EQ(um(C2, 25e-3), std::pair(0l, 25l));
  EXPECT_EQ(um(CN, 40e-3), std::pair(25l, 50l));
  EXPECT_EQ(um(CN, 40.1e-3), std::pair(30l, 60l));
  EXPECT_EQ(um(C3, 110e-3), std::pair(85l, 125l));
  EXPECT_EQ(um(C4, 150e-3), std::pair(165l, 215l));
  EXPECT_THROW(clearance_range(CN, 251e-3), std::domain_error);
}

}  // namespace
}  // namespace cagetol
