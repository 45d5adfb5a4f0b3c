#include "analysis/study/study_data.hpp"

#include "analysis/study/estimate.hpp"
#include "mc/study_file/hdf5_reader.hpp"
#include "mc/study_file/study_bytes.hpp"
#include "mc/study_file/study_file_error.hpp"

namespace cagetol {
namespace {

constexpr std::int64_t kMostPockets = 10'000, kMostSamples = 1'000'000'000'000;
constexpr std::int64_t kSchema = 2;

std::string text_or_empty(const Hdf5Reader& file, const std::string& object,
                          const std::string& name) {
  return file.has_attribute(object, name) ? file.text_attribute(object, name) : std::string();
}

/// A value that this program cannot have written.
void require_range(const std::vector<std::int64_t>& values, std::int64_t lowest,
                   std::int64_t highest, const std::string& what, const std::string& file) {
  for (const std::int64_t value : values)
    if (value < lowest || value > highest)
      throw StudyFileError(file,
                           what + " holds " + std::to_string(value) + ", possible are " +
                               std::to_string(lowest) + " to " + std::to_string(highest),
                           kRebuildRemedy);
}

void require_size(std::size_t size, std::size_t expected, const std::string& dataset,
                  const std::string& file) {
  if (size == expected) return;
  throw StudyFileError(
      file,
      dataset + " has " + std::to_string(size) + " values where " + std::to_string(expected) +
          " belong",
      "start the same `cagetol sweep` again: it rebuilds study.h5 from its journals");
}

std::vector<Column> read_columns(const Hdf5Reader& file, const std::string& group,
                                 std::size_t count, const std::string& name) {
  std::vector<Column> columns;
  for (const std::string& child : file.children(group)) {
    const std::string path = group + "/" + child;
    Column column{child, text_or_empty(file, path, "unit"),
                  text_or_empty(file, path, "description"), file.reals(path).values};
    require_size(column.values.size(), count, path, name);
    columns.push_back(std::move(column));
  }
  return columns;
}

InputColumns read_input(const Hdf5Reader& file, const std::string& key, std::size_t count,
                        std::size_t pockets, const std::string& name) {
  const std::string group = "/inputs/" + key;
  InputColumns input;
  input.key = key;
  input.unit = text_or_empty(file, group, "unit");
  if (file.has_attribute(group, "nominal")) input.nominal = file.real_attribute(group, "nominal");
  const auto read = [&](const char* part, std::size_t expected) {
    const std::string path = group + "/" + part;
    if (!file.has(path)) return std::vector<double>{};
    auto values = file.reals(path).values;
    require_size(values.size(), expected, path, name);
    return values;
  };
  input.lot = read("lot", count);
  input.pocket = read("pocket", count * pockets);
  input.noise = read("noise", count);
  const RealArray value = file.reals(group + "/value");
  input.per_pocket = value.shape.size() == 2 && value.shape[1] > 1;
  require_size(value.values.size(), input.per_pocket ? count * pockets : count, group + "/value",
               name);
  input.value = value.values;
  return input;
}

JamShares read_jams(const Hdf5Reader& file, const StudyPlan& plan, const std::string& name) {
  JamShares jams;
  if (!file.has("/jam")) return jams;
  const auto shares = [&](const std::string& dataset, std::size_t size) {
    auto values = file.reals(dataset).values;
    require_size(values.size(), size, dataset, name);
    for (const double share : values)
      if (!(share >= 0 && share <= 1))
        throw StudyFileError(name, dataset + " holds a share that is none", kRebuildRemedy);
    return values;
  };
  jams.candidate = shares("/jam/candidate", plan.candidates.size());
  if (file.has("/jam/error")) {
    const std::size_t dimensions = plan.candidates.size() * plan.dimensions.size();
    jams.error = shares("/jam/error", plan.candidates.size());
    jams.draws = file.real_attribute("/jam", "draws").at(0);
    jams.off_centre = shares("/jam/off_centre", dimensions);
    jams.pockets_alone = shares("/jam/pockets_alone", dimensions);
    jams.lots_alone = shares("/jam/lots_alone", dimensions);
  }
  for (const ToleranceDimension& dimension : plan.dimensions) {
    const std::string group = "/jam/" + dimension.key;
    const bool former = !file.has(group + "/tolerance_width_mm");  // older programs
    auto widths = file.reals(group + (former ? "/band_mm" : "/tolerance_width_mm")).values;
    auto share = shares(group + "/share", widths.size());
    jams.curves.push_back({dimension.key, std::move(widths), std::move(share)});
  }
  return jams;
}

template <class T>
std::vector<T> pick(const std::vector<T>& values, const std::vector<std::size_t>& keep,
                    std::size_t width = 1) {
  std::vector<T> picked;
  if (values.empty()) return picked;
  picked.reserve(keep.size() * width);
  for (const std::size_t i : keep)
    for (std::size_t j = 0; j < width; ++j) picked.push_back(values[i * width + j]);
  return picked;
}

void pick_columns(std::vector<Column>& columns, const std::vector<std::size_t>& keep) {
  for (Column& column : columns) column.values = pick(column.values, keep);
}

}  // namespace

const char* run_status_name(RunStatus status) {
  constexpr const char* kNames[] = {"ok", "jammed", "failed", "censored", "not run", "poisoned"};
  return kNames[static_cast<int>(status)];
}

StudyData read_study_data(const std::filesystem::path& path) {
  const std::string name = path.string();
  const Hdf5Reader file(read_study_bytes(path), name);
  StudyData study;
  study.provenance.schema_version = file.integer_attribute("/", "schema_version");
  if (study.provenance.schema_version != kSchema)
    throw StudyFileError(name,
                         "its schema version is " +
                             std::to_string(study.provenance.schema_version) +
                             ", this program reads version " + std::to_string(kSchema),
                         "report it with the version of the program that wrote it");
  study.provenance.tool_version = text_or_empty(file, "/", "tool_version");
  study.provenance.tool_commit = text_or_empty(file, "/", "tool_commit");
  study.provenance.build = text_or_empty(file, "/", "build");
  study.provenance.libraries = text_or_empty(file, "/", "libraries");
  study.provenance.study_name = text_or_empty(file, "/", "study_name");
  study.provenance.study_hash = text_or_empty(file, "/", "study_hash");
  study.provenance.seed = file.integer_attribute("/", "seed");
  if (file.has("/study/files")) study.provenance.files = file.strings("/study/files");
  study.design.kind = file.text_attribute("/", "design");
  study.design.rows_planned = file.integer_attribute("/", "rows_planned");
  study.design.samples_planned = file.integer_attribute("/", "samples_planned");
  const std::int64_t pockets = file.integer_attribute("/", "pockets");
  require_range({pockets}, 0, kMostPockets, "pockets", name);
  require_range({study.design.rows_planned, study.design.samples_planned}, 0, kMostSamples,
                "rows_planned or samples_planned", name);
  study.pockets = static_cast<std::size_t>(pockets);
  const auto json = file.strings("/study/json");
  require_size(json.size(), 1, "/study/json", name);
  study.plan = read_study_plan(json.front(), name);
  study.jam = read_jams(file, study.plan, name);

  study.id = file.integers("/samples/id");
  const std::size_t count = study.id.size();
  const auto whole = [&](const char* dataset) {
    auto values = file.integers(std::string("/samples/") + dataset);
    require_size(values.size(), count, std::string("/samples/") + dataset, name);
    return values;
  };
  study.row = whole("row");
  study.replicate = whole("replicate");
  study.lot = whole("lot");
  study.candidate = whole("candidate");
  study.pocket = whole("pocket");
  const std::int64_t most = kMostSamples;
  for (const auto* numbers : {&study.id, &study.row, &study.replicate, &study.lot})
    require_range(*numbers, 0, most, "/samples/id, row, replicate or lot", name);
  require_range(study.candidate, -1, static_cast<std::int64_t>(study.plan.candidates.size()) - 1,
                "/samples/candidate", name);
  require_range(study.pocket, -1, pockets - 1, "/samples/pocket", name);
  for (const std::int64_t status : whole("status")) {
    if (status < 0 || status > 5)
      throw StudyFileError(name,
                           "/samples/status holds " + std::to_string(status) + ", known are 0 to 5",
                           "report it with the version of the program that wrote it");
    study.status.push_back(static_cast<RunStatus>(status));
  }
  study.reason = file.strings("/samples/reason");
  require_size(study.reason.size(), count, "/samples/reason", name);
  study.interference_um = file.reals("/samples/interference_um").values;
  require_size(study.interference_um.size(), count, "/samples/interference_um", name);

  for (const std::string& key : file.children("/inputs"))
    study.inputs.push_back(read_input(file, key, count, study.pockets, name));
  study.quantities = read_columns(file, "/quantities", count, name);
  study.run = read_columns(file, "/run", count, name);
  for (Column& column : read_columns(file, "/timing", count, name))
    if (column.name == "wall_s") study.timing.push_back(std::move(column));
  return study;
}

StudyData select_samples(const StudyData& study, const std::vector<std::size_t>& keep) {
  StudyData chosen = study;
  chosen.id = pick(study.id, keep);
  chosen.row = pick(study.row, keep);
  chosen.replicate = pick(study.replicate, keep);
  chosen.lot = pick(study.lot, keep);
  chosen.candidate = pick(study.candidate, keep);
  chosen.pocket = pick(study.pocket, keep);
  chosen.status = pick(study.status, keep);
  chosen.reason = pick(study.reason, keep);
  chosen.interference_um = pick(study.interference_um, keep);
  for (InputColumns& input : chosen.inputs) {
    input.lot = pick(input.lot, keep);
    input.noise = pick(input.noise, keep);
    input.pocket = pick(input.pocket, keep, study.pockets);
    input.value = pick(input.value, keep, input.per_pocket ? study.pockets : 1);
  }
  pick_columns(chosen.quantities, keep);
  pick_columns(chosen.run, keep);
  pick_columns(chosen.timing, keep);
  return chosen;
}

StudyData results_of(StudyData study) {
  study.inputs.clear();
  return study;
}

std::vector<std::size_t> first_runs(const StudyData& study) {
  std::vector<std::size_t> keep;
  for (std::size_t i = 0; i < study.size(); ++i)
    if (study.replicate[i] == 0 && study.status[i] != RunStatus::not_run) keep.push_back(i);
  return keep;
}

std::vector<double> ok_values(const StudyData& runs, const std::vector<double>& column) {
  std::vector<double> values = column;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (runs.status[k] != RunStatus::ok) values[k] = kUndefined;
  return values;
}

const Column* find_quantity(const StudyData& study, const std::string& name) {
  for (const Column& column : study.quantities)
    if (column.name == name) return &column;
  return nullptr;
}

const InputColumns* find_input(const StudyData& study, const std::string& key) {
  for (const InputColumns& input : study.inputs)
    if (input.key == key) return &input;
  return nullptr;
}

}  // namespace cagetol
