// --snapshot FILE.vtu: the flexible cage at the instant of its largest stress, for ParaView.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "src/cage/table/cage_recovery.hpp"
#include "src/cage/table/scene_cage.hpp"
#include "src/quantities/outcome.hpp"

namespace cagetol {

void add_snapshot_option(CLI::App& command, std::string& file);

/// The one state of a run's peak.
CageStates state_of(const CagePeak& peak, const CageGeometry& cage);

/// Throws InputError where the run has no flexible cage, no stress, or the file cannot be written.
void write_peak_snapshot(const std::string& file, const Scene& scene, const CageTable* table,
                         const Outcome& outcome);

}  // namespace cagetol
