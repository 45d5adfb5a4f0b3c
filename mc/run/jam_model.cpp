#include "mc/run/jam_model.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "mc/study/study_inputs.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

constexpr double kSmallestEffect = 1e-13;  ///< of an input on a gap [m]
constexpr long kProbes = 256;              ///< cages that delta is measured on
constexpr double kReach = 8.5;             ///< of a normal number, in integrals

/// A sum of independent deviations: the normal ones as one, and at most one other.
struct Sum {
  double mean = 0, sigma = 0;
  const Law* other = nullptr;
  double factor = 0;  ///< of the other
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
  double other_below(double x) const {
    return factor > 0 ? cdf(*other, x / factor) : 1 - cdf(*other, x / factor);
  }
  /// P(sum <= x).
  double below(double x) const {
    if (!other) return sigma > 0 ? gsl_cdf_gaussian_P(x - mean, sigma) : x >= mean;
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

std::vector<double> shifted(std::vector<double> gaps, double by) {
  for (double& gap : gaps) gap += by;
  return gaps;
}

Study geometry_of(const Study& study) {
  Study plain = study;
  plain.design = DesignKind::random;
  plain.seed = 0;
  plain.extra_replicates = 0;
  plain.cages_per_lot = 1;
  plain.redraw_jams = false;
  return plain;
}

}  // namespace

JamModel::JamModel(const Study& study) : study_(geometry_of(study)) {
  base_ = gaps_in_service(study_, study_.scene);
  std::vector<UncertainInput> varied;
  for (UncertainInput& input : study_.inputs) {
    Input of{varied.size(), -1, find_key(scene_keys(), input.key), {}};
    double widest = 1;
    const auto& dimensions = study_.tolerance.dimensions;
    for (std::size_t d = 0; d < dimensions.size(); ++d) {
      if (dimensions[d].key != input.key) continue;
      of.dimension = static_cast<long>(d);
      for (const Candidate& candidate : study_.candidates)
        widest = std::max(widest, candidate.scales[d]);
    }
    double step = 0;
    for (const auto* law : {&input.lot, &input.pocket, &input.noise})
      if (*law) step = std::hypot(step, widest * standard_deviation(**law));
    if (step == 0) continue;
    const auto gaps_at = [&](double deviation) {
      Scene scene = study_.scene;
      set_key_numbers(*of.key, shifted(input.nominal, deviation), scene);
      return gaps_in_service(study_, scene);
    };
    const CageGaps above = gaps_at(step), below = gaps_at(-step);
    bool matters = false;
    for (std::size_t place = 0; place < kGapPlaces; ++place) {
      if (base_[place].empty()) continue;
      const double change = (above[place][0] - below[place][0]) / 2;
      if (std::abs(change) < kSmallestEffect) continue;
      of.slope[place] = change / step;
      matters = true;
    }
    if (!matters) continue;
    varied.push_back(input);
    inputs_.push_back(of);
  }
  study_.inputs = varied;
  std::erase_if(study_.correlations, [&](const Correlation& pair) {
    return find_input_scope(varied, pair.first).input < 0 ||
           find_input_scope(varied, pair.second).input < 0;
  });
  measure_error();
}

void JamModel::measure_error() {
  Study probes = study_;
  probes.samples = std::max(kProbes, static_cast<long>(4 * study_.candidates.size()));
  const Sampler sampler(probes);
  for (long id = 0; id < probes.samples; ++id) {
    const Sample cage = sampler.draw(static_cast<std::uint64_t>(id));
    const CageGaps exact = gaps_in_service(study_, cage.scene);
    for (std::size_t place = 0; place < kGapPlaces; ++place)
      for (std::size_t j = 0; j < exact[place].size(); ++j) {
        double gap = base_[place][j];
        for (const Input& input : inputs_) {
          const auto& value = cage.inputs[input.index].value;
          const auto& nominal = study_.inputs[input.index].nominal;
          const auto of = [j](const auto& list) { return list[list.size() == 1 ? 0 : j]; };
          gap += input.slope[place] * (of(value) - of(nominal));
        }
        delta_[place] = std::max(delta_[place], std::abs(exact[place][j] - gap));
      }
  }
}

JamModel::Levels JamModel::levels(std::size_t place,
                                  const std::vector<ScaledLaws>& tolerances) const {
  Levels levels;
  std::map<std::vector<double>, std::size_t> known;
  for (const ScaledLaws& laws : tolerances) {
    std::vector<double> key;
    for (const Input& input : inputs_) {
      if (input.dimension < 0 || input.slope[place] == 0) continue;
      const auto d = static_cast<std::size_t>(input.dimension);
      key.insert(key.end(), {laws.lot[d], laws.pocket[d], laws.shift[d]});
    }
    const auto [found, fresh] = known.try_emplace(key, levels.laws.size());
    if (fresh) levels.laws.push_back(laws);
    levels.of.push_back(found->second);
  }
  return levels;
}

double JamModel::shift(std::size_t place, const ScaledLaws& laws) const {
  double shift = 0;
  for (const Input& input : inputs_)
    if (input.dimension >= 0)
      shift += input.slope[place] * laws.shift[static_cast<std::size_t>(input.dimension)];
  return shift;
}

std::optional<JamShare> JamModel::integral(std::size_t place, const ScaledLaws& laws) const {
  Sum lot, pocket;
  for (const Input& input : inputs_) {
    const UncertainInput& of = study_.inputs[input.index];
    const auto scale = [&](const std::vector<double>& scales) {
      return input.slope[place] *
             (input.dimension < 0 ? 1 : scales[static_cast<std::size_t>(input.dimension)]);
    };
    lot.add(of.lot, scale(laws.lot));
    lot.add(of.noise, input.slope[place]);
    pocket.add(of.pocket, scale(laws.pocket));
  }
  if (!lot.known || !pocket.known || (lot.other && lot.sigma > 0)) return std::nullopt;
  const auto gaps = shifted(base_[place], shift(place, laws));
  JamShare share = over_lots(gaps, lot, pocket);
  if (delta_[place] > kSmallestEffect)
    share.error += over_lots(shifted(gaps, -2 * delta_[place]), lot, pocket).share - share.share;
  return share;
}

std::optional<std::vector<JamShare>> JamModel::integrated(
    const std::vector<ScaledLaws>& tolerances) const {
  if (!study_.correlations.empty()) return std::nullopt;
  std::vector<JamShare> joint(tolerances.size());
  std::array<std::vector<double>, kGapPlaces> of_place;
  for (std::size_t place = 0; place < kGapPlaces; ++place) {
    if (base_[place].empty()) continue;
    const Levels levels = this->levels(place, tolerances);
    std::vector<JamShare> shares;
    for (const ScaledLaws& laws : levels.laws) {
      const auto share = integral(place, laws);
      if (!share) return std::nullopt;
      shares.push_back(*share);
    }
    for (std::size_t t = 0; t < tolerances.size(); ++t) {
      const JamShare& share = shares[levels.of[t]];
      joint[t].error += share.error;
      // Dependent gaps jam together by min(P, Q) at most, independent ones by P Q.
      for (std::size_t other = 0; other < place; ++other)
        if (!of_place[other].empty() &&
            std::any_of(inputs_.begin(), inputs_.end(), [&](const Input& input) {
              return input.slope[place] != 0 && input.slope[other] != 0;
            }))
          joint[t].error += std::min(share.share, of_place[other][t]);
      joint[t].share += share.share * (1 - joint[t].share);
      of_place[place].push_back(share.share);
    }
  }
  return joint;
}

bool JamModel::jams(std::size_t place, const ScaledLaws& laws, const Sample& cage) const {
  Scene scene = study_.scene;
  for (const Input& input : inputs_) {
    const DrawnInput& drawn = cage.inputs[input.index];
    const auto of = [&](const std::vector<double>& by, double otherwise) {
      return input.dimension < 0 ? otherwise : by[static_cast<std::size_t>(input.dimension)];
    };
    auto values = shifted(study_.inputs[input.index].nominal, of(laws.shift, 0));
    if (values.size() < drawn.value.size()) values.resize(drawn.value.size(), values[0]);
    for (std::size_t j = 0; j < values.size(); ++j) {
      if (!drawn.lot.empty()) values[j] += of(laws.lot, 1) * drawn.lot[0];
      if (!drawn.pocket.empty()) values[j] += of(laws.pocket, 1) * drawn.pocket[j];
      if (!drawn.noise.empty()) values[j] += drawn.noise[0];
    }
    set_key_numbers(*input.key, values, scene);
  }
  const auto gaps = gaps_in_service(study_, scene)[place];
  return *std::min_element(gaps.begin(), gaps.end()) <= 0;
}

std::vector<JamShare> JamModel::drawn(const std::vector<ScaledLaws>& tolerances, long cages) const {
  Study plain = study_;
  plain.samples = cages;
  plain.candidates.clear();
  plain.tolerance.dimensions.clear();
  const Sampler sampler(plain);
  std::array<Levels, kGapPlaces> of_place;
  std::array<std::vector<char>, kGapPlaces> jammed;
  for (std::size_t place = 0; place < kGapPlaces; ++place) {
    of_place[place] = levels(place, tolerances);
    jammed[place].assign(of_place[place].laws.size(), 0);
  }
  std::vector<long> count(tolerances.size(), 0);
  Sample cage;
  std::vector<double> gaps;
  for (long id = 0; id < cages; ++id) {
    sampler.draw_deviations(static_cast<std::uint64_t>(id), cage);
    bool any = false;
    for (std::size_t place = 0; place < kGapPlaces; ++place)
      for (std::size_t l = 0; !base_[place].empty() && l < jammed[place].size(); ++l) {
        const ScaledLaws& laws = of_place[place].laws[l];
        gaps = base_[place];
        double all = shift(place, laws);
        for (const Input& input : inputs_) {
          const double slope = input.slope[place];
          if (slope == 0) continue;
          const DrawnInput& drawn = cage.inputs[input.index];
          const auto scale = [&](const std::vector<double>& scales) {
            return slope *
                   (input.dimension < 0 ? 1 : scales[static_cast<std::size_t>(input.dimension)]);
          };
          if (!drawn.lot.empty()) all += scale(laws.lot) * drawn.lot[0];
          if (!drawn.noise.empty()) all += slope * drawn.noise[0];
          if (drawn.pocket.empty()) continue;
          const double by = scale(laws.pocket);
          for (std::size_t j = 0; j < gaps.size(); ++j) gaps[j] += by * drawn.pocket[j];
        }
        const double least = all + *std::min_element(gaps.begin(), gaps.end());
        jammed[place][l] =
            std::abs(least) <= 4 * delta_[place] ? jams(place, laws, cage) : least <= 0;
        any = any || jammed[place][l];
      }
    for (std::size_t t = 0; any && t < tolerances.size(); ++t)
      count[t] += std::any_of(jammed.begin(), jammed.end(), [&](const auto& levels) {
        return levels[of_place[static_cast<std::size_t>(&levels - jammed.data())].of[t]];
      });
  }
  std::vector<JamShare> shares;
  for (const long jams : count) {
    const double share = static_cast<double>(jams) / static_cast<double>(cages);
    shares.push_back({share, std::sqrt(share * (1 - share) / static_cast<double>(cages))});
  }
  return shares;
}

}  // namespace cagetol
