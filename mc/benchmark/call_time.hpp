// The time of one call of something short.
#pragma once

#include <chrono>
#include <utility>
#include <vector>

#include "analysis/statistics/median.hpp"

namespace cagetol {

/// Microseconds of one call, mean of a batch.
template <class Call>
double batch_us(const Call& call) {
  constexpr int kCalls = 100;
  const auto began = std::chrono::steady_clock::now();
  for (int k = 0; k < kCalls; ++k) call();
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - began;
  return took.count() / kCalls;
}
/// The median of batches.
template <class Call>
double call_time_us(const Call& call) {
  constexpr int kBatches = 31;
  std::vector<double> times;
  for (int batch = 0; batch < kBatches; ++batch) times.push_back(batch_us(call));
  return median(std::move(times));
}

/// Time of one call of `part` over that of `whole`. Batches of the two alternate, so that a busy
/// machine affects both alike; the median of the ratios counts.
template <class Part, class Whole>
double time_ratio(const Part& part, const Whole& whole) {
  constexpr int kTurns = 31;
  std::vector<double> ratios;
  for (int turn = 0; turn < kTurns; ++turn) ratios.push_back(batch_us(part) / batch_us(whole));
  return median(std::move(ratios));
}

}  // namespace cagetol
