#include "mc/sweep/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <set>

#include "mc/host/byte_stream.hpp"

namespace cagetol {
namespace {

constexpr std::string_view kMagic = "CAGETOLJ";
constexpr std::string_view kMarker = "\xC7REC";
constexpr std::size_t kFrame = kMarker.size() + 8;
constexpr std::uint32_t kSchema = 2;

// A record survives the death of its process once write() has returned. Only a power cut or a crash
// of the kernel needs the disk as well; waiting for it at every record would cost more than the
// seconds of work that can be lost then.
constexpr std::chrono::seconds kSyncInterval{5};
constexpr std::chrono::seconds kCheckInterval{1};

enum class RecordKind : std::uint8_t { header = 0, started = 1, finished = 2, dropped = 3 };

using Crc32c = boost::crc_optimal<32, 0x1EDC6F41, 0xFFFFFFFF, 0xFFFFFFFF, true, true>;

std::uint32_t checksum(std::string_view length, std::string_view payload) {
  Crc32c crc;
  crc.process_bytes(length.data(), length.size());
  crc.process_bytes(payload.data(), payload.size());
  return crc.checksum();
}

std::string framed(const std::string& payload) {
  ByteWriter length;
  length.put(static_cast<std::uint32_t>(payload.size()));
  ByteWriter crc;
  crc.put(checksum(length.bytes(), payload));
  return std::string(kMarker) + length.bytes() + crc.bytes() + payload;
}

/// The payload of the record at the start of `bytes`, if there is a whole and sound one.
std::optional<std::string_view> payload_at(std::string_view bytes) {
  if (bytes.size() < kFrame || !bytes.starts_with(kMarker)) return std::nullopt;
  ByteReader frame(bytes.substr(kMarker.size(), 8));
  const auto length = frame.get<std::uint32_t>();
  const auto crc = frame.get<std::uint32_t>();
  if (length > bytes.size() - kFrame) return std::nullopt;
  const std::string_view payload = bytes.substr(kFrame, length);
  if (checksum(bytes.substr(kMarker.size(), 4), payload) != crc) return std::nullopt;
  return payload;
}

std::string encoded(RecordKind kind, std::uint64_t id) {
  ByteWriter out;
  out.put(static_cast<std::uint8_t>(kind));
  out.put(id);
  return out.bytes();
}

std::string encoded(const JournalHeader& header) {
  ByteWriter out;
  out.put(static_cast<std::uint8_t>(RecordKind::header));
  out.put(kSchema);
  out.put(std::string_view(header.study_hash));
  out.put(std::string_view(header.build));
  out.put(static_cast<std::int32_t>(header.rank));
  return out.bytes();
}

std::string new_name(int rank) {
  std::random_device device;
  return fmt::format("rank{:04}-{:08x}{:08x}.journal", rank, device(), device());
}

/// Reads one record into `content`; false when the payload is no record of this schema.
bool take_record(std::string_view payload, JournalContent& content,
                 std::set<std::uint64_t>& open) try {
  ByteReader in(payload);
  const auto kind = static_cast<RecordKind>(in.get<std::uint8_t>());
  if (kind == RecordKind::header) {
    if (in.get<std::uint32_t>() != kSchema) return false;
    content.header.study_hash = in.get_text();
    content.header.build = in.get_text();
    content.header.rank = in.get<std::int32_t>();
    content.readable = true;
    return true;
  }
  const auto id = in.get<std::uint64_t>();
  if (kind == RecordKind::started) {
    open.insert(id);
  } else {
    open.erase(id);
    if (kind == RecordKind::finished) content.finished.push_back(outcome_from_bytes(in));
  }
  return true;
} catch (const std::runtime_error&) {
  return false;
}

/// The whole file, or nothing with `why`.
std::optional<std::string> bytes_of(const std::string& path, std::string& why) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (error || !file) {
    why = error ? error.message() : std::strerror(errno);
    return std::nullopt;
  }
  std::string bytes(size, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

bool same_owner(const JournalHeader& a, const JournalHeader& b) {
  return a.study_hash == b.study_hash && a.build == b.build;
}

}  // namespace

Journal::Journal(const std::string& directory, const JournalHeader& header)
    : path_(directory + "/" + new_name(header.rank)),
      file_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0666)),
      last_sync_(std::chrono::steady_clock::now()),
      last_check_(last_sync_) {
  if (file_.get() < 0) throw WriteError(path_, "create", errno);
  const std::string first = std::string(kMagic) + framed(encoded(header));
  if (const int error = write_all(file_.get(), first)) {
    ::unlink(path_.c_str());
    throw WriteError(path_, "write", error);
  }
  size_ = header_size_ = first.size();
  sync();
  sync_directory(directory);
}

