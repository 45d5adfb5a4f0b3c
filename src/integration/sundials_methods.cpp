#include "src/integration/sundials_methods.hpp"

#include <arkode/arkode_arkstep.h>
#include <cvode/cvode.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_context.hpp>

#include <algorithm>
#include <stdexcept>

#include "src/integration/state_vector.hpp"
#include "src/integration/step_control.hpp"
#include "src/newton/newton_matrix.hpp"

namespace cagetol {
namespace {

/// What the C callbacks reach: evaluations are counted in the run's system, derivatives kept apart
/// from what the run observes.
struct Problem {
  Problem(const Integration& k, const System& s)
      : keys(k),
        linear(s.model.layout),
        seen(s.model),
        newton(s.model),
        scaled(static_cast<std::size_t>(s.size)),
        rate(static_cast<std::size_t>(s.size)) {}
  Integration keys;
  System* system = nullptr;
  Linearisation linear;
  Observation seen;
  NewtonMatrix newton;
  PackVector scaled, rate;
  double gamma = 0;
};

int rates(double t, N_Vector y, N_Vector rate, void* user) {
  auto& problem = *static_cast<Problem*>(user);
  return problem.system->rates(t, NV_DATA_S(y), NV_DATA_S(rate))
             ? 0
             : 1;  // 1: recoverable, the step is cut
}

int error_weights(N_Vector y, N_Vector weights, void* user) {
  auto& problem = *static_cast<Problem*>(user);
  (void)y;
  for (int i = 0; i < problem.system->size; ++i)
    NV_Ith_S(weights, i) =
        1 / (problem.keys.tolerance * problem.system->scale[static_cast<std::size_t>(i)]);
  return 0;
}

/// Prepares I - gamma J.
int linear_system(double t, N_Vector y, N_Vector, SUNMatrix, booleantype keep_jacobian,
                  booleantype* new_jacobian, double gamma, void* user, N_Vector, N_Vector,
                  N_Vector) {
  auto& problem = *static_cast<Problem*>(user);
  if (!keep_jacobian) {
    ++problem.system->counts.jacobians;
    linearise(problem.system->model, t, NV_DATA_S(y), problem.rate.data(), problem.linear,
              problem.seen);
  }
  *new_jacobian = !keep_jacobian;
  problem.gamma = gamma;
  ++problem.system->counts.factorisations;
  return problem.newton.factor(problem.linear, gamma) ? 0 : 1;
}

int linear_system_with_mass(double t, N_Vector y, N_Vector rate, SUNMatrix matrix, SUNMatrix,
                            booleantype keep_jacobian, booleantype* new_jacobian, double gamma,
                            void* user, N_Vector a, N_Vector b, N_Vector c) {
  return linear_system(t, y, rate, matrix, keep_jacobian, new_jacobian, gamma, user, a, b, c);
}

/// Solves (I - gamma J) x = b, that is (1/gamma - J) x = b/gamma.
int solve(SUNLinearSolver solver, SUNMatrix, N_Vector x, N_Vector b, double) {
  auto& problem = *static_cast<Problem*>(solver->content);
  for (std::size_t i = 0; i < problem.scaled.size(); ++i)
    problem.scaled[i] = NV_Ith_S(b, i) / problem.gamma;
  problem.newton.solve(problem.scaled.data(), NV_DATA_S(x));
  return 0;
}

SUNLinearSolver_Type direct(SUNLinearSolver) {
  return SUNLINEARSOLVER_DIRECT;
}
int nothing(SUNLinearSolver) {
  return 0;
}
int set_up(SUNLinearSolver, SUNMatrix) {
  return 0;
}  // linear_system has factored already
SUNMatrix_ID custom(SUNMatrix) {
  return SUNMATRIX_CUSTOM;
}

/// Owns the SUNDIALS objects of one run.
struct Handles {
  Handles(Problem& problem, int size, const double* y0) : vector(make_state_vector(size, context)) {
    std::copy(y0, y0 + size, NV_DATA_S(vector));
    matrix = SUNMatNewEmpty(context);
    matrix->ops->getid = custom;
    solver = SUNLinSolNewEmpty(context);
    solver->content = &problem;
    solver->ops->gettype = direct;
    solver->ops->initialize = nothing;
    solver->ops->setup = set_up;
    solver->ops->solve = solve;
  }
  ~Handles() {
    SUNLinSolFreeEmpty(solver);
    SUNMatFreeEmpty(matrix);
    N_VDestroy(vector);
  }
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;

