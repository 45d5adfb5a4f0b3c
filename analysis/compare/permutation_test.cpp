#include "analysis/compare/permutation_test.hpp"

#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <utility>

namespace cagetol {
namespace {

constexpr std::int64_t kMostDraws = 49'999, kEnough = 20;

struct Sum {
  double value = 0, count = 0;
};
using Sums = std::map<std::int64_t, Sum>;

/// A value of the samples, 0 where they have none.
double some_value(const ClusteredValues& before, const ClusteredValues& after) {
  for (const auto* sample : {&before, &after})
    for (const double value : sample->value)
      if (!std::isnan(value)) return value;
  return 0;
}

/// Sums of the values less `reference`: those of a quantity that never varies are 0, not the
/// rounding of their sums, by which one half would always differ from the other.
Sums cluster_sums(const ClusteredValues& sample, double reference) {
  Sums sums;
  for (std::size_t i = 0; i < sample.value.size(); ++i) {
    if (std::isnan(sample.value[i])) continue;
    Sum& sum = sums[sample.cluster[i]];
    sum.value += sample.value[i] - reference;
    sum.count += 1;
  }
  return sums;
}

Sum total(const std::vector<Sum>& sums) {
  Sum all;
  for (const Sum& sum : sums) all.value += sum.value, all.count += sum.count;
  return all;
}

/// `difference` of a fresh draw against the one seen.
double sequential_p_value(double seen, const std::function<double()>& difference) {
  const double minimum = seen * (1 - 1e-9);  // equal but for rounding is equal
  std::int64_t extreme = 0;
  for (std::int64_t draw = 1; draw <= kMostDraws; ++draw) {
    extreme += difference() >= minimum;
    if (extreme == kEnough) return static_cast<double>(kEnough) / static_cast<double>(draw);
  }
  return static_cast<double>(extreme + 1) / static_cast<double>(kMostDraws + 1);
}

/// Pairs change sides: what a pair adds to the difference of the means changes its sign.
double paired_p_value(const Sums& before, const Sums& after, std::mt19937_64& random) {
  Sum old_sum, new_sum;
  std::vector<std::pair<double, double>> pairs;
  for (const auto& [label, sum] : after) {
    const auto partner = before.find(label);
    if (partner == before.end()) continue;
    pairs.emplace_back(partner->second.value, sum.value);
    old_sum.count += partner->second.count;
    new_sum.count += sum.count;
  }
  if (pairs.size() < 2) return 1;
  std::vector<double> changes;
  double seen = 0;
  for (const auto& [old_value, new_value] : pairs) {
    changes.push_back(new_value / new_sum.count - old_value / old_sum.count);
    seen += changes.back();
  }
  return sequential_p_value(std::abs(seen), [&] {
    double sum = 0;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < changes.size(); ++i, bits >>= 1) {
      if (i % 64 == 0) bits = random();
      sum += bits & 1 ? changes[i] : -changes[i];
    }
    return std::abs(sum);
  });
}

double unpaired_p_value(const Sums& before, const Sums& after, std::mt19937_64& random) {
  if (before.size() < 2 || after.size() < 2) return 1;
  std::vector<Sum> all;
  for (const auto* sums : {&before, &after})
    for (const auto& [label, sum] : *sums) all.push_back(sum);
  const Sum whole = total(all);
  const double centre = whole.value / whole.count;
  for (Sum& sum : all) sum.value -= centre * sum.count;  // spares cancellation
  const auto difference = [&](double value, double count) {
    return std::abs(value / count + value / (whole.count - count));
  };
  Sum old_sum;
  for (std::size_t i = 0; i < before.size(); ++i)
    old_sum.value += all[i].value, old_sum.count += all[i].count;
  const double seen = difference(old_sum.value, old_sum.count);
  const std::size_t dealt = std::min(before.size(), after.size());
  return sequential_p_value(seen, [&] {
    Sum drawn;
    for (std::size_t i = 0; i < dealt; ++i) {  // the start of a shuffle
      const auto left = static_cast<std::uint64_t>(all.size() - i);
      std::swap(all[i], all[i + ((random() >> 32) * left >> 32)]);
      drawn.value += all[i].value;
      drawn.count += all[i].count;
    }
    return difference(drawn.value, drawn.count);
  });
}

}  // namespace

double permutation_p_value(const ClusteredValues& before, const ClusteredValues& after, bool paired,
                           std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const double reference = some_value(before, after);
  const Sums old_sums = cluster_sums(before, reference), new_sums = cluster_sums(after, reference);
  return paired ? paired_p_value(old_sums, new_sums, random)
                : unpaired_p_value(old_sums, new_sums, random);
}

}  // namespace cagetol
