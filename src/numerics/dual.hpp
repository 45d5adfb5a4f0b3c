// A number with its derivatives by n variables: a law written once for T gives its force for T =
// double or Pack, and force and derivatives for T = Dual<double, n> or Dual<Pack, n>.
//
//   (a, a') + (b, b') = (a + b, a' + b')
//   (a, a') (b, b')   = (a b, a' b + a b')
//   f((a, a'))        = (f(a), f'(a) a')
//
// Comparisons look at values alone. select() chooses values and derivatives together, so a law that
// is C1 where its branches meet has continuous derivatives here. Source: Griewank and Walther,
// Evaluating Derivatives (2008), section 3.1 (doi 10.1137/1.9780898717761).
#pragma once

#include <numbers>
#include <type_traits>

#include "src/numerics/reciprocal.hpp"

namespace cagetol {

/// Not set unless written Dual{}, which is zero.
template <class T, int n>
struct Dual {
  T value;
  T slope[n];
};

/// The plain number that a law's branches and solvers look at.
inline double value_of(double x) {
  return x;
}
inline Pack value_of(Pack x) {
  return x;
}
template <class T, int n>
T value_of(const Dual<T, n>& x) {
  return x.value;
}

/// Type of value_of.
template <class T>
using ValueOf = decltype(value_of(T{}));

/// Variable number `i` of a law.
template <class D, class T>
D variable(T value, int i) {
  D x{};
  x.value = value;
  x.slope[i] = T{} + 1.0;
  return x;
}

namespace dual_detail {
/// (f(x), f'(x) x').
template <class T, int n>
[[gnu::always_inline]] inline Dual<T, n> chain(const Dual<T, n>& x, T value, T derivative) {
  Dual<T, n> y;
  y.value = value;
  for (int i = 0; i < n; ++i) y.slope[i] = derivative * x.slope[i];
  return y;
}
}  // namespace dual_detail

/// A number that follows from x by a function of its own: its value, and its derivative by x.
template <class T, int n>
Dual<T, n> follow(const Dual<T, n>& x, T value, T derivative) {
  return dual_detail::chain(x, value, derivative);
}
template <class T>
T follow(T, T value, T) {
  return value;
}

template <class T, int n>
Dual<T, n> operator-(const Dual<T, n>& a) {
  return dual_detail::chain(a, -a.value, T{} - 1.0);
}
template <class T, int n>
Dual<T, n> operator+(Dual<T, n> a, const Dual<T, n>& b) {
  a.value += b.value;
  for (int i = 0; i < n; ++i) a.slope[i] += b.slope[i];
  return a;
}
template <class T, int n>
Dual<T, n> operator-(Dual<T, n> a, const Dual<T, n>& b) {
  a.value -= b.value;
  for (int i = 0; i < n; ++i) a.slope[i] -= b.slope[i];
  return a;
}
template <class T, int n>
Dual<T, n> operator*(const Dual<T, n>& a, const Dual<T, n>& b) {
  Dual<T, n> y;
  y.value = a.value * b.value;
  for (int i = 0; i < n; ++i) y.slope[i] = a.slope[i] * b.value + a.value * b.slope[i];
  return y;
}
template <class T, int n>
Dual<T, n> operator/(const Dual<T, n>& a, const Dual<T, n>& b) {
  const T inverse = reciprocal(b.value);
  Dual<T, n> y;
  y.value = a.value * inverse;
  for (int i = 0; i < n; ++i) y.slope[i] = (a.slope[i] - y.value * b.slope[i]) * inverse;
  return y;
}
template <class T, int n>
Dual<T, n>& operator+=(Dual<T, n>& a, const Dual<T, n>& b) {
  return a = a + b;
}
template <class T, int n>
Dual<T, n>& operator*=(Dual<T, n>& a, const Dual<T, n>& b) {
  return a = a * b;
}

// With constants: a double, or (for packs) a pack.
template <class T, int n, class C>
concept ConstantFor = (std::is_same_v<C, double> || std::is_same_v<C, T>)&&n > 0;

template <class T, int n, class C>
requires ConstantFor<T, n, C> Dual<T, n>
operator+(Dual<T, n> a, C b) {
  a.value += b;
  return a;
}
template <class T, int n, class C>
requires ConstantFor<T, n, C> Dual<T, n>
operator+(C a, Dual<T, n> b) {
  b.value += a;
  return b;
}
template <class T, int n, class C>
requires ConstantFor<T, n, C> Dual<T, n>
operator-(Dual<T, n> a, C b) {
  a.value -= b;
  return a;
}
template <class T, int n, class C>
requires ConstantFor<T, n, C> Dual<T, n>
operator-(C a, const Dual<T, n>& b) {
  return dual_detail::chain(b, T(a - b.value), T{} - 1.0);
}
template <class T, int n, class C>
requires ConstantFor<T, n, C> Dual<T, n>
operator*(const Dual<T, n>& a, C b) {
  return dual_detail::chain(a, T(a.value * b), T{} + b);
}
template <class T, int n, class C>
requires ConstantFor<T, n, C> Dual<T, n>
operator*(C a, const Dual<T, n>& b) {
  return b * a;
}
template <class T, int n, class C>
requires ConstantFor<T, n, C> Dual<T, n>
operator/(const Dual<T, n>& a, C b) {
  return a * T((T{} + 1.0) / b);
}
template <class T, int n, class C>
requires ConstantFor<T, n, C> Dual<T, n>
operator/(C a, const Dual<T, n>& b) {
  const T inverse = reciprocal(b.value), value = a * inverse;
  return dual_detail::chain(b, value, T(-value * inverse));
}

template <class T, int n, class C>
auto operator<(const Dual<T, n>& a, const C& b) {
  return a.value < value_of(b);
}
template <class T, int n, class C>
auto operator>(const Dual<T, n>& a, const C& b) {
  return a.value > value_of(b);
}

template <class T, int n, class C>
auto operator>=(const Dual<T, n>& a, const C& b) {
  return a.value >= value_of(b);
}

template <class M, class T, int n>
Dual<T, n> select(M mask, const Dual<T, n>& a, const Dual<T, n>& b) {
  Dual<T, n> y;
  y.value = select(mask, a.value, b.value);
  for (int i = 0; i < n; ++i) y.slope[i] = select(mask, a.slope[i], b.slope[i]);
  return y;
}
template <class T, int n>
Dual<T, n> max(const Dual<T, n>& a, const Dual<T, n>& b) {
  return select(a.value > b.value, a, b);
}
template <class T, int n>
Dual<T, n> min(const Dual<T, n>& a, const Dual<T, n>& b) {
  return select(a.value < b.value, a, b);
}
template <class T, int n>
Dual<T, n> sqrt(const Dual<T, n>& x) {
  const T root = sqrt(x.value);
  return dual_detail::chain(x, root, T(0.5 / root));
}
template <class T, int n>
Dual<T, n> reciprocal(const Dual<T, n>& x) {
  return 1.0 / x;
}
template <class T, int n>
Dual<T, n> inverse_root(const Dual<T, n>& x) {
  const T value = inverse_root(x.value);
  return dual_detail::chain(x, value, T(-0.5 * value * value * value));
}
template <class T, int n>
Dual<T, n> exp2(const Dual<T, n>& x) {
  const T value = exp2(x.value);
  return dual_detail::chain(x, value, T(std::numbers::ln2 * value));
}
template <class T, int n>
Dual<T, n> log2(const Dual<T, n>& x) {
  return dual_detail::chain(x, log2(x.value), T((1 / std::numbers::ln2) * reciprocal(x.value)));
}
template <class T, int n>
Dual<T, n> power(const Dual<T, n>& x, double e) {
  const T value = power(x.value, e);
  return dual_detail::chain(x, value, T(e * value * reciprocal(x.value)));
}

}  // namespace cagetol