  sundials::Context context;
  N_Vector vector;
  SUNMatrix matrix;
  SUNLinearSolver solver;
};

void require(int flag, const char* what) {
  if (flag != 0)
    throw std::runtime_error(std::string("SUNDIALS refused ") + what + " (flag " +
                             std::to_string(flag) + ")");
}

/// The calls that CVODE and ARKODE have in common but for their names.
struct Library {
  const char* name;
  int (*set_problem)(void*, void*);
  int (*set_error_weights)(void*, int (*)(N_Vector, N_Vector, void*));
  int (*set_linear_solver)(void*, SUNLinearSolver, SUNMatrix);
  int (*set_max_step)(void*, double);
  int (*set_first_step)(void*, double);
  int (*set_error_file)(void*, FILE*);
  int (*advance)(void*, double, N_Vector, double*, int one_step);
  int (*interpolate)(void*, double, int derivative, N_Vector);
  int (*error_fails)(void*, long*);
  int (*nonlinear_fails)(void*, long*);
  char* (*flag_name)(long);
  void (*destroy)(void**);
};

constexpr Library kCvode = {"CVODE",
                            CVodeSetUserData,
                            CVodeWFtolerances,
                            CVodeSetLinearSolver,
                            CVodeSetMaxStep,
                            CVodeSetInitStep,
                            CVodeSetErrFile,
                            CVode,
                            CVodeGetDky,
                            CVodeGetNumErrTestFails,
                            CVodeGetNumNonlinSolvConvFails,
                            CVodeGetReturnFlagName,
                            CVodeFree};
constexpr Library kArkode = {"ARKODE",
                             ARKStepSetUserData,
                             ARKStepWFtolerances,
                             ARKStepSetLinearSolver,
                             ARKStepSetMaxStep,
                             ARKStepSetInitStep,
                             ARKStepSetErrFile,
                             ARKStepEvolve,
                             ARKStepGetDky,
                             ARKStepGetNumErrTestFails,
                             ARKStepGetNumNonlinSolvConvFails,
                             ARKStepGetReturnFlagName,
                             ARKStepFree};

/// One-step mode with interpolation: the solver may run ahead of t_end; the state is then
/// interpolated there.
class SundialsIntegrator : public Integrator {
 public:
  SundialsIntegrator(const Library& library, const Integration& keys, const System& system,
                     double t0, const double* y0)
      : library_(library),
        problem_(keys, system),
        handles_(problem_, system.size, y0),
        reached_(t0) {}
  ~SundialsIntegrator() override { library_.destroy(&memory_); }

  const Handles& handles() const { return handles_; }

  /// Takes over the solver's memory; an `implicit` one solves with our Newton matrix.
  void adopt(void* memory, bool implicit) {
    memory_ = memory;
    require(library_.set_problem(memory_, &problem_), "the problem");
    require(library_.set_error_weights(memory_, error_weights), "the error weights");
    if (implicit)
      require(library_.set_linear_solver(memory_, handles_.solver, handles_.matrix),
              "the linear solver");
    require(library_.set_max_step(memory_, problem_.keys.max_step), "the maximum step");
    require(library_.set_first_step(memory_, kStepControl.first_step), "the first step");
    require(library_.set_error_file(memory_, nullptr), "silence");
  }

  StepStatus step(System& system, double& t, double* y, double t_end) override {
    problem_.system = &system;
    const double before = t;
    if (reached_ <= t) {
      if (system.counts.steps + system.counts.rejected >= system.step_budget)
        return StepStatus::out_of_budget;
      const long fails_before = fails();
      // CV_ONE_STEP and ARK_ONE_STEP are the same number.
      const int flag = library_.advance(memory_, t_end, handles_.vector, &reached_, CV_ONE_STEP);
      system.counts.rejected += fails() - fails_before;
      if (flag < 0) {
        failure_ = failure_text(flag) + " at t = " + std::to_string(t) + " s";
        return StepStatus::failed;
      }
      ++system.counts.steps;
    }
    if (reached_ > t_end) {
      interpolate(t_end);
      t = t_end;
    } else {
      t = reached_;
      if (interpolated_) interpolate(reached_);
    }
    std::copy(NV_DATA_S(handles_.vector), NV_DATA_S(handles_.vector) + system.size, y);
    interpolated_ = reached_ > t_end;
    if (t > before) system.counts.smallest_step = std::min(system.counts.smallest_step, t - before);
    return StepStatus::accepted;
  }

 private:
  void interpolate(double t) { library_.interpolate(memory_, t, 0, handles_.vector); }
  long fails() const {
    long errors = 0, nonlinear = 0;
    library_.error_fails(memory_, &errors);
    library_.nonlinear_fails(memory_, &nonlinear);
    return errors + nonlinear;
  }
  std::string failure_text(int flag) const {
    char* name = library_.flag_name(flag);
    std::string text = std::string(library_.name) + ": " + name;
    std::free(name);
    return text;
  }

  const Library& library_;
  Problem problem_;
  Handles handles_;
  void* memory_ = nullptr;
  double reached_;
  bool interpolated_ = false;
};
static_assert(int{CV_ONE_STEP} == int{ARK_ONE_STEP});

}  // namespace

std::unique_ptr<Integrator> make_cvode_bdf(const Integration& keys, const System& system, double t0,
                                           const double* y0) {
  auto method = std::make_unique<SundialsIntegrator>(kCvode, keys, system, t0, y0);
  void* memory = CVodeCreate(CV_BDF, method->handles().context);
  require(CVodeInit(memory, rates, t0, method->handles().vector), "CVodeInit");
  method->adopt(memory, true);
  require(CVodeSetLinSysFn(memory, linear_system), "the linear system");
  require(CVodeSetMaxOrd(memory, static_cast<int>(keys.max_order)), "the maximum order");
  return method;
}

std::unique_ptr<Integrator> make_arkode(bool implicit, const Integration& keys,
                                        const System& system, double t0, const double* y0) {
  auto method = std::make_unique<SundialsIntegrator>(kArkode, keys, system, t0, y0);
  const Handles& handles = method->handles();
  void* memory = ARKStepCreate(implicit ? nullptr : rates, implicit ? rates : nullptr, t0,
                               handles.vector, handles.context);
  method->adopt(memory, implicit);
  if (implicit) require(ARKStepSetLinSysFn(memory, linear_system_with_mass), "the linear system");
  require(ARKStepSetOrder(memory, 3), "order 3");
  return method;
}

}  // namespace cagetol
