#include "mc/host/build_info.hpp"

#include <fmt/format.h>
#include <gsl/gsl_version.h>
#include <hdf5.h>
#include <mpi.h>
#include <sundials/sundials_version.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <sstream>

#include "cagetol_build.hpp"

namespace cagetol {
namespace {

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

std::string program_hash() {
  std::ifstream file("/proc/self/exe", std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return text_hash(bytes.str());
}

}  // namespace

std::string text_hash(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const unsigned char byte : text) hash = (hash ^ byte) * 0x100000001b3u;
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
