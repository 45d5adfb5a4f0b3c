// Fits and temperatures scatter like any other number of a scene, and the clearance with them.
#include <gtest/gtest.h>

#include <cmath>

#include "mc/study/sample.hpp"
#include "src/operation/operating_clearance.hpp"

namespace cagetol {
namespace {

UncertainInput scattered(const std::string& key, const std::string& unit, double nominal,
                         std::optional<Law> lot, std::optional<Law> noise) {
  UncertainInput input;
  input.key = key;
  input.unit = unit;
  input.nominal = {nominal};
  input.lot = std::move(lot);
  input.noise = std::move(noise);
  return input;
}

struct Moments {
  double mean, sigma;
};
/// Of the change of the internal clearance [um].
Moments clearance_scatter(const Study& study) {
  const Sampler sampler(study);
  double sum = 0, squares = 0;
  const auto count = static_cast<double>(study.samples);
  for (long id = 0; id < study.samples; ++id) {
    const Sample sample = sampler.draw(static_cast<std::uint64_t>(id));
    const double change = 1e6 * operating_clearance(sample.scene).internal(7.5e-3).total();
    sum += change;
    squares += change * change;
  }
  return {sum / count, std::sqrt(squares / count - sum * sum / (count * count))};
}

TEST(OperatingScatter, PassesTheScatterOfAFitOn) {
  for (const bool lot : {true, false}) {
    Study study;
    study.samples = 4000;
    const Law law = Uniform{-5, 5};
    study.inputs = {scattered("fit.inner_interference_um", "um", 12,
                              lot ? std::optional(law) : std::nullopt,
                              lot ? std::nullopt : std::optional(law))};
    const Moments change = clearance_scatter(study);
    const double share = 25 / 31.5;  // d/F: solid shaft, one material
    EXPECT_NEAR(change.mean, -12 * share, 0.15);
    EXPECT_NEAR(change.sigma / (share * 10 / std::sqrt(12.0)), 1, 0.03);
  }
}

/// A transition fit presses in some samples only.
TEST(OperatingScatter, LeavesLooseRingsAsTheyAre) {
  Study study;
  study.samples = 4000;
  study.inputs = {scattered("fit.inner_interference_um", "um", 0, Uniform{-10, 10}, std::nullopt)};
  EXPECT_NEAR(clearance_scatter(study).mean, -2.5 * 25 / 31.5, 0.15);
}

TEST(OperatingScatter, PassesTheScatterOfATemperatureOn) {
  Study study;
  study.samples = 4000;
  study.scene.temperature.growth = true;
  study.scene.temperature.inner_ring = study.scene.temperature.rollers = 50;
  study.inputs = {scattered("temperature.outer_ring_C", "degC", 50, std::nullopt, Normal{0, 4})};
  EXPECT_NEAR(clearance_scatter(study).sigma / (12e-6 * 4 * 46.5e3), 1, 0.05);
}

}  // namespace
}  // namespace cagetol
