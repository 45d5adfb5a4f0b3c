#include "analysis/compare/mean_bias.hpp"

#include <cmath>
#include <map>
#include <set>

#include "analysis/statistics/summary.hpp"

namespace cagetol {
namespace {

constexpr double kConfidence = 0.95;
constexpr double kSteady = 1e-6;  // of the mean

/// For each run of `reference` the one of `runs` with the same row, or none (-1).
std::vector<std::ptrdiff_t> partners(const StudyData& reference, const StudyData& runs) {
  std::map<std::int64_t, std::ptrdiff_t> at;
  for (const std::size_t i : first_runs(runs)) at[runs.row[i]] = static_cast<std::ptrdiff_t>(i);
  std::vector<std::ptrdiff_t> found;
  for (const std::size_t i : first_runs(reference)) {
    const auto partner = at.find(reference.row[i]);
    found.push_back(partner == at.end() ? -1 : partner->second);
  }
  return found;
}

}  // namespace

std::vector<MeanBias> mean_biases(const StudyData& reference, const StudyData& runs,
                                  double study_samples) {
  const auto first = first_runs(reference);
  const auto partner = partners(reference, runs);
  std::vector<MeanBias> biases;
  for (const Column& column : reference.quantities) {
    const Column* other = find_quantity(runs, column.name);
    if (other == nullptr) continue;
    std::vector<double> expected, found;
    for (std::size_t k = 0; k < first.size(); ++k) {
      const double value =
          partner[k] < 0 ? kUndefined : other->values[static_cast<std::size_t>(partner[k])];
      const bool both = std::isfinite(value) && std::isfinite(column.values[first[k]]);
      expected.push_back(both ? column.values[first[k]] : kUndefined);
      found.push_back(both ? value : kUndefined);
    }
    MeanBias b{column.name, column.unit, paired_difference(expected, found, kConfidence)};
    if (b.pairs.pairs < 2) continue;
    const std::vector<double> equal(expected.size(), 1.0);
    const double scatter = weighted_standard_deviation(expected, equal);
    if (!(scatter > kSteady * std::abs(b.pairs.first_mean))) continue;
    b.study_error = scatter / std::sqrt(study_samples);
    const Estimate& d = b.pairs.difference;
    b.bias = d.value / b.study_error;
    std::vector<double> apart;
    for (std::size_t k = 0; k < expected.size(); ++k) apart.push_back(found[k] - expected[k]);
    b.error = weighted_standard_deviation(apart, equal) /
              std::sqrt(static_cast<double>(b.pairs.pairs)) / b.study_error;
    b.upper_limit = std::abs(b.bias) + (d.upper - d.value) / b.study_error;
    biases.push_back(b);
  }
  return biases;
}

bool share_lots(const StudyData& study) {
  const auto first = first_runs(study);
  std::set<std::int64_t> lots;
  for (const std::size_t i : first) lots.insert(study.lot[i]);
  return lots.size() < first.size();
}

}  // namespace cagetol
