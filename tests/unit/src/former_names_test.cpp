// Names of earlier versions are refused with what became of them; none of them is known today.
#include "src/input/former_names.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mc/study/study_keys.hpp"
#include "src/quantities/quantity_table.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

std::string text(std::string_view view) {
  return std::string(view);
}

bool is_known(const std::string& name) {
  const auto is_or_holds = [&](const auto& keys) {
    return std::any_of(keys.begin(), keys.end(), [&](const KeyInfo& key) {
      return key.name == name || key.name.starts_with(name + ".");
    });
  };
  return quantity_index(name) >= 0 || is_or_holds(scene_keys()) || is_or_holds(study_keys()) ||
         is_or_holds(dimension_keys());
}

TEST(FormerNames, AreNoNamesOfToday) {
  for (const FormerName& row : former_names()) {
    const std::string name = text(row.name);
    EXPECT_LT(quantity_index(name), 0) << name;
    const auto* scene = find_key(scene_keys(), name);
    const auto* study = find_key(study_keys(), name);
    if (row.value.empty()) {
      EXPECT_FALSE(scene || study) << name;
    } else {
      ASSERT_TRUE(scene || study) << name;
      const KeyInfo& key = scene ? static_cast<const KeyInfo&>(*scene) : *study;
      EXPECT_THAT(key.range.choices, testing::Not(testing::Contains(text(row.value)))) << name;
    }
  }
}

TEST(FormerNames, SayWhatToWriteInstead) {
  for (const FormerName& row : former_names()) {
    EXPECT_NE(row.now.empty(), row.why.empty()) << row.name << ": a new name or a reason";
    EXPECT_FALSE(former_remedy(row).empty()) << row.name;
    if (row.now.empty()) continue;
    const std::string now = text(row.now);
    EXPECT_TRUE(is_known(now)) << row.name << " is now called " << now << ", which nobody knows";
  }
}

TEST(FormerNames, AreFoundBelowASectionAndBehindTheScene) {
  ASSERT_NE(former_name("orbit_class"), nullptr);
  EXPECT_EQ(former_name("scene.orbit_class"), former_name("orbit_class"));
  EXPECT_EQ(former_name("orbit_class.key"), former_name("orbit_class"));
  EXPECT_EQ(former_name("orbit_classes"), nullptr);
  EXPECT_EQ(former_name("orbit_class", "value"), nullptr);
}

}  // namespace
}  // namespace cagetol
