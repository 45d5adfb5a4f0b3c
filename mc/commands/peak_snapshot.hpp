// Files that one run leaves: -o FILE.h5, its time histories; --snapshot FILE.vtu, the flexible cage
// at the instant of its largest stress, for ParaView.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "mc/study/sample.hpp"
#include "src/cage/table/cage_recovery.hpp"
#include "src/quantities/outcome.hpp"

namespace cagetol {

struct RunFiles {
  std::string history, snapshot;  ///< empty: not asked for
};

void add_run_file_options(CLI::App& command, RunFiles& files);

/// Runs the sample and writes the files. Throws InputError where it has no histories, no flexible
/// cage or no stress, or a file cannot be written.
Outcome run_with_files(const Study& study, const Sample& sample, const RunFiles& files);

/// The one state of a run's peak.
CageStates state_of(const CagePeak& peak, const CageGeometry& cage);

}  // namespace cagetol
