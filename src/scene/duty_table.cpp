#include <algorithm>
#include <cmath>

#include "src/scene/scene.hpp"

namespace cagetol {
namespace {

double largest(const NumberList& column, double constant) {
  if (column.empty()) return std::abs(constant);
  double most = 0;
  for (const double value : column.values) most = std::max(most, std::abs(value));
  return most;
}

}  // namespace

AxialLoads axial_loads(const Operation& o) {
  const NumberList& column = o.table.axial_load;
  if (column.empty()) return {std::min(o.axial_load, 0.0), std::max(o.axial_load, 0.0)};
  AxialLoads loads;
  for (const double value : column.values) {
    loads.minimum = std::min(loads.minimum, value);
    loads.greatest = std::max(loads.greatest, value);
  }
  return loads;
}

double first_axial_load(const Operation& o) {
  for (const double value : o.table.axial_load.values)
    if (value != 0) return value;
  return o.axial_load;
}

double largest_radial_load(const Operation& o) {
  return largest(o.table.radial_load, o.radial_load);
}

double largest_inner_speed(const Operation& o) {
  return largest(o.table.inner_speed, o.inner_speed);
}

double largest_outer_speed(const Operation& o) {
  return largest(o.table.outer_speed, o.outer_speed);
}

}  // namespace cagetol
