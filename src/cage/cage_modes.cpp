#include "src/cage/cage_modes.hpp"

#include <Spectra/SymGEigsShiftSolver.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "src/cage/unsolved_cage.hpp"

namespace cagetol {
namespace {

using ConstMap = Eigen::Map<const Eigen::VectorXd>;
using Map = Eigen::Map<Eigen::VectorXd>;

/// y = (K + s M)^-1 x without its rigid part, which rounding would otherwise let grow, and without
/// modes that are known.
class ElasticInverse {
 public:
  using Scalar = double;
  ElasticInverse(const ShiftedFactor& factor, const RigidMotions& rigid,
                 const RigidMotions& mass_rigid, const Eigen::MatrixXd& known,
                 const Eigen::MatrixXd& mass_known)
      : factor_(&factor),
        rigid_(&rigid),
        mass_rigid_(&mass_rigid),
        known_(&known),
        mass_known_(&mass_known) {}
  Eigen::Index rows() const { return rigid_->rows(); }
  Eigen::Index cols() const { return rigid_->rows(); }
  void set_shift(double) {}  // the factor already carries it
  void perform_op(const double* in, double* out) const {
    Map y(out, rows());
    y = factor_->solve(ConstMap(in, rows()));
    y -= *rigid_ * (mass_rigid_->transpose() * y);
    if (known_->cols() > 0) y -= *known_ * (mass_known_->transpose() * y);
  }

 private:
  const ShiftedFactor* factor_;
  const RigidMotions* rigid_;
  const RigidMotions* mass_rigid_;
  const Eigen::MatrixXd* known_;
  const Eigen::MatrixXd* mass_known_;
};

class MassProduct {
 public:
  using Scalar = double;
  explicit MassProduct(const SparseMatrix& mass) : mass_(&mass) {}
  Eigen::Index rows() const { return mass_->rows(); }
  Eigen::Index cols() const { return mass_->rows(); }
  void perform_op(const double* in, double* out) const {
    Map(out, rows()) = mass_->selfadjointView<Eigen::Lower>() * ConstMap(in, rows());
  }

 private:
  const SparseMatrix* mass_;
};

/// The same rough vector every time, so that results repeat to the last bit; another one for each
/// `number`.
Eigen::VectorXd start_vector(Eigen::Index size, int number) {
  Eigen::VectorXd start(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const double t = std::fmod(static_cast<double>(i + 1) * std::numbers::phi * number, 1.0);
    start[i] = t - 0.5;
  }
  return start;
}

/// Searches for missing modes; two have always been enough.
constexpr int kMostAttempts = 8;

double hertz(double eigenvalue) {
  return std::sqrt(std::max(0.0, eigenvalue)) / (2 * std::numbers::pi);
}

/// The lowest `count` elastic modes beside those that are `known` (mass-normalised columns).
FreeModes lanczos(const HexMesh& mesh, const BodyMatrices& body, const ShiftedFactor& factor,
                  long count, long vectors, const Eigen::MatrixXd& known = {},
                  int start_number = 1) try {
  FreeModes modes;
  modes.rigid = mass_orthonormal(rigid_motions(mesh.nodes), body.mass);
  const RigidMotions mass_rigid = body.mass.selfadjointView<Eigen::Lower>() * modes.rigid;
  const Eigen::MatrixXd mass_known =
      known.cols() > 0 ? Eigen::MatrixXd(body.mass.selfadjointView<Eigen::Lower>() * known) : known;
  ElasticInverse inverse(factor, modes.rigid, mass_rigid, known, mass_known);
  MassProduct product(body.mass);
  Spectra::SymGEigsShiftSolver<ElasticInverse, MassProduct, Spectra::GEigsMode::ShiftInvert> solver(
      inverse, product, count, vectors, -factor.shift());
  Eigen::VectorXd start = start_vector(mass_rigid.rows(), start_number);
  start -= modes.rigid * (mass_rigid.transpose() * start);
  if (known.cols() > 0) start -= known * (mass_known.transpose() * start);
  solver.init(start.data());
  solver.compute(Spectra::SortRule::LargestMagn, 300, 1e-11, Spectra::SortRule::SmallestAlge);
  if (solver.info() != Spectra::CompInfo::Successful) {
    throw UnsolvedCage("the search for its modes does not converge");
  }
  modes.frequency = solver.eigenvalues().unaryExpr(&hertz);
  modes.shape = solver.eigenvectors();
  return modes;
} catch (const UnsolvedCage&) {
  throw;
} catch (const std::logic_error& problem) {  // of Spectra, as the next
  throw UnsolvedCage(std::string("the search for its modes fails: ") + problem.what());
} catch (const std::runtime_error& problem) {
  throw UnsolvedCage(std::string("the search for its modes fails: ") + problem.what());
}

/// Adds modes and sorts all by frequency.
void add_modes(FreeModes& modes, const FreeModes& more) {
  const FreeModes before = modes;
  const Eigen::Index old = before.frequency.size(), all = old + more.frequency.size();
  const auto frequency = [&](Eigen::Index i) {
    return i < old ? before.frequency[i] : more.frequency[i - old];
  };
  std::vector<Eigen::Index> order(static_cast<std::size_t>(all));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return frequency(a) < frequency(b); });
  modes.frequency.resize(all);
  modes.shape.resize(Eigen::NoChange, all);
  for (Eigen::Index i = 0; i < all; ++i) {
    const Eigen::Index from = order[static_cast<std::size_t>(i)];
    modes.frequency[i] = frequency(from);
    modes.shape.col(i) = from < old ? before.shape.col(from) : more.shape.col(from - old);
  }
}

/// Of the lowest `count` modes, those that a gap parts from the next.
Eigen::Index whole_pairs(const FreeModes& modes, Eigen::Index count) {
  while (count > 1 && modes.frequency[count] / modes.frequency[count - 1] - 1 < 1e-6) --count;
  return count;
}

void keep(FreeModes& modes, Eigen::Index count) {
  modes.frequency.conservativeResize(count);
  modes.shape.conservativeResize(Eigen::NoChange, count);
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
  const long wanted = count + 2, unknowns = static_cast<long>(body.mass.rows()) - 6;
  FreeModes modes = lanczos(mesh, body, factor, wanted, std::min<long>(unknowns, 2 * wanted + 20));
  for (int attempt = 1; attempt <= kMostAttempts; ++attempt) {
    const Eigen::Index kept = whole_pairs(modes, count);
    const double between = 0.5 * (modes.frequency[kept - 1] + modes.frequency[kept]);
    const long missing = modes_below(body, between) - 6 - kept;
    if (missing == 0) {
      keep(modes, kept);
      return modes;
    }
    if (missing < 0) break;
    // A cage looks alike from every sector, so modes come in pairs of one frequency. Seen from one
    // start vector a pair is a single mode but for rounding, and where many frequencies lie close
    // together the second one may come too late: it is looked for in what the others leave.
    const long left = unknowns - static_cast<long>(modes.shape.cols());
    if (missing > left) break;
    const long vectors = std::min<long>(left, std::max(2 * missing, missing + 20));
    add_modes(modes, lanczos(mesh, body, factor, missing, vectors, modes.shape, attempt + 1));
  }
  throw UnsolvedCage("the search for its modes leaves some out");
}

}  // namespace cagetol
