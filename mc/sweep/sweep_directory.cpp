#include "mc/sweep/sweep_directory.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <sys/file.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

#include "mc/study/resolved_study.hpp"
#include "mc/study_file/study_file_error.hpp"
#include "src/input/printable.hpp"
#include "src/input/toml_file.hpp"

namespace cagetol {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOtherDirectory =
    "give the new study a directory of its own with -o, or remove this one if its results are no "
    "longer wanted";

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The value of a key: whole, to compare, and shortened, for messages.
struct Leaf {
  std::string whole = "absent", shown = "absent";
};

std::map<std::string, Leaf> leaves_of(const std::string& text) {
  std::map<std::string, Leaf> leaves;
  const toml::table root = parse_toml(text, "study.toml");
  for (const TomlLeaf& leaf : toml_leaves(root)) {
    std::ostringstream whole;
    leaf.node->visit([&](const auto& node) { whole << node; });
    leaves[leaf.name] = {whole.str(), shown(*leaf.node)};
  }
  return leaves;
}

/// Blanks and line breaks as one blank each: a long list is written in lines.
std::string on_one_line(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const bool blank = c == ' ' || c == '\n';
    if (!blank || line.empty() || line.back() != ' ') line += blank ? ' ' : c;
  }
  return line;
}

/// Where both look the same because they are shortened: from shortly before they part.
void show_where_they_part(Leaf& a, Leaf& b) {
  if (a.shown != b.shown) return;
  constexpr std::size_t kBefore = 24, kShown = 64;
  const std::string texts[] = {on_one_line(a.whole), on_one_line(b.whole)};
  const auto ends =
      std::mismatch(texts[0].begin(), texts[0].end(), texts[1].begin(), texts[1].end());
  const auto parts = static_cast<std::size_t>(ends.first - texts[0].begin());
  const std::size_t from = parts > kBefore ? parts - kBefore : 0;
  a.shown = "..." + printable(texts[0].substr(from, kShown));
  b.shown = "..." + printable(texts[1].substr(from, kShown));
}

std::string joined(const std::vector<std::string>& lines) {
  constexpr std::size_t kShown = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, lines.size()); ++i) text += "\n  " + lines[i];
  if (lines.size() > kShown) text += fmt::format("\n  and {} more", lines.size() - kShown);
  return text;
}

bool holds_all(const JournalSet& stored, std::uint64_t samples) {
  for (std::uint64_t id = 0; id < samples; ++id)
    if (!stored.finished.contains(id)) return false;
  return true;
}

/// What DIR/study.toml says, beside what it should say.
struct StoredText {
  bool missing = false, same = false;
  std::string problem;                   ///< why it is no TOML
  std::vector<std::string> differences;  ///< keys with other values
  bool unsound() const { return !problem.empty(); }
};

StoredText stored_text(const std::string& directory, const Study& study) {
  const std::string path = stored_study_path(directory);
  StoredText stored;
  stored.missing = !fs::exists(path);
  if (stored.missing) return stored;
  const std::string text = text_of(path);
  stored.same = text == study.resolved_toml;
  if (text.empty()) stored.problem = "it is empty, or cannot be read";
  if (stored.same || stored.unsound()) return stored;
  try {
    stored.differences = study_differences(identity_text(text), identity_text(study.resolved_toml));
  } catch (const std::exception& problem) {
    stored.problem = first_line(problem.what());
  }
  return stored;
}

void refuse_differences(const std::string& directory, const StoredText& text) {
  if (!text.differences.empty())
    throw InputError({directory, 0}, "", "",
                     "holds the results of another study:" + joined(text.differences),
                     kOtherDirectory);
}

}  // namespace

std::string journal_directory(const std::string& directory) {
  return directory + "/journal";
}
std::string study_file_path(const std::string& directory) {
  return directory + "/study.h5";
}
std::string stored_study_path(const std::string& directory) {
  return directory + "/study.toml";
}

std::vector<std::string> study_differences(const std::string& stored_toml,
                                           const std::string& new_toml,
                                           const std::string& pattern) {
  const auto stored = leaves_of(stored_toml), fresh = leaves_of(new_toml);
  std::vector<std::string> differences;
  const auto value_in = [](const auto& leaves, const std::string& name) {
    const auto found = leaves.find(name);
    return found == leaves.end() ? Leaf{} : found->second;
  };
  auto names = stored;
  names.insert(fresh.begin(), fresh.end());
  for (const auto& [name, value] : names) {
    Leaf before = value_in(stored, name), now = value_in(fresh, name);
    if (before.whole == now.whole) continue;
    show_where_they_part(before, now);
    differences.push_back(fmt::format(fmt::runtime(pattern), name, before.shown, now.shown));
  }
  return differences;
}

void require_no_other(const std::string& directory, const std::string& folder,
                      const std::string& what) {
  if (fs::exists(fs::path(directory) / folder))
    throw InputError({directory, 0}, "", "",
                     "holds " + what + ": one would hide the other from `report`", kOtherDirectory);
}

SweepDirectory::SweepDirectory(const std::string& directory, const Study& study,
                               const BuildInfo& build)
    : directory_(directory) {
  require_no_other(directory, "pilot", "a recommendation");
  make_directory(journal_directory(directory));
  lock();
  remove_stale_parts(directory, std::chrono::seconds(0));  // the lock keeps other machines out
  const JournalHeader own{study.hash, build_id(build), 0};
  stored_ = read_journals(journal_directory(directory), &own);
  check_journals(study, build);
  is_this_study_ = !stored_.headers.empty();
  read_study_h5(study, build);
  check_study_toml(study);
}

