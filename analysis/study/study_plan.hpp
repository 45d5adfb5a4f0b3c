// What the study asked for, read from /study/json of study.h5 (keys: mc/README.md).
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace cagetol {

/// An uncertain key of the scene. Laws are kept as the JSON objects of the study; null where the
/// scope is not varied.
struct InputPlan {
  std::string key, unit;
  std::vector<double> nominal;
  nlohmann::json lot, pocket, noise;
};

struct LimitPlan {
  std::string quantity;
  std::optional<double> minimum, maximum;
  std::string source;
  double cage_revolutions = 0;
};

/// What a tolerance costs: a + b / band^k with the band in mm, or the straight lines through a
/// table.
struct CostPlan {
  double a = 0, b = 0, k = 1;
  std::vector<std::pair<double, double>> table;  ///< band in mm and cost, bands ascending; or empty
};

struct ToleranceDimensionPlan {
  std::string key;
  double band_mm = 0;  ///< full width to which the laws of the study belong
  std::optional<CostPlan> cost = {};
};

/// The stages that lead to a confirmed tolerance.
struct CampaignSettings {
  std::size_t attempts = 2;         ///< confirmations at most
  std::size_t confirm_samples = 0;  ///< most runs of one confirmation; 0: chosen
  std::size_t budget_samples = 0;   ///< runs of all stages together; 0: no budget
  double budget_h = 0;              ///< wall-clock hours of all stages together; 0: no budget
};

/// One combination of candidate bands, in the order of the tolerance dimensions.
struct CandidatePlan {
  std::vector<double> bands_mm;
  std::vector<std::string> grades;  ///< "" where the band was given in mm
  std::vector<double> scales;
};

struct CorrelationPlan {
  std::string first, second;  ///< "KEY:lot"
  double rho = 0;
};

/// What a source claims about a quantity between two levels of a dimension.
struct TrendPlan {
  std::string claim, quantity, key;
  double from = 0, to = 0;  ///< lot deviations in the key's unit
  std::string expected;     ///< rises, falls, level, unclear
  double by_share = 0, by_value = 0;
  std::string source;
};

struct StudyPlan {
  std::string name;
  double extra_replicates = 0;
  double cages_per_lot = 1;
  double allowed_failure_share = 0.02;
  double target_yield = 0.95;
  double confidence = 0.95;
  CampaignSettings campaign;
  std::vector<InputPlan> inputs;
  std::vector<LimitPlan> limits;
  std::vector<ToleranceDimensionPlan> dimensions;
  std::vector<CandidatePlan> candidates;
  std::vector<CorrelationPlan> correlations;
  std::vector<TrendPlan> trends;
  nlohmann::ordered_json scene;  ///< every key of the scene with its nominal value
  nlohmann::ordered_json whole;  ///< the study as stored
};

/// Parses the text of /study/json. Throws StudyFileError naming `file` and the key at fault.
StudyPlan read_study_plan(const std::string& text, const std::string& file);

}  // namespace cagetol
