#include "analysis/sensitivity/noise_share.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/statistics/order_statistics.hpp"
#include "analysis/statistics/summary.hpp"
#include "distributions/basics/random_stream.hpp"

namespace cagetol {
namespace {

/// Fewer repeated rows say too little about the scatter within a row.
constexpr std::size_t kFewestRows = 8;

struct Row {
  double first = kUndefined;       ///< value of the first run
  double square = 0, freedom = 0;  ///< sum of squares within the row
};

std::vector<Row> rows_of(const StudyData& study, std::span<const double> output) {
  std::map<std::int64_t, std::vector<double>> values;
  std::map<std::int64_t, double> first;
  for (std::size_t i = 0; i < study.size(); ++i) {
    if (std::isnan(output[i])) continue;
    values[study.row[i]].push_back(output[i]);
    if (study.replicate[i] == 0) first[study.row[i]] = output[i];
  }
  std::vector<Row> rows;
  for (const auto& [number, runs] : values) {
    Row row;
    const auto found = first.find(number);
    if (found != first.end()) row.first = found->second;
    double mean = 0;
    for (const double y : runs) mean += y / static_cast<double>(runs.size());
    for (const double y : runs) row.square += (y - mean) * (y - mean);
    row.freedom = static_cast<double>(runs.size()) - 1;
    rows.push_back(row);
  }
  return rows;
}

double within_variance(const std::vector<Row>& rows, std::span<const double> weights) {
  double square = 0, freedom = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    square += weights[i] * rows[i].square;
    freedom += weights[i] * rows[i].freedom;
  }
  return freedom > 0 ? square / freedom : kUndefined;
}

double share_of(const std::vector<Row>& rows, std::span<const double> firsts,
                std::span<const double> weights) {
  const double whole = weighted_standard_deviation(firsts, weights);
  if (!(whole > 0)) return kUndefined;
  const double share = within_variance(rows, weights) / (whole * whole);
  return std::isnan(share) ? share : std::min(share, 1.0);
}

}  // namespace

NoiseShare noise_share(const StudyData& study, std::span<const double> output, double confidence,
                       std::size_t resamples) {
  const auto rows = rows_of(study, output);
  NoiseShare noise;
  std::vector<double> firsts;
  for (const Row& row : rows) {
    noise.rows += row.freedom > 0;
    firsts.push_back(row.first);
  }
  if (noise.rows < kFewestRows) return noise;
  std::vector<double> weights(rows.size(), 1.0);
  noise.share.value = share_of(rows, firsts, weights);
  noise.standard_deviation = std::sqrt(within_variance(rows, weights));
  std::vector<double> results;
  for (std::size_t b = 0; b < resamples; ++b) {
    RandomStream stream(static_cast<std::uint64_t>(study.provenance.seed), Purpose::bootstrap, b,
                        stream_address("noise"));
    std::fill(weights.begin(), weights.end(), 0.0);
    for (std::size_t i = 0; i < rows.size(); ++i) weights[stream.next_index(rows.size())] += 1;
    results.push_back(share_of(rows, firsts, weights));
  }
  const std::vector<double> equal(results.size(), 1.0);
  const auto order = ascending_order(results);
  noise.share.lower = weighted_quantile(results, order, equal, 0.5 * (1 - confidence));
  noise.share.upper = weighted_quantile(results, order, equal, 0.5 * (1 + confidence));
  return noise;
}

}  // namespace cagetol
