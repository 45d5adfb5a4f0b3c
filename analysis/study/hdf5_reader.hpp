// Read access to one HDF5 file. HDF5 identifiers are owned here and nowhere else in the room.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace cagetol {

/// A dataset of reals with its shape; row-major.
struct RealArray {
  std::vector<std::size_t> shape;
  std::vector<double> values;
};

/// Opens a file read-only. Every member throws StudyFileError naming the file and the object that
/// is missing or broken.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::filesystem::path& file);
  ~Hdf5Reader();
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

  std::string file_name_;
  std::int64_t file_ = -1;
};

}  // namespace cagetol
