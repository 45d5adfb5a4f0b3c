// Cache file of a cage table: a magic line, the key, then every array as sizes and doubles, native
// byte order.
#include <unistd.h>

#include <bit>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <system_error>

#include "src/cage/cage_table.hpp"

namespace cagetol {
namespace {

constexpr const char* kMagic = "cagetol cage table 10\n";

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
  explicit Writer(std::ostream& out) : out_(&out) {}
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
    out_->write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
  }
  std::ostream* out_;
};

class Reader {
 public:
  explicit Reader(std::istream& in) : in_(&in) {}
  void operator()(double& value) { raw(&value, sizeof value); }
  void operator()(Eigen::Index& value) { raw(&value, sizeof value); }
  void operator()(bool& value) { raw(&value, sizeof value); }
  template <typename Derived>
  void operator()(Eigen::PlainObjectBase<Derived>& matrix) {
    Eigen::Index rows = 0;
    Eigen::Index cols = 0;
    (*this)(rows);
    (*this)(cols);
    constexpr Eigen::Index limit = 1 << 28;
    if (!*in_ || rows < 0 || cols < 0 || rows > limit || cols > limit || rows * cols > limit) {
      in_->setstate(std::ios::failbit);
      return;
    }
    matrix.resize(rows, cols);
    raw(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(typename Derived::Scalar));
  }

 private:
  void raw(void* data, std::size_t size) {
    in_->read(static_cast<char*>(data), static_cast<std::streamsize>(size));
  }
  std::istream* in_;
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
  stream(table.projection);
  stream(table.contact);
  stream(table.stress);
  stream(table.attachment_stress);
  stream(table.gyroscopic);
  stream(table.in_plane);
  stream(table.centrifugal);
  stream(table.dofs);
  stream(table.seconds_full);
  stream(table.seconds_table);
}

bool read_table(const std::filesystem::path& file, const std::string& head, CageTable& table) {
  std::ifstream in(file, std::ios::binary);
  std::string found(head.size(), '\0');
  if (!in.read(found.data(), static_cast<std::streamsize>(found.size())) || found != head)
    return false;
  transfer(Reader(in), table);
  std::string tail(head.size(), '\0');
  return in.read(tail.data(), static_cast<std::streamsize>(tail.size())) && tail == head;
}

/// Written under a name of its own and renamed, so that several processes may start together.
bool write_table(const std::filesystem::path& file, const std::string& head, CageTable& table) {
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  const std::filesystem::path part = file.string() + "." + std::to_string(getpid());
  std::ofstream out(part, std::ios::binary);
  out << head;
  transfer(Writer(out), table);
  out << head;
  out.close();
  std::error_code ignored;
  if (out) std::filesystem::rename(part, file, error);
  if (!out || error) std::filesystem::remove(part, ignored);
  return out && !error;
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
        static_cast<double>(options.corrected_modes), static_cast<double>(options.reach)}) {
    hash.add(value);
  }
  for (long steps : {options.point.width, options.point.length})
    hash.add(static_cast<double>(steps));
  for (double x : stations.bar_x) hash.add(x);
  for (double half : stations.bar_half) hash.add(half);
  char text[20];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash.value()));
  return text;
}

CageTable cached_cage_table(const std::filesystem::path& folder, const CageDimensions& cage,
                            const Material& material, const CageStations& stations,
                            const CageTableOptions& options, const CageTableNews& news) {
  const std::string key = cage_table_key(cage, material, stations, options);
  const std::filesystem::path file = folder / ("cage-" + key + ".bin");
  const std::string head = kMagic + key + "\n";
  CageTable table;
  if (read_table(file, head, table)) {
    complete_cage_table(table, cage, material, stations, options);
    return table;
  }
  table = make_cage_table(cage, material, stations, options, news);
  if (!write_table(file, head, table) && news.warning) {
    news.warning("cannot write " + file.string() + "; the cage table will be made again next time");
  }
  return table;
}

}  // namespace cagetol
