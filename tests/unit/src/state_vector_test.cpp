// The vector operations handed to SUNDIALS: right, inherited by clones, and cheap enough that a
// step's own bookkeeping does not matter beside the physics.
#include <cvode/cvode.h>
#include <gtest/gtest.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <sundials/sundials_context.hpp>
#include <vector>

#include "src/integration/state_vector.hpp"
#include "tests/support/sanitizers.hpp"

namespace cagetol {
namespace {

constexpr int kSize = 19;  // no multiple of a SIMD width

class StateVector : public testing::Test {
 protected:
  StateVector() {
    for (int i = 0; i < kSize; ++i) {
      NV_Ith_S(x_, i) = std::sin(1.0 + i);
      NV_Ith_S(y_, i) = 2 + std::cos(0.7 * i);
    }
  }
  ~StateVector() override {
    for (N_Vector v : {x_, y_, z_}) N_VDestroy(v);
  }
  template <class Function>
  void expect_z(const Function& f) {
    for (int i = 0; i < kSize; ++i)
      EXPECT_DOUBLE_EQ(NV_Ith_S(z_, i), f(NV_Ith_S(x_, i), NV_Ith_S(y_, i))) << i;
  }

  sundials::Context context_;
  N_Vector x_ = make_state_vector(kSize, context_);
  N_Vector y_ = N_VClone(x_), z_ = N_VClone(x_);
};

TEST_F(StateVector, ElementwiseOperations) {
  N_VLinearSum(2, x_, -3, y_, z_);
  expect_z([](double x, double y) { return 2 * x - 3 * y; });
  N_VConst(1.5, z_);
  expect_z([](double, double) { return 1.5; });
  N_VProd(x_, y_, z_);
  expect_z([](double x, double y) { return x * y; });
  N_VDiv(x_, y_, z_);
  expect_z([](double x, double y) { return x / y; });
  N_VScale(-4, x_, z_);
  expect_z([](double x, double) { return -4 * x; });
  N_VAbs(x_, z_);
  expect_z([](double x, double) { return std::abs(x); });
  N_VInv(y_, z_);
  expect_z([](double, double y) { return 1 / y; });
  N_VAddConst(x_, 0.25, z_);
  expect_z([](double x, double) { return x + 0.25; });
}

TEST_F(StateVector, SumsAndExtremes) {
  double dot = 0, squares = 0, largest = 0, smallest = 1e300;
  for (int i = 0; i < kSize; ++i) {
    const double x = NV_Ith_S(x_, i), y = NV_Ith_S(y_, i);
    dot += x * y;
    squares += x * y * x * y;
    largest = std::max(largest, std::abs(x));
    smallest = std::min(smallest, x);
  }
  EXPECT_NEAR(N_VDotProd(x_, y_), dot, 1e-14);
  EXPECT_NEAR(N_VWrmsNorm(x_, y_), std::sqrt(squares / kSize), 1e-14);
  EXPECT_EQ(N_VMaxNorm(x_), largest);
  EXPECT_EQ(N_VMin(x_), smallest);
}

TEST_F(StateVector, SeveralVectorsAtOnceAndInPlace) {
  double c[] = {2, -1, 0.5};
  N_VScale(3, x_, z_);
  N_Vector three[] = {z_, x_, y_};
  N_VLinearCombination(3, c, three, z_);  // z = 2 (3 x) - x + y/2
  for (int i = 0; i < kSize; ++i)
    EXPECT_NEAR(NV_Ith_S(z_, i), 5 * NV_Ith_S(x_, i) + 0.5 * NV_Ith_S(y_, i), 1e-14);
  N_VConst(1, z_);
  N_Vector one[] = {z_};
  N_VScaleAddMulti(1, c, x_, one, one);
  expect_z([](double x, double) { return 2 * x + 1; });
  N_Vector from[] = {x_};
  N_VScaleVectorArray(1, c, from, one);
  expect_z([](double x, double) { return 2 * x; });
}

// y_i' = -k_i y_i with the exact diagonal Newton matrix: nothing but CVODE itself takes time.
struct Decay {
  std::vector<double> rate;
  double gamma = 0;
};
int decay_rates(double, N_Vector y, N_Vector out, void* user) {
  const auto& k = static_cast<Decay*>(user)->rate;
  for (std::size_t i = 0; i < k.size(); ++i) NV_DATA_S(out)[i] = -k[i] * NV_DATA_S(y)[i];
  return 0;
}
int decay_system(double, N_Vector, N_Vector, SUNMatrix, booleantype keep, booleantype* fresh,
                 double gamma, void* user, N_Vector, N_Vector, N_Vector) {
  *fresh = !keep;
  static_cast<Decay*>(user)->gamma = gamma;
  return 0;
}
int decay_solve(SUNLinearSolver solver, SUNMatrix, N_Vector x, N_Vector b, double) {
  const auto& decay = *static_cast<Decay*>(solver->content);
  for (std::size_t i = 0; i < decay.rate.size(); ++i)
    NV_DATA_S(x)[i] = NV_DATA_S(b)[i] / (1 + decay.gamma * decay.rate[i]);
  return 0;
}

/// Microseconds of a CVODE step in the median of batches.
double step_time(N_Vector y, Decay& decay, SUNContext context) {
  SUNMatrix matrix = SUNMatNewEmpty(context);
  matrix->ops->getid = [](SUNMatrix) { return SUNMATRIX_CUSTOM; };
  SUNLinearSolver solver = SUNLinSolNewEmpty(context);
  solver->content = &decay;
  solver->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_DIRECT; };
  solver->ops->setup = [](SUNLinearSolver, SUNMatrix) { return 0; };
  solver->ops->solve = decay_solve;
  void* memory = CVodeCreate(CV_BDF, context);
  CVodeInit(memory, decay_rates, 0, y);
  CVodeSetUserData(memory, &decay);
  CVodeSStolerances(memory, 1e-6, 1e-9);
  CVodeSetLinearSolver(memory, solver, matrix);
  CVodeSetLinSysFn(memory, decay_system);
  CVodeSetMaxOrd(memory, 2);
  CVodeSetMaxStep(memory, 1e-4);
  std::vector<double> times;
  double t = 0;
  for (int batch = 0; batch < 101; ++batch) {
    constexpr int kSteps = 20;
    const auto began = std::chrono::steady_clock::now();
    for (int k = 0; k < kSteps; ++k) EXPECT_GE(CVode(memory, 10, y, &t, CV_ONE_STEP), 0);
    const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - began;
    times.push_back(took.count() / kSteps);
  }
  EXPECT_NEAR(NV_Ith_S(y, 0), std::exp(-decay.rate[0] * t), 1e-4);
  CVodeFree(&memory);
  SUNLinSolFreeEmpty(solver);
  SUNMatFreeEmpty(matrix);
  std::nth_element(times.begin(), times.begin() + 50, times.end());
  return times[50];
}

// Measured near 2; with the library's own operations above 20.
TEST(StateVectorCost, AStepOf250NumbersCostsLessThanTenMicroseconds) {
  if (kSanitized) GTEST_SKIP() << kNotItsOwnCost;
  sundials::Context context;
  Decay decay;
  for (int i = 0; i < 250; ++i) decay.rate.push_back(1 + i);
  N_Vector y = make_state_vector(250, context);
  N_VConst(1, y);
  const double time = step_time(y, decay, context);
  N_VDestroy(y);
  RecordProperty("microseconds", std::to_string(time));
  EXPECT_LT(time, 10);
}

}  // namespace
}  // namespace cagetol
