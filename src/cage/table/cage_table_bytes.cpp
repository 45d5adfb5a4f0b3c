// Every array as its sizes and its numbers, in the machine's own byte order.
#include "src/cage/table/cage_table_bytes.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace cagetol {
namespace {

/// FNV-1a over the bit patterns of numbers.
class Hash {
 public:
  void add(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value == 0 ? 0.0 : value);
    for (int byte = 0; byte < 8; ++byte) {
      hash_ = (hash_ ^ ((bits >> (8 * byte)) & 0xff)) * 0x100000001b3ULL;
    }
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

class Writer {
 public:
  explicit Writer(std::string& out) : out_(&out) {}
  void operator()(const double& value) { raw(&value, sizeof value); }
  void operator()(const Eigen::Index& value) { raw(&value, sizeof value); }
  void operator()(const bool& value) { raw(&value, sizeof value); }
  template <typename Derived>
  void operator()(const Eigen::PlainObjectBase<Derived>& matrix) {
    (*this)(matrix.rows());
    (*this)(matrix.cols());
    raw(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(typename Derived::Scalar));
  }

 private:
  void raw(const void* data, std::size_t size) {
    out_->append(static_cast<const char*>(data), size);
  }
  std::string* out_;
};

/// Once bytes are missing, nothing more is read and `whole` stays false.
class Reader {
 public:
  Reader(std::string_view& left, bool& whole) : left_(&left), whole_(&whole) {}
  void operator()(double& value) { raw(&value, sizeof value); }
  void operator()(Eigen::Index& value) { raw(&value, sizeof value); }
  void operator()(bool& value) {
    unsigned char byte = 0;
    raw(&byte, sizeof byte);
    value = byte != 0;
  }
  template <typename Derived>
  void operator()(Eigen::PlainObjectBase<Derived>& matrix) {
    Eigen::Index rows = 0;
    Eigen::Index cols = 0;
    (*this)(rows);
    (*this)(cols);
    constexpr Eigen::Index limit = 1 << 28;
    constexpr auto each = static_cast<Eigen::Index>(sizeof(typename Derived::Scalar));
    const auto left = static_cast<Eigen::Index>(left_->size());
    constexpr bool vector = Derived::ColsAtCompileTime == 1;
    *whole_ = *whole_ && rows >= 0 && cols >= 0 && rows <= limit && cols <= limit &&
              (!vector || cols == 1) && rows * cols <= left / each;
    if (!*whole_) return;
    matrix.resize(rows, cols);
    raw(matrix.data(), static_cast<std::size_t>(matrix.size() * each));
  }

 private:
  void raw(void* data, std::size_t size) {
    *whole_ = *whole_ && size <= left_->size();
    if (!*whole_ || size == 0) return;
    std::memcpy(data, left_->data(), size);
    left_->remove_prefix(size);
  }
  std::string_view* left_;
  bool* whole_;
};

/// Everything that is computed; the rest follows from what the key covers.
template <typename Stream, typename Table>
void transfer(Stream stream, Table& table) {
  stream(table.turn.sectors);
  stream(table.turn.modes);
  stream(table.turn.per_sector);
  stream(table.turn.reach);
  stream(table.turn.partner);
  stream(table.turn.angle);
  stream(table.turn.cosine);
  stream(table.turn.sine);
  stream(table.frequency);
  if constexpr (!std::is_const_v<Table>)
    table.family.resize(static_cast<std::size_t>(table.frequency.size()));
  for (auto& family : table.family) {
    stream(family.waves);
    stream(family.axial_share);
    stream(family.opposed);
  }
  stream(table.undeviated.modal_stiffness);
  stream(table.undeviated.cross_stiffness);
  stream(table.undeviated.local_stiffness);
  stream(table.undeviated.modal_mass);
  stream(table.undeviated.cross_mass);
  stream(table.undeviated.local_mass);
  stream(table.projection);
  stream(table.contact);
  stream(table.stress);
  stream(table.attachment_stress);
  stream(table.gyroscopic);
  stream(table.in_plane);
  stream(table.centrifugal);
  stream(table.dofs);
  stream(table.seconds_table);
}

}  // namespace

std::string cage_table_key(const CageDimensions& cage, const Material& material,
                           const CageStations& stations, const CageTableOptions& options) {
  Hash hash;
  for (double value :
       {static_cast<double>(cage.pocket_count), cage.inner_radius, cage.outer_radius, cage.width,
        cage.pocket_width, cage.pocket_length, material.young, material.poisson, material.density,
        stations.pitch_radius, stations.end_offset, stations.land_offset,
        stations.outer_guided ? 1.0 : 0.0, static_cast<double>(options.density),
        static_cast<double>(options.basis_modes), static_cast<double>(options.corrections),
        static_cast<double>(options.corrected_modes), static_cast<double>(options.reach),
        cage.corner_radius}) {
    hash.add(value);
  }
  for (long steps : {options.point.width, options.point.length})
    hash.add(static_cast<double>(steps));
  const StripCounts& strip = options.strip;
  for (long count : {strip.half_bar, strip.half_arc, strip.ring, strip.across, strip.radial})
    hash.add(static_cast<double>(count));
  for (double x : stations.bar_x) hash.add(x);
  for (double half : stations.bar_half) hash.add(half);
  return fmt::format("{:016x}", hash.value());
}

std::string cage_table_bytes(const CageTable& table) {
  std::string bytes;
  transfer(Writer(bytes), table);
  return bytes;
}

bool read_cage_table_bytes(std::string_view bytes, CageTable& table) {
  bool whole = true;
  transfer(Reader(bytes, whole), table);
  return whole && bytes.empty();
}

}  // namespace cagetol
