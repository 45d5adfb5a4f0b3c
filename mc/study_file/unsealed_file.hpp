// HDF5 files without a checksum: schema 1 of study.h5, and what other programs wrote. HDF5 1.10 may
// crash on a damaged one or never come back, so a process of its own reads it.
#pragma once

#include <string>

namespace cagetol {

/// Limits on the process that reads.
struct UnsealedLimits {
  double seconds = 20;              ///< plus one for every 4 MB of the file
  std::size_t memory = 512u << 20;  ///< bytes, plus six times the file
};

/// The same contents as a sealed file with texts of fixed length, to be read in this process.
/// Damage that only changes a value is not noticed. Throws StudyFileError naming `file_name` when
/// the process fails, crashes, or needs more than `limits`.
std::string read_unsealed(const std::string& bytes, const std::string& file_name,
                          const UnsealedLimits& limits = {});

}  // namespace cagetol
