#include "analysis/sensitivity/features.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

const Feature& find(const std::vector<Feature>& features, const std::string& name) {
  for (const Feature& feature : features)
    if (feature.name == name) return feature;
  throw std::out_of_range(name);
}

TEST(Features, PlainNames) {
  EXPECT_EQ(plain_name("cage.pocket_width_mm"), "pocket width");
  EXPECT_EQ(plain_name("start.cage_offset_y_um"), "start cage offset y");
  EXPECT_EQ(plain_name("load"), "load");
  EXPECT_EQ(plain_name("load.radial_N"), "radial load");
  EXPECT_EQ(plain_name("environment.gravity_m_s2"), "environment gravity");
  EXPECT_EQ(plain_name("contact.race.restitution"), "contact race restitution");
  EXPECT_EQ(plain_name("roller.diameter_mm"), "roller diameter");
  EXPECT_EQ(plain_name("cage.width_mm"), "cage width");
}

TEST(Features, OfThePocketsOfACage) {
  StudyData study = plain_study(2);
  study.pockets = 4;
  // Pocket 0 starts at the phase; pockets are 90 degrees apart; the load zone is at 270 degrees.
  InputColumns phase{"start.cage_phase_deg", "deg", {0}, {}, {10, 100}, {}, {10, 100}, false};
  InputColumns width{
      "cage.pocket_width_mm",         "mm", {7}, {0.5, 1}, {}, {1, 2, 3, 4, 4, 4, 4, 6},
      {8, 9, 10, 11, 12, 12, 12, 14}, true};
  width.value = {8.5, 9.5, 10.5, 11.5, 12, 12, 12, 14};
  InputColumns square{"cage.pocket_squareness_mrad", "mrad", {0}, {}, {}, {1, -3, 2, 0, 1, 1, 1, 2},
                      {1, -3, 2, 0, 1, 1, 1, 2},     true};
  study.inputs = {phase, width, square};
  const auto features = cage_features(study);
  EXPECT_THAT(find(features, "pocket width: from cage to cage").values,
              testing::ElementsAre(0.5, 1));
  EXPECT_THAT(find(features, "pocket width: smallest pocket").values,
              testing::ElementsAre(8.5, 12));
  EXPECT_THAT(find(features, "pocket width: within-cage scatter").values,
              testing::ElementsAre(testing::DoubleEq(std::sqrt(5.0 / 3)), testing::DoubleEq(1)));
  EXPECT_THAT(find(features, "pocket width: pocket in load zone").values,
              testing::ElementsAre(11.5, 12));  // pockets 3 and 2
  EXPECT_THAT(find(features, "pocket squareness: largest deviation").values,
              testing::ElementsAre(3, 2));
  EXPECT_THAT(find(features, "start cage phase").values, testing::ElementsAre(10, 100));
  EXPECT_EQ(pocket_features(study, width).size(), 4u);
  EXPECT_THAT(pocket_features(study, width)[3].values, testing::ElementsAre(4, 6));
}

TEST(Features, WhatDoesNotVaryIsLeftOut) {
  StudyData study = plain_study(3);
  study.inputs = {{"load.radial_N", "N", {1000}, {0, 0, 0}, {}, {}, {1000, 1000, 1000}, false}};
  EXPECT_TRUE(cage_features(study).empty());
}

}  // namespace
}  // namespace cagetol
