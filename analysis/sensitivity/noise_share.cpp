#include "analysis/sensitivity/noise_share.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/statistics/lot_variance.hpp"
#include "analysis/statistics/summary.hpp"

namespace cagetol {
namespace {

/// Fewer repeated rows say too little about the scatter within a row.
constexpr std::size_t kFewestRows = 8;

struct Row {
  double first = kUndefined;              ///< value of the first run
  double runs = 0, mean = 0, square = 0;  ///< sum of squares within the row
  std::int64_t lot = 0;
};

using Rows = std::map<std::int64_t, Row>;

Rows rows_of(const StudyData& study, std::span<const double> output) {
  Rows rows;
  for (std::size_t i = 0; i < study.size(); ++i) {
    if (std::isnan(output[i])) continue;
    Row& row = rows[study.row[i]];
    if (study.replicate[i] == 0) row.first = output[i];
    row.lot = study.lot[i];
    const double step = output[i] - row.mean;
    row.mean += step / ++row.runs;
    row.square += step * (output[i] - row.mean);
  }
  return rows;
}

/// H(share) times s_w^2.
double between(const Rows& rows, double share) {
  double sum = 0, sum_mean = 0, square = 0;
  const double centre = rows.begin()->second.mean;
  for (const auto& [number, row] : rows) {
    const double u = row.runs * share / (share + row.runs * (1 - share)), y = row.mean - centre;
    sum += u;
    sum_mean += u * y;
    square += u * y * y;
  }
  return (square - sum_mean * sum_mean / sum) / static_cast<double>(rows.size() - 1);
}

/// Share at which between() is `wanted`, 1 if it is less everywhere.
double share_at(const Rows& rows, double wanted) {
  double low = 0, high = 1;
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = (low + high) / 2;
    (between(rows, middle) < wanted ? low : high) = middle;
  }
  return high;
}

}  // namespace

NoiseShare noise_share(const StudyData& study, std::span<const double> output, double confidence) {
  const auto rows = rows_of(study, output);
  NoiseShare noise;
  std::vector<double> firsts;
  std::vector<std::size_t> lot_of;
  std::map<std::int64_t, std::size_t> lots;
  double square = 0, freedom = 0;
  for (const auto& [number, row] : rows) {
    noise.rows += row.runs > 1;
    square += row.square;
    freedom += row.runs - 1;
    firsts.push_back(row.first);
    lot_of.push_back(lots.try_emplace(row.lot, lots.size()).first->second);
  }
  if (noise.rows < kFewestRows) return noise;
  const std::vector<double> equal(rows.size(), 1.0);
  const auto count = static_cast<double>(rows.size()), lot_count = static_cast<double>(lots.size());
  const LotVariance variance = lot_variance(firsts, equal, lot_of);
  const double within = square / freedom, whole = variance.whole();
  if (!(whole > 0)) return noise;
  noise.standard_deviation = std::sqrt(within);
  noise.share.value = std::min(within / whole, 1.0);
  // With one row a lot the correlation has no weight.
  const double correlation = std::clamp(variance.of_lots / whole, 0.0, 1.0),
               more = count / lot_count - 1, common = more * correlation * correlation;
  const double rows_freedom = (count - 1) / (1 + common);
  // Between rows of common lots the mean square falls short of the whole variance.
  const double shortfall = std::pow(weighted_standard_deviation(firsts, equal), 2) / whole;
  const auto end = [&](double probability) {
    return share_at(rows,
                    within * shortfall * gsl_cdf_fdist_Pinv(probability, rows_freedom, freedom));
  };
  noise.share.lower = end(0.5 * (1 - confidence));
  noise.share.upper = end(0.5 * (1 + confidence));
  return noise;
}

}  // namespace cagetol
