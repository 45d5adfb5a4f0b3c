// Which share of cages jams at a tolerance, exactly or from many draws of the geometry alone.
//
// Room of a cage is an affine function of its deviations but for a small error delta, both measured
// on the study's own scene:
//   gap_j = base_j + sum_i c_i (s_i X_i + shift_i)      X_i of the lot, or of pocket j
// Where the deviations are independent and those of a gap are all normal but at most one,
//   P(jam) = 1 - E_lot prod_j (1 - P(gap_j <= 0 | lot))
// is integrated: the pockets in closed form, the lot by the trapezoidal rule over its normal
// number. Gaps of different places that share a deviation bound each other's error. Elsewhere (a
// copula, measured values, gaps that are not affine) kJamCages cages are drawn, the gaps within
// 4 delta of zero computed in full.
#pragma once

#include <optional>

#include "mc/study/cage_fit.hpp"
#include "mc/study/sample.hpp"
#include "src/input/key_table.hpp"

namespace cagetol {

/// Cages drawn where nothing is integrated.
inline constexpr long kJamCages = 1000000;
/// Largest error of an integral that is taken for exact: 1 ppm.
inline constexpr double kJamError = 1e-6;

/// By tolerance dimension: factors on the deviations of the study's laws, and the mean beside the
/// nominal value in the key's unit.
struct ScaledLaws {
  std::vector<double> lot, pocket, shift;
};

struct JamShare {
  double share = 0, error = 0;
};

class JamModel {
 public:
  explicit JamModel(const Study& study);

  /// Nothing where the study's laws or gaps allow no integral.
  std::optional<std::vector<JamShare>> integrated(const std::vector<ScaledLaws>& tolerances) const;
  /// From the same cages at every tolerance, the same ones in every study. Errors are standard
  /// errors.
  std::vector<JamShare> drawn(const std::vector<ScaledLaws>& tolerances, long cages) const;

 private:
  /// A varied input, and what each place loses by a unit of it.
  struct Input {
    std::size_t index = 0;  ///< in Study::inputs
    long dimension = -1;    ///< among the tolerance dimensions
    const Key<Scene>* key = nullptr;
    std::array<double, kGapPlaces> slope{};  ///< [m] for each unit of the key
  };
  /// Tolerances that are alike for a place, each once, and which of them each tolerance is.
  struct Levels {
    std::vector<ScaledLaws> laws;
    std::vector<std::size_t> of;
  };

  Levels levels(std::size_t place, const std::vector<ScaledLaws>& tolerances) const;
  double shift(std::size_t place, const ScaledLaws& laws) const;
  std::optional<JamShare> integral(std::size_t place, const ScaledLaws& laws) const;
  void measure_error();
  bool jams(std::size_t place, const ScaledLaws& laws, const Sample& cage) const;

  Study study_;
  std::vector<Input> inputs_;
  CageGaps base_;
  std::array<double, kGapPlaces> delta_{};
};

}  // namespace cagetol
