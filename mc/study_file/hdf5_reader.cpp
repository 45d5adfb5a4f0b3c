#include "mc/study_file/hdf5_reader.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "mc/study_file/study_file_error.hpp"

namespace cagetol {
namespace {

constexpr const char* kSpace = "its shape cannot be read";

std::vector<std::size_t> shape_of(hid_t space) {
  const int rank = H5Sget_simple_extent_ndims(space);
  std::vector<hsize_t> sizes(static_cast<std::size_t>(std::max(rank, 0)));
  if (rank > 0) H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
  return {sizes.begin(), sizes.end()};
}

std::size_t count_of(hid_t space) {
  return static_cast<std::size_t>(std::max<hssize_t>(H5Sget_simple_extent_npoints(space), 0));
}

/// Values that the room a dataset takes in its file cannot hold, even packed as well as HDF5 packs.
bool holds_less(hid_t dataset, hid_t space) {
  constexpr double kBestPacking = 1032;  // zlib's largest ratio
  const H5Handle type(H5Dget_type(dataset), H5Tclose, "read a type");
  const double announced =
      static_cast<double>(count_of(space)) * static_cast<double>(H5Tget_size(type));
  return announced > kBestPacking * static_cast<double>(H5Dget_storage_size(dataset));
}

bool is_utf8(const std::string& text) {
  try {
    return !nlohmann::json(text).dump().empty();
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
}

/// Every text; false where they cannot be read or are not UTF-8. `read` fills a buffer of the type.
template <class Read>
bool read_texts(hid_t type, hid_t space, const Read& read, std::vector<std::string>& texts) {
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0) return false;
  const std::size_t size = H5Tget_size(type);
  texts.resize(count_of(space));
  std::vector<char> buffer(size * texts.size());
  if (!texts.empty() && read(static_cast<void*>(buffer.data())) < 0) return false;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const char* begin = buffer.data() + i * size;
    texts[i].assign(begin, std::find(begin, begin + size, '\0'));
  }
  return std::all_of(texts.begin(), texts.end(), is_utf8);
}

}  // namespace

Hdf5Reader::Hdf5Reader(std::string bytes, std::string file_name)
    : file_name_(std::move(file_name)), bytes_(std::move(bytes)), file_([&] {
        try {
          return open_h5_image(bytes_);
        } catch (const H5Error& problem) {
          throw StudyFileError(file_name_, std::string("HDF5 ") + problem.what(), kRebuildRemedy);
        }
      }()) {}

void Hdf5Reader::fail(const std::string& object, const std::string& problem) const {
  throw StudyFileError(file_name_, object + ": " + problem, kRebuildRemedy);
}

H5Handle Hdf5Reader::opened(hid_t id, H5Handle::Close close, const std::string& object,
                            const std::string& problem) const {
  if (id < 0) fail(object, problem);
  return {id, close, object};
}

bool Hdf5Reader::has(const std::string& path) const {
  if (path == "/") return true;
  for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
    if (H5Lexists(file_, path.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
    if (end == std::string::npos) return true;
  }
}

std::vector<std::string> Hdf5Reader::children(const std::string& group) const {
  std::vector<std::string> names;
  if (!has(group)) return names;
  const H5Handle handle =
      opened(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose, group, "is not a group");
  H5G_info_t info{};
  H5Gget_info(handle, &info);
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    const auto size =
        H5Lget_name_by_idx(handle, ".", H5_INDEX_NAME, H5_ITER_INC, i, nullptr, 0, H5P_DEFAULT);
    if (size < 0) fail(group, "its list of members cannot be read");
    std::string name(static_cast<std::size_t>(size), '\0');
    H5Lget_name_by_idx(handle, ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(),
                       static_cast<std::size_t>(size) + 1, H5P_DEFAULT);
    names.push_back(std::move(name));
  }
  std::sort(names.begin(), names.end());
  return names;
}

Hdf5Reader::Dataset Hdf5Reader::opened_dataset(const std::string& dataset) const {
  H5Handle data =
      opened(H5Dopen2(file_, dataset.c_str(), H5P_DEFAULT), H5Dclose, dataset, "is missing");
  H5Handle space = opened(H5Dget_space(data), H5Sclose, dataset, kSpace);
  if (holds_less(data, space)) fail(dataset, "it announces more values than the file can hold");
  return {std::move(data), std::move(space)};
}

RealArray Hdf5Reader::reals(const std::string& dataset) const {
  const Dataset found = opened_dataset(dataset);
  RealArray array;
  array.shape = shape_of(found.space);
  array.values.resize(count_of(found.space));
  if (!array.values.empty() && H5Dread(found.data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                                       array.values.data()) < 0)
    fail(dataset, "its numbers cannot be read");
  return array;
}

std::vector<std::int64_t> Hdf5Reader::integers(const std::string& dataset) const {
  const Dataset found = opened_dataset(dataset);
  std::vector<std::int64_t> values(count_of(found.space));
  if (!values.empty() &&
      H5Dread(found.data, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    fail(dataset, "its whole numbers cannot be read");
  return values;
}

std::vector<std::string> Hdf5Reader::strings(const std::string& dataset) const {
  const Dataset found = opened_dataset(dataset);
  const H5Handle type =
      opened(H5Dget_type(found.data), H5Tclose, dataset, "its type cannot be read");
  const auto read = [&](void* buffer) {
    return H5Dread(found.data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer);
  };
  std::vector<std::string> texts;
  if (!read_texts(type, found.space, read, texts))
    fail(dataset, "its text cannot be read, or is not UTF-8");
  return texts;
}

H5Handle Hdf5Reader::attribute(const std::string& object, const std::string& name) const {
  return opened(H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
                H5Aclose, object, "has no attribute `" + name + "`");
}

bool Hdf5Reader::has_attribute(const std::string& object, const std::string& name) const {
  return H5Aexists_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

std::string Hdf5Reader::text_attribute(const std::string& object, const std::string& name) const {
  const H5Handle found = attribute(object, name);
  const H5Handle space = opened(H5Aget_space(found), H5Sclose, object, kSpace);
  const H5Handle type = opened(H5Aget_type(found), H5Tclose, object, "its type cannot be read");
  const auto read = [&](void* buffer) { return H5Aread(found, type, buffer); };
  std::vector<std::string> texts;
  if (!read_texts(type, space, read, texts) || texts.empty())
    fail(object, "its attribute `" + name + "` cannot be read as text, or is not UTF-8");
  return texts.front();
}

std::int64_t Hdf5Reader::integer_attribute(const std::string& object,
                                           const std::string& name) const {
  const H5Handle found = attribute(object, name);
  const H5Handle space = opened(H5Aget_space(found), H5Sclose, object, kSpace);
  std::int64_t value = 0;
  if (count_of(space) != 1 || H5Aread(found, H5T_NATIVE_INT64, &value) < 0)
    fail(object, "its attribute `" + name + "` is not a whole number");
  return value;
}

std::vector<double> Hdf5Reader::real_attribute(const std::string& object,
                                               const std::string& name) const {
  const H5Handle found = attribute(object, name);
  const H5Handle space = opened(H5Aget_space(found), H5Sclose, object, kSpace);
  std::vector<double> values(count_of(space));
  if (H5Aread(found, H5T_NATIVE_DOUBLE, values.data()) < 0)
    fail(object, "its attribute `" + name + "` is not a number");
  return values;
}

}  // namespace cagetol
