#include "src/heat_balance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "src/input/input_error.hpp"
#include "src/operation/heat_shed.hpp"
#include "src/quantities/quantity_table.hpp"
#include "src/simulate.hpp"

namespace cagetol {
namespace {

constexpr double kFirstRise = 30;    // above ambient [K]
constexpr double kUsualFall = 0.02;  // of the losses' logarithm [1/K]
constexpr double kAgreement = 0.01;  // of power and heat shed
constexpr double kSettled = 0.02;    // likewise, after the last run
constexpr int kMostRuns = 8;         // three or four are usual; losses of a few turns scatter
constexpr double kSteps = 400000, kStepsOfDoubt = 40000;  // of a run
constexpr double kFarApart = 3;    // temperatures whose losses tell a slope [K]
constexpr double kMeasured = 2;    // turns of the cage
constexpr double kDoubted = 1.25;  // of heat shed: beyond, a given temperature is not held
constexpr double kHeldAt = 100;    // temperature for which a flow of oil is named [degC]

InputError refused(const std::string& why, const std::string& remedy) {
  return {{}, "temperature.balance", "true", why, remedy};
}

/// Power that the bearing loses at a temperature, found within so many steps [W].
double power_at(const Scene& scene, double temperature, double steps) {
  Scene run = at_temperature(scene, temperature);
  run.temperature.balance = false;
  run.cage.model = CageKind::rigid;
  run.phase = {};
  run.integration.step_budget = given_or(run.integration.step_budget, steps);
  if (std::isnan(run.window.measure_time)) {
    run.window.measure_revolutions = std::min(run.window.measure_revolutions, kMeasured);
    run.window.peak_revolutions =
        std::min(run.window.peak_revolutions, run.window.measure_revolutions);
  }
  const Outcome outcome = simulate(run);
  if (outcome.status != Status::ok)
    throw refused(fmt::format("the nominal bearing does not run at {:.4g} degC: {}", temperature,
                              outcome.reason),
                  "correct the scene, or set temperature.balance = false and give temperatures");
  return outcome.quantities[static_cast<std::size_t>(quantity_index("power_loss_W"))];
}

/// Where losses that fall by the share `fall` for each kelvin from `power` at `from` are shed.
double crossing(const HeatShed& shed, double from, double power, double fall) {
  double low = shed.zero, high = 1e4;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    const double lost = power * std::exp(std::clamp(-fall * (middle - from), -50.0, 50.0));
    (lost > shed.at(middle) ? low : high) = middle;
  }
  return low;
}

/// Mean of the losses that were found near a temperature, moved there by their `fall`: those of a
/// few turns scatter by percents.
double mean_near(double temperature, const std::vector<std::pair<double, double>>& runs,
                 double fall) {
  double sum = 0, count = 0;
  for (const auto& [at, lost] : runs)
    if (std::abs(at - temperature) <= kFarApart)
      sum += lost * std::exp(-fall * (temperature - at)), ++count;
  return sum / count;
}

/// Whether the oil of its runs has a temperature that nothing has balanced.
bool gives_temperature(const Scene& scene) {
  return !scene.temperature.balance && !is_quasi_static(scene) && is_lubricated(scene);
}

double rounded(const std::string& digits) {
  return std::strtod(digits.c_str(), nullptr);
}

}  // namespace

Scene with_temperature_found(const Scene& scene, double first) {
  if (!needs_temperature(scene.temperature) || is_quasi_static(scene)) return scene;
  const HeatShed shed = heat_shed(scene);
  double T = given_or(first, shed.zero + kFirstRise), fall = kUsualFall;
  double power = 0, before = 0, before_power = 0;
  std::vector<std::pair<double, double>> runs;  // temperatures and losses
  for (int run = 1;; ++run) {
    power = power_at(scene, T, kSteps);
    if (run > 1 && std::abs(T - before) > kFarApart)
      fall = -std::log(std::max(power, 1e-9) / std::max(before_power, 1e-9)) / (T - before);
    runs.emplace_back(T, power);
    power = mean_near(T, runs, std::max(fall, 0.0));
    const double apart = std::abs(power - shed.at(T));
    if (apart <= kAgreement * power + 1e-3 || (run == kMostRuns && apart <= kSettled * power))
      break;
    if (-fall * power > shed.slope)
      throw refused(fmt::format("between {:.4g} and {:.4g} degC the losses grow faster than what "
                                "the bearing sheds: there is no one temperature",
                                before, T),
                    "give more clearance, or temperature.oil_flow_l_min");
    if (run == kMostRuns)
      throw refused(fmt::format("after {} runs the bearing loses {:.4g} W at {:.4g} degC and sheds "
                                "{:.4g} W",
                                run, power, T, shed.at(T)),
                    "set temperature.balance = false and give temperatures");
    before = T, before_power = power;
    T = crossing(shed, T, power, std::max(fall, 0.0));
    if (T > kHottestBalance) {
      const double at_limit = power * std::exp(-std::max(fall, 0.0) * (kHeldAt - before));
      const double inlet = given_or(scene.temperature.oil_inlet, scene.temperature.ambient);
      const double flow =
          (at_limit - shed.at(kHeldAt)) / oil_heat_capacity(scene) / std::max(kHeldAt - inlet, 1.0);
      throw refused(fmt::format("the bearing would have to be at {:.0f} degC to shed what it loses "
                                "({:.4g} W at {:.4g} degC, where it sheds {:.4g} W)",
                                T, power, before, shed.at(before)),
                    fmt::format("temperature.oil_flow_l_min = {:.2g} more would hold {:.0f} degC; "
                                "or less oil (lubrication.supply)",
                                flow * 60e3, kHeldAt));
    }
  }
  Scene found = at_temperature(scene, rounded(fmt::format("{:.2f}", T)));
  found.temperature.found = found.lubrication.temperature;
  found.temperature.found_power = rounded(fmt::format("{:.4g}", power));
  found.temperature.found_slope =
      rounded(fmt::format("{:.4g}", shed.slope + std::max(fall, 0.0) * power));
  return found;
}

std::string temperature_doubt(const Scene& scene) {
  if (!gives_temperature(scene)) return "";
  try {
    return temperature_doubt(scene, power_at(scene, scene.lubrication.temperature, kStepsOfDoubt));
  } catch (const InputError&) {
    return "";
  }
}

std::string temperature_doubt(const Scene& scene, double power) {
  const double T = scene.lubrication.temperature;
  const HeatShed shed = heat_shed(scene);
  if (!gives_temperature(scene) || !(power > kDoubted * shed.at(T))) return "";
  return fmt::format(
      "at {:.4g} degC the bearing loses {:.3g} W and sheds {:.3g} W (ISO 15312, {:.4g} degC "
      "ambient): it will be warmer; temperature.balance = true finds how warm",
      T, power, shed.at(T), scene.temperature.ambient);
}

}  // namespace cagetol
