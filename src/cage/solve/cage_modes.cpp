#include "src/cage/solve/cage_modes.hpp"

#include <Spectra/SymGEigsShiftSolver.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "src/cage/solve/unsolved_cage.hpp"

namespace cagetol {
namespace {

using ConstMap = Eigen::Map<const Eigen::VectorXd>;
using Map = Eigen::Map<Eigen::VectorXd>;

/// y = elastic part of the static response to the load x.
class ElasticInverse {
 public:
  using Scalar = double;
  ElasticInverse(const HeldFactor& factor, const Eigen::MatrixXd& rigid,
                 const Eigen::MatrixXd& mass_rigid)
      : factor_(&factor), rigid_(&rigid), mass_rigid_(&mass_rigid) {}
  Eigen::Index rows() const { return rigid_->rows(); }
  Eigen::Index cols() const { return rigid_->rows(); }
  void set_shift(double) {}  // always zero
  void perform_op(const double* in, double* out) const {
    Map y(out, rows());
    // Rounding leaves some imbalance in the load, which the springs would take.
    const ConstMap x(in, rows());
    y = factor_->solve(x - *mass_rigid_ * (rigid_->transpose() * x));
    y -= *rigid_ * (mass_rigid_->transpose() * y);
  }

 private:
  const HeldFactor* factor_;
  const Eigen::MatrixXd* rigid_;
  const Eigen::MatrixXd* mass_rigid_;
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

/// A unit of eigenvalues, a power of 4 [1/s^2]. Spectra measures the convergence of 1 / eigenvalue
/// against at least 4e-11. Of a light or small cage all of them lie below, and half-found modes
/// would count as converged: eigenvalues are counted in a unit of their own magnitude.
double eigenvalue_unit(const ElasticInverse& inverse, const SparseMatrix& mass,
                       const Eigen::VectorXd& start) {
  const Eigen::VectorXd load = mass.selfadjointView<Eigen::Lower>() * start;
  Eigen::VectorXd response(start.size());
  inverse.perform_op(load.data(), response.data());
  return std::exp2(2 * std::floor(0.5 * std::log2(start.dot(load) / response.dot(load))));
}

Eigen::MatrixXd free_motions(const HexMesh& mesh, const SparseMatrix& mass) {
  return mass_orthonormal(rigid_motions(mesh.nodes), mass);
}

}  // namespace

FreeModes lowest_modes(const BodyMatrices& body, const HeldFactor& factor,
                       const Eigen::MatrixXd& rigid, long count, long vectors) try {
  FreeModes modes;
  modes.rigid = rigid;
  const Eigen::MatrixXd mass_rigid = body.mass.selfadjointView<Eigen::Lower>() * rigid;
  vectors = std::min<long>(vectors, body.mass.rows() - rigid.cols());
  ElasticInverse inverse(factor, rigid, mass_rigid);
  Eigen::VectorXd start = start_vector(rigid.rows());
  start -= rigid * (mass_rigid.transpose() * start);
  const double unit = eigenvalue_unit(inverse, body.mass, start);
  MassProduct product(body.mass, unit);
  Spectra::SymGEigsShiftSolver<ElasticInverse, MassProduct, Spectra::GEigsMode::ShiftInvert> solver(
      inverse, product, count, vectors, 0);
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

FreeModes free_modes(const HexMesh& mesh, const BodyMatrices& body, const HeldFactor& factor,
                     long count) {
  return lowest_modes(body, factor, free_motions(mesh, body.mass), count,
                      std::max(2 * count, count + 20));
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

Eigen::Index whole_pairs(const Eigen::VectorXd& frequency, Eigen::Index count) {
  while (count > 1 && frequency[count] / frequency[count - 1] - 1 < 1e-6) --count;
  return count;
}

}  // namespace cagetol
