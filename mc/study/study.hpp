// A study: which numbers of a scene are uncertain, how many samples, which limits decide, which
// tolerances are candidates.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "distributions/design.hpp"
#include "distributions/law.hpp"
#include "mc/study/measured_parts.hpp"
#include "mc/study_file/correlation.hpp"
#include "mc/study_file/limit.hpp"
#include "mc/study_file/tolerance.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

/// A scene key that is a distribution. Deviations add up, in the key's unit:
///   value = nominal + scale * (lot + pocket) + noise      (scale of the lot: 1 without scale_lots)
/// Laws describe deviations from the nominal value, not the value itself.
struct UncertainInput {
  std::string key;
  std::string unit;
  std::vector<double> nominal;  ///< one value, or one per pocket
  bool per_pocket = false;      ///< the key holds one number per pocket
  std::optional<Law> lot;       ///< drawn once per lot (a cage, unless cages_per_lot > 1)
  std::optional<Law> pocket;    ///< drawn for every pocket
  std::optional<Law> noise;  ///< drawn from the sample's own noise stream: not part of the design
  std::optional<MeasuredParts> measured = {};  ///< what the laws were read from

  /// Measured cages are drawn, and not laws of their parts.
  bool draws_cages() const { return measured && measured->is_grouped() && !measured->fitted; }
};

/// How `cagetol recommend` goes about it: pilot, mixture of all candidates, confirmations.
struct RecommendPlan {
  long pilot_samples = 128;
  long attempts = 2;         ///< confirmations at most, planned beforehand
  long confirm_samples = 0;  ///< most runs of one confirmation; 0: chosen
  long budget_samples = 0;   ///< runs of all stages together; 0: no budget
  double budget_time = 0;    ///< wall-clock time of all stages together, s; 0: no budget
  /// Runs under each alternative of an assumption; 0: none, NaN: as many as confirm the target when
  /// none fails.
  double assumption_samples = 0;
};

/// How `cagetol screen` goes about it.
struct ScreenPlan {
  long budget_samples = 40;  ///< runs in all
};

/// How `cagetol map` goes about it.
struct MapPlan {
  long budget_samples = 24;  ///< runs of each cell
  long border_samples = 40;  ///< further runs at a border, or where nothing is resolved
};

/// How `cagetol rare` goes about it.
struct RarePlan {
  double target_ppm = 63;       ///< share of cages in question
  long budget_samples = 0;      ///< runs in all; 0: no stage of `recommend`, 1100 runs of `rare`
  double relative_error = 0.3;  ///< standard error of a measured share, as a share of it
};

struct TolerancePlan {
  double target_yield = 0.95;
  double confidence = 0.95;
  std::vector<ToleranceDimension> dimensions;
};

/// What a rung of the model ladder does to the mean of a limited quantity, in the quantity's unit
/// (analysis/fidelity/minimum_rung.hpp). Numbers that are not known are NaN.
struct FidelityShift {
  std::string quantity, rung;
  double shift = 0, lower = 0, upper = 0;  ///< against the highest rung, with its interval
  double budget = 0;                       ///< largest |shift| allowed
  std::string verdict;                     ///< adequate, settled, biased, unresolved, unusable
  std::string limit = {};                  ///< on the quantity, in words
  /// Share of samples on the wrong side of the limit, at most, and what would settle it.
  double wrong_share = 0, allowed_wrong_share = 0;
};

/// The rung that fidelity = "auto" has taken, and why.
struct FidelityDecision {
  std::string rung;                   ///< empty: nothing has been decided
  std::string reason;                 ///< in words
  std::string assumption;             ///< what verdicts rest on, where some limit is settled
  std::vector<FidelityShift> shifts;  ///< by quantity, then by rung
};

/// One of several operating points at which each sample runs (mc/study/operating_points.hpp).
struct OperatingPointPlan {
  std::string name;
  double weight = 1;                                          ///< relative to the other points
  std::vector<std::pair<std::string, std::string>> settings;  ///< scene key, value as TOML text
};

/// What a report says of the order that it belongs to; empty texts are left out.
struct DocumentPlan {
  std::string customer, project, drawing, revision, author, checked_by, date;
};

struct Study {
  std::string name = "study";
  long seed = 1;
  long samples = 256;  ///< design rows
  double extra_replicates =
      0;  ///< additional runs with fresh noise, as a share of rows; 15 means 16 runs of every row
  DesignKind design = DesignKind::random;
  long cages_per_lot = 1;
  bool redraw_jams = false;       ///< cages that do not fit are drawn again (cage_fit.hpp)
  bool measured_in_turn = false;  ///< rows run the measured cages one after the other
  bool scale_lots = true;  ///< candidates scale the lots' deviations like those of the pockets
  double allowed_failure_share = 0.02;
  std::string fidelity = "pinned";  ///< of the model: "pinned" as the scene says, or "auto"
  long fidelity_samples = 24;       ///< runs on each rung of the model ladder
  double fidelity_budget = 0.1;     ///< largest shift allowed, in standard errors of the study
  Scene scene;                      ///< nominal
  bool names_lubrication = true;    ///< the scene gives lubrication.model
  std::vector<UncertainInput> inputs;
  std::vector<OperatingPointPlan> points;  ///< none: the scene's own load and speed
  std::vector<Correlation> correlations;
  std::vector<Limit> limits;
  TolerancePlan tolerance;
  double cage_check_share = 0.01;  ///< of samples whose flexible cage is also solved in full
  FidelityDecision fidelity_decision;
  RecommendPlan recommend;
  ScreenPlan screen;
  DocumentPlan document;
  MapPlan map;
  RarePlan rare;
  std::vector<Candidate> candidates;
  std::string resolved_toml, resolved_json;
  std::vector<std::pair<std::string, std::string>> files;  ///< further input files: name, text hash
  std::string hash;  ///< 16 hex digits, 64-bit FNV-1a over identity_text(resolved_toml) and `files`
};

/// Samples in all: rows plus noise replicates.
std::uint64_t sample_count(const Study& study);

/// Reads a study file, or a scene file (then: one row, every distribution of the scene drawn).
/// `settings` are "key=value" in TOML syntax; scene keys may be given with or without "scene." in
/// front. Throws InputError.
Study read_study(const std::string& path, const std::vector<std::string>& settings = {});

/// Likewise, to run the measured cages of the CSV file `measured` one after the other: laws with a
/// file read this one, whose path is relative to the working directory.
Study read_measured_study(const std::string& path, std::vector<std::string> settings,
                          const std::string& measured);

/// Reads a study from its resolved text (Study::resolved_toml): gives the same study with the same
/// hash. Keys of an earlier program that are gone without a successor are left out with a warning.
Study read_resolved_study(const std::string& resolved_toml, const std::string& name);

/// The study after `change`, which may touch all that its text says; resolved and hashed anew.
Study changed_study(Study study, const std::function<void(Study&)>& change);

/// Refuses to set the scene in motion that does not say whether there is oil in the bearing: a
/// quasi-static scene, when it stands on a model ladder. Throws InputError naming `file`.
void require_word_of_oil(const Study& study, const std::string& file);

/// What a user should know before a sweep, though nothing is wrong: "limit ... is for 6 cage
/// revolutions, the window has 2".
std::vector<std::string> study_notes(const Study& study);

/// These, and what concerns a sweep of the study's own rows alone, which is no recommendation.
std::vector<std::string> sweep_notes(const Study& study);

/// Of these, what a simplified model (the scene's section [model]) leaves out of this study.
std::vector<std::string> model_notes(const Study& study);

}  // namespace cagetol
