// A finished sample as journals and study.h5 keep it: what the sample determines, and apart from it
// what the machine did.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mc/host/byte_stream.hpp"
#include "mc/run/sample_run.hpp"
#include "src/quantities/outcome.hpp"

namespace cagetol {

struct StoredOutcome {
  std::uint64_t id = 0;
  Status status = Status::not_run;
  std::string reason;  ///< up to kLongestReason bytes
  int pocket = -1;
  double interference_um = 0;
  std::vector<double> quantities;  ///< in the order of quantity_table(); NaN where there is none
  std::vector<double> run;         ///< in the order of stored_run_fields()
  double wall_s = 0;               ///< wall-clock seconds of the run
  int rank = 0;                    ///< rank that ran it
};

/// Bytes of a reason: study.h5 gives each of them the room of the longest.
inline constexpr std::size_t kLongestReason = 1000;

/// `text`, or as much of its beginning as `most` bytes hold without splitting a UTF-8 character.
std::string first_bytes(const std::string& text, std::size_t most);

/// run_fields() without those that depend on the machine.
std::vector<RunField> stored_run_fields();

StoredOutcome make_stored_outcome(std::uint64_t id, const Outcome& outcome, double wall_s,
                                  int rank);

/// Where two outcomes of one sample differ to the bit, wall clock and rank apart:
/// "quantities[3]: 1.5 and 1.25". Empty when equal.
std::vector<std::string> outcome_differences(const StoredOutcome& a, const StoredOutcome& b);

/// For journals and pipes. Reading throws std::runtime_error when bytes are missing.
std::string to_bytes(const StoredOutcome& stored);
StoredOutcome outcome_from_bytes(ByteReader& in);

/// Whether the run has a result that meets every limit of the study.
bool meets_limits(const Study& study, const StoredOutcome& stored);

/// True for outcomes that count against study.allowed_failure_share: failed, censored, poisoned. A
/// jam is a result.
bool is_failure(Status status);

}  // namespace cagetol
