// What a duty over time imposes: values at instants, straight lines between them, the first ones
// before and the last ones after; or again and again after a period.
//
// The slopes have corners at the instants. A step of an integrator must end there (next_corner):
// then no step meets a corner, and its order is that of a smooth problem.
#pragma once

#include <limits>
#include <vector>

#include "src/scene/scene.hpp"

namespace cagetol {

class DutyCourse {
 public:
  struct Row {
    double time = 0;                               ///< [s]
    double inner = 0, outer = 0;                   ///< speeds of the rings [rad/s]
    double radial = 0, direction = 0;              ///< load [N], [rad]
    double axial = 0, moment_y = 0, moment_z = 0;  ///< [N], [N m]
    double inner_turned = 0, outer_turned = 0;     ///< since t = 0 [rad]
  };

  DutyCourse() = default;
  /// Columns that the table leaves out have the constants of `operation`.
  explicit DutyCourse(const Operation& operation);

  bool empty() const { return rows_.empty(); }
  bool repeats() const { return period_ > 0; }
  /// Whether the speed of a ring changes.
  bool drives() const { return drives_; }
  /// Instants with their values, of a duty that repeats its end too.
  const std::vector<Row>& rows() const { return rows_; }
  double period() const { return period_; }  ///< [s]; 0: none
  /// After which nothing changes; infinite where the duty repeats [s].
  double end() const {
    return repeats() ? std::numeric_limits<double>::infinity() : rows_.back().time;
  }

  Row at(double t) const;
  /// The first instant after `t`; infinite if there is none [s].
  double next_corner(double t) const;

 private:
  std::vector<Row> rows_;
  double period_ = 0;
  bool drives_ = false;
};

}  // namespace cagetol
