#include "mc/host/build_info.hpp"

#include <fmt/format.h>
#include <gsl/gsl_version.h>
#include <hdf5.h>
#include <mpi.h>
#include <sundials/sundials_version.h>

#include <array>
#include <bit>
#include <cstdint>
#include <fstream>

#include "cagetol_build.hpp"

namespace cagetol {
namespace {

constexpr std::uint64_t kHashStart = 0xcbf29ce484222325u, kHashFactor = 0x100000001b3u;  // FNV-1a

std::string hdf5_version() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return fmt::format("{}.{}.{}", major, minor, release);
}

std::string sundials_version() {
  std::array<char, 32> text{};
  SUNDIALSGetVersion(text.data(), static_cast<int>(text.size()));
  return text.data();
}

/// By words and in blocks: every command waits for it.
std::string program_hash() {
  std::ifstream file("/proc/self/exe", std::ios::binary);
  std::array<std::uint64_t, 8192> block{};
  std::uint64_t hash = kHashStart;
  while (file.read(reinterpret_cast<char*>(block.data()), sizeof block) || file.gcount() > 0)
    for (const std::uint64_t word : block) hash = std::rotl((hash ^ word) * kHashFactor, 29);
  return fmt::format("{:016x}", hash);
}

}  // namespace

std::string text_hash(const std::string& text) {
  std::uint64_t hash = kHashStart;
  for (const unsigned char byte : text) hash = (hash ^ byte) * kHashFactor;
  return fmt::format("{:016x}", hash);
}

BuildInfo build_info() {
  BuildInfo info;
  info.version = CAGETOL_VERSION;
  info.commit = CAGETOL_COMMIT;
  info.compiler = CAGETOL_COMPILER;
  static const std::string program = program_hash();
  info.program = program;
  info.libraries = fmt::format(R"({{"gsl":"{}","hdf5":"{}","openmpi":"{}.{}.{}","sundials":"{}"}})",
                               gsl_version, hdf5_version(), OMPI_MAJOR_VERSION, OMPI_MINOR_VERSION,
                               OMPI_RELEASE_VERSION, sundials_version());
  return info;
}

std::string build_id(const BuildInfo& info) {
  return fmt::format("cagetol {} commit {} program {} ({})", info.version, info.commit,
                     info.program, info.compiler);
}

}  // namespace cagetol
