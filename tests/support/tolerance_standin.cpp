#include "tests/support/tolerance_standin.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "distributions/basics/random_stream.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kPockets = 13;

nlohmann::json law(double sigma) {
  return sigma > 0 ? nlohmann::json{{"law", "normal"}, {"sigma", sigma}} : nlohmann::json();
}

/// All combinations of the dimensions' candidates, the first dimension slowest.
void add_candidates(StudyPlan& plan, const std::vector<StandinDimension>& dimensions,
                    const Candidate& shorter) {
  const std::size_t d = shorter.scales.size();
  if (d == dimensions.size()) {
    plan.candidates.push_back(shorter);
    return;
  }
  const auto& [scales, middles] = std::tie(dimensions[d].scales, dimensions[d].middles);
  for (std::size_t k = 0; k < scales.size(); ++k) {
    Candidate longer = shorter;
    longer.scales.push_back(scales[k]);
    longer.tolerance_widths_mm.push_back(0.1 * scales[k]);
    longer.middles.push_back(middles.empty() ? 0 : middles[k]);
    const double half = 0.05 * scales[k], middle = longer.middles.back();
    const auto end = [](double length) { return std::round(1e6 * length) / 1e6 + 0.0; };
    longer.grades.push_back(
        middle == 0 ? "" : fmt::format("{:+}/{:+}", end(middle + half), end(middle - half)));
    add_candidates(plan, dimensions, longer);
  }
}

}  // namespace

StudyData tolerance_standin(std::int64_t rows, std::int64_t seed,
                            const std::vector<StandinDimension>& dimensions, double target_yield,
                            const std::function<double(const StandinCage&)>& badness,
                            std::int64_t cages_per_lot) {
  StudyData study = plain_study(rows, "random", cages_per_lot, seed);
  study.plan.target_yield = target_yield;
  study.plan.limits = {{"badness", {}, 0.0, "stand-in", 1}};
  add_candidates(study.plan, dimensions, {});
  for (const StandinDimension& dimension : dimensions) {
    study.plan.dimensions.push_back({dimension.key, 0.1});
    study.plan.inputs.push_back(
        {dimension.key, "mm", {9}, law(dimension.lot_sigma), law(dimension.pocket_sigma), {}});
    study.inputs.push_back({dimension.key, "mm", {9}, {}, {}, {}, {}, true});
  }
  study.quantities = {{"badness", "-", "stand-in", {}}};
  const auto useed = static_cast<std::uint64_t>(seed);
  for (std::size_t i = 0; i < study.size(); ++i) {
    study.candidate[i] = study.row[i] % static_cast<std::int64_t>(study.plan.candidates.size());
    const auto& candidate = study.plan.candidates[static_cast<std::size_t>(study.candidate[i])];
    const auto& scales = candidate.scales;
    StandinCage cage;
    for (std::size_t d = 0; d < dimensions.size(); ++d) {
      const auto stream = static_cast<std::uint32_t>(d);
      RandomStream lots(useed, Purpose::lot, static_cast<std::uint64_t>(study.lot[i]), stream);
      RandomStream pockets(useed, Purpose::pocket, static_cast<std::uint64_t>(study.row[i]),
                           stream);
      const bool lot = dimensions[d].lot_sigma > 0;
      cage.lot.push_back(scales[d] * dimensions[d].lot_sigma * gsl_cdf_ugaussian_Pinv(lots.next()) +
                         (lot ? candidate.shift(d) : 0));
      cage.pocket.emplace_back();
      for (std::size_t j = 0; j < kPockets; ++j) {
        cage.pocket[d].push_back(scales[d] * dimensions[d].pocket_sigma *
                                     gsl_cdf_ugaussian_Pinv(pockets.next()) +
                                 (lot ? 0 : candidate.shift(d)));
        study.inputs[d].value.push_back(9 + cage.lot[d] + cage.pocket[d][j]);
      }
      if (dimensions[d].lot_sigma > 0) study.inputs[d].lot.push_back(cage.lot[d]);
      if (dimensions[d].pocket_sigma > 0)
        study.inputs[d].pocket.insert(study.inputs[d].pocket.end(), cage.pocket[d].begin(),
                                      cage.pocket[d].end());
    }
    study.quantities[0].values.push_back(badness(cage));
  }
  return study;
}

const StandinDimension kPrintedWidth{"cage.pocket_width_mm", 0, 0.01, {0.36, 0.58, 0.9, 1.5}};
const StandinDimension kPrintedLength{"cage.pocket_length_mm", 0.01, 0.01, {0.36, 0.9}};

double widest_pocket(const StandinCage& cage) {
  return *std::max_element(cage.pocket[0].begin(), cage.pocket[0].end()) - 0.026;
}

double widest_pocket_yield(double tolerance_width_mm) {
  return std::pow(gsl_cdf_ugaussian_P(0.26 / tolerance_width_mm), kPockets);
}

}  // namespace cagetol
