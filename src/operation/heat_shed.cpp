#include "src/operation/heat_shed.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/lubrication/lubricant.hpp"

namespace cagetol {
namespace {

constexpr double kReferenceHeat = 0.016e6;   // q_r [W/m2]
constexpr double kReferenceArea = 50000e-6;  // up to which it holds [m2]
constexpr double kReferenceRise = 50;        // [K]
constexpr double kSpecificHeat = 2000;       // of oil [J/(kg K)]

}  // namespace

double oil_heat_capacity(const Scene& scene) {
  const Lubrication& l = scene.lubrication;
  return kSpecificHeat * given_or(l.density, lubricant_named(l.lubricant).oil.density_15);
}

HeatShed heat_shed(const Scene& scene) {
  const BearingGeometry& b = scene.bearing;
  const Temperatures& t = scene.temperature;
  const double area = std::numbers::pi * b.width * (b.bore_diameter + b.outside_diameter);
  const double by_size = std::min(1.0, std::pow(area / kReferenceArea, -0.34));
  const double G = given_or(t.conductance, kReferenceHeat * by_size * area / kReferenceRise);
  const double carried = t.oil_flow * oil_heat_capacity(scene);
  const double slope = G + carried;
  return {slope, (G * t.ambient + carried * given_or(t.oil_inlet, t.ambient)) / slope};
}

Scene at_temperature(Scene scene, double temperature) {
  scene.lubrication.temperature = temperature;
  if (!scene.temperature.growth) return scene;
  scene.temperature.outer_ring = temperature;
  scene.temperature.inner_ring = temperature + scene.temperature.inner_above;
  return scene;
}

}  // namespace cagetol
