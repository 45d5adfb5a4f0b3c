// Displacement and stress of the whole deviated cage in states of the per-sample model, by full
// finite elements. Used to check the model's stress stations and to draw the field.
//
//   u = Phi q + (K^+ f - Phi Lambda^-1 Phi^T f)
//
// Phi: modes of the full solution and static modes of the bars; f: forces on the bar stations and
// centrifugal load; K^+: static response with inertia relief. The bracket is the static correction,
// the part of the response to f that the kept modes leave out (mode acceleration). Sign and, within
// a pair, orientation of the full modes are arbitrary; they are combined to match the model's modes
// at the contact points.
#pragma once

#include <Eigen/Core>
#include <variant>
#include <vector>

#include "src/cage/table/cage_model.hpp"

namespace cagetol {

/// States of a cage, one column each.
struct CageStates {
  Eigen::MatrixXd q;          ///< modal coordinates: elastic modes, then those of the bars if any
  Eigen::MatrixXd bar_force;  ///< tangential forces as station_stress takes them [N]
  Eigen::VectorXd spin;       ///< spin of the centrifugal load, 0: none [rad/s]
  bool bar_modes = true;      ///< q has those of the bars
};

struct CageRecovery {
  CageMesh mesh;
  Eigen::MatrixXd displacement;  ///< elastic, cage frame; row 3 n + d, a column per state [m]
};

/// Recovers all states with one full solution.
std::variant<CageRecovery, CageFault> recover_cage(const CageTable& table,
                                                   const std::vector<PocketDeviation>& deviations,
                                                   const CageStates& states);

/// Forces on the bar stations as forces on the nodes of the whole mesh.
Eigen::VectorXd bar_forces_on_nodes(const CageMesh& mesh, const CageStations& stations,
                                    const std::vector<PocketDeviation>& deviations,
                                    const Eigen::VectorXd& bar_forces);

/// Stress of a displacement field at every node, averaged over the adjacent elements: rows xx, yy,
/// zz, xy, yz, zx, one column per node [Pa].
Eigen::Matrix<double, 6, Eigen::Dynamic> stress_everywhere(const HexMesh& mesh,
                                                           const Material& material,
                                                           const Eigen::VectorXd& displacement);

}  // namespace cagetol
