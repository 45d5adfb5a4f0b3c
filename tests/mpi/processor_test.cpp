// A processor that lacks instructions of the build: the C library is made to believe so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/mpi/standin.hpp"

namespace cagetol {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(ProcessorTest, ABuildForAnotherProcessorSaysSoAndEndsWith2) {
  const Ended ended = run({"env", "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA",
                           CAGETOL_BINARY_DIR "/cagetol", "--version"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.output,
              AllOf(HasSubstr("this one lacks AVX2 FMA\n"), HasSubstr("-DCAGETOL_PORTABLE=ON")));
}

TEST(ProcessorTest, TheProcessorThatItWasBuiltOnHasAllThatItNeeds) {
  EXPECT_EQ(run({CAGETOL_BINARY_DIR "/cagetol", "--version"}).code, 0);
}

}  // namespace
}  // namespace cagetol
