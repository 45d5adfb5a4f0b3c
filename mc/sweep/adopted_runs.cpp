#include "mc/sweep/adopted_runs.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "mc/host/build_info.hpp"
#include "mc/study/resolved_study.hpp"
#include "mc/study/sample.hpp"
#include "mc/study_file/study_file_error.hpp"
#include "mc/sweep/stored_study.hpp"
#include "mc/sweep/sweep_directory.hpp"

namespace cagetol {
namespace {

namespace fs = std::filesystem;

bool same_model(const Study& a, const Study& b) {
  const auto differences =
      study_differences(identity_text(a.resolved_toml), identity_text(b.resolved_toml));
  return std::none_of(differences.begin(), differences.end(), [](const std::string& difference) {
    return difference.starts_with("scene.") || difference.starts_with("cage_check_share");
  });
}

bool same_sample(const Sample& a, const Sample& b) {
  return a.candidate == b.candidate && a.replicate == b.replicate &&
         std::equal(a.inputs.begin(), a.inputs.end(), b.inputs.begin(), b.inputs.end(),
                    [](const DrawnInput& x, const DrawnInput& y) { return x.value == y.value; });
}

}  // namespace

std::size_t adopt_runs(const Study& study, const std::string& directory, const std::string& from) {
  const StudyFile file = read_study_file(study_file_path(from));
  const BuildInfo build = build_info();
  const Study other = read_resolved_study(file.study_toml, from);
  if (file.build != build_id(build) || !same_model(study, other)) return 0;
  const SweepDirectory opened(directory, study, build);
  if (!opened.stored().headers.empty() || !opened.only_in_study_file().empty()) return 0;
  const Sampler mine(study), theirs(other);
  std::optional<Journal> journal;
  std::size_t adopted = 0;
  for (const auto& [id, outcome] : file.outcomes) {
    if (id >= sample_count(study) || !same_sample(mine.draw(id), theirs.draw(id))) continue;
    if (!journal)
      journal.emplace(journal_directory(directory), JournalHeader{study.hash, build_id(build), 0});
    journal->finished(outcome);
    ++adopted;
  }
  return adopted;
}

std::vector<fs::path> sweeps_like(const fs::path& parent, const std::string& prefix,
                                  const fs::path& below) {
  std::vector<fs::path> found;
  if (!fs::exists(parent)) return found;
  for (const auto& entry : fs::directory_iterator(parent))
    if (entry.path().filename().string().starts_with(prefix) &&
        fs::exists(study_file_path(entry.path() / below)))
      found.push_back(entry.path() / below);
  const auto key = [](const fs::path& path) {
    return std::pair(fs::file_size(study_file_path(path)), path);
  };
  std::sort(found.begin(), found.end(),
            [&](const fs::path& a, const fs::path& b) { return key(a) > key(b); });
  return found;
}

std::optional<fs::path> adopt_any(const Study& study, const std::string& directory,
                                  const std::vector<fs::path>& from) {
  for (const fs::path& other : from) {
    try {
      if (adopt_runs(study, directory, other) > 0) return other;
    } catch (const StudyFileError&) {  // its runs are made again
    }
  }
  return std::nullopt;
}

long stored_rows(const std::string& directory) {
  const fs::path before = directory + ".before";
  if (fs::exists(before) && !fs::exists(directory)) fs::rename(before, directory);
  fs::remove_all(before);
  const std::string file = stored_study_path(directory);
  std::ifstream stream(file);
  if (!stream) return 0;
  return read_resolved_study({std::istreambuf_iterator<char>(stream), {}}, file).samples;
}

void grow_directory(const Study& study, const std::string& directory) {
  const std::string larger = directory + ".larger", before = directory + ".before";
  fs::remove_all(larger);
  adopt_runs(study, larger, directory);
  fs::rename(directory, before);
  fs::rename(larger, directory);
  fs::remove_all(before);
}

}  // namespace cagetol
