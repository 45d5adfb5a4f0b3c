// HDF5 with owners: every identifier is closed once, every failure is an H5Error with the library's
// own words.
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace cagetol {

class H5Error : public std::runtime_error {
 public:
  /// "ACTION: what HDF5 says", taken from the library's error stack.
  explicit H5Error(const std::string& action);
};

/// Owns one HDF5 identifier. Throws H5Error when constructed from a negative one.
class H5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  H5Handle(hid_t id, Close close, const std::string& action);
  H5Handle(H5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  H5Handle(const H5Handle&) = delete;
  H5Handle& operator=(const H5Handle&) = delete;
  H5Handle& operator=(H5Handle&&) = delete;
  ~H5Handle();
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

/// Keeps HDF5 from printing its error stack while it lives.
class H5Quiet {
 public:
  H5Quiet();
  H5Quiet(const H5Quiet&) = delete;
  H5Quiet& operator=(const H5Quiet&) = delete;
  ~H5Quiet();

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

/// What a dataset says about itself.
struct H5Meaning {
  std::string unit;
  std::string description;
};

/// A file that grows in memory; `sealed_h5_image` gives its bytes, with the seal of file_seal.hpp
/// in front. Full disks are then met by plain writes, which can be undone.
H5Handle make_h5_memory_file();
std::string sealed_h5_image(const H5Handle& file);
/// Opens the bytes of a file read-only, without a copy: they must outlive the handle.
H5Handle open_h5_image(const std::string& bytes);

/// Groups and datasets carry no times, so that equal contents are equal bytes. `columns` 0 makes a
/// dataset of one dimension. Texts are UTF-8 of fixed length, padded with zeros to the longest of
/// their dataset; a text ends before its first zero.
H5Handle make_h5_group(hid_t parent, const std::string& name);
void write_h5(hid_t parent, const std::string& name, const std::vector<double>& values,
              const H5Meaning& meaning, std::size_t columns = 0);
void write_h5(hid_t parent, const std::string& name, const std::vector<std::int64_t>& values,
              const H5Meaning& meaning);
void write_h5(hid_t parent, const std::string& name, const std::vector<std::string>& values,
              const H5Meaning& meaning);
void write_h5(hid_t parent, const std::string& name, const std::string& value,
              const H5Meaning& meaning);

/// Attributes hold less than 64 KiB: HDF5 keeps them with their object. Long texts are datasets.
void write_h5_attribute(hid_t object, const std::string& name, const std::string& value);
void write_h5_attribute(hid_t object, const std::string& name, std::int64_t value);
void write_h5_attribute(hid_t object, const std::string& name, const std::vector<double>& values);

}  // namespace cagetol
