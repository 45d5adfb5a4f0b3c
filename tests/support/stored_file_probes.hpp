// Probes of what the program itself stores.
#pragma once

#include <vector>

#include "tests/support/reader_probes.hpp"

namespace cagetol {

/// study.h5 as a restart reads it and as the analysis does, edited object by object and sealed
/// anew, or damaged below its seal.
std::vector<ReaderProbe> study_file_probes();

/// The bytes of a cage table, as behind a right checksum.
std::vector<ReaderProbe> cage_table_probes();

}  // namespace cagetol
