// A cage table as bytes for storage between runs, and the key that identifies it.
#pragma once

#include <string>
#include <string_view>

#include "src/cage/table/cage_table.hpp"

namespace cagetol {

/// Key of everything in a scene that a table depends on: 16 hex digits. The version of the program
/// is not part of it.
std::string cage_table_key(const CageDimensions& cage, const Material& material,
                           const CageStations& stations, const CageTableOptions& options);

/// The computed part of a table; the rest follows from the dimensions.
std::string cage_table_bytes(const CageTable& table);

/// Fills the computed part of a table from cage_table_bytes(); complete_cage_table() sets the rest.
/// False if the bytes do not have the form of a table: too short, too long, impossible sizes.
/// Changed bytes are not detected; that needs a checksum.
bool read_cage_table_bytes(std::string_view bytes, CageTable& table);

}  // namespace cagetol
