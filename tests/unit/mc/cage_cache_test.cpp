#include "mc/run/cage_cache.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>

#include "mc/host/build_info.hpp"
#include "mc/host/sealed_bytes.hpp"
#include "src/cage/table/cage_table_bytes.hpp"
#include "src/input/input_error.hpp"
#include "src/quantities/quantity_table.hpp"
#include "src/simulate.hpp"
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
  scene.cage.corner_radius = 0;
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

/// The coarse scene with all pockets wider.
Scene wider(double by) {
  Scene scene = coarse_scene();
  for (double& width : scene.cage.pocket_width) width += by;
  return scene;
}

std::ptrdiff_t kept_files(const std::string& folder) {
  return std::distance(std::filesystem::directory_iterator(folder), {});
}

/// What is said, on stderr or stdout, while the coarse scene's table is asked for; `table` is it.
std::string said_for_table(std::shared_ptr<const CageTable>& table) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  table = CageTables(coarse_scene()).of(coarse_scene());
  return testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout();
}

long count_of(const std::string& text, const std::string& part) {
  long count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(CageCache, FolderThatCannotBeMadeIsOneWarning) {
  const ScratchDirectory scratch;
  std::ofstream(scratch / "file") << "no folder";
  const Variable own("CAGETOL_CACHE", (scratch / "file").c_str());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  CageTables tables(coarse_scene());
  EXPECT_GT(tables.of(coarse_scene())->dofs, 0);
  tables.of(wider(0.2e-3));
  const std::string said =
      testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout();
  EXPECT_THAT(said,
              testing::AllOf(testing::HasSubstr(scratch / "file: cannot open the folder: Not"),
                             testing::HasSubstr("cage tables are not kept"),
                             testing::HasSubstr("remedy: set CAGETOL_CACHE")));
  EXPECT_EQ(count_of(said, "cage tables are not kept"), 1);
}

TEST(CageCache, FolderThatOthersMayWriteToIsNotUsed) {
  const ScratchDirectory scratch;
  std::filesystem::create_directory(scratch / "open");
  std::filesystem::permissions(scratch / "open", std::filesystem::perms(0777));
  const Variable own("CAGETOL_CACHE", (scratch / "open").c_str());
  std::shared_ptr<const CageTable> table;
  EXPECT_THAT(said_for_table(table),
              testing::AllOf(testing::HasSubstr(scratch / "open may be written by others"),
                             testing::HasSubstr("remedy: `chmod go-w " + scratch / "open")));
  EXPECT_EQ(kept_files(scratch / "open"), 0);
}

std::string only_file(const std::string& folder) {
  return std::filesystem::directory_iterator(folder)->path().string();
}

void flip(const std::string& file, std::uintmax_t bit) {
  std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
  bytes.seekg(static_cast<std::streamoff>(bit / 8));
  const char changed = static_cast<char>(bytes.get() ^ (1 << bit % 8));
  bytes.seekp(static_cast<std::streamoff>(bit / 8));
  bytes.put(changed);
}

/// The same but for how long it took to make.
bool same(const CageTable& one, const CageTable& two) {
  const auto bytes = [](CageTable table) {
    table.seconds_table = 0;
    return cage_table_bytes(table);
  };
  return bytes(one) == bytes(two);
}

TEST(CageCache, ADamagedTableIsOneWarningAndMadeAgain) {
  const ScratchDirectory scratch;
  const Variable own("CAGETOL_CACHE", (scratch / "cache").c_str());
  std::shared_ptr<const CageTable> first, again;
  EXPECT_EQ(count_of(said_for_table(first), "warning"), 0);
  const std::string file = only_file(scratch / "cache");
  const std::uintmax_t bits = 8 * std::filesystem::file_size(file);
  const std::vector<std::function<void()>> faults = {
      [&] { flip(file, bits / 3); },
      [&] { flip(file, bits - 1); },
      [&] { flip(file, 0); },
      [&] { std::filesystem::resize_file(file, bits / 16); },
      [&] { std::filesystem::resize_file(file, 0); },
      [&] { std::ofstream(file, std::ios::app) << '\0'; }};
  for (const auto& fault : faults) {
    fault();
    const std::string said = said_for_table(again);
    EXPECT_EQ(count_of(said, file + " is damaged"), 1) << said;
    EXPECT_TRUE(same(*again, *first));
    EXPECT_EQ(count_of(said_for_table(again), "warning"), 0);  // whole again
  }
  EXPECT_EQ(kept_files(scratch / "cache"), 1);
}

TEST(CageCache, ATableOfAnotherBuildOrFormatIsMadeAgainWithoutAWord) {
  const ScratchDirectory scratch;
  const Variable own("CAGETOL_CACHE", (scratch / "cache").c_str());
  std::shared_ptr<const CageTable> first, again;
  said_for_table(first);
  const std::string file = only_file(scratch / "cache");
  const std::string build = build_id(build_info());
  const auto other_build = [&](const std::string& its_build) {
    CageTable wrong = *first;
    wrong.frequency *= 2;
    const std::string head =
        "cage table 14\n" + scene_cage_table_key(coarse_scene(), {}) + "\n" + its_build + "\n";
    std::ofstream(file, std::ios::binary) << sealed_bytes(head, cage_table_bytes(wrong));
  };
  other_build(build);
  EXPECT_EQ(CageTables(coarse_scene()).of(coarse_scene())->frequency, 2 * first->frequency);
  other_build("another build");
  EXPECT_EQ(count_of(said_for_table(again), "warning"), 0);
  EXPECT_TRUE(same(*again, *first));
  std::ofstream(file, std::ios::binary) << "cagetol cage table 10\nwithout a checksum";
  EXPECT_EQ(count_of(said_for_table(again), "warning"), 0);
  EXPECT_TRUE(same(*again, *first));
}

TEST(CageCache, AFileThatIsNotOursIsReplaced) {
  const ScratchDirectory scratch;
  const Variable own("CAGETOL_CACHE", (scratch / "cache").c_str());
  std::shared_ptr<const CageTable> first, again;
  said_for_table(first);
  const std::string file = only_file(scratch / "cache");
  std::filesystem::permissions(file, std::filesystem::perms(0666));
  EXPECT_THAT(said_for_table(again), testing::HasSubstr(file + " may be written by others"));
  EXPECT_NE(again->seconds_table, first->seconds_table);
  EXPECT_EQ(count_of(said_for_table(again), "warning"), 0);
}

/// The largest stress in a short run.
double peak_stress(const std::shared_ptr<const CageTable>& table) {
  Scene scene = coarse_scene();
  scene.cage.model = CageKind::flexible;
  scene.window.settle_revolutions = 0.1;
  scene.window.measure_revolutions = 0.1;
  return simulate(scene, {.cage_table = table})
      .quantities.at(static_cast<std::size_t>(quantity_index("cage_stress_peak_MPa")));
}

/// Goes on at the fault at which the last run was stopped.
TEST(NightlyCageCache, AThousandFaultsNeverChangeAResult) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1";
  constexpr int faults = 1000;
  const std::string progress = CAGETOL_BINARY_DIR "/cage-cache-faults";
  int begin = 0;
  std::ifstream(progress) >> begin;
  const ScratchDirectory scratch;
  const Variable own("CAGETOL_CACHE", (scratch / "cache").c_str());
  std::shared_ptr<const CageTable> table;
  said_for_table(table);
  const double right = peak_stress(table);
  const std::string file = only_file(scratch / "cache");
  const std::uintmax_t bytes = std::filesystem::file_size(file);
  std::mt19937_64 random(37);
  random.discard(static_cast<unsigned long long>(begin));
  for (int fault = begin; fault < faults && !HasFailure(); ++fault) {
    const std::uintmax_t place = random();
    if (fault % 10 == 9)
      std::filesystem::resize_file(file, place % bytes);
    else
      flip(file, place % (8 * bytes));
    EXPECT_EQ(count_of(said_for_table(table), "is damaged"), 1) << fault << ", " << place;
    EXPECT_EQ(peak_stress(table), right) << fault << ", " << place;
    std::ofstream(progress) << fault + 1;
  }
  if (!HasFailure()) std::filesystem::remove(progress);
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

TEST(CageCache, ACageWithoutASolutionIsBadInputOrAFailedRun) {
  Scene scene = coarse_scene();
  scene.cage.model = CageKind::flexible;
  scene.cage.material.density = 1e-300;
  testing::internal::CaptureStderr();
  try {
    CageTables(scene).of(scene);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("cage.mesh_density = 1: "),
                                             testing::HasSubstr("cannot be solved: "),
                                             testing::HasSubstr("remedy: ")));
  }
  testing::internal::GetCapturedStderr();
  for (const std::string reason : {"", "its modes are gone"}) {
    const Outcome outcome = simulate(scene, {.why_no_cage = reason});
    EXPECT_EQ(outcome.status, Status::failed);
    EXPECT_THAT(outcome.reason,
                testing::HasSubstr("its finite elements cannot be solved: " + reason));
  }
}

TEST(CageCache, AnImpossibleCageIsBadInput) {
  Scene scene = coarse_scene();
  scene.cage.pocket_length = {15e-3};
  EXPECT_THROW(CageTables{scene}, InputError);
}

}  // namespace
}  // namespace cagetol
