#include "analysis/tolerance/mixture_weights.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/study/refused.hpp"
#include "analysis/tolerance/tolerance_density.hpp"

namespace cagetol {
namespace {

/// Where less fits, cages are not redrawn until one does.
constexpr double kLeastFit = 1e-3;

/// Share of the runs that each candidate was used for.
std::vector<double> candidate_shares(const StudyData& runs) {
  std::vector<double> shares(runs.plan.candidates.size(), 0.0);
  for (const std::int64_t candidate : runs.candidate)
    if (candidate >= 0 && static_cast<std::size_t>(candidate) < shares.size())
      shares[static_cast<std::size_t>(candidate)] += 1.0 / static_cast<double>(runs.size());
  return shares;
}

/// A candidate's own runs count 1/a_k, all others nothing.
std::vector<std::vector<double>> own_runs_only(const StudyData& runs,
                                               std::span<const double> shares) {
  std::vector<std::vector<double>> weights(shares.size(), std::vector<double>(runs.size(), 0.0));
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto k = static_cast<std::size_t>(runs.candidate[i]);
    if (runs.candidate[i] >= 0 && k < shares.size()) weights[k][i] = 1 / shares[k];
  }
  return weights;
}

}  // namespace

MixtureWeights mixture_weights(const StudyData& runs) {
  MixtureWeights mixture;
  const auto shares = candidate_shares(runs);
  for (std::size_t k = 0; k < shares.size(); ++k)
    mixture.fit.push_back(fit_share(runs, k, 1 - runs.plan.confidence));
  try {
    const ToleranceDensity density(runs);
    std::vector<std::vector<double>> log_densities;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      const Candidate& candidate = runs.plan.candidates[k];
      const auto shifts = candidate.all_shifts();
      const double fits = std::log(std::max(mixture.fit[k].share, kLeastFit));
      std::vector<double> column(runs.size());
      for (std::size_t i = 0; i < runs.size(); ++i)
        column[i] = density.log_density(i, candidate.scales, shifts) - fits;
      log_densities.push_back(std::move(column));
    }
    mixture.candidate = weights_of_densities(log_densities, shares, &mixture.log_mixture);
  } catch (const Refused& refusal) {
    mixture.note = std::string(refusal.what()) + ". Each candidate is judged by its own runs only.";
    mixture.candidate = own_runs_only(runs, shares);
  }
  return mixture;
}

std::vector<double> weights_of_scales(const StudyData& runs, const MixtureWeights& mixture,
                                      std::span<const double> scales,
                                      std::span<const double> shifts) {
  if (mixture.log_mixture.empty()) throw Refused("weights refused: " + mixture.note);
  const ToleranceDensity density(runs);
  std::vector<double> weights(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i)
    weights[i] = std::exp(density.log_density(i, scales, shifts) - mixture.log_mixture[i]);
  return weights;
}

std::vector<std::vector<double>> weights_of_densities(
    const std::vector<std::vector<double>>& log_densities, std::span<const double> shares,
    std::vector<double>* log_mixture) {
  auto weights = log_densities;
  if (weights.empty()) return weights;
  const std::size_t samples = weights.front().size();
  if (log_mixture != nullptr) log_mixture->resize(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    // Relative to the largest: densities in 28 dimensions overflow otherwise.
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < weights.size(); ++k)
      if (shares[k] > 0) largest = std::max(largest, log_densities[k][i]);
    double mixture = 0;
    for (std::size_t k = 0; k < weights.size(); ++k)
      if (shares[k] > 0) mixture += shares[k] * std::exp(log_densities[k][i] - largest);
    for (std::size_t k = 0; k < weights.size(); ++k)
      weights[k][i] = std::exp(log_densities[k][i] - largest) / mixture;
    if (log_mixture != nullptr) (*log_mixture)[i] = largest + std::log(mixture);
  }
  return weights;
}

std::vector<double> average_weights(const MixtureWeights& mixture,
                                    std::span<const std::size_t> candidates) {
  std::vector<double> average(mixture.candidate.at(candidates.front()).size(), 0.0);
  const double all =
      average_fit(mixture, candidates).share * static_cast<double>(candidates.size());
  for (const std::size_t k : candidates)
    for (std::size_t i = 0; i < average.size(); ++i)
      average[i] += mixture.candidate[k][i] * mixture.fit[k].share / all;
  return average;
}

FitShare average_fit(const MixtureWeights& mixture, std::span<const std::size_t> candidates) {
  FitShare average{0, 0, 1};
  for (const std::size_t k : candidates) {
    average.share += mixture.fit[k].share / static_cast<double>(candidates.size());
    average.bound += mixture.fit[k].bound / static_cast<double>(candidates.size());
  }
  return average;
}

}  // namespace cagetol
