// Error against cost of every method and tolerance on one scene: trajectories over a short horizon,
// means of the quantities of interest over the scene's whole window. There the rungs of the model
// ladder may stand beside them: what a cheaper model saves and costs, in the same units.
#pragma once

#include <functional>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "analysis/compare/bias.hpp"
#include "mc/benchmark/setting.hpp"
#include "mc/ladder/rungs.hpp"
#include "mc/study/study.hpp"
#include "src/quantities/outcome.hpp"

namespace cagetol {

struct ChartOptions {
  std::vector<IntegrationMethod> methods;  ///< empty: all
  double horizon = kAuto;  ///< of trajectories; kAuto: the time between two rollers that pass [s]
  int replicas = 4;        ///< of the long horizon; 0: short horizon only
  int starts = 64;         ///< of short runs: places of the rollers within one pitch
  int threads = 1;         ///< replicas at a time
  bool rungs = false;      ///< the model ladder beside the settings
};

inline constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

/// One setting over one horizon.
struct ChartCost {
  /// Wall seconds per simulated second, median over the runs that are ok. Of trajectories without
  /// the search for their start.
  double rtf = kNotMeasured;
  double rhs_per_s = kNotMeasured;  ///< right-hand sides per simulated second, median
  std::string problem{};            ///< why runs are missing; empty if none is
  bool on_front = false;            ///< nothing measured is both cheaper and more accurate
};

/// Means over the replicas' windows against those of a reference.
struct WindowErrors {
  ChartCost window;
  std::vector<Bias> biases;  ///< in the order of quantity_table()
  double bias_rms = 0;       ///< root mean square over the quantities of bias / deviation
  double bias_noise = 0;     ///< the same of standard error / deviation: what is resolved
};

struct ChartPoint : WindowErrors {
  Setting setting;
  ChartCost brief;
  double trajectory_error = 0;  ///< at the horizon, median over the starts [error scales]
};

/// A rung of the model ladder with its own settings, against the highest rung integrated tightly;
/// over the quantities that it defines.
struct RungPoint : WindowErrors {
  Rung rung;
  int quantities = 0;  ///< in bias_rms
};

struct Chart {
  std::string scene;
  ChartOptions options;
  double reference_gap = 0;        ///< trajectories of the two references apart, likewise
  std::vector<ChartPoint> points;  ///< the scene's own setting first
  std::vector<RungPoint> rungs;    ///< of the ladder for the scene, where asked for
};

/// Measures all settings; `say` is told what is going on.
Chart make_chart(const Study& study, const ChartOptions& options,
                 const std::function<void(const std::string&)>& say);

nlohmann::ordered_json chart_json(const Chart& chart);
/// What to read in the chart, in sentences.
std::string chart_text(const Chart& chart);

}  // namespace cagetol
