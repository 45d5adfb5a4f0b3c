// The synthetic study as an HDF5 file.
#include <hdf5.h>

#include <stdexcept>

#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

hid_t checked(hid_t id) {
  if (id < 0) throw std::runtime_error("the synthetic study cannot be written");
  return id;
}

hid_t text_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

void attribute(hid_t object, const char* name, const std::string& text) {
  const hid_t type = text_type(), space = H5Screate(H5S_SCALAR);
  const hid_t id = checked(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT));
  const char* pointer = text.c_str();
  H5Awrite(id, type, &pointer);
  H5Aclose(id), H5Sclose(space), H5Tclose(type);
}

void attribute(hid_t object, const char* name, std::int64_t value) {
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t id =
      checked(H5Acreate2(object, name, H5T_STD_I64LE, space, H5P_DEFAULT, H5P_DEFAULT));
  H5Awrite(id, H5T_NATIVE_INT64, &value);
  H5Aclose(id), H5Sclose(space);
}

void attribute(hid_t object, const char* name, const std::vector<double>& values) {
  const hsize_t count = values.size();
  const hid_t space = H5Screate_simple(1, &count, nullptr);
  const hid_t id =
      checked(H5Acreate2(object, name, H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT));
  H5Awrite(id, H5T_NATIVE_DOUBLE, values.data());
  H5Aclose(id), H5Sclose(space);
}

void dataset(hid_t parent, const std::string& name, hid_t type, const void* data, std::size_t count,
             std::size_t width, const std::string& unit, const std::string& description) {
  const hsize_t sizes[2] = {width > 1 ? count / width : count, width};
  const hid_t space = H5Screate_simple(width > 1 ? 2 : 1, sizes, nullptr);
  const hid_t id =
      checked(H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  if (count > 0) H5Dwrite(id, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data);
  attribute(id, "unit", unit);
  attribute(id, "description", description);
  H5Dclose(id), H5Sclose(space);
}

void reals(hid_t parent, const std::string& name, const std::vector<double>& values,
           const std::string& unit, std::size_t width = 1, const std::string& description = "") {
  dataset(parent, name, H5T_NATIVE_DOUBLE, values.data(), values.size(), width, unit, description);
}

void integers(hid_t parent, const std::string& name, const std::vector<std::int64_t>& values) {
  dataset(parent, name, H5T_NATIVE_INT64, values.data(), values.size(), 1, "-", "");
}

void texts(hid_t parent, const std::string& name, const std::vector<std::string>& values) {
  std::vector<const char*> pointers;
  for (const std::string& value : values) pointers.push_back(value.c_str());
  const hid_t type = text_type();
  dataset(parent, name, type, pointers.data(), values.size(), 1, "-", "");
  H5Tclose(type);
}

hid_t group(hid_t parent, const std::string& name) {
  return checked(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
}

void write_root(hid_t file, const StudyData& study) {
  attribute(file, "schema_version", study.provenance.schema_version);
  attribute(file, "tool_version", study.provenance.tool_version);
  attribute(file, "tool_commit", study.provenance.tool_commit);
  attribute(file, "build", study.provenance.build);
  attribute(file, "libraries", study.provenance.libraries);
  attribute(file, "study_name", study.provenance.study_name);
  attribute(file, "study_hash", study.provenance.study_hash);
  attribute(file, "seed", study.provenance.seed);
  attribute(file, "design", study.design.kind);
  attribute(file, "rows_planned", study.design.rows_planned);
  attribute(file, "samples_planned", study.design.samples_planned);
  attribute(file, "scrambles", study.design.scrambles);
  attribute(file, "pockets", static_cast<std::int64_t>(study.pockets));
}

void write_samples(hid_t file, const StudyData& study) {
  const hid_t samples = group(file, "samples");
  integers(samples, "id", study.id);
  integers(samples, "row", study.row);
  integers(samples, "replicate", study.replicate);
  integers(samples, "lot", study.lot);
  integers(samples, "candidate", study.candidate);
  std::vector<std::int64_t> status;
  for (const RunStatus value : study.status) status.push_back(static_cast<std::int64_t>(value));
  integers(samples, "status", status);
  texts(samples, "reason", study.reason);
  integers(samples, "pocket", study.pocket);
  reals(samples, "interference_um", study.interference_um, "um");
  H5Gclose(samples);
}

void write_columns(hid_t file, const char* name, const std::vector<Column>& columns) {
  const hid_t parent = group(file, name);
  for (const Column& column : columns)
    reals(parent, column.name, column.values, column.unit, 1, column.description);
  H5Gclose(parent);
}

}  // namespace

void write_synthetic_study(const StudyData& study, const std::filesystem::path& path) {
  const hid_t file = checked(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  write_root(file, study);
  const hid_t texts_of_study = group(file, "study");
  texts(texts_of_study, "toml", {"name = \"synthetic\""});
  texts(texts_of_study, "json", {study.plan.whole.dump()});
  texts(texts_of_study, "files", study.provenance.files);
  H5Gclose(texts_of_study);
  write_samples(file, study);
  if (!study.design.columns.empty()) {
    const hid_t design = group(file, "design");
    reals(design, "point", study.design.point, "-", study.design.columns.size());
    texts(design, "columns", study.design.columns);
    texts(design, "groups", study.design.groups);
    H5Gclose(design);
  }
  const hid_t inputs = group(file, "inputs");
  for (const InputColumns& input : study.inputs) {
    const hid_t parent = group(inputs, input.key);
    attribute(parent, "unit", input.unit);
    attribute(parent, "nominal", input.nominal);
    if (!input.lot.empty()) reals(parent, "lot", input.lot, input.unit);
    if (!input.pocket.empty()) reals(parent, "pocket", input.pocket, input.unit, study.pockets);
    if (!input.noise.empty()) reals(parent, "noise", input.noise, input.unit);
    reals(parent, "value", input.value, input.unit, input.per_pocket ? study.pockets : 1);
    H5Gclose(parent);
  }
  H5Gclose(inputs);
  write_columns(file, "quantities", study.quantities);
  write_columns(file, "run", study.run);
  write_columns(file, "timing", study.timing);
  if (study.history_points > 0) {
    const hid_t history = group(file, "history");
    for (const Column& channel : study.history)
      reals(history, channel.name, channel.values, channel.unit, study.history_points);
    H5Gclose(history);
  }
  H5Fclose(file);
}

}  // namespace cagetol
