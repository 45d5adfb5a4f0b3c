// Read access to the objects of one HDF5 file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mc/study_file/h5.hpp"

namespace cagetol {

/// A dataset of reals with its shape; row-major.
struct RealArray {
  std::vector<std::size_t> shape;
  std::vector<double> values;
};

/// Reads from the bytes of a file (study_bytes.hpp). Every member throws StudyFileError naming the
/// file and the object that is missing or broken.
class Hdf5Reader {
 public:
  /// `file_name` stands for the file in messages.
  Hdf5Reader(std::string bytes, std::string file_name);
  Hdf5Reader(const Hdf5Reader&) = delete;
  Hdf5Reader& operator=(const Hdf5Reader&) = delete;

  bool has(const std::string& path) const;
  /// Names of the links of a group in alphabetical order; empty where the group is absent.
  std::vector<std::string> children(const std::string& group) const;

  RealArray reals(const std::string& dataset) const;
  std::vector<std::int64_t> integers(const std::string& dataset) const;
  std::vector<std::string> strings(const std::string& dataset) const;

  bool has_attribute(const std::string& object, const std::string& name) const;
  std::string text_attribute(const std::string& object, const std::string& name) const;
  std::int64_t integer_attribute(const std::string& object, const std::string& name) const;
  /// One number or several.
  std::vector<double> real_attribute(const std::string& object, const std::string& name) const;

 private:
  [[noreturn]] void fail(const std::string& object, const std::string& problem) const;

  H5Handle opened(hid_t id, H5Handle::Close close, const std::string& object,
                  const std::string& problem) const;
  struct Dataset {
    H5Handle data, space;
  };
  /// Refuses one that announces more than the file can hold.
  Dataset opened_dataset(const std::string& dataset) const;
  H5Handle attribute(const std::string& object, const std::string& name) const;

  H5Quiet quiet_;
  std::string file_name_, bytes_;
  H5Handle file_;
};

}  // namespace cagetol
