// Exit codes of the program.
#pragma once

namespace cagetol {

/// Exit codes of the program; --help lists them.
enum ExitCode : int {
  kDone = 0,
  kLimitsNotMet = 1,
  kBadInput = 2,
  kSamplesFailed = 3,
  kUnexpected = 70,  ///< a fault of the program
  kInterrupted = 75,
};

}  // namespace cagetol
