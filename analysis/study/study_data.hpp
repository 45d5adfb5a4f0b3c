// study.h5 (mc/RESULTS_FORMAT.md) as plain structs. Everything the room computes starts here.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/study/study_plan.hpp"
#include "mc/study_file/jam.hpp"

namespace cagetol {

/// How a run ended, as numbered in study.h5.
enum class RunStatus : std::int64_t { ok, jammed, failed, censored, not_run, poisoned };
const char* run_status_name(RunStatus status);

/// A column of reals, one for each sample; NaN where not defined.
struct Column {
  std::string name, unit, description;
  std::vector<double> values;
};

/// An uncertain key of the scene in the key's unit. Parts the study does not vary are empty.
struct InputColumns {
  std::string key, unit;
  std::vector<double> nominal;
  std::vector<double> lot, noise;  ///< N values
  std::vector<double> pocket;      ///< N x Z deviations, row-major
  std::vector<double> value;       ///< N x Z where `per_pocket`, else N
  bool per_pocket = false;
};

struct Provenance {
  std::string tool_version, tool_commit, build, libraries, study_name, study_hash;
  std::int64_t schema_version = 0, seed = 0;
  std::vector<std::string> files;
};

/// How the rows were chosen.
struct StudyDesign {
  std::string kind;  ///< random, lhs; of old files also others
  std::int64_t rows_planned = 0, samples_planned = 0;
};

struct StudyData {
  Provenance provenance;
  StudyDesign design;
  StudyPlan plan;
  /// Limits, target or confidence of the plan were stated after the runs had been seen.
  bool judged_again = false;
  std::size_t pockets = 0;  ///< Z
  JamShares jam;

  std::vector<std::int64_t> id, row, replicate, lot, candidate, pocket;
  std::vector<RunStatus> status;
  std::vector<std::string> reason;
  std::vector<double> interference_um;

  std::vector<InputColumns> inputs;
  std::vector<Column> quantities, run, timing;

  std::size_t size() const { return id.size(); }
};

/// Reads and checks a study file: schema version, shapes, sizes. Throws StudyFileError.
StudyData read_study_data(const std::filesystem::path& file);

/// The samples at `keep`, in that order, with all their columns.
StudyData select_samples(const StudyData& study, const std::vector<std::size_t>& keep);

/// The study without its inputs, by far the most of it: for those who judge results alone.
StudyData results_of(StudyData study);

/// Samples that are the first run of their row and have an outcome (not_run is none): what every
/// statistic but the noise share is computed from.
std::vector<std::size_t> first_runs(const StudyData& study);

/// A column of the runs, NaN where a run gave no result.
std::vector<double> ok_values(const StudyData& runs, const std::vector<double>& column);

const Column* find_quantity(const StudyData& study, const std::string& name);
const InputColumns* find_input(const StudyData& study, const std::string& key);

}  // namespace cagetol
