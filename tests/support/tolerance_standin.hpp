// Analytic stand-ins for tolerance studies: normal deviations of 13 pockets, yields known in closed
// form.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/study/study_data.hpp"

namespace cagetol {

struct StandinDimension {
  std::string key;                         ///< "cage.pocket_width_mm"
  double lot_sigma = 0, pocket_sigma = 0;  ///< at scale 1; 0: no such part
  std::vector<double> scales;              ///< candidates; tolerances are 0.1 mm times these
  std::vector<double> middles = {};        ///< of their zones [mm]; empty: about the nominal value
};

/// Deviations of one sample: lot and 13 pockets of each dimension.
struct StandinCage {
  std::vector<double> lot;
  std::vector<std::vector<double>> pocket;
};

/// A study over all candidate combinations whose only limit is quantity "badness" <= 0; `badness`
/// gives it.
StudyData tolerance_standin(std::int64_t rows, std::int64_t seed,
                            const std::vector<StandinDimension>& dimensions, double target_yield,
                            const std::function<double(const StandinCage&)>& badness,
                            std::int64_t cages_per_lot = 1);

/// A drawing of two dimensions: widths whose yields are widest_pocket_yield(), lengths that do
/// nothing.
extern const StandinDimension kPrintedWidth, kPrintedLength;

/// "badness" of a cage that fails when the widest of its 13 pockets exceeds 0.026 mm.
double widest_pocket(const StandinCage& cage);

/// Its yield, Phi(0.26 mm / tolerance)^13: at 0.036, 0.058, 0.09, 0.15 mm 1.0000, 0.99995, 0.9751,
/// 0.5731.
double widest_pocket_yield(double tolerance_width_mm);

}  // namespace cagetol
