#include "mc/sweep_directory.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

#include "mc/h5.hpp"
#include "src/input/toml_file.hpp"

namespace cagetol {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOtherDirectory =
    "give the new study a directory of its own with -o, or remove this one if its results are no "
    "longer wanted";

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

std::string joined(const std::vector<std::string>& lines) {
  constexpr std::size_t kShown = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, lines.size()); ++i) text += "\n  " + lines[i];
  if (lines.size() > kShown) text += fmt::format("\n  and {} more", lines.size() - kShown);
  return text;
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
    const Leaf before = value_in(stored, name), now = value_in(fresh, name);
    if (before.whole != now.whole)
      differences.push_back(fmt::format(fmt::runtime(pattern), name, before.shown, now.shown));
  }
  return differences;
}

SweepDirectory::SweepDirectory(const std::string& directory, const Study& study,
                               const BuildInfo& build)
    : directory_(directory) {
  make_directory(journal_directory(directory));
  lock();
  stored_ = read_journals(journal_directory(directory));
  check_study(study, build);
  read_study_h5(study, build);
  if (!fs::exists(stored_study_path(directory)))
    replace_file(stored_study_path(directory), study.resolved_toml);
}

void SweepDirectory::lock() {
  const std::string path = journal_directory(directory_) + "/lock";
  lock_ = FileDescriptor(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  if (lock_.get() < 0) throw WriteError(path, "create", errno);
  // Ranks of a killed sweep may take a moment to die.
  for (int attempt = 0; ::flock(lock_.get(), LOCK_EX | LOCK_NB) != 0; ++attempt) {
    if (errno != EWOULDBLOCK && errno != EINTR) return;  // a file system without locks
    if (attempt == 50)
      throw InputError({directory_, 0}, "", "", "another sweep is writing to this directory",
                       "wait until it ends, or stop it with SIGUSR1");
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}

void SweepDirectory::check_study(const Study& study, const BuildInfo& build) const {
  const std::string path = stored_study_path(directory_);
  const std::string stored = text_of(path);
  const auto differences =
      stored.empty() ? std::vector<std::string>{} : study_differences(stored, study.resolved_toml);
  if (!differences.empty())
    throw InputError({directory_, 0}, "", "",
                     "holds the results of another study:" + joined(differences), kOtherDirectory);
  for (const auto& [file, header] : stored_.headers) {
    if (header.study_hash != study.hash)
      throw InputError(
          {file, 0}, "", "",
          fmt::format(
              "belongs to another study: hash {} stored, {} now. {}", header.study_hash, study.hash,
              stored.empty()
                  ? "study.toml, which would tell the difference, is missing"
                  : "All keys agree: a file that the study reads (measurements) has changed"),
          kOtherDirectory);
    if (header.build != build_id(build))
      throw InputError(
          {file, 0}, "", "",
          fmt::format("was written by another build, whose results may differ in the last digits:"
                      "\n  stored {}\n  now    {}",
                      header.build, build_id(build)),
          kOtherDirectory);
  }
}

void SweepDirectory::read_study_h5(const Study& study, const BuildInfo& build) {
  const std::string path = study_file_path(directory_);
  if (!fs::exists(path)) return;
  try {
    const StudyFile file = read_study_file(path);
    if (file.study_hash != study.hash || file.build != build_id(build)) {
      if (stored_.headers.empty())
        throw InputError(
            {path, 0}, "", "",
            fmt::format("belongs to another study or build:\n  stored {} {}\n  now    {} {}",
                        file.study_hash, file.build, study.hash, build_id(build)),
            kOtherDirectory);
      return;
    }
    for (const auto& [id, outcome] : file.outcomes)
      if (stored_.finished.try_emplace(id, outcome).second) only_in_study_file_.push_back(outcome);
    for (const StoredOutcome& outcome : only_in_study_file_) stored_.losses.erase(outcome.id);
    if (!only_in_study_file_.empty())
      stored_.notes.push_back(fmt::format("{}: holds {} samples that no journal has; they are used",
                                          path, only_in_study_file_.size()));
  } catch (const H5Error& problem) {
    stored_.notes.push_back(
        fmt::format("{}: damaged ({}); it is built again from the journals", path, problem.what()));
  }
}

}  // namespace cagetol
