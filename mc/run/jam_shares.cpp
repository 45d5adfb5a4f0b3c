#include "mc/run/jam_shares.hpp"

#include <algorithm>
#include <cmath>

#include "mc/study/sample.hpp"
#include "src/model/bearing_model.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kPoints = 33;

/// A tolerance dimension among the inputs: what a cage drawn at scale 1 deviates by.
struct Deviation {
  std::size_t input = 0;
  const Key<Scene>* key = nullptr;
};

Study with_tolerances_of_the_laws(const Study& study) {
  Study plain = study;
  plain.design = DesignKind::random;
  plain.samples = kJamCages;
  plain.extra_replicates = 0;
  Candidate as_stated;
  for (const ToleranceDimension& dimension : study.tolerance.dimensions) {
    as_stated.tolerance_widths_mm.push_back(dimension.tolerance_width_mm);
    as_stated.grades.emplace_back();
    as_stated.scales.push_back(1);
    as_stated.shifts.push_back(0);
  }
  plain.candidates = {as_stated};
  return plain;
}

std::vector<Deviation> deviations_of(const Study& study) {
  std::vector<Deviation> deviations;
  for (const ToleranceDimension& dimension : study.tolerance.dimensions) {
    const auto found = std::find_if(study.inputs.begin(), study.inputs.end(),
                                    [&](const auto& input) { return input.key == dimension.key; });
    deviations.push_back({static_cast<std::size_t>(found - study.inputs.begin()),
                          find_key(scene_keys(), dimension.key)});
  }
  return deviations;
}

struct TolerancesAndCentres {
  std::vector<double> scales, shifts;
};

/// The cage with the deviations of its dimensions scaled and their centres moved.
void apply_tolerance(const Study& study, const std::vector<Deviation>& deviations,
                     const Sample& cage, const TolerancesAndCentres& tolerance, Scene& scene) {
  const auto& scales = tolerance.scales;
  for (std::size_t d = 0; d < deviations.size(); ++d) {
    const DrawnInput& drawn = cage.inputs[deviations[d].input];
    const auto& nominal = study.inputs[deviations[d].input].nominal;
    auto values = drawn.value;
    for (std::size_t j = 0; j < values.size(); ++j) {
      values[j] = nominal[nominal.size() == 1 ? 0 : j] +
                  (tolerance.shifts.empty() ? 0 : tolerance.shifts[d]);
      if (!drawn.lot.empty()) values[j] += scales[d] * drawn.lot[0];
      if (!drawn.pocket.empty()) values[j] += scales[d] * drawn.pocket[j];
      if (!drawn.noise.empty()) values[j] += drawn.noise[0];
    }
    set_key_numbers(*deviations[d].key, values, scene);
  }
}

bool has_jams(const Study& study) {
  return !study.candidates.empty() && !study.scene.allow_interference;
}

std::vector<TolerancesAndCentres> tolerances_of_candidates(const Study& study) {
  std::vector<TolerancesAndCentres> all;
  for (const Candidate& candidate : study.candidates)
    all.push_back({candidate.scales, candidate.shifts});
  return all;
}

/// Each candidate, then each point of each curve.
std::vector<TolerancesAndCentres> all_tolerances(const Study& study,
                                                 std::vector<JamCurve>& curves) {
  std::vector<TolerancesAndCentres> all = tolerances_of_candidates(study);
  std::vector<double> narrowest = study.candidates.front().scales, widest = narrowest;
  for (const Candidate& candidate : study.candidates) {
    for (std::size_t d = 0; d < narrowest.size(); ++d) {
      narrowest[d] = std::min(narrowest[d], candidate.scales[d]);
      widest[d] = std::max(widest[d], candidate.scales[d]);
    }
  }
  for (std::size_t d = 0; d < narrowest.size(); ++d) {
    JamCurve curve{study.tolerance.dimensions[d].key, {}, {}};
    const double ratio = kWidestJamTolerance * widest[d] / narrowest[d];
    for (std::size_t p = 0; p < kPoints; ++p) {
      auto point = narrowest;
      point[d] *= std::pow(ratio, static_cast<double>(p) / (kPoints - 1));
      curve.tolerance_width_mm.push_back(point[d] *
                                         study.tolerance.dimensions[d].tolerance_width_mm);
      all.push_back({std::move(point), {}});
    }
    curves.push_back(std::move(curve));
  }
  return all;
}

/// Share of the drawn cages that jam at each tolerance.
std::vector<double> shares_at(const Study& study,
                              const std::vector<TolerancesAndCentres>& tolerances) {
  const Study plain = with_tolerances_of_the_laws(study);
  const auto deviations = deviations_of(plain);
  const Sampler sampler(plain);
  std::vector<long> jammed(tolerances.size(), 0);
  for (long id = 0; id < kJamCages; ++id) {
    const Sample cage = sampler.draw(static_cast<std::uint64_t>(id));
    Scene scene = cage.scene;
    for (std::size_t k = 0; k < tolerances.size(); ++k) {
      apply_tolerance(plain, deviations, cage, tolerances[k], scene);
      jammed[k] += find_jam(scene).pocket >= 0;
    }
  }
  std::vector<double> shares;
  for (const long count : jammed)
    shares.push_back(static_cast<double>(count) / static_cast<double>(kJamCages));
  return shares;
}

}  // namespace

JamShares jam_shares(const Study& study) {
  JamShares jams;
  if (!has_jams(study)) return jams;
  const auto shares = shares_at(study, all_tolerances(study, jams.curves));
  auto next = shares.begin() + static_cast<std::ptrdiff_t>(study.candidates.size());
  jams.candidate.assign(shares.begin(), next);
  for (JamCurve& curve : jams.curves)
    for (std::size_t p = 0; p < curve.tolerance_width_mm.size(); ++p)
      curve.share.push_back(*next++);
  return jams;
}

std::vector<double> candidate_jam_shares(const Study& study) {
  if (!has_jams(study)) return {};
  return shares_at(study, tolerances_of_candidates(study));
}

}  // namespace cagetol
