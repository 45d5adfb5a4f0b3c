// A state of the flexible cage as a file for ParaView.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "src/cage/cage_recovery.hpp"

namespace cagetol {

/// Writes a VTK unstructured grid (XML, .vtu, ASCII): the mesh of the deviated cage [m] with the
/// node data `displacement` (elastic, cage frame) [m], `von_mises` and `stress` (xx, yy, zz, xy,
/// yz, zx) [Pa]. The first of the states is drawn. A fault where there is no such cage;
/// throws std::runtime_error where the file cannot be written.
std::optional<CageFault> write_cage_snapshot(const std::filesystem::path& file,
                                             const CageTable& table,
                                             const std::vector<PocketDeviation>& deviations,
                                             const CageStates& state);

}  // namespace cagetol
