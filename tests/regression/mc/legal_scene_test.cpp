// Whatever a legal scene says, its run ends with an outcome and a reason, or the scene is refused
// as bad input with a remedy. Any other exception would reach the user as "unexpected".
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <random>

#include "src/heat_balance.hpp"
#include "src/simulate.hpp"
#include "tests/support/reference_scene.hpp"

namespace cagetol {
namespace {

class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  bool happens(double share) { return between(0, 1) < share; }
  std::size_t pick(std::size_t count) { return engine_() % count; }

 private:
  std::mt19937_64 engine_;
};

using Settings = std::vector<std::pair<std::string, std::string>>;

/// A bearing whose parts fit each other: small and large, slender and stout, 3 to 64 rollers.
Settings random_bearing_keys(Draw& draw) {
  const auto rollers = static_cast<long>(3 + draw.pick(62));
  const double roller = std::pow(10, draw.between(0, 2));
  const double pitch = std::max(3 * roller, roller * static_cast<double>(rollers) /
                                                std::numbers::pi * draw.between(1.03, 1.6));
  const double inner = pitch - roller, outer = pitch + roller;
  const double length = roller * draw.between(0.6, 2.5);
  const double pocket_length = length * (1 + std::pow(10, draw.between(-3, -1)));
  const double cage_inner = inner + roller * draw.between(0.1, 0.98);
  const double shoulder = pitch + roller * draw.between(0.2, 0.95);
  const double cage_outer = cage_inner + (shoulder - cage_inner) * draw.between(0.2, 0.99);
  const double cage_width = pocket_length * draw.between(1.05, 2);
  const std::vector<std::pair<const char*, double>> numbers = {
      {"bearing.bore_diameter_mm", inner * draw.between(0.3, 0.95)},
      {"bearing.outside_diameter_mm", outer * draw.between(1.05, 1.4)},
      {"bearing.width_mm", std::max(cage_width, length) * draw.between(1.02, 1.3)},
      {"bearing.inner_raceway_diameter_mm", inner},
      {"bearing.outer_raceway_diameter_mm", outer},
      {"bearing.shoulder_diameter_mm", shoulder},
      {"bearing.internal_clearance_um", draw.between(-10, 200)},
      {"bearing.flange_clearance_mm", 0.01 * roller * draw.between(0, 1)},
      {"roller.diameter_mm", roller},
      {"roller.length_mm", length},
      {"cage.inner_diameter_mm", cage_inner},
      {"cage.outer_diameter_mm", cage_outer},
      {"cage.width_mm", cage_width},
      {"cage.pocket_width_mm", roller * (1 + std::pow(10, draw.between(-3, -1)))},
      {"cage.pocket_length_mm", pocket_length},
      {"load.radial_N", std::pow(10, draw.between(-1, 5))},
      {"speed.inner_rpm", std::pow(10, draw.between(0, 4.5))}};
  Settings settings = {{"bearing.roller_count", std::to_string(rollers)}};
  for (const auto& [key, value] : numbers)
    settings.emplace_back(key, fmt::format("{:.17g}", value));
  return settings;
}

double random_number(const KeyRange& range, double example, Draw& draw) {
  if (std::isfinite(range.maximum)) {
    if (draw.happens(0.15)) return range.maximum;
    return range.minimum + (range.maximum - range.minimum) * std::pow(10, draw.between(-4, 0));
  }
  const double scale = std::isfinite(example) && example != 0 ? std::abs(example) : 1;
  const double sign = std::isinf(range.minimum) && draw.happens(0.5) ? -1 : 1;
  return sign * scale * std::pow(10, draw.between(-3, 3));
}

std::string random_value(const Key<Scene>& key, Draw& draw) {
  switch (key.kind) {
    case KeyKind::number:
    case KeyKind::numbers:
      return fmt::format("{:.17g}",
                         random_number(key.range, key_numbers(key, example_scene())[0], draw));
    case KeyKind::integer:
      return std::to_string(std::lround(random_number(key.range, 1, draw)));
    case KeyKind::boolean:
      return draw.happens(0.5) ? "true" : "false";
    default:
      return key.range.choices.empty() ? "x"
                                       : key.range.choices[draw.pick(key.range.choices.size())];
  }
}

/// Keys that set how long a run takes.
bool costs_time(const std::string& name) {
  for (const char* part : {"window.", "integration.max_step", "integration.step_budget",
                           "integration.wall_budget", "discretisation.", "cage.mesh_density"})
    if (name.starts_with(part)) return true;
  return false;
}

/// Lists over time, which fit each other or are refused: a single key of them says nothing.
bool is_over_time(const std::string& name) {
  return name.starts_with("duty.") || name.starts_with("phase.");
}

Settings random_settings(unsigned seed) {
  Draw draw(seed);
  Settings settings = random_bearing_keys(draw);
  settings.emplace_back("lubrication.model", seed % 3 == 0 ? "film" : "none");
  for (std::size_t k = 3 + draw.pick(12); k > 0; --k) {
    const auto& key = scene_keys()[draw.pick(scene_keys().size())];
    const bool fits = std::any_of(settings.begin(), settings.end(), [&](const auto& setting) {
      return setting.first == key.name;  // to the other parts; another value would not
    });
    if (!fits && !costs_time(key.name) && !is_over_time(key.name))
      settings.emplace_back(key.name, random_value(key, draw));
  }
  const bool warm = std::any_of(settings.begin(), settings.end(), [](const auto& setting) {
    return setting.first.starts_with("temperature.");
  });
  if (warm) settings.emplace_back("temperature.growth", "true");  // else they would be refused
  settings.emplace_back("cage.mesh_density", "1");
  settings.emplace_back("window.settle_revolutions", "0.05");
  settings.emplace_back("window.measure_revolutions", "0.1");
  settings.emplace_back("integration.step_budget", "3000");
  return settings;
}

enum class Ending { ok, not_ok, refused };

Ending ending_of(const Settings& settings) {
  toml::table root;
  std::string line;
  for (const auto& [key, value] : settings) {
    apply_setting(root, key + "=" + value);
    line += " --set " + key + "=" + value;
  }
  SCOPED_TRACE(line);
  try {
    const Outcome outcome = simulate(with_temperature_found(read_scene(root, "scene.toml")));
    EXPECT_EQ(outcome.reason.empty(), outcome.status == Status::ok);
    return outcome.status == Status::ok ? Ending::ok : Ending::not_ok;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("remedy: "));
    return Ending::refused;
  } catch (const std::exception& error) {
    ADD_FAILURE() << error.what();
    return Ending::refused;
  }
}

TEST(LegalScenes, EndWithAnOutcomeOrAreRefused) {
  int ran = 0;
  for (unsigned seed = 1; seed <= 72; ++seed)
    ran += ending_of(random_settings(seed)) != Ending::refused;
  EXPECT_GT(ran, 24);
}

/// Goes on at the scene at which the last run was stopped.
TEST(NightlyLegalScenes, EndWithAnOutcomeOrAreRefused) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1";
  const std::string progress = CAGETOL_BINARY_DIR "/legal-scenes";
  unsigned begin = 1;
  std::ifstream(progress) >> begin;
  for (unsigned seed = begin; seed <= 1000 && !HasFailure(); ++seed) {
    ending_of(random_settings(seed));
    std::ofstream(progress) << seed + 1;
  }
  if (!HasFailure()) std::remove(progress.c_str());
}

}  // namespace
}  // namespace cagetol
