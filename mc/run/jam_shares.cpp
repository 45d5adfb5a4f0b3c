#include "mc/run/jam_shares.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "mc/study/cage_fit.hpp"
#include "mc/study/sample.hpp"
#include "mc/study/study_inputs.hpp"
#include "src/input/unit.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

constexpr double kJamError = 1e-6;   ///< largest of an integral that is taken for exact
constexpr long kProbes = 256;        ///< cages that delta is measured on
constexpr double kReach = 8.5;       ///< of a normal number, in integrals
constexpr std::size_t kPoints = 65;  ///< of a curve
/// Narrowest tolerance of a curve, as a share of the narrowest candidate.
constexpr double kNarrowestJamTolerance = 0.5;

/// By tolerance dimension: factors on the deviations of the study's laws, and the mean beside the
/// nominal value in the key's unit.
struct ScaledLaws {
  std::vector<double> lot, pocket, shift;
};

struct JamShare {
  double share = 0, error = 0;
};

struct Geometry {
  Study study;  ///< its inputs are those that matter
  std::vector<GapSlopes> slopes;
  std::vector<long> dimension;  ///< of each input among the tolerances, or -1
  CageGaps base;
  GapSlopes delta{};

  double scale(std::size_t i, const std::vector<double>& scales) const {
    return dimension[i] < 0 ? 1 : scales[static_cast<std::size_t>(dimension[i])];
  }
  double factor(std::size_t i, std::size_t place, const std::vector<double>& scales) const {
    return slopes[i][place] * scale(i, scales);
  }
  double shift(std::size_t place, const ScaledLaws& laws) const {
    double shift = 0;
    for (std::size_t i = 0; i < slopes.size(); ++i)
      if (dimension[i] >= 0) shift += factor(i, place, laws.shift);
    return shift;
  }
};

std::vector<double> shifted(std::vector<double> values, double by) {
  for (double& value : values) value += by;
  return values;
}

void measure_slopes(const std::vector<UncertainInput>& inputs, Geometry& geometry) {
  const Study& study = geometry.study;
  const auto& dimensions = study.tolerance.dimensions;
  for (const UncertainInput& input : inputs) {
    const auto found = std::find_if(dimensions.begin(), dimensions.end(),
                                    [&](const auto& of) { return of.key == input.key; });
    const long d = found == dimensions.end() ? -1 : found - dimensions.begin();
    const GapSlopes slopes = gap_slopes(study, input);
    if (slopes == GapSlopes{}) continue;
    geometry.study.inputs.push_back(input);
    geometry.slopes.push_back(slopes);
    geometry.dimension.push_back(d);
  }
}

void measure_delta(Geometry& geometry) {
  Study probes = geometry.study;
  probes.samples = std::max(kProbes, static_cast<long>(4 * probes.candidates.size()));
  const Sampler sampler(probes);
  for (long id = 0; id < probes.samples; ++id) {
    const Sample cage = sampler.draw(static_cast<std::uint64_t>(id));
    const CageGaps exact = gaps_in_service(probes, cage.scene);
    for (std::size_t place = 0; place < kGapPlaces; ++place)
      for (std::size_t j = 0; j < exact[place].size(); ++j) {
        double gap = geometry.base[place][j];
        const auto of = [j](const auto& list) { return list[list.size() == 1 ? 0 : j]; };
        for (std::size_t i = 0; i < cage.inputs.size(); ++i)
          gap +=
              geometry.slopes[i][place] * (of(cage.inputs[i].value) - of(probes.inputs[i].nominal));
        geometry.delta[place] = std::max(geometry.delta[place], std::abs(exact[place][j] - gap));
      }
  }
}

Geometry geometry_of(const Study& study) {
  Geometry geometry{study, {}, {}, gaps_in_service(study, study.scene)};
  Study& plain = geometry.study;
  plain.design = DesignKind::random;
  plain.seed = 0;
  plain.extra_replicates = 0;
  plain.cages_per_lot = 1;
  plain.redraw_jams = false;
  plain.inputs.clear();
  measure_slopes(study.inputs, geometry);
  std::erase_if(plain.correlations, [&](const Correlation& pair) {
    return find_input_scope(plain.inputs, pair.first).input < 0 ||
           find_input_scope(plain.inputs, pair.second).input < 0;
  });
  measure_delta(geometry);
  return geometry;
}

/// A sum of independent deviations: the normal ones as one, and at most one other.
struct Sum {
  double mean = 0, sigma = 0, factor = 0;  ///< factor of the other
  const Law* other = nullptr;
  bool known = true;

