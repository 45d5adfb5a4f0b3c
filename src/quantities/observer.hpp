// Observes a run through its measuring window and computes its results: quantities of interest,
// energy account, consistency with statics.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "src/integration/system.hpp"
#include "src/quantities/along_rolling.hpp"
#include "src/quantities/bar_peaks.hpp"
#include "src/quantities/cage_fatigue.hpp"
#include "src/quantities/cage_stress.hpp"
#include "src/quantities/cage_whirl.hpp"
#include "src/quantities/orbit_slip.hpp"
#include "src/quantities/outcome.hpp"
#include "src/quantities/peak_extrapolation.hpp"
#include "src/quantities/series.hpp"
#include "src/quantities/stationarity.hpp"
#include "src/quantities/window_times.hpp"
#include "src/statics/static_equilibrium.hpp"

namespace cagetol {

class Observer {
 public:
  /// The window is [begin, end] in seconds.
  Observer(const BearingModel& model, double begin, double end);
  /// The first window that a run has after settling.
  Observer(const BearingModel& model, const WindowTimes& times);

  /// Records an accepted state inside the window. Expects system.linearise_at() at this state.
  void record(double t, const double* y, const System& system);

  /// All quantities in the order of quantity_table().
  std::vector<double> quantities() const;
  /// Relative error of the energy account:
  ///   |work in - dissipation - change of stored energy| / max(dissipation, stored energy/1000)
  double energy_residual() const;
  /// The part of energy_residual() that steps with this tolerance cannot resolve: the energy
  /// difference of two states that differ by the largest error of a step. The error norm is a mean
  /// over n components, so a single component may be sqrt(n) times larger.
  double energy_resolution(double tolerance) const;
  double static_consistency_error() const;
  /// The part of static_consistency_error() that statics leaves out: the ring's change of momentum
  /// over the window, and the force of a cage guided by the inner ring.
  double static_resolution() const;
  /// Number of roller positions compared with statics, and how many of them have no static
  /// solution.
  long static_positions() const { return static_positions_; }
  long static_positions_missed() const { return static_positions_missed_; }
  /// Whether the motion drifts through the window. None if this is not judged: dry bearing,
  /// standstill, ramp within the window, or less than two turns of the cage.
  const std::optional<Stationarity>& stationarity() const { return stationarity_; }
  /// Revolutions of the cage within the window.
  double cage_revolutions() const { return revolutions_; }
  /// Largest angle between the axes of a roller and of the bearing [rad].
  double largest_lean() const { return std::sqrt(largest_lean_squared_); }
  /// Largest tilt of a free inner ring; 0 if the tilt is prescribed [rad].
  double largest_tilt() const { return ring_tilt_.empty() ? 0 : ring_tilt_.peak(); }
  /// State of the largest stress; empty for a rigid cage.
  const CagePeak& cage_peak() const { return extremes_.empty() ? cage_peak_ : extreme_peak_; }

 private:
  /// Counts contacts that close. A contact closed in the first state is not counted.
  struct Impacts {
    std::vector<Mask> open;
    long count = 0;
    void see(std::size_t pack, Mask touching);
  };
  void record_rollers(double t, const double* y, const System& system, const SeenStep& step);
  /// Whether a whole revolution of the cage has ended at t.
  bool revolution_ended(double t) const;
  /// Mean load and weight on the ring [N].
  double mean_imposed() const;
  void record_statics(double t, const double* y);
  /// The centrifugal force of one roller [N].
  double light_force() const;
  /// Reference force of static_consistency_error() [N].
  double static_scale() const;
  /// Reference energy of energy_residual() [J].
  double energy_scale() const;
  /// Moment on the ring that the rollers carry, not the shaft, as a couple at the roller ends [N].
  double rollers_couple(const RingLoad& load) const;
  void record_stress(double t, const double* y, const Observation& seen);
  void record_revolution(double t);
  /// Of everything that has been recorded so far.
  std::vector<double> quantities_so_far() const;

