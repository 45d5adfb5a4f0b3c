// A coarse cage table, shared by the tests of a program, and scattered pockets to go with it.
#pragma once

#include <algorithm>
#include <random>
#include <vector>

#include "src/cage/table/cage_table.hpp"

namespace cagetol::test {

inline const Material kCageSteel{206e9, 0.30, 7850};

/// The default cage at mesh density 2.
inline const CageTable& coarse_table() {
  static const CageTable table = make_cage_table({}, kCageSteel, {}, {.density = 2});
  return table;
}

/// Lot and pocket scatter of 75 um each in width and length, 75 um in pitch, 2 mrad in squareness,
/// cut at the range of the table.
inline std::vector<PocketDeviation> scattered_pockets(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const PocketDeviation& range = coarse_table().range;
  const auto within = [](double value, double limit) { return std::clamp(value, -limit, limit); };
  const double lot_width = 75e-6 * normal(random);
  const double lot_length = 75e-6 * normal(random);
  std::vector<PocketDeviation> deviations(13);
  for (auto& d : deviations) {
    d.width = within(lot_width + 75e-6 * normal(random), range.width);
    d.length = within(lot_length + 75e-6 * normal(random), range.length);
    d.pitch = within(75e-6 / 19.5e-3 * normal(random), range.pitch);
    d.squareness = within(2e-3 * normal(random), range.squareness);
  }
  return deviations;
}

/// Deviations from the default cage as deviations from the undeviated pocket of one of its tables.
inline std::vector<PocketDeviation> deviations_from(const CageTable& table,
                                                    std::vector<PocketDeviation> deviations) {
  for (PocketDeviation& deviation : deviations) {
    deviation.width += CageDimensions{}.pocket_width - table.cage.pocket_width;
    deviation.length += CageDimensions{}.pocket_length - table.cage.pocket_length;
  }
  return deviations;
}

}  // namespace cagetol::test