  void add(const std::optional<Law>& law, double by) {
    if (!law || by == 0) return;
    const double deviation = standard_deviation(*law);
    if (deviation == 0 || std::holds_alternative<Normal>(*law) ||
        std::holds_alternative<Capability>(*law)) {
      mean += by * cagetol::mean(*law);
      sigma = std::hypot(sigma, by * deviation);
    } else {
      known = known && other == nullptr && !std::holds_alternative<Empirical>(*law);
      other = &*law;
      factor = by;
    }
  }
  double deviation() const {
    return other ? std::hypot(sigma, factor * standard_deviation(*other)) : sigma;
  }
  /// The value at a normal number, where one law has it all.
  double at(double z) const {
    return mean + (other ? factor * quantile(*other, gsl_cdf_ugaussian_P(z)) : sigma * z);
  }
  /// P(sum <= x).
  double below(double x) const {
    if (!other) return sigma > 0 ? gsl_cdf_gaussian_P(x - mean, sigma) : x >= mean;
    const auto other_below = [&](double y) {
      return factor > 0 ? cdf(*other, y / factor) : 1 - cdf(*other, y / factor);
    };
    if (sigma == 0) return other_below(x - mean);
    constexpr double step = 0.125;
    double sum = 0;
    for (double z = -kReach; z <= kReach; z += step)
      sum += step * gsl_ran_ugaussian_pdf(z) * other_below(x - mean - sigma * z);
    return std::min(sum, 1.0);
  }
};

/// Share of cages with a gap <= 0 when the lot adds `lot` to all of them.
double jam_of_lot(const std::vector<double>& gaps, const Sum& pocket, double lot) {
  double log_fits = 0, gap = NAN, log_fit = 0;
  for (const double next : gaps) {
    if (next != gap) log_fit = std::log1p(-pocket.below(-next - lot));
    gap = next;
    log_fits += log_fit;
  }
  return -std::expm1(log_fits);
}

/// Over the lot, and its change when every other point is left out.
JamShare over_lots(const std::vector<double>& gaps, const Sum& lot, const Sum& pocket) {
  if (lot.deviation() == 0) return {jam_of_lot(gaps, pocket, lot.mean), 0};
  if (pocket.deviation() == 0)
    return {lot.below(-*std::min_element(gaps.begin(), gaps.end()) - pocket.mean), 0};
  const double sharpness = pocket.deviation() / lot.deviation() / 4;
  const long half = std::lround(kReach / std::clamp(sharpness, 1.0 / 512, 1.0 / 16) / 2);
  const double step = kReach / static_cast<double>(2 * half);
  double even = 0, odd = 0;
  for (long k = -2 * half; k <= 2 * half; ++k) {
    const double z = step * static_cast<double>(k);
    (k % 2 == 0 ? even : odd) +=
        step * gsl_ran_ugaussian_pdf(z) * jam_of_lot(gaps, pocket, lot.at(z));
  }
  return {even + odd, std::abs(even - odd)};
}

/// Nothing where the laws allow no integral.
std::optional<JamShare> integral(const Geometry& geometry, std::size_t place,
                                 const ScaledLaws& laws) {
  Sum lot, pocket;
  for (std::size_t i = 0; i < geometry.slopes.size(); ++i) {
    const UncertainInput& input = geometry.study.inputs[i];
    lot.add(input.lot, geometry.factor(i, place, laws.lot));
    lot.add(input.noise, geometry.slopes[i][place]);
    pocket.add(input.pocket, geometry.factor(i, place, laws.pocket));
  }
  if (!lot.known || !pocket.known || (lot.other && lot.sigma > 0)) return std::nullopt;
  const auto gaps = shifted(geometry.base[place], geometry.shift(place, laws));
  JamShare share = over_lots(gaps, lot, pocket);
  const double delta = 2 * geometry.delta[place];
  if (delta > kSmallestEffect)
    share.error += over_lots(shifted(gaps, -delta), lot, pocket).share - share.share;
  return share;
}

std::optional<std::vector<JamShare>> integrals(const Geometry& geometry,
                                               const std::vector<ScaledLaws>& tolerances) {
  if (!geometry.study.correlations.empty()) return std::nullopt;
  std::vector<JamShare> joint;
  for (const ScaledLaws& laws : tolerances) {
    JamShare& all = joint.emplace_back();
    std::array<double, kGapPlaces> share{};
    for (std::size_t place = 0; place < kGapPlaces; ++place) {
      if (geometry.base[place].empty()) continue;
      const auto own = integral(geometry, place, laws);
      if (!own) return std::nullopt;
      share[place] = own->share;
      all.error += own->error;
      all.share += own->share * (1 - all.share);
      // Dependent gaps jam together by min(P, Q) at most, independent ones by P Q.
      for (std::size_t other = 0; other < place; ++other)
        if (std::any_of(
                geometry.slopes.begin(), geometry.slopes.end(),
                [&](const GapSlopes& slopes) { return slopes[place] != 0 && slopes[other] != 0; }))
          all.error += std::min(share[place], share[other]);
    }
  }
  return joint;
}

