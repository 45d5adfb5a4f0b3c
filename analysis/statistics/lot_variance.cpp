#include "analysis/statistics/lot_variance.hpp"

#include <cmath>

namespace cagetol {

Lots lots_of(const Resampling& resampling) {
  const auto& of = resampling.lot_of();
  return resampling.lots() < of.size() ? Lots{resampling.lots(), of} : Lots{};
}

RunVariance residual_variance(std::span<const double> residuals, std::span<const double> weights,
                              const Lots& lots, double fitted, double fitted_in_lots) {
  struct Lot {
    double weight = 0, runs = 0, sum = 0;
  };
  std::vector<Lot> of_lot(lots.count);
  double squares = 0, runs = 0;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (weights[i] == 0 || std::isnan(residuals[i])) continue;
    squares += weights[i] * residuals[i] * residuals[i];
    runs += weights[i];
    if (lots.count == 0) continue;
    Lot& lot = of_lot[lots.of[i]];
    lot.weight = weights[i];
    lot.runs += 1;
    lot.sum += residuals[i];
  }
  double within = squares, freedom = runs;
  for (const Lot& lot : of_lot) {
    if (lot.runs == 0) continue;
    within -= lot.weight * lot.sum * lot.sum / lot.runs;
    freedom -= lot.weight;
  }
  within = lots.count > 0 && freedom > 0 ? within / freedom : 0;
  const double left = runs - fitted_in_lots;
  if (left < 1) return {};
  return {within, (squares - within * (runs - fitted)) / left};
}

RunVariance run_variance(std::span<const double> values, std::span<const double> weights,
                         const Lots& lots) {
  std::vector<double> centred(values.begin(), values.end()), of_lot(lots.count);
  double sum = 0, runs = 0, in_lots = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (weights[i] == 0 || std::isnan(values[i])) continue;
    sum += weights[i] * values[i];
    runs += weights[i];
    // The sum over lots of weight times squared runs, one run at a time.
    in_lots += weights[i] * (lots.count == 0 ? 1 : 2 * of_lot[lots.of[i]]++ + 1);
  }
  for (double& value : centred) value -= sum / runs;
  return residual_variance(centred, weights, lots, 1, in_lots / runs);
}

}  // namespace cagetol
