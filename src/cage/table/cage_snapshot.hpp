// Writes a state of the flexible cage to a file for ParaView.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "src/cage/table/cage_recovery.hpp"

namespace cagetol {

/// Writes a VTK unstructured grid (XML, .vtu, ASCII): the mesh of the deviated cage [m] with the
/// node data `displacement` (elastic, cage frame) [m], `von_mises` and `stress` (xx, yy, zz, xy,
/// yz, zx) [Pa], for the first of the states. Returns a fault if the cage is impossible; throws
/// std::runtime_error if the file cannot be written.
std::optional<CageFault> write_cage_snapshot(const std::filesystem::path& file,
                                             const CageTable& table,
                                             const std::vector<PocketDeviation>& deviations,
                                             const CageStates& state);

}  // namespace cagetol