/// Tolerances that are alike for a place, each once, and which of them each tolerance is.
struct Levels {
  std::vector<ScaledLaws> laws;
  std::vector<std::size_t> of;
  std::vector<char> jammed;
};

Levels levels_of(const Geometry& geometry, std::size_t place,
                 const std::vector<ScaledLaws>& tolerances) {
  Levels levels;
  std::map<std::vector<double>, std::size_t> known;
  for (const ScaledLaws& laws : tolerances) {
    std::vector<double> key;
    for (std::size_t i = 0; i < geometry.slopes.size(); ++i)
      for (const auto* by : {&laws.lot, &laws.pocket, &laws.shift})
        key.push_back(geometry.factor(i, place, *by));
    const auto [found, fresh] = known.try_emplace(key, levels.laws.size());
    if (fresh) levels.laws.push_back(laws);
    levels.of.push_back(found->second);
  }
  levels.jammed.resize(levels.laws.size());
  return levels;
}

/// Least room of a drawn cage under the laws.
double least_gap(const Geometry& geometry, std::size_t place, const ScaledLaws& laws,
                 const Sample& cage, std::vector<double>& gaps) {
  gaps = geometry.base[place];
  double all = geometry.shift(place, laws);
  for (std::size_t i = 0; i < geometry.slopes.size(); ++i) {
    const double slope = geometry.slopes[i][place];
    if (slope == 0) continue;
    const DrawnInput& drawn = cage.inputs[i];
    if (!drawn.lot.empty()) all += geometry.factor(i, place, laws.lot) * drawn.lot[0];
    if (!drawn.noise.empty()) all += slope * drawn.noise[0];
    if (drawn.pocket.empty()) continue;
    const double by = geometry.factor(i, place, laws.pocket);
    for (std::size_t j = 0; j < gaps.size(); ++j) gaps[j] += by * drawn.pocket[j];
  }
  return all + *std::min_element(gaps.begin(), gaps.end());
}

/// Whether a drawn cage jams under the laws, computed in full.
bool jams_at(const Geometry& geometry, std::size_t place, const ScaledLaws& laws,
             const Sample& cage) {
  Scene scene = geometry.study.scene;
  for (std::size_t i = 0; i < geometry.slopes.size(); ++i) {
    if (geometry.slopes[i][place] == 0) continue;
    const UncertainInput& input = geometry.study.inputs[i];
    const DrawnInput& drawn = cage.inputs[i];
    double all = geometry.dimension[i] < 0 ? 0 : geometry.scale(i, laws.shift);
    if (!drawn.lot.empty()) all += geometry.scale(i, laws.lot) * drawn.lot[0];
    if (!drawn.noise.empty()) all += drawn.noise[0];
    std::vector<double> values(drawn.value.size(), input.nominal[0]);
    if (input.nominal.size() > 1) values = input.nominal;
    values = shifted(values, all);
    for (std::size_t j = 0; j < drawn.pocket.size(); ++j)
      values[j] += geometry.scale(i, laws.pocket) * drawn.pocket[j];
    set_key_numbers(*find_key(scene_keys(), input.key), values, scene);
  }
  const auto gaps = gaps_in_service(geometry.study, scene)[place];
  return *std::min_element(gaps.begin(), gaps.end()) <= 0;
}

/// From the same cages at every tolerance. Errors are standard errors.
std::vector<JamShare> drawn(const Geometry& geometry, const std::vector<ScaledLaws>& tolerances,
                            long cages) {
  Study plain = geometry.study;
  plain.samples = cages;
  plain.candidates.clear();
  plain.tolerance.dimensions.clear();
  const Sampler sampler(plain);
  std::vector<Levels> places(kGapPlaces);
  for (std::size_t place = 0; place < kGapPlaces; ++place)
    if (!geometry.base[place].empty()) places[place] = levels_of(geometry, place, tolerances);
  std::vector<long> count(tolerances.size(), 0);
  Sample cage;
  std::vector<double> gaps;
  for (long id = 0; id < cages; ++id) {
    sampler.draw_deviations(static_cast<std::uint64_t>(id), cage);
    for (std::size_t place = 0; place < kGapPlaces; ++place)
      for (std::size_t l = 0; l < places[place].laws.size(); ++l) {
        const ScaledLaws& laws = places[place].laws[l];
        const double least = least_gap(geometry, place, laws, cage, gaps);
        places[place].jammed[l] = std::abs(least) <= 4 * geometry.delta[place]
                                      ? jams_at(geometry, place, laws, cage)
                                      : least <= 0;
      }
    for (std::size_t t = 0; t < tolerances.size(); ++t)
      count[t] += std::any_of(places.begin(), places.end(), [t](const Levels& place) {
        return !place.of.empty() && place.jammed[place.of[t]];
      });
  }
  std::vector<JamShare> shares;
  for (const long jams : count) {
    const double share = static_cast<double>(jams) / static_cast<double>(cages);
    shares.push_back({share, std::sqrt(share * (1 - share) / static_cast<double>(cages))});
  }
  return shares;
}

