// The numbers of the report as CSV, for spreadsheets. First line: column names, units in them.
#pragma once

#include <filesystem>

#include "analysis/report/json_parts.hpp"
#include "analysis/study/study_data.hpp"

namespace cagetol {

/// samples.csv: one line a sample, with outcome, features of the cage and quantities.
/// quantities.csv and yield.csv: tables of report.json. limit_curves.csv where the report has them:
/// one line for each value of a limit and candidate. Throws StudyFileError when a file cannot be
/// written.
void write_csv_tables(const std::filesystem::path& directory, const StudyData& study,
                      const Json& report);

/// The `count` samples nearest to a limit, jams first: limits with their margins, quantities that
/// are limited, and every pocket's value of each input. `quantity`: whose limits count; empty: all.
std::string worst_csv(const StudyData& study, std::size_t count, const std::string& quantity);

}  // namespace cagetol
