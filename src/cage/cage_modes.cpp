#include "src/cage/cage_modes.hpp"

#include <Spectra/SymGEigsShiftSolver.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "src/cage/unsolved_cage.hpp"

namespace cagetol {
namespace {

using ConstMap = Eigen::Map<const Eigen::VectorXd>;
using Map = Eigen::Map<Eigen::VectorXd>;

constexpr double kLargestShift = 1e8;  // [1/s^2]

/// y = (K + s M)^-1 x without its rigid part, which rounding would otherwise let grow.
class ElasticInverse {
 public:
  using Scalar = double;
  ElasticInverse(const ShiftedFactor& factor, const RigidMotions& rigid,
                 const RigidMotions& mass_rigid)
      : factor_(&factor), rigid_(&rigid), mass_rigid_(&mass_rigid) {}
  Eigen::Index rows() const { return rigid_->rows(); }
  Eigen::Index cols() const { return rigid_->rows(); }
  void set_shift(double) {}  // the factor already carries it
  void perform_op(const double* in, double* out) const {
    Map y(out, rows());
    y = factor_->solve(ConstMap(in, rows()));
    y -= *rigid_ * (mass_rigid_->transpose() * y);
  }

 private:
  const ShiftedFactor* factor_;
  const RigidMotions* rigid_;
  const RigidMotions* mass_rigid_;
};

class MassProduct {
 public:
  using Scalar = double;
  MassProduct(const SparseMatrix& mass, double unit) : mass_(&mass), unit_(unit) {}
  Eigen::Index rows() const { return mass_->rows(); }
  Eigen::Index cols() const { return mass_->rows(); }
  void perform_op(const double* in, double* out) const {
    Map(out, rows()) = mass_->selfadjointView<Eigen::Lower>() * ConstMap(in, rows());
    if (unit_ != 1) Map(out, rows()) *= unit_;
  }

 private:
  const SparseMatrix* mass_;
  double unit_;
};

/// A unit of eigenvalues, a power of 4 [1/s^2]. Spectra measures the convergence of 1 / (eigenvalue
/// + shift) against at least 4e-11. Of a light or small cage all of them lie below, and half-found
/// modes would count as converged: larger eigenvalues are counted in a unit that brings the shift
/// down to where steel cages of bearings have it.
double eigenvalue_unit(double shift) {
  double unit = 1;
  while (shift / unit > kLargestShift) unit *= 4;
  return unit;
}

/// The same rough vector every time, so that results repeat to the last bit.
Eigen::VectorXd start_vector(Eigen::Index size) {
  Eigen::VectorXd start(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const double t = std::fmod(static_cast<double>(i + 1) * std::numbers::phi, 1.0);
    start[i] = t - 0.5;
  }
  return start;
}

double hertz(double eigenvalue) {
  return std::sqrt(std::max(0.0, eigenvalue)) / (2 * std::numbers::pi);
}

FreeModes lanczos(const HexMesh& mesh, const BodyMatrices& body, const ShiftedFactor& factor,
                  long count, long vectors) try {
  FreeModes modes;
  modes.rigid = mass_orthonormal(rigid_motions(mesh.nodes), body.mass);
  const RigidMotions mass_rigid = body.mass.selfadjointView<Eigen::Lower>() * modes.rigid;
  ElasticInverse inverse(factor, modes.rigid, mass_rigid);
  const double unit = eigenvalue_unit(factor.shift());
  MassProduct product(body.mass, unit);
  Spectra::SymGEigsShiftSolver<ElasticInverse, MassProduct, Spectra::GEigsMode::ShiftInvert> solver(
      inverse, product, count, vectors, -factor.shift() / unit);
  Eigen::VectorXd start = start_vector(mass_rigid.rows());
  start -= modes.rigid * (mass_rigid.transpose() * start);
  solver.init(start.data());
  solver.compute(Spectra::SortRule::LargestMagn, 300, 1e-11, Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful) {
    throw UnsolvedCage("the search for its modes does not converge");
  }
  modes.frequency = (unit * solver.eigenvalues()).unaryExpr(&hertz);
  modes.shape = std::sqrt(unit) * solver.eigenvectors();
  return modes;
} catch (const std::logic_error& problem) {  // of Spectra
  throw UnsolvedCage(std::string("the search for its modes fails: ") + problem.what());
} catch (const UnsolvedCage&) {
  throw;
} catch (const std::runtime_error& problem) {  // of Spectra, too
  throw UnsolvedCage(std::string("the search for its modes fails: ") + problem.what());
}

void keep(FreeModes& modes, Eigen::Index count) {
  modes.frequency = modes.frequency.head(count).eval();
  modes.shape = modes.shape.leftCols(count).eval();
}

}  // namespace

FreeModes free_modes(const HexMesh& mesh, const BodyMatrices& body, const ShiftedFactor& factor,
                     long count) {
  const long vectors = std::min<long>(body.mass.rows() - 6, std::max(2 * count, count + 20));
  return lanczos(mesh, body, factor, count, vectors);
}

long modes_below(const BodyMatrices& body, double frequency) {
  const double omega = 2 * std::numbers::pi * frequency;
  const SparseMatrix shifted = body.stiffness - omega * omega * body.mass;
  Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower> factor(shifted);
  if (factor.info() != Eigen::Success) {
    throw UnsolvedCage("its modes cannot be counted (a pivot is zero)");
  }
  return (factor.vectorD().array() < 0).count();
}

FreeModes checked_free_modes(const HexMesh& mesh, const BodyMatrices& body,
                             const ShiftedFactor& factor, long count) {
  // Two modes more than asked for, so that a gap to count below and a split pair can be seen.
  const long wanted = count + 2;
  for (long attempt = 1; attempt <= 4; ++attempt) {
    const long vectors = std::min<long>(body.mass.rows() - 6, (attempt + 1) * wanted + 20);
    FreeModes modes = lanczos(mesh, body, factor, wanted, vectors);
    const auto gap = [&](Eigen::Index i) {
      return modes.frequency[i] / modes.frequency[i - 1] - 1;
    };
    Eigen::Index kept = count;
    while (kept > 1 && gap(kept) < 1e-6) --kept;
    const double between = 0.5 * (modes.frequency[kept - 1] + modes.frequency[kept]);
    if (modes_below(body, between) == kept + 6) {
      keep(modes, kept);
      return modes;
    }
  }
  throw UnsolvedCage("the search for its modes leaves some out");
}

}  // namespace cagetol
