#include "mc/cage_cache.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "src/input/input_error.hpp"
#include "tests/support/process.hpp"

namespace cagetol {
namespace {

/// Sets or, given nullptr, removes an environment variable while it lives.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    value ? ::setenv(name, value, 1) : ::unsetenv(name);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
  ~Variable() { old_ ? ::setenv(name_, old_->c_str(), 1) : ::unsetenv(name_); }

 private:
  const char* name_;
  std::optional<std::string> old_;
};

TEST(CageCache, FolderIsTheFirstThatTheEnvironmentNames) {
  const Variable home("HOME", "/h"), general("XDG_CACHE_HOME", "/x"), own("CAGETOL_CACHE", "/c");
  EXPECT_EQ(cage_cache_folder(), "/c");
  const Variable no_own("CAGETOL_CACHE", nullptr);
  EXPECT_EQ(cage_cache_folder(), "/x/cagetol");
  const Variable empty("XDG_CACHE_HOME", "");
  EXPECT_EQ(cage_cache_folder(), "/h/.cache/cagetol");
  const Variable no_home("HOME", nullptr);
  EXPECT_THAT(cage_cache_folder().filename().string(), testing::StartsWith("cagetol-"));
}

Scene coarse_scene() {
  Scene scene;
  scene.cage.mesh_density = 1;
  return scene;
}

TEST(CageCache, TableIsMadeOnce) {
  const ScratchDirectory scratch;
  const Variable own("CAGETOL_CACHE", (scratch / "cache").c_str());
  const auto made = CageTables(coarse_scene()).of(coarse_scene());
  const auto read = CageTables(coarse_scene()).of(coarse_scene());
  EXPECT_EQ(made->seconds_table, read->seconds_table);
  EXPECT_TRUE(made->projection == read->projection);
}

TEST(CageCache, FolderThatCannotBeWrittenIsAWarning) {
  const ScratchDirectory scratch;
  std::ofstream(scratch / "file") << "no folder";
  const Variable own("CAGETOL_CACHE", (scratch / "file").c_str());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const auto table = CageTables(coarse_scene()).of(coarse_scene());
  const std::string said =
      testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout();
  EXPECT_GT(table->dofs, 0);
  EXPECT_THAT(said, testing::HasSubstr("cannot write " + scratch / "file"));
}

/// The coarse scene with all pockets wider.
Scene wider(double by) {
  Scene scene = coarse_scene();
  for (double& width : scene.cage.pocket_width) width += by;
  return scene;
}

std::ptrdiff_t kept_files(const std::string& folder) {
  return std::distance(std::filesystem::directory_iterator(folder), {});
}

TEST(CageCache, TheTableOfASampleDoesNotDependOnTheSamplesBefore) {
  const ScratchDirectory scratch;
  const Variable own("CAGETOL_CACHE", (scratch / "cache").c_str());
  CageTables tables(coarse_scene());
  const auto nominal = tables.of(coarse_scene());
  const auto wide = tables.of(wider(0.2e-3));
  EXPECT_NEAR(wide->cage.pocket_width - nominal->cage.pocket_width, 0.2e-3, 0.04e-3);
  EXPECT_EQ(tables.of(wider(0.22e-3)), wide);
  EXPECT_EQ(tables.of(wider(0.01e-3)), nominal);
  const auto alone = CageTables(coarse_scene()).of(wider(0.2e-3));
  EXPECT_TRUE(alone->projection == wide->projection);
  EXPECT_EQ(kept_files(scratch / "cache"), 2);
}

TEST(CageCache, RanksShareTheTablesThatSamplesNeed) {
  const ScratchDirectory scratch;
  const Variable own("CAGETOL_CACHE", (scratch / "cache").c_str());
  const std::set<GridPoint> points{{0, 0}, {0, 1}, {1, 0}};
  testing::internal::CaptureStderr();
  CageTables(coarse_scene()).make(points, 0, 2);
  EXPECT_EQ(kept_files(scratch / "cache"), 2);
  CageTables(coarse_scene()).make(points, 1, 2);
  EXPECT_EQ(kept_files(scratch / "cache"), 3);
  CageTables(coarse_scene()).make(points, 0, 1);
  EXPECT_EQ(kept_files(scratch / "cache"), 3);
  EXPECT_THAT(testing::internal::GetCapturedStderr(),
              testing::AllOf(testing::HasSubstr("making cage table 1 of 3"),
                             testing::HasSubstr("making cage table 2 of 3"),
                             testing::HasSubstr("making cage table 3 of 3")));
}

TEST(CageCache, MoreTablesThanStayInMemoryAreReadAgain) {
  const ScratchDirectory scratch;
  const Variable own("CAGETOL_CACHE", (scratch / "cache").c_str());
  CageTables tables(coarse_scene());
  const std::weak_ptr<const CageTable> first = tables.of(coarse_scene());
  const double made = first.lock()->seconds_table;
  std::set<GridPoint> points;
  for (long length = -6; length <= 6; ++length)
    for (long width : {1, 2})
      if (points.size() < 16) points.insert({width, length});
  tables.make(points, 0, 1);
  EXPECT_TRUE(first.expired());
  EXPECT_EQ(tables.of(coarse_scene())->seconds_table, made);
}

TEST(CageCache, AnImpossibleCageIsBadInput) {
  Scene scene = coarse_scene();
  scene.cage.pocket_length = {15e-3};
  EXPECT_THROW(CageTables{scene}, InputError);
}

}  // namespace
}  // namespace cagetol
