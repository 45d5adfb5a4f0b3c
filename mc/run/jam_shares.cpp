#include "mc/run/jam_shares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mc/run/jam_model.hpp"
#include "src/input/unit.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kPoints = 65;
/// Narrowest tolerance of a curve, as a share of the narrowest candidate.
constexpr double kNarrowestJamTolerance = 0.5;

std::vector<ScaledLaws> laws_of_candidates(const Study& study) {
  std::vector<ScaledLaws> all;
  for (const Candidate& candidate : study.candidates) {
    all.push_back({candidate.scales, candidate.scales, candidate.shifts});
    all.back().shift.resize(candidate.scales.size());
  }
  return all;
}

/// The points of one curve for each dimension.
void add_curves(const Study& study, std::vector<JamCurve>& curves, std::vector<ScaledLaws>& all) {
  std::vector<double> narrowest = study.candidates.front().scales, widest = narrowest;
  for (const Candidate& candidate : study.candidates) {
    for (std::size_t d = 0; d < narrowest.size(); ++d) {
      narrowest[d] = std::min(narrowest[d], candidate.scales[d]);
      widest[d] = std::max(widest[d], candidate.scales[d]);
    }
  }
  for (std::size_t d = 0; d < narrowest.size(); ++d) {
    JamCurve curve{study.tolerance.dimensions[d].key, {}, {}};
    const double ratio = kWidestJamTolerance * widest[d] / (kNarrowestJamTolerance * narrowest[d]);
    for (std::size_t p = 0; p < kPoints; ++p) {
      auto point = narrowest;
      point[d] *= kNarrowestJamTolerance * std::pow(ratio, static_cast<double>(p) / (kPoints - 1));
      curve.tolerance_width_mm.push_back(point[d] *
                                         study.tolerance.dimensions[d].tolerance_width_mm);
      all.push_back({point, point, std::vector<double>(point.size())});
    }
    curves.push_back(std::move(curve));
  }
}

/// Four for each candidate and dimension: off centre to either side, all variance among pockets,
/// all from cage to cage.
void add_variants(const Study& study, std::vector<ScaledLaws>& all) {
  for (std::size_t k = 0; k < study.candidates.size(); ++k)
    for (std::size_t d = 0; d < study.tolerance.dimensions.size(); ++d) {
      const auto& key = study.tolerance.dimensions[d].key;
      const UncertainInput& input =
          *std::find_if(study.inputs.begin(), study.inputs.end(),
                        [&](const UncertainInput& of) { return of.key == key; });
      const double off = from_si(
          to_si(kOffCentre * study.candidates[k].tolerance_widths_mm[d], 1e-3), unit_of(key).to_si);
      const double lot = input.lot ? standard_deviation(*input.lot) : 0,
                   pocket = input.pocket ? standard_deviation(*input.pocket) : 0;
      for (const double side : {-1, 1}) {
        all.push_back(all[k]);
        all.back().shift[d] += side * off;
      }
      for (const bool lots : {false, true}) {
        all.push_back(all[k]);
        all.back().lot[d] *= lots && lot > 0 ? std::hypot(lot, pocket) / lot : 0;
        all.back().pocket[d] *= !lots && pocket > 0 ? std::hypot(lot, pocket) / pocket : 0;
        if (lot == 0 || pocket == 0) all.back() = all[k];
      }
    }
}

}  // namespace

JamShares jam_shares(const Study& study) {
  JamShares jams;
  if (study.candidates.empty() || study.scene.allow_interference) return jams;
  std::vector<ScaledLaws> all = laws_of_candidates(study);
  const std::size_t candidates = all.size();
  add_variants(study, all);
  add_curves(study, jams.curves, all);
  const JamModel model(study);
  auto shares = model.integrated(all);
  if (!shares || std::any_of(shares->begin(), shares->begin() + candidates,
                             [](const JamShare& of) { return of.error > kJamError; })) {
    shares = model.drawn(all, kJamCages);
    jams.draws = kJamCages;
  }
  auto next = shares->begin();
  for (std::size_t k = 0; k < candidates; ++k, ++next) {
    jams.candidate.push_back(next->share);
    jams.error.push_back(next->error);
  }
  for (std::size_t k = 0; k < candidates * study.tolerance.dimensions.size(); ++k, next += 4) {
    jams.off_centre.push_back(std::max(next[0].share, next[1].share));
    jams.pockets_alone.push_back(next[2].share);
    jams.lots_alone.push_back(next[3].share);
  }
  for (JamCurve& curve : jams.curves)
    for (std::size_t p = 0; p < curve.tolerance_width_mm.size(); ++p)
      curve.share.push_back((next++)->share);
  return jams;
}

}  // namespace cagetol
