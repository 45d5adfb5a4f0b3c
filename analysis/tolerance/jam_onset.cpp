#include "analysis/tolerance/jam_onset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cagetol {
namespace {
constexpr double kNone = 1e-9;  // of drawn cages may be 0
}

double share_of_jams(const JamCurve& curve, double tolerance_width_mm) {
  const auto& width = curve.tolerance_width_mm;
  if (width.empty()) return 0;
  const auto next = std::upper_bound(width.begin(), width.end(), tolerance_width_mm);
  if (next == width.begin()) return curve.share.front();
  if (next == width.end()) return curve.share.back();
  const auto p = static_cast<std::size_t>(next - width.begin());
  const double before = std::log(std::max(curve.share[p - 1], kNone)),
               after = std::log(std::max(curve.share[p], kNone));
  return std::exp(before + (after - before) * (tolerance_width_mm - width[p - 1]) /
                               (width[p] - width[p - 1]));
}

std::optional<double> tolerance_of_jams(const JamCurve& curve, double most) {
  const auto& share = curve.share;
  const auto first = std::find_if(share.begin(), share.end(), [&](double s) { return s > most; });
  if (first == share.end()) return std::nullopt;
  const auto p = static_cast<std::size_t>(first - share.begin());
  const auto& width = curve.tolerance_width_mm;
  if (p == 0) return width[0];
  const double before = std::log(std::max(share[p - 1], kNone));
  const double part = (std::log(most) - before) / (std::log(share[p]) - before);
  return width[p - 1] + std::clamp(part, 0.0, 1.0) * (width[p] - width[p - 1]);
}

std::string jam_text(double share, double draws) {
  const double least = draws > 0 ? 3 / draws : 1e-8;
  if (share == 0 || (draws == 0 && share < least))
    return fmt::format("less than {:.2g} ppm", 1e6 * least);
  return share < 1e-4 ? fmt::format("{:.2g} ppm", 1e6 * share)
                      : fmt::format("{:.3g} %", 100 * share);
}

JamOnset jam_onset(const JamCurve& curve, double target_yield) {
  constexpr double kPpm = 1e-6;
  JamOnset onset{std::nullopt, tolerance_of_jams(curve, 1 - target_yield)};
  if (!curve.share.empty() && curve.share[0] <= kPpm)
    onset.ppm_mm = tolerance_of_jams(curve, kPpm).value_or(curve.tolerance_width_mm.back());
  return onset;
}

}  // namespace cagetol
