// The whole deviated cage in states of the per-sample model, by full finite elements: what the
// model's stations are held against, and what a snapshot shows.
//
//   u = Phi q + (K^+ f - Phi Lambda^-1 Phi^T f)
//
// Phi the modes of the full solve, f the forces on the bar stations and the centrifugal load, K^+
// the static response with inertia relief; the bracket is the static correction, what the kept
// modes leave out of the response to f (mode acceleration). The modes of the full solve come in any
// sign and any mixture of a pair; they are combined so that they move the contact points as the
// model's do.
#pragma once

#include <Eigen/Core>
#include <variant>
#include <vector>

#include "src/cage/cage_model.hpp"

namespace cagetol {

/// States of a cage, a column each.
struct CageStates {
  Eigen::MatrixXd q;          ///< modal coordinates of make_cage_model with as many modes as rows
  Eigen::MatrixXd bar_force;  ///< tangential forces as station_stress takes them [N]
  Eigen::VectorXd spin;       ///< whose centrifugal load acts, 0: none [rad/s]
};

struct CageRecovery {
  CageMesh mesh;
  Eigen::MatrixXd displacement;  ///< elastic, cage frame; row 3 n + d, a column per state [m]
};

/// Recovers states; one full solve for all.
std::variant<CageRecovery, CageFault> recover_cage(const CageTable& table,
                                                   const std::vector<PocketDeviation>& deviations,
                                                   const CageStates& states);

/// Forces on the bar stations as forces on the nodes of the whole mesh.
Eigen::VectorXd bar_forces_on_nodes(const CageMesh& mesh, const CageStations& stations,
                                    const std::vector<PocketDeviation>& deviations,
                                    const Eigen::VectorXd& bar_forces);

/// Stress of a displacement field at every node, averaged over the elements that meet there: rows
/// xx, yy, zz, xy, yz, zx, one column per node [Pa].
Eigen::Matrix<double, 6, Eigen::Dynamic> stress_everywhere(const HexMesh& mesh,
                                                           const Material& material,
                                                           const Eigen::VectorXd& displacement);

/// Largest von Mises stress of a state both ways [Pa].
struct PeakStress {
  double stations = 0;  ///< station_stress of the per-sample model
  double full = 0;      ///< over all nodes of the full recovery
  int node = -1;        ///< where in the mesh the full recovery has it
};
/// One entry per state.
std::variant<std::vector<PeakStress>, CageFault> compare_peak_stress(
    const CageTable& table, const std::vector<PocketDeviation>& deviations,
    const CageStates& states);

}  // namespace cagetol
