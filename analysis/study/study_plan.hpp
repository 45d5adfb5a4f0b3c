// What the study asked for, read from /study/json of study.h5 (keys: mc/README.md).
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mc/study_file/correlation.hpp"
#include "mc/study_file/limit.hpp"
#include "mc/study_file/tolerance.hpp"

namespace cagetol {

/// An uncertain key of the scene. Laws are kept as the JSON objects of the study; null where the
/// scope is not varied.
struct InputPlan {
  std::string key, unit;
  std::vector<double> nominal;
  nlohmann::json lot, pocket, noise;
};

/// The stages that lead to a confirmed tolerance.
struct CampaignSettings {
  std::size_t attempts = 2;         ///< confirmations at most
  std::size_t confirm_samples = 0;  ///< most runs of one confirmation; 0: chosen
  std::size_t budget_samples = 0;   ///< runs of all stages together; 0: no budget
  double budget_h = 0;              ///< wall-clock hours of all stages together; 0: no budget
  std::size_t screen_samples = 0;   ///< runs before the pilot
  bool jams_alone = false;          ///< the screen: no limit takes what jams leave of the target
};

struct StudyPlan {
  std::string name;
  double extra_replicates = 0;
  double cages_per_lot = 1;
  bool redraw_jams = false;  ///< every run is of a cage that fits
  bool scale_lots = true;    ///< candidates scale lots as they do pockets
  double allowed_failure_share = 0.02;
  double target_yield = 0.95;
  double confidence = 0.95;
  CampaignSettings campaign;
  std::vector<InputPlan> inputs;
  std::vector<Limit> limits;
  std::vector<ToleranceDimension> dimensions;
  std::vector<Candidate> candidates;
  std::vector<Correlation> correlations;
  nlohmann::ordered_json scene;  ///< every key of the scene with its nominal value
  nlohmann::ordered_json whole;  ///< the study as stored
};

/// What runs are judged by: limits, target and confidence.
nlohmann::ordered_json judgement_of(const StudyPlan& plan);

/// Parses the text of /study/json. Throws StudyFileError naming `file` and the key at fault.
StudyPlan read_study_plan(const std::string& text, const std::string& file);

}  // namespace cagetol