std::vector<ScaledLaws> laws_of_candidates(const Study& study) {
  std::vector<ScaledLaws> all;
  for (const Candidate& candidate : study.candidates) {
    all.push_back({candidate.scales, candidate.scales, candidate.all_shifts()});
  }
  return all;
}

/// Where the zone of a dimension lies at another width: as that of the candidate of nearest width.
double middle_at(const Study& study, std::size_t d, double scale) {
  const auto away = [&](const Candidate& of) { return std::abs(std::log(of.scales[d] / scale)); };
  const Candidate& nearest = *std::ranges::min_element(study.candidates, {}, away);
  return nearest.middle(d) / nearest.scales[d] * scale;
}

/// The points of one curve for each dimension.
void add_curves(const Study& study, std::vector<JamCurve>& curves, std::vector<ScaledLaws>& all) {
  std::vector<double> narrowest = study.candidates.front().scales, widest = narrowest;
  for (const Candidate& candidate : study.candidates)
    for (std::size_t d = 0; d < narrowest.size(); ++d) {
      narrowest[d] = std::min(narrowest[d], candidate.scales[d]);
      widest[d] = std::max(widest[d], candidate.scales[d]);
    }
  for (std::size_t d = 0; d < narrowest.size(); ++d) {
    const ToleranceDimension& dimension = study.tolerance.dimensions[d];
    JamCurve curve{dimension.key, {}, {}};
    const double least = kNarrowestJamTolerance * narrowest[d],
                 ratio = kWidestJamTolerance * widest[d] / least;
    for (std::size_t p = 0; p < kPoints; ++p) {
      auto point = narrowest;
      point[d] = least * std::pow(ratio, static_cast<double>(p) / (kPoints - 1));
      curve.tolerance_width_mm.push_back(point[d] * dimension.tolerance_width_mm);
      all.push_back({point, point, {}});
      for (std::size_t i = 0; i < point.size(); ++i)
        all.back().shift.push_back(middle_at(study, i, point[i]));
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
      const double off = kOffCentre * study.candidates[k].tolerance_widths_mm[d] * 1e-3;
      for (const double side : {-1, 1}) {
        all.push_back(all[k]);
        all.back().shift[d] += side * from_si(off, unit_of(key).to_si);
      }
      const double lot = input.lot ? standard_deviation(*input.lot) : 0,
                   pocket = input.pocket ? standard_deviation(*input.pocket) : 0;
      const bool both = lot > 0 && pocket > 0;
      all.push_back(all[k]);
      if (both) all.back().lot[d] = 0, all.back().pocket[d] *= std::hypot(lot, pocket) / pocket;
      all.push_back(all[k]);
      if (both) all.back().pocket[d] = 0, all.back().lot[d] *= std::hypot(lot, pocket) / lot;
    }
}

}  // namespace

JamShares jam_shares(const Study& study) {
  JamShares jams;
  if (study.candidates.empty() || study.scene.allow_interference || !study.scale_lots) return jams;
  std::vector<ScaledLaws> all = laws_of_candidates(study);
  const auto candidates = static_cast<std::ptrdiff_t>(all.size());
  add_variants(study, all);
  add_curves(study, jams.curves, all);
  const Geometry geometry = geometry_of(study);
  auto shares = integrals(geometry, all);
  if (!shares || std::any_of(shares->begin(), shares->begin() + candidates,
                             [](const JamShare& of) { return of.error > kJamError; })) {
    shares = drawn(geometry, all, kJamCages);
    jams.draws = kJamCages;
  }
  auto next = shares->begin();
  for (; next < shares->begin() + candidates; ++next) {
    jams.candidate.push_back(next->share);
    jams.error.push_back(next->error);
  }
  for (const auto end = shares->end() - static_cast<std::ptrdiff_t>(jams.curves.size() * kPoints);
       next < end; next += 4) {
    jams.off_centre.push_back(std::max(next[0].share, next[1].share));
    jams.pockets_alone.push_back(next[2].share);
    jams.lots_alone.push_back(next[3].share);
  }
  for (JamCurve& curve : jams.curves)
    for (std::size_t p = 0; p < kPoints; ++p) curve.share.push_back((next++)->share);
  return jams;
}

std::vector<double> drawn_jam_shares(const Study& study, long cages) {
  std::vector<double> shares;
  for (const JamShare& of : drawn(geometry_of(study), laws_of_candidates(study), cages))
    shares.push_back(of.share);
  return shares;
}

}  // namespace cagetol