Journal::~Journal() {
  if (size_ == header_size_)
    ::unlink(path_.c_str());
  else
    ::fdatasync(file_.get());
}

void Journal::started(std::uint64_t id) {
  append(encoded(RecordKind::started, id));
}
void Journal::dropped(std::uint64_t id) {
  append(encoded(RecordKind::dropped, id));
}

void Journal::finished(const StoredOutcome& stored) {
  append(encoded(RecordKind::finished, stored.id) + to_bytes(stored));
  const auto now = std::chrono::steady_clock::now();
  if (now - last_sync_ > kSyncInterval) sync();
  if (now - last_check_ > kCheckInterval) {
    check_in_place();
    last_check_ = now;
  }
}

void Journal::check_in_place() const {
  struct stat opened {
  }, found{};
  if (::fstat(file_.get(), &opened) != 0) throw WriteError(path_, "append", errno);
  const bool there = ::stat(path_.c_str(), &found) == 0;
  if (!there && errno != ENOENT && errno != ENOTDIR) return;  // a bad moment of a file server
  if (there && found.st_ino == opened.st_ino && found.st_dev == opened.st_dev) return;
  throw WriteError(path_, "append: it was removed or renamed while the program ran", ENOENT);
}

void Journal::sync() {
  if (::fdatasync(file_.get()) != 0) throw WriteError(path_, "write", errno);
  last_sync_ = std::chrono::steady_clock::now();
}

void Journal::append(const std::string& payload) {
  const std::string record = framed(payload);
  if (const int error = write_all(file_.get(), record)) {
    // A half-written record is cut off; should that fail as well, the reader skips it.
    if (::ftruncate(file_.get(), static_cast<off_t>(size_)) != 0) size_ += record.size();
    throw WriteError(path_, "write", error);
  }
  size_ += record.size();
}

JournalContent read_journal(const std::string& path) {
  JournalContent content;
  std::string why;
  const std::optional<std::string> read = bytes_of(path, why);
  if (!read) {
    content.notes.push_back(
        fmt::format("{}: cannot be read ({}); its samples will be run again", path, why));
    return content;
  }
  const std::string& bytes = *read;
  if (!bytes.starts_with(kMagic)) content.notes.push_back(path + ": does not start like a journal");

  std::set<std::uint64_t> open;
  std::string_view rest = std::string_view(bytes).substr(std::min(bytes.size(), kMagic.size()));
  while (!rest.empty()) {
    const auto payload = payload_at(rest);
    if (payload && take_record(*payload, content, open)) {
      rest.remove_prefix(kFrame + payload->size());
      continue;
    }
    std::size_t skipped = 1;
    while (skipped < rest.size() && !payload_at(rest.substr(skipped))) ++skipped;
    const std::size_t place = bytes.size() - rest.size();
    content.notes.push_back(
        skipped == rest.size()
            ? fmt::format("{}: the last record is torn ({} bytes from byte {}) and left out", path,
                          skipped, place)
            : fmt::format("{}: damaged at byte {}: {} bytes left out, the records after them used",
                          path, place, skipped));
    rest.remove_prefix(skipped);
  }
  content.lost.assign(open.begin(), open.end());
  if (!content.readable)
    content.notes.push_back(
        path + ": has no readable header and is left out; its samples will be run again");
  return content;
}

JournalSet read_journals(const std::string& directory, const JournalHeader* owner) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    if (entry.path().extension() == ".journal") paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());

  JournalSet set;
  for (const std::string& path : paths) {
    JournalContent content = read_journal(path);
    set.notes.insert(set.notes.end(), content.notes.begin(), content.notes.end());
    if (!content.readable) continue;
    if (owner != nullptr && !same_owner(*owner, content.header)) {
      set.refused.emplace_back(path, content.header);
      continue;
    }
    set.headers.emplace_back(path, content.header);
    for (const std::uint64_t id : content.lost) ++set.losses[id];
    for (StoredOutcome& stored : content.finished) {
      const auto [place, is_new] = set.finished.try_emplace(stored.id, std::move(stored));
      const auto differences =
          is_new ? std::vector<std::string>{} : outcome_differences(place->second, stored);
      if (!differences.empty())
        set.notes.push_back(fmt::format(
            "{}: sample {} was run twice with different results ({}); the first is kept", path,
            stored.id, differences.front()));
    }
  }
  for (const auto& [id, stored] : set.finished) set.losses.erase(id);
  return set;
}

}  // namespace cagetol
