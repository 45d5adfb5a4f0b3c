// A climbed model ladder: every quantity of interest on every rung, from the study files of the
// rungs.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/fidelity/least_rung.hpp"
#include "analysis/study/study_data.hpp"

namespace cagetol {

struct LadderRung {
  std::string name;
  std::string meaning = {};
  std::vector<std::string> settings = {};  ///< "dotted.key=value"
  double cost_ratio = kUndefined;  ///< wall time over the reference's, median of the samples
  std::size_t ok = 0;              ///< runs that gave a result
};

struct LadderQuantity {
  std::string name, unit;
  std::vector<Limit> limits = {};  ///< of the study on it
  QuantityLadder ladder;
  /// Predicted for a mean that takes cheaper rungs to help (multifidelity.hpp), measured costs; 1:
  /// the reference alone.
  double multifidelity_gain = 1;
  bool limited() const { return !limits.empty(); }
};

struct ModelLadder {
  std::string study;
  std::string build;                      ///< of the program that climbed it
  nlohmann::ordered_json resolved_study;  ///< for which (mc/README.md lists the keys)
  /// Rungs refine the reference, the scene as it is, so that no least one is sought: a shift is
  /// what refining adds to the mean, and the reference errs by its opposite.
  bool refining = false;
  LadderRule rule;
  std::size_t samples = 0;
  std::vector<LadderRung> rungs;          ///< cheapest first, the last one is the reference
  std::vector<std::string> not_run = {};  ///< rungs that were not climbed: nothing is known of them
  std::vector<LadderQuantity> quantities;
};

/// `runs[r]` are the same samples on rung r; target yield, candidates and limits are those of the
/// study in their files. Throws StudyFileError where the samples differ.
ModelLadder make_model_ladder(std::vector<LadderRung> rungs, const std::vector<StudyData>& runs,
                              const LadderRule& rule);

/// The rung that `fidelity = "auto"` takes: the cheapest one that will do for every limited
/// quantity, the reference where no other one does.
std::size_t chosen_rung(const ModelLadder& ladder);

/// "limit at least 1, at most 2".
std::string limits_text(const std::vector<Limit>& limits);

nlohmann::ordered_json ladder_json(const ModelLadder& ladder);
std::string ladder_csv(const ModelLadder& ladder);
std::string ladder_text(const ModelLadder& ladder);

}  // namespace cagetol
