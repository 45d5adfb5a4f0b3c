// Linearly implicit (Rosenbrock) methods with a current Jacobian and error control: no nonlinear
// iteration, so a contact that opens or closes inside a step costs a smaller step and never a
// failed Newton.
#pragma once

#include "src/integration/integrator.hpp"
#include "src/newton/newton_matrix.hpp"

namespace cagetol {

/// Coefficients in the transformed variables U of Hairer & Wanner II, eq. (IV.7.25):
///   (1/(gamma h) - J) U_i
///       = f(t + alpha_i h, y + sum_j a_ij U_j) + sum_j (c_ij/h) U_j + gamma_i h f_t
///   y_new = y + sum_i m_i U_i
/// The methods here are stiffly accurate: the last stage's argument is the solution of lower order
/// that the error is told by, so that the last stage is the error's estimate.
struct RosenbrockTable {
  static constexpr int kMaxStages = 6;
  int stages;
  double gamma;
  double error_order;  ///< the error estimate behaves like h^error_order
  double a[kMaxStages][kMaxStages], c[kMaxStages][kMaxStages];
  double alpha[kMaxStages], gamma_sum[kMaxStages], m[kMaxStages];
  bool new_rates[kMaxStages];  ///< stage evaluates the rates anew (else it uses those of the stage
                               ///< before)
};

/// RODAS3: 4 stages, order 3(2), L-stable, stiffly accurate. Sandu et al. 1997
/// (doi 10.1016/S1352-2310(97)83212-8).
extern const RosenbrockTable kRodas3;

/// RODASP: 6 stages, order 4(3), L-stable, stiffly accurate, and of order 3 on Prothero and
/// Robinson's stiff equation. Steinebach, Order reduction of ROW-methods for DAEs and method of
/// lines applications, TH Darmstadt preprint 1741 (1995); coefficients as in Hairer and Wanner's
/// code RODAS.
extern const RosenbrockTable kRodasP;

class Rosenbrock : public Integrator {
 public:
  Rosenbrock(const RosenbrockTable& table, const Integration& keys, const System& system);
  StepStatus step(System& system, double& t, double* y, double t_end) override;

 private:
  /// to = from + factor times the weighted sum of the first `stages` stages. `to` may be `from`.
  void combine(const double* from, const double* weights, double factor, int stages,
               double* to) const;

  /// to = y + the weighted sum of the first `stages` stages; from the last argument where that is
  /// all of the sum but its last term, as in stiffly accurate methods.
  void advance(const double* y, const double* weights, int stages, double* to);

  const RosenbrockTable& table_;
  Integration keys_;
  NewtonMatrix newton_;
  double next_step_;
  double last_log_error_ = 0;
  int stalled_ = 0;  ///< steps in a row shorter than kStepControl.stalled
  std::vector<PackVector> stage_;
  PackVector rates_, argument_, time_rates_;
};

}  // namespace cagetol
