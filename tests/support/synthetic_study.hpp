// Studies with formulas in place of a bearing: what the analysis must find is known.
#pragma once

#include <filesystem>
#include <string>

#include "analysis/study/study_data.hpp"

namespace cagetol {

struct SyntheticOptions {
  std::int64_t rows = 1000;
  std::int64_t seed = 7;
  std::int64_t cages_per_lot = 1;
  std::string design = "random";
  double replicate_share = 0.15;
  bool candidates = true;
  double failed_share = 0.004;
  double stress_limit = 100;  ///< two-sided with a lower limit of 20
  double whirl_limit = 1.1;
};

/// An NU 205 with 13 pockets. Quantities:
///   cage_stress_peak_MPa    60 + 1.2 (largest width of the cage - 7.65 mm) / um, and noise of 2
///   whirl_radius_ratio_p95  0.9 + 0.006 (width lot) / um + 0.02 (noise of the start)
///   cage_slip_ratio         grows with the squareness scatter
///   pocket_force_peak_N     grows with the deviation of pocket 4
///   lambda_min              undefined
/// Length changes nothing. A cage with a pocket narrower than 7.60 mm jams; `failed_share` of the
/// runs fail.
StudyData make_synthetic_study(const SyntheticOptions& options = {});

/// A study without inputs or quantities: rows that all are ok, each in its lot.
StudyData plain_study(std::int64_t rows, const std::string& design = "random",
                      std::int64_t cages_per_lot = 1, std::int64_t seed = 7);

/// Writes the study as mc/RESULTS_FORMAT.md says.
void write_synthetic_study(const StudyData& study, const std::filesystem::path& file);

}  // namespace cagetol
