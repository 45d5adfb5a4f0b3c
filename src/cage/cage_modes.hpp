// Free-free modes of an elastic body: K phi = omega^2 M phi without supports.
//
// Rigid modes are known exactly and are constructed. The Lanczos iteration works in their
// mass-orthogonal complement, by shift and invert with a negative shift, because a shift of zero is
// singular for a free body. Sylvester's law of inertia shows whether a mode was missed: the number
// of negative pivots of K - s M is the number of eigenvalues below s.
#pragma once

#include <Eigen/Core>

#include "src/cage/elastic_body.hpp"

namespace cagetol {

struct FreeModes {
  Eigen::VectorXd frequency;  ///< elastic modes, ascending [Hz]
  Eigen::MatrixXd shape;      ///< elastic modes, mass-normalised
  RigidMotions rigid;         ///< mass-orthonormal
};

/// The lowest `count` elastic modes. Throws UnsolvedCage if the iteration does not converge.
FreeModes free_modes(const HexMesh& mesh, const BodyMatrices& body, const ShiftedFactor& factor,
                     long count);

/// Number of modes, the rigid ones included, below a frequency [Hz].
long modes_below(const BodyMatrices& body, double frequency);

/// Like free_modes(), and checks with modes_below() that no mode is missing; if one is, the
/// iteration is repeated with more vectors. `count` is reduced by one if it would split a pair.
/// Throws UnsolvedCage if modes are still missing.
FreeModes checked_free_modes(const HexMesh& mesh, const BodyMatrices& body,
                             const ShiftedFactor& factor, long count);

}  // namespace cagetol
