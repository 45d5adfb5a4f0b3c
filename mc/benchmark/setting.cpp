#include "mc/benchmark/setting.hpp"

#include <fmt/format.h>

#include "mc/cage_cache.hpp"
#include "src/integration/integrator.hpp"

namespace cagetol {
namespace {

constexpr double kTolerances[] = {1e-1, 1e-2, 3e-3, 1e-3, 1e-4};
constexpr double kSteps[] = {2e-6, 1e-6, 0.5e-6, 0.25e-6};  // [s]
constexpr double kTight = 1e-5;

}  // namespace

bool has_fixed_step(const std::string& method) {
  return method == "semi-implicit-euler";
}

std::string setting_label(const Setting& s) {
  return has_fixed_step(s.method) ? fmt::format("{} at {:.3g} us", s.method, 1e6 * s.accuracy)
                                  : fmt::format("{} at {:.3g}", s.method, s.accuracy);
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

std::vector<Setting> setting_ladder(const Scene& scene, const std::vector<std::string>& methods) {
  const Setting own = setting_of(scene);
  std::vector<Setting> ladder = {own};
  const auto add = [&](const std::string& method, double accuracy) {
    if (method != own.method || accuracy != own.accuracy) ladder.push_back({method, accuracy});
  };
  std::vector<std::string> names = methods;
  if (names.empty())
    for (const MethodName& known : integration_methods()) names.push_back(known.name);
  for (const std::string& name : names) {
    if (has_fixed_step(name))
      for (double step : kSteps) add(name, step);
    else
      for (double tolerance : kTolerances) add(name, tolerance);
  }
  return ladder;
}

SimulateOptions with_cage_table(const Scene& scene) {
  SimulateOptions options;
  if (is_flexible(scene)) options.cage_table = made_cage_table(scene);
  return options;
}

Setting reference_setting(const std::string& method) {
  return {method.starts_with("rodas") ? "arkode-erk" : "rodasp", kTight};
}

}  // namespace cagetol