void SweepDirectory::forget_outcomes() {
  stored_ = {};
  only_in_study_file_ = {};
}

void SweepDirectory::lock() {
  const std::string path = journal_directory(directory_) + "/lock";
  lock_ = FileDescriptor(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  if (lock_.get() < 0) throw WriteError(path, "create", errno);
  // Ranks of a killed sweep may take a moment to die.
  for (int attempt = 0; ::flock(lock_.get(), LOCK_EX | LOCK_NB) != 0; ++attempt) {
    if (errno != EWOULDBLOCK && errno != EINTR)
      return spdlog::warn(
          "{}: this file system has no locks ({}): start no second command with this directory "
          "while one runs",
          directory_, std::strerror(errno));
    if (attempt == 50)
      throw InputError({directory_, 0}, "", "", "another sweep is writing to this directory",
                       "wait until it ends, or stop it with SIGUSR1");
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}

void SweepDirectory::check_journals(const Study& study, const BuildInfo& build) const {
  for (const auto& [file, header] : stored_.refused) {
    const StoredText text = stored_text(directory_, study);
    const bool same_keys = !text.missing && !text.unsound() && text.differences.empty();
    if (header.study_hash == study.hash || (same_keys && header.build != build_id(build)))
      throw InputError({file, 0}, "", "",
                       fmt::format("was written by another build, whose results may differ in the "
                                   "last digits:\n  stored {}\n  now    {}",
                                   header.build, build_id(build)),
                       kOtherDirectory);
    refuse_differences(directory_, text);
    throw InputError(
        {file, 0}, "", "",
        fmt::format("belongs to another study: hash {} stored, {} now. {}", header.study_hash,
                    study.hash,
                    text.missing     ? "study.toml, which would tell the difference, is missing"
                    : text.unsound() ? "study.toml, which would tell the difference, is damaged"
                                     : "All keys agree: a file that the study reads "
                                       "(measurements) has changed, or the journal is not this "
                                       "directory's"),
        kOtherDirectory);
  }
}

void SweepDirectory::read_study_h5(const Study& study, const BuildInfo& build) {
  const std::string path = study_file_path(directory_);
  if (holds_all(stored_, sample_count(study)) || !fs::exists(path)) return;
  try {
    const StudyFile file = read_study_file(path);
    if (file.study_hash == study.hash && file.build == build_id(build)) {
      take_over(file.outcomes);
    } else if (stored_.headers.empty()) {
      if (file.study_hash != study.hash)
        refuse_differences(directory_, stored_text(directory_, study));
      throw InputError(
          {path, 0}, "", "",
          fmt::format("belongs to another study or build:\n  stored {} {}\n  now    {} {}",
                      file.study_hash, file.build, study.hash, build_id(build)),
          kOtherDirectory);
    } else {
      stored_.notes.push_back(
          path + ": belongs to another study or build; it is built again from the journals");
    }
  } catch (const StudyFileError& problem) {
    if (stored_.headers.empty())
      throw InputError({path, 0}, "", "",
                       problem.reason() + "; its results cannot be taken over, and " +
                           journal_directory(directory_) + " holds no readable journal with them",
                       "put a sound copy of study.h5 or of the journals back; or remove study.h5 "
                       "to run every sample again");
    stored_.notes.push_back(fmt::format(
        "{}: damaged ({}); it is built again from the journals, and samples that they lack are "
        "run again",
        path, problem.reason()));
  }
}

void SweepDirectory::take_over(const OutcomesById& outcomes) {
  is_this_study_ = true;
  for (const auto& [id, outcome] : outcomes)
    if (stored_.finished.try_emplace(id, outcome).second) only_in_study_file_.push_back(outcome);
  for (const StoredOutcome& outcome : only_in_study_file_) stored_.losses.erase(outcome.id);
  if (!only_in_study_file_.empty())
    stored_.notes.push_back(fmt::format("{}: holds {} samples that no journal has; they are used",
                                        study_file_path(directory_), only_in_study_file_.size()));
}

void SweepDirectory::check_study_toml(const Study& study) {
  const std::string path = stored_study_path(directory_);
  const StoredText text = stored_text(directory_, study);
  if (text.same) return;
  const bool sound = !text.unsound() && text.differences.empty();
  if (!text.missing && is_this_study_ && sound) {
    stored_.notes.push_back(path +
                            ": what runs are judged by has changed, or its layout: it is "
                            "written again, and the runs stay");
  } else if (!text.missing && is_this_study_) {
    stored_.notes.push_back(fmt::format(
        "{}: damaged or changed: {}; the results beside it carry this study's hash, so it is "
        "written again",
        path, text.unsound() ? text.problem : joined(text.differences)));
  } else if (!text.missing) {
    if (text.unsound())
      throw InputError({path, 0}, "", "",
                       "is damaged, or no stored study (" + text.problem + "), and " + directory_ +
                           " holds no results that would say whose it is",
                       "remove this file, or choose another directory with -o");
    refuse_differences(directory_, text);
  }
  replace_file(path, study.resolved_toml);
}

}  // namespace cagetol