  const BearingModel& model_;
  bool over_time_;  ///< a duty over time: speeds and angles count along rolling without slip
  /// Whether net_power_rate tells how the power changes over a step: not under a duty over time,
  /// whose share of it is left out, nor under oil. There the traction of loaded contacts follows
  /// sliding within 1e-8 m/s, and its rate at one state is that state's own error, much enlarged.
  bool rate_known_;
  double begin_, end_;
  double revolution_ = std::numeric_limits<double>::infinity();  ///< of the cage [s]
  double peaks_end_ = std::numeric_limits<double>::infinity();   ///< where peaks end [s]
  StaticEquilibrium statics_;
  std::vector<double> angles_;
  double next_statics_;
  double statics_interval_;
  long static_positions_ = 0, static_positions_missed_ = 0;
  Series dynamic_displacement_, static_displacement_, static_elastic_,
      static_carried_;  ///< mean force of a roller on the inner race at rest [N]

  StepClock clock_;
  double stress_interval_;  ///< of the record of the cage's stress [s]
  double last_time_ = -1;

  StepSeries cage_speed_, rolling_, apart_, whirl_speed_, cage_axial_, cage_lean_y_, cage_lean_z_,
      ring_elastic_, tilt_y_, tilt_z_;
  StepSeries whirl_radius_{kPeak | kQuantiles}, guide_force_{kPeak | kQuantiles},
      ring_y_{kQuantiles}, ring_z_{kQuantiles}, sunk_, ring_tilt_{kPeak};
  CageWhirl whirl_;
  OrbitSlip orbit_slip_;
  AlongRolling along_;            ///< of a duty over time
  StepSeries imposed_;            ///< likewise: load and weight on the ring [N]
  StepSeries spun_;               ///< likewise: kinematic spin of the rollers [rad/s]
  RollerSeries spun_loaded_;      ///< likewise, of loaded rollers
  RollerSeries carried_rolling_;  ///< likewise: force times kinematic speed of the cage
  long ended_revolutions_ = 0;
  std::optional<Stationarity> stationarity_;
  RollerSeries carried_, carried_orbit_;  ///< force on the inner race [N], and times orbital rate
  RollerSeries slip_loaded_, slip_all_, sliding_{kPeak}, roller_speed_;
  RollerSeries skew_{kQuantiles}, tilt_{kQuantiles}, pocket_force_{kPeak | kQuantiles},
      wall_force_{kPeak | kQuantiles};
  PlaneAcceleration ring_acceleration_;
  std::optional<CageStress> stress_;
  std::optional<CageFatigue> fatigue_;
  std::optional<BarPeaks> bar_peaks_;
  Series cage_stress_;
  double last_stress_ = 0, next_stress_ = 0;
  CagePeak cage_peak_;
  std::vector<double> extremes_;  ///< quantities where peaks ended; empty: not yet
  CagePeak extreme_peak_;         ///< likewise
  /// Largest values of each revolution, ended ones and the one under way; for extrapolation.
  struct BlockPeaks {
    std::vector<double> ended;
    double now = 0;
    void see(double value) { now = std::max(now, value); }
    void end() {
      ended.push_back(now);
      now = 0;
    }
  };
  ExtrapolatedPeak extrapolated(const BlockPeaks& of) const;
  double extrapolate_ = std::numeric_limits<double>::quiet_NaN();  ///< [revolutions]; NaN: off
  BlockPeaks pocket_blocks_, guide_blocks_, stress_blocks_;
  double thinnest_film_ = kNoFilm;                              ///< [m]
  double roller_load_ = 0, inner_slice_ = 0, outer_slice_ = 0;  ///< largest at the races [N]
  double largest_lean_squared_ = 0;
  double orbit_turned_ = 0, orbit_angle_ = 0;
  double revolutions_ = 0, start_phase_ = 0;
  double end_displacement_ = 0;
  Impacts pocket_impacts_, wall_impacts_, guide_impacts_;
  HermiteQuadrature net_work_;      ///< where the power's rate is known [J]
  StepSeries net_power_;            ///< where it is not [W]
  StepSeries dissipation_, drive_;  ///< powers [W]
  std::array<StepSeries, kMechanisms> lost_;
  double first_energy_ = 0, last_energy_ = 0;
  double first_ring_speed_[2] = {0, 0}, last_ring_speed_[2] = {0, 0};  ///< y and z [m/s]
};

}  // namespace cagetol
