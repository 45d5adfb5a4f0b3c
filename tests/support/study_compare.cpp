#include "tests/support/study_compare.hpp"

#include <hdf5.h>

#include <cstring>
#include <map>

#include "mc/study_file/h5.hpp"
#include "mc/study_file/study_bytes.hpp"

namespace cagetol {
namespace {

/// Everything in a file: path -> type, shape and bytes as one text.
using Contents = std::map<std::string, std::string>;

std::string shape_text(hid_t space) {
  hsize_t shape[H5S_MAX_RANK];
  const int rank = H5Sget_simple_extent_dims(space, shape, nullptr);
  std::string text = "shape";
  for (int i = 0; i < rank; ++i) text += " " + std::to_string(shape[i]);
  return text + ";";
}

/// The values as bytes.
template <class Read>
std::string value_text(hid_t type, hid_t space, Read read) {
  const auto count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
  std::string bytes(count * H5Tget_size(type), '\0');
  if (H5Tis_variable_str(type) > 0) return "a text of variable length, which no file may have";
  if (count > 0 && read(static_cast<void*>(bytes.data())) < 0) return "unreadable";
  return bytes;
}

struct Walk {
  Contents contents;
  std::string object;
};

extern "C" herr_t take_attribute(hid_t object, const char* name, const H5A_info_t*,
                                 void* data) noexcept {
  auto& walk = *static_cast<Walk*>(data);
  const H5Handle attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose, "open");
  const H5Handle type(H5Aget_type(attribute), H5Tclose, "type");
  const H5Handle space(H5Aget_space(attribute), H5Sclose, "space");
  walk.contents[walk.object + "@" + name] =
      shape_text(space) +
      value_text(type, space, [&](void* to) { return H5Aread(attribute, type, to); });
  return 0;
}

extern "C" herr_t take_object(hid_t root, const char* name, const H5O_info_t* info,
                              void* data) noexcept {
  auto& walk = *static_cast<Walk*>(data);
  if (std::strncmp(name, "timing", 6) == 0) return 0;
  const H5Handle object(H5Oopen(root, name, H5P_DEFAULT), H5Oclose, "open");
  walk.object = name;
  H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, take_attribute, data);
  if (info->type != H5O_TYPE_DATASET) {
    walk.contents[name] = "group";
    return 0;
  }
  const H5Handle type(H5Dget_type(object), H5Tclose, "type");
  const H5Handle space(H5Dget_space(object), H5Sclose, "space");
  walk.contents[name] = shape_text(space) + value_text(type, space, [&](void* to) {
                          return H5Dread(object, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, to);
                        });
  return 0;
}

Contents contents_of(const std::string& path) {
  const std::string bytes = read_study_bytes(path);
  const H5Handle file = open_h5_image(bytes);
  Walk walk;
  H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, take_object, &walk, H5O_INFO_BASIC);
  return walk.contents;
}

}  // namespace

std::vector<std::string> study_file_differences(const std::string& first,
                                                const std::string& second) {
  const Contents a = contents_of(first), b = contents_of(second);
  std::vector<std::string> differences;
  if (a.size() < 20) differences.push_back(first + " holds next to nothing");
  for (const auto& [name, value] : a) {
    const auto found = b.find(name);
    if (found == b.end())
      differences.push_back(name + " is missing in " + second);
    else if (found->second != value)
      differences.push_back(name + " differs");
  }
  for (const auto& [name, value] : b)
    if (!a.contains(name)) differences.push_back(name + " is missing in " + first);
  return differences;
}

}  // namespace cagetol
