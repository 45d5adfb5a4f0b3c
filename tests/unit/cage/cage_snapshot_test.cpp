#include "src/cage/table/cage_snapshot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "src/cage/stress/field_recovery.hpp"
#include "src/cage/table/cage_model.hpp"
#include "src/cage/table/cage_recovery.hpp"
#include "tests/support/flexible_cage.hpp"
#include "tests/support/process.hpp"

namespace cagetol {
namespace {

/// Reads the file with Python's own XML parser and prints counts, and per array its number of
/// values and largest magnitude.
constexpr const char* kReader = R"(
import sys, xml.etree.ElementTree as xml
root = xml.parse(sys.argv[1]).getroot()
piece = root.find('UnstructuredGrid/Piece')
points, cells = int(piece.get('NumberOfPoints')), int(piece.get('NumberOfCells'))
print(root.get('type'), points, cells)
for array in piece.iter('DataArray'):
    values = [float(v) for v in array.text.split()]
    print(array.get('Name'), len(values), repr(max(abs(v) for v in values)))
)";

TEST(CageSnapshot, IsXmlThatHoldsMeshDisplacementAndStress) {
  const CageTable& table = test::coarse_table();
  const auto deviations = test::scattered_pockets(2);
  Eigen::VectorXd q = Eigen::VectorXd::Zero(20);
  q[0] = 1e-6;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(13 * 6);
  forces[6 * 3 + 4] = 25;
  const CageStates state{q, forces, Eigen::VectorXd::Constant(1, 250)};  // 7 elastic modes
  const ScratchDirectory scratch;
  const std::string file = scratch / "cage.vtu";
  ASSERT_FALSE(write_cage_snapshot(file, table, deviations, state));
  std::ofstream(scratch / "read.py") << kReader;
  Process reader({"/usr/bin/python3", scratch / "read.py", file});
  ASSERT_EQ(reader.wait(), 0) << reader.output();

  const auto recovered = recover_cage(table, deviations, state);
  const auto& [cage, displacement] = std::get<CageRecovery>(recovered);
  const auto stress = stress_everywhere(cage.mesh, table.material, displacement.col(0));
  double largest = 0;
  for (Eigen::Index n = 0; n < stress.cols(); ++n)
    largest = std::max(largest, von_mises(stress.col(n)));
  const auto points = cage.mesh.nodes.cols();
  const auto cells = static_cast<Eigen::Index>(cage.mesh.elements.size());
  std::istringstream lines(reader.output());
  std::string name;
  Eigen::Index count = 0;
  double value = 0;
  ASSERT_TRUE(lines >> name >> count >> value);
  EXPECT_EQ(name, "UnstructuredGrid");
  EXPECT_EQ(count, points);
  EXPECT_EQ(value, static_cast<double>(cells));
  const auto expect = [&](const char* what, Eigen::Index values, double magnitude) {
    ASSERT_TRUE(lines >> name >> count >> value) << what;
    EXPECT_EQ(name, what);
    EXPECT_EQ(count, values);
    EXPECT_NEAR(value, magnitude, 1e-8 * magnitude) << what;
  };
  expect("position", 3 * points, cage.mesh.nodes.cwiseAbs().maxCoeff());
  expect("connectivity", 8 * cells, static_cast<double>(points - 1));
  expect("offsets", cells, static_cast<double>(8 * cells));
  expect("types", cells, 12);
  expect("displacement", 3 * points, displacement.cwiseAbs().maxCoeff());
  expect("von_mises", points, largest);
  expect("stress", 6 * points, stress.cwiseAbs().maxCoeff());
  EXPECT_GT(largest, 1e6);
}

TEST(CageSnapshot, SaysWhatIsWrong) {
  const CageTable& table = test::coarse_table();
  std::vector<PocketDeviation> deviations(13);
  const CageStates state{Eigen::VectorXd::Zero(4), Eigen::VectorXd::Zero(13 * 6),
                         Eigen::VectorXd::Zero(1), false};
  EXPECT_THAT([&] { write_cage_snapshot("/no/such/folder/a.vtu", table, deviations, state); },
              testing::ThrowsMessage<std::runtime_error>(
                  testing::HasSubstr("cannot write /no/such/folder/a.vtu: No such file")));
  deviations[8].length = 6e-3;
  const auto fault = write_cage_snapshot("/dev/null", table, deviations, state);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->pocket, 8);
}

}  // namespace
}  // namespace cagetol
