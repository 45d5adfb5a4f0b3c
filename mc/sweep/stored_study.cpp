#include "mc/sweep/stored_study.hpp"

#include <fmt/format.h>

#include <limits>
#include <stdexcept>

#include "mc/host/file_write.hpp"
#include "mc/run/jam_shares.hpp"
#include "mc/study/operating_points.hpp"
#include "mc/study_file/h5.hpp"
#include "mc/study_file/hdf5_reader.hpp"
#include "mc/study_file/study_bytes.hpp"
#include "mc/study_file/study_file_error.hpp"
#include "src/quantities/operating_point.hpp"
#include "src/quantities/quantity_labels.hpp"

namespace cagetol {
namespace {

std::int64_t integer(std::uint64_t value) {
  return static_cast<std::int64_t>(value);
}

/// Columns of one uncertain input, filled row by row.
struct InputColumns {
  std::vector<double> lot, pocket, noise, value;
};

/// Everything that comes from drawing the samples again, so that journals need not carry it.
struct DrawnColumns {
  std::vector<std::int64_t> row, replicate, lot, candidate;
  std::vector<InputColumns> inputs;
};

/// Appends one value per pocket; a single value stands for all pockets.
void append(std::vector<double>& column, const std::vector<double>& values, std::size_t width) {
  if (values.size() != width && values.size() != 1)
    throw std::logic_error("a drawn input has the wrong number of values");
  for (std::size_t i = 0; i < width; ++i) column.push_back(values[values.size() == 1 ? 0 : i]);
}

std::size_t width_of(const UncertainInput& input, const Study& study) {
  return input.per_pocket ? static_cast<std::size_t>(study.scene.bearing.roller_count) : 1;
}

DrawnColumns draw_columns(const SweepPlan& plan, const OutcomesById& outcomes) {
  const Study& study = plan.study;
  DrawnColumns columns;
  columns.inputs.resize(study.inputs.size());
  for (const auto& [id, outcome] : outcomes) {
    const Sample sample = plan.draw(id);
    columns.row.push_back(integer(sample.row));
    columns.replicate.push_back(integer(sample.replicate));
    columns.lot.push_back(integer(sample.lot));
    columns.candidate.push_back(sample.candidate);
    for (std::size_t k = 0; k < study.inputs.size(); ++k) {
      const std::size_t width = width_of(study.inputs[k], study);
      const DrawnInput& drawn = sample.inputs[k];
      InputColumns& input = columns.inputs[k];
      if (study.inputs[k].lot) append(input.lot, drawn.lot, 1);
      if (study.inputs[k].pocket) append(input.pocket, drawn.pocket, width);
      if (study.inputs[k].noise) append(input.noise, drawn.noise, 1);
      append(input.value, drawn.value, width);
    }
  }
  return columns;
}

template <class T, class Get>
std::vector<T> column(const OutcomesById& outcomes, Get get) {
  std::vector<T> values;
  values.reserve(outcomes.size());
  for (const auto& [id, outcome] : outcomes) values.push_back(static_cast<T>(get(outcome)));
  return values;
}

void write_root(hid_t root, const SweepPlan& plan, const BuildInfo& build) {
  const Study& study = plan.study;
  write_h5_attribute(root, "schema_version", std::int64_t{kStudySchema});
  write_h5_attribute(root, "tool_version", build.version);
  write_h5_attribute(root, "tool_commit", build.commit);
  write_h5_attribute(root, "build", build_id(build));
  write_h5_attribute(root, "libraries", build.libraries);
  write_h5_attribute(root, "study_name", first_bytes(study.name, kLongestReason));
  write_h5_attribute(root, "study_hash", study.hash);
  write_h5_attribute(root, "seed", std::int64_t{study.seed});
  write_h5_attribute(root, "design", std::string(design_name(study.design)));
  write_h5_attribute(root, "rows_planned", integer(plan.rows));
  write_h5_attribute(root, "samples_planned", integer(plan.samples));
  write_h5_attribute(root, "pockets", std::int64_t{study.scene.bearing.roller_count});
}

void write_study_texts(hid_t root, const Study& study) {
  const H5Handle group = make_h5_group(root, "study");
  write_h5(group, "toml", study.resolved_toml, {"-", "the resolved study with its scene"});
  write_h5(group, "json", study.resolved_json, {"-", "the resolved study as JSON"});
  std::vector<std::string> files;
  for (const auto& [name, hash] : study.files) files.push_back(name + " " + hash);
  write_h5(group, "files", files, {"-", "further input files: name and hash of the text"});
  write_h5(group, "labels", quantity_labels(study),
           {"-", "operating points and phases with quantities of their own"});
}

void write_operating_point(hid_t root, const Scene& scene) {
  const H5Handle group = make_h5_group(root, "operating_point");
  const OperatingPoint at = operating_point(scene);
  for (const OperatingRow& row : operating_rows())
    write_h5(group, row.key, std::vector<double>{row.value(at)}, {row.unit, row.definition});
}

void write_samples(hid_t root, const DrawnColumns& drawn, const OutcomesById& outcomes) {
  using S = StoredOutcome;
  const H5Handle group = make_h5_group(root, "samples");
  const auto integers = [&](const char* name, const auto& get, const char* description) {
    write_h5(group, name, column<std::int64_t>(outcomes, get), {"-", description});
  };
  integers(
      "id", [](const S& s) { return s.id; }, "sample id");
  write_h5(group, "row", drawn.row, {"-", "design row"});
  write_h5(group, "replicate", drawn.replicate,
           {"-", "0, or k for the k-th repetition of the row with fresh noise"});
  write_h5(group, "lot", drawn.lot, {"-", "lot of the cage"});
  write_h5(group, "candidate", drawn.candidate,
           {"-", "tolerance candidate that scaled the deviations; -1 without candidates"});
  integers(
      "status", [](const S& s) { return s.status; },
      "0 ok, 1 jammed, 2 failed, 3 censored, 4 not run, 5 poisoned");
  write_h5(group, "reason", column<std::string>(outcomes, [](const S& s) { return s.reason; }),
           {"-", "what happened; empty when ok"});
  integers(
      "pocket", [](const S& s) { return s.pocket; }, "pocket that jams, from 0; -1 without");
  write_h5(group, "interference_um",
           column<double>(outcomes, [](const S& s) { return s.interference_um; }),
           {"um", "by how much the roller is too large for the pocket that jams"});
}

void write_inputs(hid_t root, const Study& study, const DrawnColumns& drawn) {
  const H5Handle all = make_h5_group(root, "inputs");
  for (std::size_t k = 0; k < study.inputs.size(); ++k) {
    const UncertainInput& input = study.inputs[k];
    const std::size_t width = input.per_pocket ? width_of(input, study) : 0;
    const H5Handle group = make_h5_group(all, input.key);
    write_h5_attribute(group, "unit", input.unit);
    write_h5_attribute(group, "nominal", input.nominal);
    if (input.lot)
      write_h5(group, "lot", drawn.inputs[k].lot, {input.unit, "deviation shared by the cage"});
    if (input.pocket)
      write_h5(group, "pocket", drawn.inputs[k].pocket, {input.unit, "deviation of each pocket"},
               width);
    if (input.noise)
      write_h5(group, "noise", drawn.inputs[k].noise,
               {input.unit, "draw of the sample's own noise"});
    write_h5(group, "value", drawn.inputs[k].value, {input.unit, "what was simulated"}, width);
  }
}

/// How often geometry alone jams a cage, by candidate and over the tolerance of each dimension.
void write_jams(hid_t root, const JamShares& jams) {
  if (jams.candidate.empty()) return;
  const H5Handle group = make_h5_group(root, "jam");
  write_h5_attribute(group, "draws", std::vector<double>{jams.draws});
  write_h5(group, "candidate", jams.candidate, {"-", "share of cages that jam, by candidate"});
  write_h5(group, "error", jams.error, {"-", "standard error of that from draws, else its bound"});
  const std::size_t dimensions = jams.curves.size();
  write_h5(group, "off_centre", jams.off_centre,
           {"-", "share with the mean of one dimension off by 5 % of its tolerance"}, dimensions);
  write_h5(group, "pockets_alone", jams.pockets_alone,
           {"-", "share with all variance of one dimension among pockets"}, dimensions);
  write_h5(group, "lots_alone", jams.lots_alone,
           {"-", "share with all variance of one dimension from cage to cage"}, dimensions);
  for (const JamCurve& curve : jams.curves) {
    const H5Handle of_dimension = make_h5_group(group, curve.key);
    write_h5(of_dimension, "tolerance_width_mm", curve.tolerance_width_mm,
             {"mm", "full width of the tolerance"});
    write_h5(of_dimension, "share", curve.share,
             {"-", "share of cages that jam, all other tolerances at their narrowest"});
  }
}

void write_results(hid_t root, const OutcomesById& outcomes,
                   const std::vector<std::string>& labels) {
  const H5Handle quantities = make_h5_group(root, "quantities");
  const std::vector<LabelledQuantity> columns = labelled_quantities(labels);
  for (std::size_t i = 0; i < columns.size(); ++i)
    write_h5(quantities, columns[i].name,
             column<double>(outcomes,
                            [i](const auto& s) {
                              return i < s.quantities.size()
                                         ? s.quantities[i]
                                         : std::numeric_limits<double>::quiet_NaN();
                            }),
             {columns[i].unit, columns[i].definition});
  const H5Handle run = make_h5_group(root, "run");
  const std::vector<RunField> fields = stored_run_fields();
  for (std::size_t i = 0; i < fields.size(); ++i)
    write_h5(run, fields[i].key,
             column<double>(outcomes, [i](const auto& s) { return s.run.at(i); }),
             {fields[i].unit, fields[i].meaning});
  const H5Handle timing = make_h5_group(root, "timing");
  write_h5(timing, "wall_s", column<double>(outcomes, [](const auto& s) { return s.wall_s; }),
           {"s", "wall-clock seconds of the run"});
  write_h5(timing, "rank", column<std::int64_t>(outcomes, [](const auto& s) { return s.rank; }),
           {"-", "rank that ran it"});
}

/// Reads columns with one value for each row, and checks that.
class RowReader {
 public:
  RowReader(const std::string& path)
      : file_(read_study_bytes(path), path), path_(path), ids_(file_.integers("/samples/id")) {}

