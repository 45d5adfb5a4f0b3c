#include "mc/host/machine.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/process.hpp"

namespace cagetol {
namespace {

class Groups : public testing::Test {
 protected:
  void write(const std::string& file, const std::string& text) {
    const std::filesystem::path path = root_ / file;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  double room(const std::string& membership) {
    return room_of_control_groups(membership, root_.path()).bytes;
  }
  ScratchDirectory root_;
};

TEST_F(Groups, TheTightestLimitAroundTheProcessCounts) {
  write("job/memory.max", "5000\n");
  write("job/memory.current", "3000\n");
  write("job/memory.stat", "anon 2500\ninactive_file 400\n");
  write("job/step/memory.max", "max\n");
  write("job/step/memory.current", "3000\n");
  EXPECT_EQ(room("0::/job/step\n"), 2400);  // 5000 - 3000 + 400
  write("job/step/memory.max", "3500\n");
  EXPECT_EQ(room("0::/job/step\n"), 500);
  write("job/step/memory.current", "9000\n");
  EXPECT_EQ(room("0::/job/step\n"), 0);
  EXPECT_EQ(room("0::/\n"), std::numeric_limits<double>::infinity());
}

TEST_F(Groups, ThoseOfVersionOneToo) {
  write("memory/memory.limit_in_bytes", "7000\n");
  write("memory/memory.usage_in_bytes", "1000\n");
  write("memory/memory.stat", "inactive_file 1\ntotal_inactive_file 200\n");
  const std::string others = "9:cpuset:/\n8:hugetlb:/\n";
  EXPECT_EQ(room(others + "4:cpu,memory:/path/of/the/host\n"), 6200);
  EXPECT_EQ(room(others), std::numeric_limits<double>::infinity());
}

TEST(Machine, HasMemoryAndDisk) {
  EXPECT_GT(room_of_machine().bytes, 1e6);
  EXPECT_LT(room_of_machine().bytes, 1e15);
  const double free = room_on_disk("/no/such/folder/yet").bytes;
  EXPECT_GT(free, 0);
  EXPECT_EQ(room_on_disk("/no/such/folder/yet").name, "free on the disk of /");
}

}  // namespace
}  // namespace cagetol
