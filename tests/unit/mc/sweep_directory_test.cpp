#include "mc/sweep_directory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/process.hpp"

namespace cagetol {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(StudyDifferencesTest, NamesKeysWithOldAndNewValue) {
  const std::string stored = "samples = 10\nseed = 1\n[scene.load]\nradial_N = 1000.0\n";
  EXPECT_THAT(study_differences(stored, stored), IsEmpty());
  EXPECT_THAT(
      study_differences(stored, "samples = 20\n[scene.load]\nradial_N = 1000.0\nramp_s = 0.5\n"),
      ElementsAre("samples: 10 stored, 20 now", "scene.load.ramp_s: absent stored, 0.5 now",
                  "seed: 1 stored, absent now"));
}

TEST(StudyDifferencesTest, SeesTheLastNumberOfALongList) {
  std::string list = "values = [0.0";
  for (int i = 0; i < 500; ++i) list += ", 1.25";
  EXPECT_THAT(study_differences(list + ", 1.0]", list + ", 2.0]"), testing::SizeIs(1));
}

}  // namespace
}  // namespace cagetol
