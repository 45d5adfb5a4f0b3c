// How far work is, on stderr: of a sweep one line that rewrites itself on a terminal, plain lines
// at growing intervals in a log; of a cage table a bar.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "src/quantities/outcome.hpp"

namespace cagetol {

enum class ProgressStyle { automatic, line, plain, off };

/// Counts of outcomes.
struct Tally {
  std::uint64_t done = 0, jammed = 0, failed = 0, censored = 0, poisoned = 0;
  void count(Status status);
  std::uint64_t failures() const { return failed + censored + poisoned; }
};

/// "120/1000 done, 3.2/s, 1 jammed, 2 failed, 4 min 35 s left". `before` were done when this
/// session began.
std::string progress_text(const Tally& tally, std::uint64_t before, std::uint64_t samples,
                          double elapsed_s);

/// "[##########          ]  50 %", for a share of 0 to 1.
std::string progress_bar(double share);

class Progress {
 public:
  Progress(ProgressStyle style, std::uint64_t before, std::uint64_t samples);
  /// Prints when it is time to.
  void update(const Tally& tally);
  void finish(const Tally& tally);
  double elapsed_s() const;

 private:
  void print(const Tally& tally, bool last);

  ProgressStyle style_;
  std::uint64_t before_, samples_;
  std::chrono::steady_clock::time_point begin_;
  double next_s_ = 0;
  std::size_t width_ = 0;
};

}  // namespace cagetol
