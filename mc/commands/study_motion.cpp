#include "mc/commands/study_motion.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "analysis/study/study_data.hpp"
#include "mc/host/file_write.hpp"
#include "mc/ranks/signals.hpp"
#include "mc/study_file/study_file_error.hpp"
#include "mc/sweep/sample_motion.hpp"

namespace cagetol {
namespace {

using Json = nlohmann::ordered_json;

struct ShownSample {
  const char* role;
  std::int64_t id;
};

/// What a sample is called worst by, in this order.
constexpr const char* kDeciding[] = {"cage_stress_peak_MPa", "pocket_force_peak_N"};

/// Worst and median sample of those that are ok, by the first quantity that any of them has.
std::vector<ShownSample> shown_samples(const StudyData& study, std::string& quantity) {
  for (const char* name : kDeciding) {
    const Column* column = find_quantity(study, name);
    std::vector<std::size_t> runs;
    for (std::size_t i = 0; column != nullptr && i < study.size(); ++i)
      if (study.status[i] == RunStatus::ok && !std::isnan(column->values[i])) runs.push_back(i);
    if (runs.empty()) continue;
    quantity = name;
    std::stable_sort(runs.begin(), runs.end(), [&](std::size_t a, std::size_t b) {
      return column->values[a] < column->values[b];
    });
    const std::size_t median = runs[(runs.size() - 1) / 2], worst = runs.back();
    std::vector<ShownSample> shown = {{"worst", study.id[worst]}};
    if (median != worst) shown.push_back({"median", study.id[median]});
    return shown;
  }
  return {};
}

Json key_of(const StudyData& study, const std::vector<ShownSample>& shown) {
  Json ids;
  for (const ShownSample& sample : shown) ids.push_back(sample.id);
  return {{"study_hash", study.provenance.study_hash},
          {"build", study.provenance.build},
          {"samples", ids}};
}

bool is_current(const std::filesystem::path& file, const Json& key) {
  std::ifstream stream(file);
  const Json stored = stream ? Json::parse(stream, nullptr, false) : Json();
  return stored.is_object() && stored.value("key", Json()) == key;
}

Json motion_of(const std::filesystem::path& sweep_directory, std::int64_t id) {
  const SampleMotion motion =
      record_motion(read_stored_sample(sweep_directory.string(), static_cast<std::uint64_t>(id)),
                    SignalWatch::stopping);
  if (motion.outcome.status == Status::not_run)
    throw std::runtime_error("interrupted; start the same command again to make it");
  return motion.frames.json();
}

}  // namespace

void update_study_motion(const std::filesystem::path& sweep_directory) {
  try {
    const StudyData study = read_study_data(sweep_directory / "study.h5");
    std::string quantity;
    const std::vector<ShownSample> shown = shown_samples(study, quantity);
    const Json key = key_of(study, shown);
    const std::filesystem::path file = sweep_directory / "motion.json";
    if (shown.empty() || is_current(file, key)) return;
    if (SignalWatch::draining()) return;  // the same command makes it when it goes on
    Json json{{"key", key}, {"by", quantity}};
    for (const ShownSample& sample : shown) {
      Json motion = motion_of(sweep_directory, sample.id);
      if (motion.is_null()) return;  // equilibria do not move
      json["motions"].push_back(
          {{"role", sample.role}, {"sample", sample.id}, {"motion", std::move(motion)}});
    }
    replace_file(file.string(), json.dump() + "\n");
  } catch (const StudyFileError&) {
    // The report itself says what is wrong with the study file.
  } catch (const std::exception& problem) {
    spdlog::warn("no animation of the worst sample: {}", problem.what());
  }
}

}  // namespace cagetol
