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

struct ToleranceDimensionPlan {
  std::string key;
  double band_mm = 0;  ///< full width to which the laws of the study belong
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
  double cages_per_lot = 1;
  double allowed_failure_share = 0.02;
  double target_yield = 0.95;
  double confidence = 0.95;
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
