// Free-free modes of an elastic body: K phi = omega^2 M phi without supports.
//
// Rigid modes are known exactly and are constructed. The Lanczos iteration works in their
// mass-orthogonal complement on the static response to inertia loads. Sylvester's law of inertia
// shows whether a mode was missed: the number of negative pivots of K - s M is the number of
// eigenvalues below s.
#pragma once

#include <Eigen/Core>

#include "src/cage/solve/elastic_body.hpp"

namespace cagetol {

struct FreeModes {
  Eigen::VectorXd frequency;  ///< elastic modes, ascending [Hz]
  Eigen::MatrixXd shape;      ///< elastic modes, mass-normalised
  Eigen::MatrixXd rigid;      ///< mass-orthonormal
};

/// The lowest `count` elastic modes from an iteration with `vectors` vectors. `rigid`: as for
/// `factor`, mass-orthonormal. Throws UnsolvedCage if the iteration does not converge.
FreeModes lowest_modes(const BodyMatrices& body, const HeldFactor& factor,
                       const Eigen::MatrixXd& rigid, long count, long vectors);

/// The lowest `count` elastic modes of a free body.
FreeModes free_modes(const HexMesh& mesh, const BodyMatrices& body, const HeldFactor& factor,
                     long count);

/// Number of modes, the rigid ones included, below a frequency [Hz].
long modes_below(const BodyMatrices& body, double frequency);

/// How many of the ascending frequencies to keep: `count`, or fewer if that would split a pair.
Eigen::Index whole_pairs(const Eigen::VectorXd& frequency, Eigen::Index count);

}  // namespace cagetol
