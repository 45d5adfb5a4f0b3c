#include "mc/run/clearance_chains.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mc/study/cage_fit.hpp"
#include "mc/study/sample.hpp"
#include "src/input/unit.hpp"

namespace cagetol {
namespace {

constexpr const char* kNames[] = {"roller to both bars",
                                  "roller to both pocket ends",
                                  "roller to the lips at the bore",
                                  "roller to the lips at the outside",
                                  "cage to the inner ring, radial",
                                  "cage to the outer ring, radial",
                                  "evenly spaced roller to one bar"};

Interval ends_of(const Study& study, const UncertainInput& input) {
  for (const ToleranceDimension& dimension : study.tolerance.dimensions)
    if (dimension.key == input.key) {
      const double half =
          from_si(to_si(dimension.tolerance_width_mm / 2, 1e-3), unit_of(input.key).to_si);
      return {-half, half};
    }
  Interval sum{0, 0};
  for (const auto* law : {&input.lot, &input.pocket, &input.noise}) {
    if (!*law) continue;
    const Interval ends = support(**law);
    const double middle = mean(**law), reach = 3 * standard_deviation(**law);
    sum.lower += std::isfinite(ends.lower) ? ends.lower : middle - reach;
    sum.upper += std::isfinite(ends.upper) ? ends.upper : middle + reach;
  }
  return sum;
}

}  // namespace

std::vector<ClearanceChain> clearance_chains(const Study& study) {
  // Gaps that jam (cage_gaps.hpp), and the room before a bar, where pitch counts.
  const double pitch = pitch_radius(study.scene.bearing);
  const CageGaps fit = gaps_in_service(study, study.scene);
  std::vector<std::vector<double>> base(fit.begin(), fit.end()), slopes;
  base.emplace_back();
  for (std::size_t j = 0; j < fit[0].size(); ++j)
    base.back().push_back(fit[0][j] / 2 +
                          pitch * each(study.scene.cage.pocket_pitch, static_cast<long>(j)));
  for (const UncertainInput& input : study.inputs) {
    const GapSlopes of = gap_slopes(study, input);
    slopes.emplace_back(of.begin(), of.end());
    slopes.back().push_back(input.key == "cage.pocket_pitch_mrad" ? 1e-3 * pitch : of[0] / 2);
  }
  Study plain = study;
  plain.design = DesignKind::random;
  plain.seed = 0;
  plain.cages_per_lot = 1;
  plain.samples = kChainCages;
  plain.candidates.clear();
  plain.tolerance.dimensions.clear();
  const Sampler sampler(plain);
  std::vector<std::vector<double>> drawn(base.size());
  Sample cage;
  for (std::uint64_t id = 0; id < kChainCages; ++id) {
    sampler.draw_deviations(id, cage);
    for (std::size_t p = 0; p < base.size(); ++p)
      for (std::size_t j = 0; j < base[p].size(); ++j) {
        const auto of = [j](const auto& list) { return list[list.size() == 1 ? 0 : j]; };
        double gap = base[p][j];
        for (std::size_t i = 0; i < slopes.size(); ++i)
          if (slopes[i][p] != 0)
            gap += slopes[i][p] * (of(cage.inputs[i].value) - of(study.inputs[i].nominal));
        drawn[p].push_back(gap);
      }
  }
  std::vector<ClearanceChain> chains;
  for (std::size_t p = 0; p < base.size(); ++p) {
    if (base[p].empty()) continue;
    ClearanceChain chain{kNames[p], {}, *std::min_element(base[p].begin(), base[p].end())};
    double middle = chain.nominal, sum = 0, squares = 0;
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      if (slopes[i][p] == 0) continue;
      const Interval ends = ends_of(study, study.inputs[i]);
      const double half = std::abs(slopes[i][p]) * (ends.upper - ends.lower) / 2;
      chain.keys.push_back(study.inputs[i].key);
      middle += slopes[i][p] * (ends.upper + ends.lower) / 2;
      sum += half, squares += half * half;
    }
    chain.worst = {middle - sum, middle + sum};
    chain.rss = {middle - std::sqrt(squares), middle + std::sqrt(squares)};
    std::sort(drawn[p].begin(), drawn[p].end());
    const auto tail = static_cast<std::size_t>(kChainTail * static_cast<double>(drawn[p].size()));
    chain.sampled = {drawn[p][tail], drawn[p][drawn[p].size() - 1 - tail]};
    chains.push_back(std::move(chain));
  }
  return chains;
}

std::string chains_text(const std::vector<ClearanceChain>& chains) {
  std::string text = fmt::format(
      "clearance chains in operation [um]; sampled: {} % to {} % of the pockets of {} cages drawn "
      "by the study's laws\n"
      "  {:<34} {:>8} {:>18} {:>18} {:>18}  by\n",
      100 * kChainTail, 100 - 100 * kChainTail, kChainCages, "", "nominal", "worst case", "RSS",
      "sampled");
  const auto range = [](const Interval& of) {
    return fmt::format("{:.1f} to {:.1f}", 1e6 * of.lower, 1e6 * of.upper);
  };
  for (const ClearanceChain& chain : chains)
    text += fmt::format("  {:<34} {:>8.1f} {:>18} {:>18} {:>18}  {}\n", chain.name,
                        1e6 * chain.nominal, range(chain.worst), range(chain.rss),
                        range(chain.sampled), fmt::join(chain.keys, ", "));
  return text;
}

}  // namespace cagetol
