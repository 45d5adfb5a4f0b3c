// Probes of cage tables.
#include "src/cage/table/cage_table_bytes.hpp"
#include "tests/support/stored_file_probes.hpp"

namespace cagetol {
namespace {

/// A table of the least size that has the form of one, and damage to it.
bool read_cage_table_probe(std::string_view bytes) {
  CageTable table;
  return read_cage_table_bytes(bytes, table);
}
std::vector<std::string> cage_table_seeds() {
  CageTable table;
  table.turn.sectors = 3;
  table.frequency = Eigen::VectorXd::Constant(2, 1000.0);
  table.family.resize(2);
  table.projection = Eigen::MatrixXd::Ones(2, 3);
  table.stress = Eigen::MatrixXf::Ones(3, 2);
  return {cage_table_bytes(table)};
}

}  // namespace

std::vector<ReaderProbe> cage_table_probes() {
  return {{"cage_table", read_cage_table_probe, cage_table_seeds}};
}

}  // namespace cagetol
