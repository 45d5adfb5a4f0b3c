#include "mc/sweep/replay.hpp"

#include <fmt/format.h>

#include "mc/host/build_info.hpp"
#include "mc/sweep/stored_study.hpp"
#include "mc/sweep/sweep_directory.hpp"
#include "src/input/input_error.hpp"

namespace cagetol {
StoredSample read_stored_sample(const std::string& directory, std::uint64_t id) {
  const StudyFile file = read_study_file(study_file_path(directory));
  const Study study = read_resolved_study(file.study_toml, study_file_path(directory));
  if (id >= sample_count(study))
    throw InputError({}, "--sample", std::to_string(id),
                     fmt::format("the study has the samples 0 to {}", sample_count(study) - 1),
                     "choose one of them");
  StoredSample sample{.study = study,
                      .sample = Sampler(study).draw(id),
                      .stored = {},
                      .stored_build = file.build,
                      .notes = {}};
  if (const auto found = file.outcomes.find(id); found != file.outcomes.end())
    sample.stored = found->second;
  const std::string now = build_id(build_info());
  if (file.build != now)
    sample.notes.push_back(
        fmt::format("written by another build:\n  stored {}\n  now    {}", file.build, now));
  if (study.hash != file.study_hash)
    sample.notes.push_back(
        fmt::format("this program reads the stored study as another one: hash {} stored, {} now",
                    file.study_hash, study.hash));
  return sample;
}

}  // namespace cagetol
