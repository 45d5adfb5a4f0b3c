// Does a way to integrate shift the mean of a quantity? Means over replicas, held against the
// standard error of a study.
#pragma once

#include <cstddef>
#include <vector>

namespace cagetol {

/// Size of the study whose standard error a bias must not exceed, where nothing else is asked.
inline constexpr double kStudySamples = 1000;

/// steady: the quantity does not vary between replicas of the reference (by less than a millionth
/// of its mean): there is no scatter to hold a bias against.
enum class BiasVerdict { unbiased, biased, unresolved, steady };
const char* verdict_name(BiasVerdict verdict);

struct Bias {
  std::size_t pairs = 0;      ///< with a value on both sides
  double mean = 0;            ///< of the reference
  double bias = 0;            ///< mean minus the reference's mean
  double standard_error = 0;  ///< of the bias
  double lower_limit = 0;     ///< of |bias|, 95 % interval (Student t), not below 0
  double upper_limit = 0;     ///< of |bias|
  double deviation = 0;       ///< standard deviation of the reference's replicas
  double allowed = 0;         ///< deviation / sqrt(samples of the study)
  BiasVerdict verdict = BiasVerdict::unresolved;
};

/// Pairs that call a setting without any bias unbiased where the two of a pair have nothing in
/// common; fewer do where they have.
double replicas_to_resolve();

/// The same replicas in two ways, replica k's value at k of both; pairs with a value missing (NaN)
/// are left out. Unbiased only if the whole interval of |bias| lies below what is allowed, biased
/// only if it lies above; else, and with fewer than two pairs, unresolved.
Bias compare_pairs(const std::vector<double>& values, const std::vector<double>& reference,
                   double study_samples = kStudySamples);

}  // namespace cagetol
