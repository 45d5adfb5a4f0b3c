// What one newton on a bar does to a flexible cage: how far the bar deflects, and the stress.
//
// A static force along the tangent, balanced by the inertia of the whole cage (inertia relief).
#pragma once

#include <string>
#include <vector>

#include "src/cage/table/cage_model.hpp"

namespace cagetol {

struct UnitBarLoad {
  double x = 0;                 ///< axial position of the station [m]
  double kept_compliance = 0;   ///< of the station, by the modes kept [m/N]
  double other_compliance = 0;  ///< what these leave out [m/N]
  double stress = 0;            ///< largest von Mises stress of the stress stations [Pa/N]
  std::string place;            ///< where that is (station_name)
};

/// One for each bar station of the leading face of `pocket`. `model` is of `table` and has stress
/// rows.
std::vector<UnitBarLoad> unit_bar_loads(const CageTable& table, const CageModel& model,
                                        long pocket);

}  // namespace cagetol
