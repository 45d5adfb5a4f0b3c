#include "analysis/tolerance/jam_onset.hpp"

namespace cagetol {

JamOnset jam_onset(const JamCurve& curve, double target_yield) {
  JamOnset onset;
  const double allowed = 1 - target_yield;
  bool fits = true;
  for (std::size_t p = 0; p < curve.tolerance_width_mm.size(); ++p) {
    fits = fits && curve.share[p] == 0;
    if (fits) onset.free_mm = curve.tolerance_width_mm[p];
    if (curve.share[p] <= allowed || onset.limit_mm) continue;
    onset.limit_mm = curve.tolerance_width_mm[p];
    if (p == 0) continue;
    const double part = (allowed - curve.share[p - 1]) / (curve.share[p] - curve.share[p - 1]);
    *onset.limit_mm = curve.tolerance_width_mm[p - 1] +
                      part * (curve.tolerance_width_mm[p] - curve.tolerance_width_mm[p - 1]);
  }
  return onset;
}

}  // namespace cagetol
