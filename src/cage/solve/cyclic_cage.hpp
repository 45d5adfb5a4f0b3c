// The undeviated cage by its cyclic symmetry: modes and static responses, one harmonic at a time.
//
// All sectors are alike, so displacements of the whole cage are sums over harmonics
// n = 0 ... Z/2 of
//   u_j = Re(e^(i n j a) R_j z),   a = 2 pi / Z
// with one complex field z on a sector; R_j turns by j a about the axis. A sector also equals its
// mirror image P about the middle of the pocket. Any z is z_1 + i z_2 of two fields with
//   P conj(z) = z,
// which are as good as real ones: w = Re z + Im z holds them, and the strain energy of z is that of
// w, since symmetric and antisymmetric fields do not couple. What the harmonic demands of the
// bars' middle planes, about which the cage is symmetric too, is real:
//   axial and radial  w = (cos + sin)(n a / 2) rho   behind the pocket, (cos - sin) rho before it
//   normal            w = (cos - sin)(n a / 2) rho   behind the pocket, (cos + sin) rho before it
// So each harmonic is one real symmetric problem with the unknowns of a sector.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "src/cage/solve/cage_modes.hpp"
#include "src/cage/solve/elastic_body.hpp"

namespace cagetol {

class CyclicCage {
 public:
  /// `mesh`: an undeviated cage. Keeps a reference to it.
  CyclicCage(const CageMesh& mesh, const Material& material);

  /// Mass of the whole cage, lower triangle.
  const SparseMatrix& mass() const { return mass_; }

  /// The lowest elastic modes of the whole cage, whole_pairs() of them, with the modes of a pair at
  /// cos(n j a) and sin(n j a). Throws UnsolvedCage where modes_below() counts others.
  FreeModes modes(long count) const;

  /// Of the whole cage, as free_static_response() gives it.
  Eigen::MatrixXd static_response(const Eigen::MatrixXd& loads) const;

 private:
  /// Problem of one harmonic. Unknowns: those inside the sector, then rho of its middle plane.
  struct Harmonic {
    double angle = 0;              ///< n a
    std::size_t multiplicity = 2;  ///< modes of the whole cage per mode: cosine and sine
    SparseMatrix spread;           ///< w on all points of the sector from the unknowns
    BodyMatrices body;
    Eigen::MatrixXd rigid;
    std::unique_ptr<HeldFactor> factor;
  };
  /// Real and imaginary part of a field on a sector.
  struct Complex {
    Eigen::MatrixXd real, imaginary;
  };

  Harmonic make_harmonic(long n, const BodyMatrices& sector) const;
  /// Loads of the whole cage as those of a harmonic.
  Complex in_harmonic(const Harmonic& harmonic, const Eigen::MatrixXd& loads) const;
  Complex complex_field(const Eigen::MatrixXd& w) const;
  void add_to_cage(const Harmonic& harmonic, const Complex& z, Eigen::Ref<Eigen::MatrixXd> u) const;

  const CageMesh& mesh_;
  std::vector<int> mirror_;
  SparseMatrix mass_;
  std::vector<Harmonic> harmonics_;
};

}  // namespace cagetol
