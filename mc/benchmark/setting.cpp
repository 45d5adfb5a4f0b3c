#include "mc/benchmark/setting.hpp"

#include <fmt/format.h>

#include "mc/run/cage_cache.hpp"

namespace cagetol {
namespace {

constexpr double kTolerances[] = {1e-1, 1e-2, 3e-3, 1e-3, 1e-4};
constexpr double kTight = 1e-5;

}  // namespace

std::string setting_label(const Setting& s) {
  return fmt::format("{} at {:.3g}", spelled(s.method), s.tolerance);
}

Setting setting_of(const Scene& scene) {
  return {scene.integration.method, scene.integration.tolerance};
}

Scene with_setting(const Scene& scene, const Setting& setting) {
  Scene set = scene;
  set.integration.method = setting.method;
  set.integration.tolerance = setting.tolerance;
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
  for (const IntegrationMethod method : methods.empty() ? all_methods() : methods)
    for (const double tolerance : kTolerances)
      if (method != own.method || tolerance != own.tolerance) ladder.push_back({method, tolerance});
  return ladder;
}

SimulateOptions with_cage_table(const Scene& scene) {
  SimulateOptions options;
  if (is_flexible(scene)) options.cage_table = made_cage_table(scene);
  return options;
}

Setting reference_setting(IntegrationMethod method) {
  const bool ours = method == IntegrationMethod::rodas3 || method == IntegrationMethod::rodasp;
  return {ours ? IntegrationMethod::arkode_erk : IntegrationMethod::rodasp, kTight};
}

}  // namespace cagetol
