// Stress at the fillets and bars of a whole cage with its fillets meshed, by CalculiX, against the
// stress of the cage table.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>

#include "src/cage/mesh/hex20.hpp"
#include "src/cage/mesh/strip_stations.hpp"
#include "src/cage/solve/elastic_body.hpp"
#include "src/cage/stress/field_recovery.hpp"
#include "src/cage/table/cage_model.hpp"

namespace cagetol {
namespace {

namespace fs = std::filesystem;
const Material kElasticSteel{206e9, 0.30, 7850};

struct Bearing {
  const char* name;
  CageDimensions cage;
  CageStations stations;
};

Bearing nu205() {
  return {"NU205", {}, {}};
}

/// Brass cage of 14 rollers 11 x 12 mm; the material does not matter to the stress of a force.
Bearing fourteen_rollers() {
  Bearing b{"FourteenRollers", {14, 28e-3, 32.9e-3, 17e-3, 11.2e-3, 12.25e-3}, {}};
  b.stations.bar_x = {-4.8e-3, 0, 4.8e-3};
  b.stations.bar_half = {1.2e-3, 2.4e-3, 1.2e-3};
  b.stations.pitch_radius = 30.25e-3;
  b.stations.end_offset = 4.4e-3;
  b.stations.land_offset = 7.3e-3;
  return b;
}

/// The half x > 0 of a cage as quadratic elements: strips of all bars and their mirror images.
struct HalfCage {
  BarStrip strip;
  std::vector<Eigen::Vector3d> nodes;
  std::vector<std::array<int, 20>> elements;
  std::vector<int> loaded;  ///< node of the half cage at each node of the loaded strip, -1: x < 0
};

HalfCage half_cage(const Bearing& b, double radius, const StripCounts& counts) {
  HalfCage half;
  half.strip = make_bar_strip(counts, radius);
  const Eigen::Matrix3Xd at = strip_nodes(b.cage, {}, half.strip);
  std::map<std::array<long, 3>, int> number;
  for (long j = 0; j < b.cage.pocket_count; ++j)
    for (const double side : {1.0, -1.0}) {
      const Eigen::Matrix3d turn = sector_rotation(b.cage, j);
      std::vector<int> node(half.strip.place.size(), -1);
      for (std::size_t i = 0; i < node.size(); ++i) {
        if (half.strip.place[i][0] < 0) continue;
        Eigen::Vector3d x = at.col(static_cast<Eigen::Index>(i));
        x[2] *= side;
        x = turn * x;
        const std::array<long, 3> key{std::lround(1e8 * x[0]), std::lround(1e8 * x[1]),
                                      std::lround(1e8 * x[2])};
        // Neighbours within rounding of a key's edge.
        int found = -1;
        for (long a = -1; a <= 1; ++a)
          for (long c = -1; c <= 1; ++c)
            for (long d = -1; d <= 1; ++d)
              if (const auto it = number.find({key[0] + a, key[1] + c, key[2] + d});
                  it != number.end())
                found = it->second;
        if (found < 0) {
          found = static_cast<int>(half.nodes.size());
          number[key] = found;
          half.nodes.push_back(x);
        }
        node[i] = found;
      }
      if (j == 0 && side > 0) half.loaded = node;
      // A mirror image swaps the lower and the upper face of an element.
      constexpr int swapped[20] = {4,  5,  6, 7, 0,  1,  2,  3,  12, 13,
                                   14, 15, 8, 9, 10, 11, 16, 17, 18, 19};
      for (const auto& element : half.strip.elements) {
        if (half.strip.place[static_cast<std::size_t>(element[0])][0] < 0) continue;
        std::array<int, 20> here{};
        for (std::size_t a = 0; a < 20; ++a) {
          const auto from = side > 0 ? a : static_cast<std::size_t>(swapped[a]);
          here[a] = node[static_cast<std::size_t>(element[from])];
        }
        half.elements.push_back(here);
      }
    }
  return half;
}

/// Half of a newton on the leading face's middle station, and inertia against it.
Eigen::VectorXd balanced_load(const Bearing& b, const HalfCage& half) {
  const Eigen::Matrix3Xd at = strip_nodes(b.cage, {}, half.strip);
  const Eigen::VectorXd line =
      strip_line_load(b.cage, b.stations, {}, half.strip, at, Eigen::Vector3d::UnitZ(), 1);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(half.nodes.size()));
  for (std::size_t i = 0; i < half.loaded.size(); ++i)
    if (half.loaded[i] >= 0)
      load.segment<3>(3 * half.loaded[i]) = line.segment<3>(3 * static_cast<Eigen::Index>(i));
  // Nodes on the plane of symmetry share their force with the other half.
  for (std::size_t n = 0; n < half.nodes.size(); ++n)
    if (std::abs(half.nodes[n][0]) < 1e-9) load.segment<3>(3 * static_cast<Eigen::Index>(n)) *= 0.5;
  Eigen::MatrixXd motions = Eigen::MatrixXd::Zero(load.size(), 3);
  for (std::size_t n = 0; n < half.nodes.size(); ++n) {
    const auto row = 3 * static_cast<Eigen::Index>(n);
    motions(row + 1, 0) = motions(row + 2, 1) = 1;
    motions(row + 1, 2) = -half.nodes[n][2];
    motions(row + 2, 2) = half.nodes[n][1];
  }
  Eigen::MatrixXd inertia = Eigen::MatrixXd::Zero(load.size(), 3);
  for (const auto& element : half.elements) {
    Hex20Nodes nodes;
    for (std::size_t a = 0; a < 20; ++a)
      nodes.col(static_cast<Eigen::Index>(a)) = half.nodes[static_cast<std::size_t>(element[a])];
    const auto mass = hex20_mass(nodes, kElasticSteel.density);
    for (int a = 0; a < 20; ++a)
      for (int c = 0; c < 20; ++c)
        inertia.middleRows<3>(3 * element[static_cast<std::size_t>(a)]) +=
            mass(a, c) * motions.middleRows<3>(3 * element[static_cast<std::size_t>(c)]);
  }
  const Eigen::Matrix3d gram = motions.transpose() * inertia;
  load -= inertia * gram.inverse() * (motions.transpose() * load);
  return load;
}

/// Von Mises stress at all nodes by CalculiX [Pa].
std::vector<double> calculix_stress(const HalfCage& half, const Eigen::VectorXd& load) {
  const fs::path folder =
      fs::temp_directory_path() / ("cagetol-fillet-" + std::to_string(getpid()));
  fs::create_directories(folder);
  {
    std::ofstream deck(folder / "cage.inp");
    deck.precision(12);
    deck << "*NODE, NSET=NALL\n";
    for (std::size_t n = 0; n < half.nodes.size(); ++n)
      deck << n + 1 << ", " << 1e3 * half.nodes[n][0] << ", " << 1e3 * half.nodes[n][1] << ", "
           << 1e3 * half.nodes[n][2] << "\n";
    deck << "*ELEMENT, TYPE=C3D20, ELSET=EALL\n";
    for (std::size_t e = 0; e < half.elements.size(); ++e) {
      deck << e + 1;
      for (std::size_t a = 0; a < 20; ++a)
        deck << (a == 10 ? ",\n" : ", ") << half.elements[e][a] + 1;
      deck << "\n";
    }
    deck << "*MATERIAL, NAME=STEEL\n*ELASTIC\n206000., 0.3\n*SOLID SECTION, ELSET=EALL, "
            "MATERIAL=STEEL\n*BOUNDARY\n";
    // Symmetry, and three nodes that take the rigid motion: the forces balance.
    std::vector<std::size_t> plane;
    for (std::size_t n = 0; n < half.nodes.size(); ++n)
      if (std::abs(half.nodes[n][0]) < 1e-9) {
        deck << n + 1 << ", 1, 1\n";
        plane.push_back(n);
      }
    const std::size_t far = plane[plane.size() / 2], other = plane[plane.size() / 4];
    const bool steep = std::abs(half.nodes[other][1] - half.nodes[far][1]) >
                       std::abs(half.nodes[other][2] - half.nodes[far][2]);
    deck << far + 1 << ", 2, 3\n" << other + 1 << (steep ? ", 3, 3\n" : ", 2, 2\n");
    deck << "*STEP\n*STATIC\n*CLOAD\n";
    for (Eigen::Index i = 0; i < load.size(); ++i)
      if (load[i] != 0) deck << i / 3 + 1 << ", " << i % 3 + 1 << ", " << load[i] << "\n";
    deck << "*EL FILE\nS\n*END STEP\n";
  }
  const std::string command =
      "cd '" + folder.string() + "' && OMP_NUM_THREADS=1 ccx cage > log 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::vector<double> stress(half.nodes.size(), 0);
  std::ifstream frd(folder / "cage.frd");
  bool inside = false;
  for (std::string line; std::getline(frd, line);) {
    if (line.starts_with(" -4  STRESS")) inside = true;
    if (line.starts_with(" -3")) inside = false;
    if (!inside || !line.starts_with(" -1")) continue;
    const auto node = static_cast<std::size_t>(std::stol(line.substr(3, 10)));
    Eigen::Matrix<double, 6, 1> s;  // the file has xx, yy, zz, xy, yz, zx
    for (std::size_t c = 0; c < 6; ++c)
      s[static_cast<Eigen::Index>(c)] = 1e6 * std::stod(line.substr(13 + 12 * c, 12));
    stress[node - 1] = von_mises(s);
  }
  fs::remove_all(folder);
  return stress;
}

/// Peaks at fillets and at the middle of the bars under a newton at the middle of one.
struct Peaks {
  double fillet = 0, middle = 0;
};

Peaks by_calculix(const Bearing& b, double radius) {
  const HalfCage half =
      half_cage(b, radius, {.half_bar = 6, .half_arc = 5, .ring = 3, .across = 6, .radial = 4});
  const auto stress = calculix_stress(half, balanced_load(b, half));
  Peaks peaks;
  const double x = 0.5 * b.cage.pocket_length - radius, u = 0.5 * b.cage.pocket_width - radius;
  for (std::size_t n = 0; n < half.nodes.size(); ++n) {
    const Eigen::Vector3d& at = half.nodes[n];
    // In the frame of the nearest pocket.
    const double pitch = 2 * std::numbers::pi / static_cast<double>(b.cage.pocket_count);
    double angle = std::atan2(at[2], at[1]);
    angle -= pitch * std::round(angle / pitch);
    const double offset = std::abs(at.tail<2>().norm() * std::sin(angle));
    if (at[0] > x - 1e-9 && offset > u - 1e-9 &&
        std::abs(std::hypot(at[0] - x, offset - u) - radius) < 1e-8)
      peaks.fillet = std::max(peaks.fillet, stress[n]);
    if (std::abs(at[0]) < 1e-9 && std::abs(offset - u - radius) < 1e-8)
      peaks.middle = std::max(peaks.middle, stress[n]);
  }
  return peaks;
}

Peaks by_table(const Bearing& b, double radius) {
  CageDimensions cage = b.cage;
  cage.corner_radius = radius;
  const CageTable table = make_cage_table(cage, kElasticSteel, b.stations);
  const auto sectors = static_cast<std::size_t>(b.cage.pocket_count);
  const CageModel model =
      std::get<CageModel>(make_cage_model(table, std::vector<PocketDeviation>(sectors)));
  Eigen::VectorXd force = Eigen::VectorXd::Zero(b.cage.pocket_count * 2 * model.bar_stations);
  const long station = model.bar_stations + 1;  // middle of the leading face of pocket 0
  force[station] = 1;
  const Eigen::ArrayXd omega = 2 * std::numbers::pi * model.frequency.array();
  const Eigen::VectorXd q =
      (model.contact.row(model.contact_row(0, station, 1)).transpose().array() / omega.square())
          .matrix();
  const Eigen::VectorXd stress = station_stress(model, q, force);
  Peaks peaks;
  for (Eigen::Index i = 0; i < stress.size(); ++i) {
    const SectorPoint& p = table.stress_points[static_cast<std::size_t>(i % model.stress_stations)];
    if (p.fillet >= 0) peaks.fillet = std::max(peaks.fillet, stress[i]);
    if (p.fillet < 0 && p.axial == 0 && std::abs(p.around) == 1)
      peaks.middle = std::max(peaks.middle, stress[i]);
  }
  return peaks;
}

class NightlyFilletStress : public testing::TestWithParam<std::pair<Bearing (*)(), double>> {};

TEST_P(NightlyFilletStress, IsThatOfACalculixModelWithFillets) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1";
  if (std::system("command -v ccx > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "CalculiX (ccx) is not installed";
  const Bearing b = GetParam().first();
  const double radius = GetParam().second;
  const Peaks found = by_table(b, radius), wanted = by_calculix(b, radius);
  std::printf("%s, radius %.1f mm: fillet %.3f MPa/N (CalculiX %.3f), bar's middle %.3f (%.3f)\n",
              b.name, 1e3 * radius, 1e-6 * found.fillet, 1e-6 * wanted.fillet, 1e-6 * found.middle,
              1e-6 * wanted.middle);
  EXPECT_NEAR(found.fillet / wanted.fillet, 1, 0.05);
  EXPECT_NEAR(found.middle / wanted.middle, 1, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Cages, NightlyFilletStress,
                         testing::Values(std::pair{&nu205, 0.3e-3}, std::pair{&nu205, 0.5e-3},
                                         std::pair{&nu205, 1.0e-3},
                                         std::pair{&fourteen_rollers, 0.3e-3},
                                         std::pair{&fourteen_rollers, 0.5e-3},
                                         std::pair{&fourteen_rollers, 1.0e-3}),
                         [](const auto& test) {
                           return std::string(test.param.first().name) + "Radius" +
                                  std::to_string(std::lround(1e6 * test.param.second));
                         });

}  // namespace
}  // namespace cagetol
