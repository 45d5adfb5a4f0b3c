// Results of a model ladder: every quantity of interest on every rung, from the rungs' study files.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/fidelity/minimum_rung.hpp"
#include "analysis/study/study_data.hpp"

namespace cagetol {

struct LadderRung {
  std::string name;
  std::string meaning = {};
  std::vector<std::string> settings = {};  ///< "dotted.key=value"
  double cost_ratio = kUndefined;  ///< wall time over that of the reference, median of the samples
  std::size_t ok = 0;              ///< runs with a result
};

struct LadderQuantity {
  std::string name, unit;
  std::vector<Limit> limits = {};  ///< limits of the study on this quantity
  QuantityLadder ladder;
  bool limited() const { return !limits.empty(); }
};

struct ModelLadder {
  std::string study;
  std::string build;                      ///< of the program that ran it
  nlohmann::ordered_json resolved_study;  ///< mc/README.md lists the keys
  /// True if the rungs refine the reference, which is the scene as given. A shift is then the
  /// change of the mean by refining, the error of the reference is minus the shift, and no cheapest
  /// rung is sought.
  bool refining = false;
  LadderRule rule;
  std::size_t samples = 0;
  std::vector<LadderRung> rungs;          ///< cheapest first, the last one is the reference
  std::vector<std::string> not_run = {};  ///< rungs without runs
  std::vector<LadderQuantity> quantities;
};

/// Judges a ladder. `runs[r]` are the same samples on rung r; target yield, candidates and limits
/// come from the study in their files. Throws StudyFileError if the samples differ.
ModelLadder make_model_ladder(std::vector<LadderRung> rungs, const std::vector<StudyData>& runs,
                              const LadderRule& rule);

/// The rung for `fidelity = "auto"`: the cheapest one that is sufficient for every limited
/// quantity, or the reference if there is none.
std::size_t chosen_rung(const ModelLadder& ladder);

/// "limit at least 1, at most 2".
std::string limits_text(const std::vector<Limit>& limits);

nlohmann::ordered_json ladder_json(const ModelLadder& ladder);
std::string ladder_text(const ModelLadder& ladder);

}  // namespace cagetol
