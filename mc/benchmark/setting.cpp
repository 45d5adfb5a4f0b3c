#include "mc/benchmark/setting.hpp"

#include <fmt/format.h>

#include "mc/cage_cache.hpp"

namespace cagetol {
namespace {

constexpr double kTolerances[] = {1e-1, 1e-2, 3e-3, 1e-3, 1e-4};
constexpr double kSteps[] = {2e-6, 1e-6, 0.5e-6, 0.25e-6};  // [s]
constexpr double kTight = 1e-5;

}  // namespace

bool has_fixed_step(IntegrationMethod method) {
  return method == IntegrationMethod::semi_implicit_euler;
}

std::string setting_label(const Setting& s) {
  return has_fixed_step(s.method)
             ? fmt::format("{} at {:.3g} us", spelled(s.method), 1e6 * s.accuracy)
             : fmt::format("{} at {:.3g}", spelled(s.method), s.accuracy);
}

Setting setting_of(const Scene& scene) {
  const Integration& i = scene.integration;
  return {i.method, has_fixed_step(i.method) ? i.fixed_step : i.tolerance};
}

Scene with_setting(const Scene& scene, const Setting& setting) {
  Scene set = scene;
  set.integration.method = setting.method;
  (has_fixed_step(setting.method) ? set.integration.fixed_step : set.integration.tolerance) =
      setting.accuracy;
  return set;
}

std::vector<IntegrationMethod> all_methods() {
  std::vector<IntegrationMethod> methods;
  for (const auto& [method, text] : spellings(IntegrationMethod{})) methods.push_back(method);
  return methods;
}

std::vector<Setting> setting_ladder(const Scene& scene,
                                    const std::vector<IntegrationMethod>& methods) {
  const Setting own = setting_of(scene);
  std::vector<Setting> ladder = {own};
  const auto add = [&](IntegrationMethod method, double accuracy) {
    if (method != own.method || accuracy != own.accuracy) ladder.push_back({method, accuracy});
  };
  for (const IntegrationMethod method : methods.empty() ? all_methods() : methods) {
    if (has_fixed_step(method))
      for (double step : kSteps) add(method, step);
    else
      for (double tolerance : kTolerances) add(method, tolerance);
  }
  return ladder;
}

SimulateOptions with_cage_table(const Scene& scene) {
  SimulateOptions options;
  if (is_flexible(scene)) options.cage_table = made_cage_table(scene);
  return options;
}

Setting reference_setting(IntegrationMethod method) {
  switch (method) {
    case IntegrationMethod::rodas3:
    case IntegrationMethod::rodasp:
      return {IntegrationMethod::arkode_erk, kTight};
    default:
      return {IntegrationMethod::rodasp, kTight};
  }
}

}  // namespace cagetol
