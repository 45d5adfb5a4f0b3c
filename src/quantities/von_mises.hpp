// Von Mises stress of the stations of a sector of the cage.
#pragma once

#include <Eigen/Core>

namespace cagetol {

/// Squares of the von Mises stress, from a sector's components one after the other: all xx, then
/// yy, zz, xy, yz, zx.
template <typename Sector>
auto von_mises_squared(const Sector& sector) {
  const Eigen::Index stations = sector.size() / 6;
  const auto part = [&](Eigen::Index c) { return sector.segment(c * stations, stations).array(); };
  return 0.5F * ((part(0) - part(1)).square() + (part(1) - part(2)).square() +
                 (part(2) - part(0)).square()) +
         3.0F * (part(3).square() + part(4).square() + part(5).square());
}

}  // namespace cagetol
