// What a sweep will need, counted before anything is built: a pure function of the study.
//
// With N samples, O bytes of a finished sample in memory, R bytes of its records in the journals, D
// numbers that are drawn for it, F bytes of it in study.h5 and P bytes of the program:
//
//   rank 0      P + 16 N + N O + max(2 N R + 2 N O, N O + 12 N D + 2 N F)
//   other rank  P
//   journals    N R
//   study.h5    N F + 2 T, T the resolved study; while it is replaced, twice that
//
// The first N O is what an interrupted sweep finds stored. The larger of the two terms is the
// moment at which rank 0 needs most: reading a journal, its text beside its records, or building
// study.h5, the samples beside their columns (which grow by half their size) and two images of the
// file.
#pragma once

#include <cstdint>
#include <string>

#include "mc/study/study.hpp"

namespace cagetol {

struct SweepForecast {
  std::uint64_t rows = 0, samples = 0;
  std::uint64_t numbers = 0;                       ///< kept of each sample
  double rank_0_memory = 0, rank_memory = 0;       ///< at most [bytes]
  double journal_bytes = 0, study_file_bytes = 0;  ///< at the end

  /// At most: study.h5 is replaced by a new one beside it.
  double disk_bytes() const { return journal_bytes + 2 * study_file_bytes; }
};

SweepForecast forecast_sweep(const Study& study);

/// Memory that making a table of the scene's flexible cage takes [bytes]; 0 for a rigid one.
double forecast_cage_table(const Scene& scene);

/// "rank 0 needs about 52 MB of memory, every other rank 48 MB; ..." in one line.
std::string forecast_text(const SweepForecast& forecast);

/// Below this a need is not refused [bytes]: what is short then is said when it is met, and costs
/// nothing that was finished.
inline constexpr double kMinimumRefused = 64e6;

/// Throw InputError with the counts and what to do where memory, of `ranks_here` ranks on this
/// machine, or the disk of `directory` cannot hold what is predicted. What DIR holds already is
/// part of the prediction.
void require_memory(const SweepForecast& forecast, int ranks_here);
void require_disk(const SweepForecast& forecast, const std::string& directory);
void require_cage_memory(const Scene& scene);

/// Ranks of this launch on this machine, from the launcher's environment.
int ranks_on_this_machine();

}  // namespace cagetol
