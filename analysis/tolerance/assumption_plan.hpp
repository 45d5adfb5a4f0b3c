// Which alternatives of assumptions a recommendation runs, and where their runs are: what
// DIR/assumptions.json holds.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/study/estimate.hpp"

namespace cagetol {

/// One end of the range of an assumed key, in the key's unit.
struct AssumedValue {
  std::string key, unit, note;
  double low = 0, high = 0;     ///< the range
  double value = 0;             ///< the end
  double nominal = kUndefined;  ///< NaN: "auto", or not the same for all pockets
};

struct AssumptionPlan {
  std::size_t attempt =
      0;                 ///< number of the attempt whose runs are the reference; 0: there is none
  std::size_t runs = 0;  ///< under each alternative; 0: none
  std::size_t confirming = 0;  ///< runs under each with which it holds if none fails
  /// Runs that settle an alternative with kWantedPower if its yield is the attempt's; 0: not known.
  std::size_t settling = 0;
  double seconds_per_run = 0;  ///< over all processes
  std::vector<AssumedValue> alternatives;
};

/// More runs than this many times `confirming` are only run where they are asked for by number.
inline constexpr std::size_t kMostOfAuto = 100;

/// Runs under each alternative for "auto": those that settle it, within kMostOfAuto; else those
/// that confirm if none fails.
std::size_t automatic_runs(const AssumptionPlan& plan);

/// Name of the directory of an alternative's runs: "assume-1-300/lubrication.pocket_layer_um-5".
std::string alternative_directory(const AssumptionPlan& plan, const AssumedValue& alternative);

/// What will be run and how long it takes, or how to have it run; empty without alternatives.
std::string assumption_plan_text(const AssumptionPlan& plan);

nlohmann::ordered_json to_json(const AssumptionPlan& plan);
/// Throws nlohmann::json::exception.
AssumptionPlan assumption_plan_of(const nlohmann::ordered_json& json);

}  // namespace cagetol
