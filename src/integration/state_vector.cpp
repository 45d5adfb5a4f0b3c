#include "src/integration/state_vector.hpp"

#include <algorithm>
#include <cmath>

namespace cagetol {
namespace {

constexpr long kSums = 8;  // side by side, so that additions need not wait for one another

double* data(N_Vector x) {
  return NV_DATA_S(x);
}

/// z_i = f(i). Arguments may be z itself: each element depends on its own index only.
template <class Function>
void for_each(N_Vector z, const Function& f) {
  double* out = data(z);
  const long n = NV_LENGTH_S(z);
#pragma GCC ivdep
  for (long i = 0; i < n; ++i) out[i] = f(i);
}

/// Sum of f(i) over the elements of x.
template <class Function>
double sum_over(N_Vector x, const Function& f) {
  const long n = NV_LENGTH_S(x);
  double parts[kSums] = {};
  long i = 0;
  for (; i + kSums <= n; i += kSums)
    for (long k = 0; k < kSums; ++k) parts[k] += f(i + k);
  for (; i < n; ++i) parts[i % kSums] += f(i);
  double total = 0;
  for (double part : parts) total += part;
  return total;
}

void linear_sum(double a, N_Vector x, double b, N_Vector y, N_Vector z) {
  const double *p = data(x), *q = data(y);
  for_each(z, [=](long i) { return a * p[i] + b * q[i]; });
}
void set_constant(double c, N_Vector z) {
  for_each(z, [=](long) { return c; });
}
void product(N_Vector x, N_Vector y, N_Vector z) {
  const double *p = data(x), *q = data(y);
  for_each(z, [=](long i) { return p[i] * q[i]; });
}
void quotient(N_Vector x, N_Vector y, N_Vector z) {
  const double *p = data(x), *q = data(y);
  for_each(z, [=](long i) { return p[i] / q[i]; });
}
void scale(double c, N_Vector x, N_Vector z) {
  const double* p = data(x);
  for_each(z, [=](long i) { return c * p[i]; });
}
void magnitude(N_Vector x, N_Vector z) {
  const double* p = data(x);
  for_each(z, [=](long i) { return std::abs(p[i]); });
}
void inverse(N_Vector x, N_Vector z) {
  const double* p = data(x);
  for_each(z, [=](long i) { return 1 / p[i]; });
}
void add_constant(N_Vector x, double b, N_Vector z) {
  const double* p = data(x);
  for_each(z, [=](long i) { return p[i] + b; });
}

double dot_product(N_Vector x, N_Vector y) {
  const double *p = data(x), *q = data(y);
  return sum_over(x, [=](long i) { return p[i] * q[i]; });
}
double largest_magnitude(N_Vector x) {
  double largest = 0;
  for (long i = 0; i < NV_LENGTH_S(x); ++i) largest = std::max(largest, std::abs(data(x)[i]));
  return largest;
}
double smallest(N_Vector x) {
  return *std::min_element(data(x), data(x) + NV_LENGTH_S(x));
}
double weighted_rms(N_Vector x, N_Vector weights) {
  const double *p = data(x), *w = data(weights);
  const double squares = sum_over(x, [=](long i) { return (p[i] * w[i]) * (p[i] * w[i]); });
  return std::sqrt(squares / static_cast<double>(NV_LENGTH_S(x)));
}

/// z = sum_k c_k x_k; z may be x_0.
int linear_combination(int count, double* c, N_Vector* x, N_Vector z) {
  scale(c[0], x[0], z);
  for (int k = 1; k < count; ++k) linear_sum(1, z, c[k], x[k], z);
  return 0;
}
/// z_k = a_k x + y_k.
int scale_add_multi(int count, double* a, N_Vector x, N_Vector* y, N_Vector* z) {
  for (int k = 0; k < count; ++k) linear_sum(a[k], x, 1, y[k], z[k]);
  return 0;
}
int scale_vectors(int count, double* c, N_Vector* x, N_Vector* z) {
  for (int k = 0; k < count; ++k) scale(c[k], x[k], z[k]);
  return 0;
}

}  // namespace

N_Vector make_state_vector(int size, SUNContext context) {
  N_Vector vector = N_VNew_Serial(size, context);
  auto& operations = *vector->ops;
  operations.nvlinearsum = linear_sum;
  operations.nvconst = set_constant;
  operations.nvprod = product;
  operations.nvdiv = quotient;
  operations.nvscale = scale;
  operations.nvabs = magnitude;
  operations.nvinv = inverse;
  operations.nvaddconst = add_constant;
  operations.nvdotprod = dot_product;
  operations.nvmaxnorm = largest_magnitude;
  operations.nvmin = smallest;
  operations.nvwrmsnorm = weighted_rms;
  operations.nvlinearcombination = linear_combination;
  operations.nvscaleaddmulti = scale_add_multi;
  operations.nvscalevectorarray = scale_vectors;
  return vector;
}

}  // namespace cagetol
