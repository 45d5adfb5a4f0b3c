#include "mc/sweep/agreement.hpp"

#include <fmt/format.h>

#include <climits>
#include <filesystem>

#include "mc/host/byte_stream.hpp"
#include "mc/host/failure.hpp"
#include "mc/host/file_write.hpp"
#include "mc/host/log.hpp"
#include "mc/study_file/exit_code.hpp"
#include "mc/sweep/sweep_directory.hpp"
#include "src/input/input_error.hpp"

namespace cagetol {
namespace {

/// The first rank whose text differs from that of rank 0, known to every rank; 0 where none does.
int stranger(const Team& team, const std::vector<std::string>& texts) {
  int first = 0;
  for (int rank = team.size() - 1; team.rank() == 0 && rank > 0; --rank)
    if (texts[static_cast<std::size_t>(rank)] != texts[0]) first = rank;
  return std::stoi(team.from_rank_0(std::to_string(first)));
}

[[noreturn]] void refuse(const std::string& problem, const std::string& remedy) {
  throw InputError({}, "", "", problem, remedy);
}

/// The study in full, as text: resolved keys, then the files that it reads with their hashes.
std::string in_full(const Study& study) {
  ByteWriter out;
  out.put(std::string_view(study.resolved_toml));
  std::string files;
  for (const auto& [file, hash] : study.files)
    files += fmt::format("\n  file {} has hash {}", file, hash);
  out.put(std::string_view(files));
  return out.bytes();
}

}  // namespace

Problem problem_of(const std::function<void()>& work) {
  try {
    work();
    return {};
  } catch (const WriteError& problem) {
    return {problem.what(), problem.can_go_on() ? kInterrupted : kBadInput};
  } catch (const std::exception& problem) {
    return {ending_text(problem), exit_code_for(problem)};
  }
}

int agreed(const Team& team, const Problem& problem) {
  const bool well = problem.code == kDone;
  const int first = team.smallest(well ? INT_MAX : team.rank());
  if (first == team.rank() && !well) say("cagetol: {}\n", problem.text);
  const int code = team.smallest(well ? INT_MAX : problem.code);
  return code == INT_MAX ? kDone : code;
}

void check_same_program(const Team& team, const BuildInfo& build, const std::string& command) {
  const std::string own = command + " with " + build_id(build);
  const auto all = team.gathered(own);
  const int other = stranger(team, all);
  if (other == 0 || team.rank() != 0) return;
  refuse(
      fmt::format("the ranks run different programs:\n  {} runs {}\n  {} runs {}", team.name_of(0),
                  all[0], team.name_of(other), all[static_cast<std::size_t>(other)]),
      "start all ranks with one command, and give every host the same build");
}

void check_same_study(const Team& team, const Study& study) {
  const int other = stranger(team, team.gathered(text_hash(in_full(study))));
  if (other == 0) return;
  if (team.rank() == other) team.send(0, in_full(study));
  if (team.rank() != 0) return;
  const std::string text = team.next_message().bytes, own_text = in_full(study);
  ByteReader in(text), own(own_text);
  const std::string theirs = in.get_text(), ours = own.get_text();
  const std::string pattern = fmt::format("{} has {{0}} = {{2}}, {} has {{0}} = {{1}}",
                                          team.name_of(other), team.name_of(0));
  std::string difference;
  for (const std::string& key : study_differences(ours, theirs, pattern))
    difference += "\n  " + key;
  if (difference.empty())
    difference = fmt::format("\n  {}:{}\n  {}:{}", team.name_of(other), in.get_text(),
                             team.name_of(0), own.get_text());
  refuse("the ranks read different studies:" + difference,
         "start all ranks with the same arguments, and give every host the same files");
}

void check_same_directory(const Team& team, const std::string& directory, const std::string& file) {
  const std::string name = team.from_rank_0(std::filesystem::path(file).filename().string());
  const std::string here = journal_directory(directory) + "/" + name;
  if (std::filesystem::exists(here)) return;
  throw InputError({directory, 0}, "", "",
                   fmt::format("is another directory to {} than to {}: {}, which rank 0 has made, "
                               "is not there",
                               team.name_of(team.rank()), team.name_of(0), here),
                   "give all ranks one -o, on a file system that all hosts share");
}

}  // namespace cagetol
