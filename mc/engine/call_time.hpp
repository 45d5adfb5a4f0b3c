// The time of one call of something short.
#pragma once

#include <chrono>
#include <utility>
#include <vector>

#include "mc/engine/statistics.hpp"

namespace cagetol {

/// Microseconds of one call: the median of batches.
template <class Call>
double call_time_us(const Call& call) {
  constexpr int kBatches = 31, kCalls = 100;
  std::vector<double> times;
  for (int batch = 0; batch < kBatches; ++batch) {
    const auto began = std::chrono::steady_clock::now();
    for (int k = 0; k < kCalls; ++k) call();
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - began;
    times.push_back(took.count() / kCalls);
  }
  return median(std::move(times));
}

}  // namespace cagetol
