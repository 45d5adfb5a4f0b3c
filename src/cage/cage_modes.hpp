// Free-free modes of an elastic body: K phi = omega^2 M phi without supports.
//
// Rigid modes are not computed but constructed (they are exact); the Lanczos iteration works in
// their mass-orthogonal complement. Shift-invert with a negative shift, since a zero shift on a
// free body is singular. Whether a mode was missed is settled by Sylvester's law of inertia: the
// number of negative pivots of K - s M is the number of eigenvalues below s.
#pragma once

#include <Eigen/Core>

#include "src/cage/elastic_body.hpp"

namespace cagetol {

struct FreeModes {
  Eigen::VectorXd frequency;  ///< elastic modes, rising [Hz]
  Eigen::MatrixXd shape;      ///< elastic modes, mass-normalised
  RigidMotions rigid;         ///< mass-orthonormal
};

/// The lowest `count` elastic modes. Throws UnsolvedCage where the iteration does not converge.
FreeModes free_modes(const HexMesh& mesh, const BodyMatrices& body, const ShiftedFactor& factor,
                     long count);

/// Number of modes, the rigid ones included, below a frequency [Hz].
long modes_below(const BodyMatrices& body, double frequency);

/// As `free_modes`, and checks by `modes_below` that none is missing: repeats with more vectors if
/// so. Pairs are kept together: `count` is lowered by one where it would split a pair. Throws
/// UnsolvedCage where modes stay missing.
FreeModes checked_free_modes(const HexMesh& mesh, const BodyMatrices& body,
                             const ShiftedFactor& factor, long count);

}  // namespace cagetol
