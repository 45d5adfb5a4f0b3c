#include "mc/cage_cache.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
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
  const auto made = kept_cage_table(coarse_scene());
  const auto read = kept_cage_table(coarse_scene());
  EXPECT_EQ(made->seconds_table, read->seconds_table);
  EXPECT_TRUE(made->projection == read->projection);
}

TEST(CageCache, FolderThatCannotBeWrittenIsAWarning) {
  const ScratchDirectory scratch;
  std::ofstream(scratch / "file") << "no folder";
  const Variable own("CAGETOL_CACHE", (scratch / "file").c_str());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const auto table = kept_cage_table(coarse_scene());
  const std::string said =
      testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout();
  EXPECT_GT(table->dofs, 0);
  EXPECT_THAT(said, testing::HasSubstr("cannot write " + scratch / "file"));
}

TEST(CageCache, AnImpossibleCageIsBadInput) {
  Scene scene = coarse_scene();
  scene.cage.pocket_length = {15e-3};
  EXPECT_THROW(kept_cage_table(scene), InputError);
}

}  // namespace
}  // namespace cagetol
