// The journal of one rank: what it started and finished, in the order in which it happened. Append
// only, so that a process killed at any moment loses at most the record it was writing; every other
// record proves itself by its checksum.
//
// File: "CAGETOLJ", then records. Record: marker (4 bytes), length of the payload (4), CRC-32C of
// length and payload (4), payload. The first record is the header. A reader that meets a bad record
// looks for the next good one, so damage costs only what it hit.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "mc/host/file_write.hpp"
#include "mc/run/stored_outcome.hpp"

namespace cagetol {

/// Whose records these are. Journals with another hash or build are never mixed.
struct JournalHeader {
  std::string study_hash;
  std::string build;  ///< build_id()
  int rank = 0;
};

class Journal {
 public:
  /// Creates a new file in `directory`, under a name that no other session has. Throws WriteError.
  Journal(const std::string& directory, const JournalHeader& header);
  /// Removes the file when nothing was noted in it.
  ~Journal();

  /// All throw WriteError, after which the file ends with its last complete record.
  void started(std::uint64_t id);
  void finished(const StoredOutcome& stored);
  /// The sample was given back on purpose (an interruption, a wall-clock limit): it was not lost.
  void dropped(std::uint64_t id);
  /// Waits until everything is on the disk.
  void sync();
  /// Throws WriteError when the file is no longer where readers look for it: its directory was
  /// removed or renamed. Any thread may call it; finished() does about once a second.
  void check_in_place() const;

  const std::string& path() const { return path_; }

 private:
  void append(const std::string& payload);

  std::string path_;
  FileDescriptor file_;
  std::uint64_t header_size_ = 0;
  std::uint64_t size_ = 0;  ///< bytes up to the end of the last complete record
  std::chrono::steady_clock::time_point last_sync_, last_check_;
};

/// What one journal file says.
struct JournalContent {
  bool readable = false;  ///< the header is whole and of a known schema
  JournalHeader header;
  std::vector<StoredOutcome> finished;
  std::vector<std::uint64_t> lost;  ///< started, neither finished nor dropped: the process died
  std::vector<std::string> notes;   ///< damage, for people: "FILE: ..."
};
JournalContent read_journal(const std::string& path);

/// All journals of a directory, in the order of their names.
struct JournalSet {
  using Headers = std::vector<std::pair<std::string, JournalHeader>>;  ///< file and header
  Headers headers;  ///< of every journal that is read
  Headers refused;  ///< of those that belong to another study or build: nothing of them is used
  std::map<std::uint64_t, StoredOutcome> finished;
  std::map<std::uint64_t, int> losses;  ///< how often a sample that is not finished was lost
  std::vector<std::string> notes;
};
/// `owner` says whose journals are read (its rank does not matter); nullptr: everybody's.
JournalSet read_journals(const std::string& directory, const JournalHeader* owner = nullptr);

}  // namespace cagetol
