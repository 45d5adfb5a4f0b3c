#include "analysis/study/hdf5_reader.hpp"

#include <hdf5.h>

#include <algorithm>

#include "analysis/study/study_file_error.hpp"

namespace cagetol {
namespace {

/// An HDF5 identifier closed at the end of its scope.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  hid_t id() const { return id_; }
  bool valid() const { return id_ >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// HDF5 prints its error stack by itself; what users see is the message of StudyFileError.
class SilentHdf5 {
 public:
  SilentHdf5() {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~SilentHdf5() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

std::vector<std::size_t> shape_of(hid_t space) {
  const int rank = H5Sget_simple_extent_ndims(space);
  std::vector<hsize_t> sizes(static_cast<std::size_t>(std::max(rank, 0)));
  if (rank > 0) H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
  return {sizes.begin(), sizes.end()};
}

std::size_t count_of(const std::vector<std::size_t>& shape) {
  std::size_t count = 1;
  for (const std::size_t size : shape) count *= size;
  return count;
}

/// Strings as stored: variable-length, or fixed-length with padding. `read` fills a buffer of the
/// memory type given.
template <class Read>
std::vector<std::string> read_strings(hid_t stored, hid_t space, std::size_t count,
                                      const Read& read, bool& ok) {
  std::vector<std::string> texts(count);
  if (H5Tis_variable_str(stored) > 0) {
    const Handle memory(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(memory.id(), H5T_VARIABLE);
    H5Tset_cset(memory.id(), H5Tget_cset(stored));
    std::vector<char*> pointers(count, nullptr);
    ok = read(memory.id(), pointers.data()) >= 0;
    for (std::size_t i = 0; ok && i < count; ++i)
      if (pointers[i] != nullptr) texts[i] = pointers[i];
    if (ok) H5Dvlen_reclaim(memory.id(), space, H5P_DEFAULT, pointers.data());
    return texts;
  }
  const std::size_t size = H5Tget_size(stored);
  std::vector<char> buffer(size * count);
  ok = read(stored, buffer.data()) >= 0;
  for (std::size_t i = 0; ok && i < count; ++i) {
    const char* begin = buffer.data() + i * size;
    texts[i].assign(begin, std::find(begin, begin + size, '\0'));
  }
  return texts;
}

}  // namespace

Hdf5Reader::Hdf5Reader(const std::filesystem::path& file) : file_name_(file.string()) {
  const SilentHdf5 silent;
  if (!std::filesystem::exists(file))
    throw StudyFileError(
        file_name_, "there is no such file",
        "run `cagetol sweep STUDY -o DIR` first, or name the directory that holds study.h5");
  if (H5Fis_hdf5(file_name_.c_str()) <= 0)
    throw StudyFileError(
        file_name_, "this is not a complete HDF5 file (truncated, or another kind of file)",
        "start the same `cagetol sweep` again: it rebuilds study.h5 from its journals");
  file_ = H5Fopen(file_name_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (file_ < 0)
    throw StudyFileError(
        file_name_, "HDF5 cannot open it (truncated, or not readable)",
        "check its permissions, or start the same `cagetol sweep` again: it rebuilds study.h5");
}

Hdf5Reader::~Hdf5Reader() {
  if (file_ >= 0) H5Fclose(file_);
}

void Hdf5Reader::fail(const std::string& object, const std::string& problem) const {
  throw StudyFileError(file_name_, object + ": " + problem,
                       "start the same `cagetol sweep` again with this version of the program: it "
                       "rebuilds study.h5");
}

bool Hdf5Reader::has(const std::string& path) const {
  const SilentHdf5 silent;
  for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
    if (H5Lexists(file_, path.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    if (end == std::string::npos) return true;
  }
}

std::vector<std::string> Hdf5Reader::children(const std::string& group) const {
  const SilentHdf5 silent;
  std::vector<std::string> names;
  if (!has(group)) return names;
  const Handle handle(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose);
  if (!handle.valid()) fail(group, "is not a group");
  H5G_info_t info{};
  H5Gget_info(handle.id(), &info);
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const auto size = H5Lget_name_by_idx(handle.id(), ".", H5_INDEX_NAME, H5_ITER_INC, i, nullptr,
                                         0, H5P_DEFAULT);
    if (size < 0) fail(group, "its list of members cannot be read");
    std::string name(static_cast<std::size_t>(size), '\0');
    H5Lget_name_by_idx(handle.id(), ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(),
                       static_cast<std::size_t>(size) + 1, H5P_DEFAULT);
    names.push_back(std::move(name));
  }
  std::sort(names.begin(), names.end());
  return names;
}

RealArray Hdf5Reader::reals(const std::string& dataset) const {
  const SilentHdf5 silent;
  const Handle data(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
  if (!data.valid()) fail(dataset, "is missing");
  const Handle space(H5Dget_space(data.id()), H5Sclose);
  RealArray array;
  array.shape = shape_of(space.id());
  array.values.resize(count_of(array.shape));
  if (!array.values.empty() &&
      H5Dread(data.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values.data()) < 0)
    fail(dataset, "its numbers cannot be read");
  return array;
}

std::vector<std::int64_t> Hdf5Reader::integers(const std::string& dataset) const {
  const SilentHdf5 silent;
  const Handle data(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
  if (!data.valid()) fail(dataset, "is missing");
  const Handle space(H5Dget_space(data.id()), H5Sclose);
  std::vector<std::int64_t> values(count_of(shape_of(space.id())));
  if (!values.empty() &&
      H5Dread(data.id(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    fail(dataset, "its whole numbers cannot be read");
  return values;
}

std::vector<std::string> Hdf5Reader::strings(const std::string& dataset) const {
  const SilentHdf5 silent;
  const Handle data(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose);
  if (!data.valid()) fail(dataset, "is missing");
  const Handle space(H5Dget_space(data.id()), H5Sclose);
  const Handle type(H5Dget_type(data.id()), H5Tclose);
  if (H5Tget_class(type.id()) != H5T_STRING) fail(dataset, "does not hold text");
  const std::size_t count = count_of(shape_of(space.id()));
  if (count == 0) return {};
  bool ok = false;
  const auto read = [&](hid_t memory, void* buffer) {
    return H5Dread(data.id(), memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer);
  };
  auto texts = read_strings(type.id(), space.id(), count, read, ok);
  if (!ok) fail(dataset, "its text cannot be read");
  return texts;
}

bool Hdf5Reader::has_attribute(const std::string& object, const std::string& name) const {
  const SilentHdf5 silent;
  return H5Aexists_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

std::string Hdf5Reader::text_attribute(const std::string& object, const std::string& name) const {
  const SilentHdf5 silent;
  const Handle attribute(
      H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (!attribute.valid()) fail(object, "has no attribute `" + name + "`");
  const Handle space(H5Aget_space(attribute.id()), H5Sclose);
  const Handle type(H5Aget_type(attribute.id()), H5Tclose);
  bool ok = H5Tget_class(type.id()) == H5T_STRING;
  if (!ok) fail(object, "its attribute `" + name + "` is not text");
  const auto read = [&](hid_t memory, void* buffer) {
    return H5Aread(attribute.id(), memory, buffer);
  };
  auto texts = read_strings(type.id(), space.id(), count_of(shape_of(space.id())), read, ok);
  if (!ok || texts.empty()) fail(object, "its attribute `" + name + "` cannot be read");
  return texts.front();
}

std::int64_t Hdf5Reader::integer_attribute(const std::string& object,
                                           const std::string& name) const {
  const SilentHdf5 silent;
  const Handle attribute(
      H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (!attribute.valid()) fail(object, "has no attribute `" + name + "`");
  std::int64_t value = 0;
  if (H5Aread(attribute.id(), H5T_NATIVE_INT64, &value) < 0)
    fail(object, "its attribute `" + name + "` is not a whole number");
  return value;
}

std::vector<double> Hdf5Reader::real_attribute(const std::string& object,
                                               const std::string& name) const {
  const SilentHdf5 silent;
  const Handle attribute(
      H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  if (!attribute.valid()) fail(object, "has no attribute `" + name + "`");
  const Handle space(H5Aget_space(attribute.id()), H5Sclose);
  std::vector<double> values(count_of(shape_of(space.id())));
  if (H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, values.data()) < 0)
    fail(object, "its attribute `" + name + "` is not a number");
  return values;
}

}  // namespace cagetol
