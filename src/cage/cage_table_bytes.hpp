// A cage table as bytes, to be kept between runs, and what identifies it.
#pragma once

#include <string>
#include <string_view>

#include "src/cage/cage_table.hpp"

namespace cagetol {

/// Identifies everything of a scene that a table depends on: 16 hex digits. The program that makes
/// a table is no part of it.
std::string cage_table_key(const CageDimensions& cage, const Material& material,
                           const CageStations& stations, const CageTableOptions& options);

/// Everything of a table that is computed; the rest follows from what the key covers.
std::string cage_table_bytes(const CageTable& table);

/// Fills what `cage_table_bytes` wrote; complete_cage_table() sets the rest. False where the bytes
/// have not the form of a table: too short, too long, sizes that cannot be. Whether they are those
/// that were written is for a checksum to say.
bool read_cage_table_bytes(std::string_view bytes, CageTable& table);

}  // namespace cagetol
