#include "analysis/statistics/lot_variance.hpp"

#include <cmath>

namespace cagetol {

LotVariance residual_variance(std::span<const double> residuals, std::span<const double> weights,
                              std::span<const std::size_t> lot_of, double fitted,
                              double fitted_in_lots) {
  struct Lot {
    double weight = 0, runs = 0, sum = 0;
  };
  std::vector<Lot> lots(residuals.size());
  double squares = 0, runs = 0, within = 0, freedom = 0;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (weights[i] == 0 || std::isnan(residuals[i])) continue;
    Lot& lot = lots[lot_of[i]];
    lot = {weights[i], lot.runs + 1, lot.sum + residuals[i]};
    squares += weights[i] * residuals[i] * residuals[i];
    runs += weights[i];
  }
  within = squares;
  for (const Lot& lot : lots) {
    if (lot.runs == 0) continue;
    within -= lot.weight * lot.sum * lot.sum / lot.runs;
    freedom += lot.weight * (lot.runs - 1);
  }
  within = freedom > 0 ? within / freedom : 0;
  const double left = runs - fitted_in_lots;
  return {within, left < 1 ? kUndefined : (squares - within * (runs - fitted)) / left};
}

LotVariance lot_variance(std::span<const double> values, std::span<const double> weights,
                         std::span<const std::size_t> lot_of) {
  std::vector<double> centred(values.begin(), values.end()), seen(values.size());
  double sum = 0, runs = 0, in_lots = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (weights[i] == 0 || std::isnan(values[i])) continue;
    sum += weights[i] * values[i];
    runs += weights[i];
    in_lots += weights[i] * (2 * seen[lot_of[i]]++ + 1);  // sums up to squared runs of each lot
  }
  for (double& value : centred) value -= sum / runs;
  return residual_variance(centred, weights, lot_of, 1, in_lots / runs);
}

}  // namespace cagetol
