#include "src/cage/table/cage_snapshot.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "src/cage/stress/field_recovery.hpp"

namespace cagetol {
namespace {

constexpr int kHexahedron = 12;  // VTK's number of the cell type

using Values = Eigen::Ref<const Eigen::MatrixXd>;

/// One array: a column of `values` is a tuple.
void write_array(std::string& out, const char* name, const char* attributes, const Values& values) {
  fmt::format_to(std::back_inserter(out),
                 "<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\"{} "
                 "format=\"ascii\">\n",
                 name, values.rows(), attributes);
  for (Eigen::Index n = 0; n < values.cols(); ++n) {
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
      fmt::format_to(std::back_inserter(out), "{:.9g}{}", values(i, n),
                     i + 1 < values.rows() ? ' ' : '\n');
    }
  }
  out += "</DataArray>\n";
}

void write_cells(std::string& out, const std::vector<std::array<int, 8>>& elements) {
  out += "<Cells>\n<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">\n";
  for (const auto& corners : elements) {
    for (int corner : corners) out += std::to_string(corner) + " ";
    out += "\n";
  }
  out += "</DataArray>\n<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">\n";
  for (std::size_t e = 1; e <= elements.size(); ++e) out += std::to_string(8 * e) + "\n";
  out += "</DataArray>\n<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">\n";
  for (std::size_t e = 0; e < elements.size(); ++e) out += std::to_string(kHexahedron) + "\n";
  out += "</DataArray>\n</Cells>\n";
}

}  // namespace

std::optional<CageFault> write_cage_snapshot(const std::filesystem::path& file,
                                             const CageTable& table,
                                             const std::vector<PocketDeviation>& deviations,
                                             const CageStates& state) {
  const auto recovered = recover_cage(table, deviations, state);
  if (const auto* fault = std::get_if<CageFault>(&recovered)) return *fault;
  const auto& [cage, displacement] = std::get<CageRecovery>(recovered);
  const HexMesh& mesh = cage.mesh;
  const auto stress = stress_everywhere(mesh, table.material, displacement.col(0));
  Eigen::RowVectorXd equivalent(stress.cols());
  for (Eigen::Index n = 0; n < stress.cols(); ++n) equivalent[n] = von_mises(stress.col(n));

  std::string out = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" "
      "NumberOfCells=\"{}\">\n<Points>\n",
      mesh.nodes.cols(), mesh.elements.size());
  write_array(out, "position", "", mesh.nodes);
  out += "</Points>\n";
  write_cells(out, mesh.elements);
  out += "<PointData Vectors=\"displacement\" Scalars=\"von_mises\">\n";
  write_array(out, "displacement", "", displacement.col(0).reshaped(3, mesh.nodes.cols()));
  write_array(out, "von_mises", "", equivalent);
  write_array(out, "stress",
              " ComponentName0=\"xx\" ComponentName1=\"yy\" ComponentName2=\"zz\" "
              "ComponentName3=\"xy\" ComponentName4=\"yz\" ComponentName5=\"zx\"",
              stress);
  out += "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  errno = 0;
  std::ofstream stream(file, std::ios::binary);
  stream << out;
  stream.close();
  if (!stream) {
    throw std::runtime_error("cannot write " + file.string() + ": " + std::strerror(errno));
  }
  return std::nullopt;
}

}  // namespace cagetol
