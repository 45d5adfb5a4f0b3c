#include "mc/study_file/h5.hpp"

#include <hdf5_hl.h>

#include <algorithm>

#include "mc/study_file/file_seal.hpp"

namespace cagetol {
namespace {

extern "C" herr_t keep_last_message(unsigned, const H5E_error2_t* error, void* text) noexcept {
  if (error->desc != nullptr) *static_cast<const char**>(text) = error->desc;
  return 0;
}

std::string library_message() {
  // The walk goes from the outermost call to the place where it went wrong: the last message says
  // why.
  const char* message = "";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keep_last_message, static_cast<void*>(&message));
  return *message == '\0' ? "HDF5 gives no reason" : message;
}

void check(herr_t result, const std::string& action) {
  if (result < 0) throw H5Error(action);
}

/// HDF5 1.10 crashes on damaged files with strings of variable length: none are written.
H5Handle text_type(std::size_t size) {
  H5Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "make a string type");
  check(H5Tset_size(type, std::max<std::size_t>(size, 1)), "make a string type");
  check(H5Tset_strpad(type, H5T_STR_NULLPAD), "make a string type");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "make a string type");
  return type;
}

H5Handle scalar_space() {
  return {H5Screate(H5S_SCALAR), H5Sclose, "make a scalar space"};
}

H5Handle without_times(hid_t property_class) {
  H5Handle list(H5Pcreate(property_class), H5Pclose, "make a property list");
  check(H5Pset_obj_track_times(list, false), "switch times off");
  return list;
}

void write_attribute(hid_t object, const std::string& name, hid_t type, hid_t space,
                     const void* value) {
  const std::string action = "write attribute " + name;
  const H5Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose, action);
  check(H5Awrite(attribute, type, value), action);
}

void write_dataset(hid_t parent, const std::string& name, hid_t type, const H5Handle& space,
                   const void* values, const H5Meaning& meaning) {
  const std::string action = "write dataset " + name;
  const H5Handle creation = without_times(H5P_DATASET_CREATE);
  const H5Handle dataset(
      H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT), H5Dclose,
      action);
  if (values != nullptr)
    check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), action);
  write_h5_attribute(dataset, "unit", meaning.unit);
  write_h5_attribute(dataset, "description", meaning.description);
}

H5Handle array_space(std::size_t values, std::size_t columns) {
  if (columns == 0) {
    const hsize_t length = values;
    return {H5Screate_simple(1, &length, nullptr), H5Sclose, "make a space"};
  }
  const hsize_t shape[2] = {values / columns, columns};
  return {H5Screate_simple(2, shape, nullptr), H5Sclose, "make a space"};
}

}  // namespace

H5Error::H5Error(const std::string& action)
    : std::runtime_error("cannot " + action + ": " + library_message()) {}

H5Handle::H5Handle(hid_t id, Close close, const std::string& action) : id_(id), close_(close) {
  if (id < 0) throw H5Error(action);
}

H5Handle::~H5Handle() {
  if (id_ >= 0) close_(id_);
}

H5Quiet::H5Quiet() {
  H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

H5Quiet::~H5Quiet() {
  H5Eset_auto2(H5E_DEFAULT, function_, data_);
}

H5Handle make_h5_memory_file() {
  constexpr std::size_t kGrowth = 4 << 20;
  const H5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make a property list");
  check(H5Pset_fapl_core(access, kGrowth, false), "keep a file in memory");
  const H5Handle creation = without_times(H5P_FILE_CREATE);
  // The library tells such files apart by their names: an identifier is given once.
  const std::string name = "memory " + std::to_string(static_cast<hid_t>(access));
  return {H5Fcreate(name.c_str(), H5F_ACC_TRUNC, creation, access), H5Fclose,
          "make a file in memory"};
}

std::string sealed_h5_image(const H5Handle& file) {
  check(H5Fflush(file, H5F_SCOPE_GLOBAL), "flush a file in memory");
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  if (size < 0) throw H5Error("size a file in memory");
  // HDF5 looks for its signature behind any user block, and counts addresses from there.
  std::string bytes(kSealSize + static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file, bytes.data() + kSealSize, static_cast<std::size_t>(size)) < 0)
    throw H5Error("copy a file in memory");
  return sealed(std::move(bytes));
}

H5Handle open_h5_image(const std::string& bytes) {
  // With these flags the library only reads the buffer, though its interface takes it as writable.
  return {H5LTopen_file_image(const_cast<char*>(bytes.data()), bytes.size(),
                              H5LT_FILE_IMAGE_DONT_COPY | H5LT_FILE_IMAGE_DONT_RELEASE),
          H5Fclose, "open a file in memory"};
}

H5Handle make_h5_group(hid_t parent, const std::string& name) {
  const H5Handle creation = without_times(H5P_GROUP_CREATE);
  return {H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT), H5Gclose,
          "make group " + name};
}

void write_h5(hid_t parent, const std::string& name, const std::vector<double>& values,
              const H5Meaning& meaning, std::size_t columns) {
  write_dataset(parent, name, H5T_NATIVE_DOUBLE, array_space(values.size(), columns),
                values.empty() ? nullptr : values.data(), meaning);
}

void write_h5(hid_t parent, const std::string& name, const std::vector<std::int64_t>& values,
              const H5Meaning& meaning) {
  write_dataset(parent, name, H5T_NATIVE_INT64, array_space(values.size(), 0),
                values.empty() ? nullptr : values.data(), meaning);
}

void write_h5(hid_t parent, const std::string& name, const std::vector<std::string>& values,
              const H5Meaning& meaning) {
  std::size_t size = 1;
  for (const std::string& value : values) size = std::max(size, value.size());
  std::string texts(size * values.size(), '\0');
  for (std::size_t i = 0; i < values.size(); ++i)
    texts.replace(i * size, values[i].size(), values[i]);
  write_dataset(parent, name, text_type(size), array_space(values.size(), 0),
                texts.empty() ? nullptr : texts.data(), meaning);
}

void write_h5(hid_t parent, const std::string& name, const std::string& value,
              const H5Meaning& meaning) {
  write_dataset(parent, name, text_type(value.size()), scalar_space(), value.c_str(), meaning);
}

void write_h5_attribute(hid_t object, const std::string& name, const std::string& value) {
  write_attribute(object, name, text_type(value.size()), scalar_space(), value.c_str());
}

void write_h5_attribute(hid_t object, const std::string& name, std::int64_t value) {
  write_attribute(object, name, H5T_NATIVE_INT64, scalar_space(), &value);
}

void write_h5_attribute(hid_t object, const std::string& name, const std::vector<double>& values) {
  write_attribute(object, name, H5T_NATIVE_DOUBLE, array_space(values.size(), 0), values.data());
}

}  // namespace cagetol
