// The synthetic study as a study file.
#include <fstream>

#include "mc/study_file/h5.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

void write_root(hid_t file, const StudyData& study) {
  write_h5_attribute(file, "schema_version", study.provenance.schema_version);
  write_h5_attribute(file, "tool_version", study.provenance.tool_version);
  write_h5_attribute(file, "tool_commit", study.provenance.tool_commit);
  write_h5_attribute(file, "build", study.provenance.build);
  write_h5_attribute(file, "libraries", study.provenance.libraries);
  write_h5_attribute(file, "study_name", study.provenance.study_name);
  write_h5_attribute(file, "study_hash", study.provenance.study_hash);
  write_h5_attribute(file, "seed", study.provenance.seed);
  write_h5_attribute(file, "design", study.design.kind);
  write_h5_attribute(file, "rows_planned", study.design.rows_planned);
  write_h5_attribute(file, "samples_planned", study.design.samples_planned);
  write_h5_attribute(file, "pockets", static_cast<std::int64_t>(study.pockets));
}

void write_samples(hid_t file, const StudyData& study) {
  const H5Handle samples = make_h5_group(file, "samples");
  const H5Meaning plain{"-", ""};
  write_h5(samples, "id", study.id, plain);
  write_h5(samples, "row", study.row, plain);
  write_h5(samples, "replicate", study.replicate, plain);
  write_h5(samples, "lot", study.lot, plain);
  write_h5(samples, "candidate", study.candidate, plain);
  std::vector<std::int64_t> status;
  for (const RunStatus value : study.status) status.push_back(static_cast<std::int64_t>(value));
  write_h5(samples, "status", status, plain);
  write_h5(samples, "reason", study.reason, plain);
  write_h5(samples, "pocket", study.pocket, plain);
  write_h5(samples, "interference_um", study.interference_um, {"um", ""});
}

void write_inputs(hid_t file, const StudyData& study) {
  const H5Handle inputs = make_h5_group(file, "inputs");
  for (const InputColumns& input : study.inputs) {
    const H5Handle parent = make_h5_group(inputs, input.key);
    const H5Meaning meaning{input.unit, ""};
    write_h5_attribute(parent, "unit", input.unit);
    write_h5_attribute(parent, "nominal", input.nominal);
    if (!input.lot.empty()) write_h5(parent, "lot", input.lot, meaning);
    if (!input.pocket.empty()) write_h5(parent, "pocket", input.pocket, meaning, study.pockets);
    if (!input.noise.empty()) write_h5(parent, "noise", input.noise, meaning);
    write_h5(parent, "value", input.value, meaning, input.per_pocket ? study.pockets : 0);
  }
}

void write_columns(hid_t file, const char* name, const std::vector<Column>& columns,
                   std::size_t width = 0) {
  const H5Handle parent = make_h5_group(file, name);
  for (const Column& column : columns)
    write_h5(parent, column.name, column.values, {column.unit, column.description}, width);
}

}  // namespace

void write_synthetic_study(const StudyData& study, const std::filesystem::path& path) {
  const H5Handle file = make_h5_memory_file();
  const H5Handle root(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose, "open the root group");
  write_root(root, study);
  {
    const H5Handle texts = make_h5_group(file, "study");
    write_h5(texts, "toml", std::string("name = \"synthetic\""), {"-", ""});
    write_h5(texts, "json", study.plan.whole.dump(), {"-", ""});
    write_h5(texts, "files", study.provenance.files, {"-", ""});
  }
  write_samples(file, study);
  write_inputs(file, study);
  write_columns(file, "quantities", study.quantities);
  write_columns(file, "run", study.run);
  write_columns(file, "timing", study.timing);
  std::ofstream(path, std::ios::binary) << sealed_h5_image(file);
}

}  // namespace cagetol
