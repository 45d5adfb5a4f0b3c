#include "src/scene/oil_supply.hpp"

#include <limits>

#include "src/input/given.hpp"

namespace cagetol {
namespace {

constexpr double kFlooded = std::numeric_limits<double>::infinity();

OilLayers supplied(OilSupply supply) {
  switch (supply) {
    case OilSupply::bath:
      return {50e-6, kFlooded, 50e-6, kFlooded, 0.1};
    case OilSupply::oil_air:
      return {5e-6, 20e-6, 10e-6, 20e-6, 0.002};
    case OilSupply::grease:
      return {10e-6, 50e-6, 20e-6, 50e-6, 0.005};
    default:
      return {20e-6, 200e-6, 20e-6, 200e-6, 0.02};
  }
}

}  // namespace

OilSupply oil_supply(const Lubrication& l) {
  if (l.supply != OilSupply::automatic) return l.supply;
  return l.lubricant.starts_with("grease") ? OilSupply::grease : OilSupply::circulation;
}

OilLayers oil_layers(const Lubrication& l) {
  const OilLayers of = supplied(oil_supply(l));
  return {given_or(l.race_layer, of.inner), given_or(l.outer_layer, of.outer),
          given_or(l.pocket_layer, of.pocket), given_or(l.land_layer, of.land),
          given_or(l.oil_share, of.share)};
}

}  // namespace cagetol
