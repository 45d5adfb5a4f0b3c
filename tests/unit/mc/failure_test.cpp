#include "mc/host/failure.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

#include "mc/host/file_write.hpp"
#include "mc/study_file/study_file_error.hpp"
#include "src/input/input_error.hpp"

namespace cagetol {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Failure, WantOfResourcesHasARemedy) {
  const std::system_error no_thread(EAGAIN, std::generic_category());
  const std::filesystem::filesystem_error no_file("open", {EMFILE, std::generic_category()});
  EXPECT_THAT(failure_text(std::bad_alloc()),
              AllOf(HasSubstr("out of memory"), HasSubstr("\n  remedy: ")));
  EXPECT_THAT(failure_text(std::length_error("vector::reserve")), HasSubstr("out of memory"));
  EXPECT_THAT(failure_text(no_thread),
              AllOf(HasSubstr("no further thread"), HasSubstr("ulimit -u")));
  EXPECT_THAT(failure_text(no_file), AllOf(HasSubstr("open files"), HasSubstr("ulimit -n")));
  for (const std::exception* problem : {static_cast<const std::exception*>(&no_thread),
                                        static_cast<const std::exception*>(&no_file)})
    EXPECT_TRUE(is_want_of_resources(*problem));
}

TEST(Failure, OtherProblemsKeepTheirWords) {
  const std::runtime_error singular("the matrix is singular");
  EXPECT_FALSE(is_want_of_resources(singular));
  EXPECT_EQ(failure_text(singular), "the matrix is singular");
  EXPECT_FALSE(is_want_of_resources(std::system_error(ENOENT, std::generic_category())));
}

TEST(Failure, OnlyWhatNoUserCanMendIsUnexpected) {
  const InputError bad({"study.toml", 3}, "sigma", "-1", "must not be negative", "give another");
  const StudyFileError damaged("study.h5", "it is empty", "build it again");
  const WriteError full("out/report.json", "write", ENOSPC);
  for (const std::exception* problem :
       {static_cast<const std::exception*>(&bad), static_cast<const std::exception*>(&damaged),
        static_cast<const std::exception*>(&full)}) {
    EXPECT_EQ(exit_code_for(*problem), kBadInput) << problem->what();
    EXPECT_EQ(ending_text(*problem), problem->what());
  }
  EXPECT_EQ(exit_code_for(std::bad_alloc()), kBadInput);
  EXPECT_EQ(exit_code_for(std::logic_error("no such row")), kUnexpected);
  EXPECT_EQ(ending_text(std::logic_error("no such row")), "unexpected: no such row");
}

}  // namespace
}  // namespace cagetol