  const Hdf5Reader& file() const { return file_; }
  const std::vector<std::int64_t>& ids() const { return ids_; }
  std::vector<std::int64_t> integers(const std::string& dataset) const {
    return checked(file_.integers(dataset), dataset);
  }
  std::vector<double> reals(const std::string& dataset) const {
    return checked(file_.reals(dataset).values, dataset);
  }
  std::vector<std::string> texts(const std::string& dataset) const {
    return checked(file_.strings(dataset), dataset);
  }
  [[noreturn]] void fail(const std::string& problem) const {
    throw StudyFileError(path_, problem, kRebuildRemedy);
  }

 private:
  template <class T>
  std::vector<T> checked(std::vector<T> values, const std::string& dataset) const {
    if (values.size() != ids_.size())
      fail(fmt::format("{} has {} values where {} belong", dataset, values.size(), ids_.size()));
    return values;
  }

  Hdf5Reader file_;
  std::string path_;
  std::vector<std::int64_t> ids_;
};

Status status_from(std::int64_t number, const RowReader& file) {
  if (number < 0 || number > static_cast<std::int64_t>(Status::poisoned))
    file.fail(fmt::format("/samples/status holds {}, known are 0 to 5", number));
  return static_cast<Status>(number);
}

}  // namespace

std::string make_study_file(const SweepPlan& plan, const OutcomesById& outcomes,
                            const BuildInfo& build) {
  const H5Quiet quiet;
  const H5Handle file = make_h5_memory_file();
  const H5Handle root(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose, "open the root group");
  write_root(root, plan, build);
  write_study_texts(root, plan.study);
  write_operating_point(root, plan.study.scene);
  {
    // Freed before the file is copied out: of many samples it is as large as the file.
    const DrawnColumns drawn = draw_columns(plan, outcomes);
    write_samples(root, drawn, outcomes);
    write_inputs(root, plan.study, drawn);
  }
  write_jams(root, jam_shares(plan.study));
  write_results(root, outcomes, quantity_labels(plan.study));
  return sealed_h5_image(file);
}

void write_study_file(const std::string& path, const SweepPlan& plan, const OutcomesById& outcomes,
                      const BuildInfo& build) {
  replace_file(path, make_study_file(plan, outcomes, build));
}

StudyFile read_study_file(const std::string& path) {
  const RowReader file(path);
  StudyFile study;
  study.study_hash = file.file().text_attribute("/", "study_hash");
  study.build = file.file().text_attribute("/", "build");
  const auto toml = file.file().strings("/study/toml");
  if (toml.size() != 1) file.fail("/study/toml is not one text");
  study.study_toml = toml.front();

  const auto status = file.integers("/samples/status");
  const auto reason = file.texts("/samples/reason");
  const auto pocket = file.integers("/samples/pocket");
  const auto interference = file.reals("/samples/interference_um");
  const auto wall = file.reals("/timing/wall_s");
  const auto rank = file.integers("/timing/rank");
  std::vector<StoredOutcome> rows(file.ids().size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i] = {.id = static_cast<std::uint64_t>(file.ids()[i]),
               .status = status_from(status[i], file),
               .reason = reason[i],
               .pocket = static_cast<int>(pocket[i]),
               .interference_um = interference[i],
               .quantities = {},
               .run = {},
               .wall_s = wall[i],
               .rank = static_cast<int>(rank[i])};
  std::vector<std::string> labels;  // of files of older programs: none
  if (file.file().has("/study/labels")) labels = file.file().strings("/study/labels");
  for (const LabelledQuantity& quantity : labelled_quantities(labels)) {
    const std::string dataset = "/quantities/" + quantity.name;
    if (!file.file().has(dataset))
      throw StudyFileError(
          path,
          dataset + ": the file is of a cagetol without this quantity (build " + study.build + ")",
          "use that build, or sweep the study again into another directory");
    const auto values = file.reals(dataset);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].quantities.push_back(values[i]);
  }
  for (const RunField& field : stored_run_fields()) {
    const auto values = file.reals(std::string("/run/") + field.key);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].run.push_back(values[i]);
  }
  for (StoredOutcome& row : rows) study.outcomes.emplace(row.id, std::move(row));
  return study;
}

}  // namespace cagetol
