// A number with its derivatives by n variables: a law written once for T gives its force for T =
// double or Pack, and force and derivatives for T = Dual<double, n> or Dual<Pack, n>.
//
//   (a, a') + (b, b') = (a + b, a' + b')
//   (a, a') (b, b')   = (a b, a' b + a b')
//   f((a, a'))        = (f(a), f'(a) a')
//
// A number may say at compile time which variables it depends on at all: slopes by the others are
// zero and never computed, so that a law pays for what it couples.
//
// Comparisons look at values alone. select() chooses values and derivatives together, so a law that
// is C1 where its branches meet has continuous derivatives here. Source: Griewank and Walther,
// Evaluating Derivatives (2008), section 3.1 (doi 10.1137/1.9780898717761).
#pragma once

#include <numbers>
#include <type_traits>

#include "src/numerics/reciprocal.hpp"

namespace cagetol {

inline constexpr unsigned every_variable(int n) {
  return (1U << n) - 1;
}
/// Not set unless written Dual{}, which is zero. `on`: bit i is set where the number depends on
/// variable i; other slopes are not set.
template <class T, int n, unsigned on = every_variable(n)>
struct Dual {
  T value;
  T slope[n];

  /// As one that may depend on more.
  template <unsigned more>
  requires((on & ~more) == 0 && on != more) operator Dual<T, n, more>() const {
    Dual<T, n, more> y;
    y.value = value;
    for (int i = 0; i < n; ++i)
      if (more >> i & 1U) y.slope[i] = on >> i & 1U ? slope[i] : T{};
    return y;
  }
};

/// The plain number that a law's branches and solvers look at.
inline double value_of(double x) {
  return x;
}
inline Pack value_of(Pack x) {
  return x;
}
template <class T, int n, unsigned on>
T value_of(const Dual<T, n, on>& x) {
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

/// The same, which depends on that one of n variables alone.
template <int i, int n, class T>
Dual<T, n, 1U << i> variable(T value) {
  Dual<T, n, 1U << i> x;
  x.value = value;
  x.slope[i] = T{} + 1.0;
  return x;
}

namespace dual_detail {
/// (f(x), f'(x) x').
template <class T, int n, unsigned on>
[[gnu::always_inline]] inline Dual<T, n, on> chain(const Dual<T, n, on>& x, T value, T derivative) {
  Dual<T, n, on> y;
  y.value = value;
  for (int i = 0; i < n; ++i)
    if (on >> i & 1U) y.slope[i] = derivative * x.slope[i];
  return y;
}
/// `both` of the slopes of a and b, or `left` of a's or `right` of b's alone.
template <class T, int n, unsigned a, unsigned b, class Left, class Right>
[[gnu::always_inline]] inline Dual<T, n, a | b> joined(T value, const Dual<T, n, a>& x,
                                                       const Dual<T, n, b>& y, const Left& left,
                                                       const Right& right) {
  Dual<T, n, a | b> z;
  z.value = value;
  for (int i = 0; i < n; ++i)
    if ((a & b) >> i & 1U)
      z.slope[i] = left(x.slope[i]) + right(y.slope[i]);
    else if (a >> i & 1U)
      z.slope[i] = left(x.slope[i]);
    else if (b >> i & 1U)
      z.slope[i] = right(y.slope[i]);
  return z;
}
}  // namespace dual_detail

/// A number that follows from x by a function of its own: its value, and its derivative by x.
template <class T, int n, unsigned on>
Dual<T, n, on> follow(const Dual<T, n, on>& x, T value, T derivative) {
  return dual_detail::chain(x, value, derivative);
}
template <class T>
T follow(T, T value, T) {
  return value;
}

template <class T, int n, unsigned on>
Dual<T, n, on> operator-(const Dual<T, n, on>& a) {
  return dual_detail::chain(a, -a.value, T{} - 1.0);
}
template <class T, int n, unsigned a, unsigned b>
Dual<T, n, a | b> operator+(const Dual<T, n, a>& x, const Dual<T, n, b>& y) {
  const auto same = [](T slope) { return slope; };
  return dual_detail::joined(x.value + y.value, x, y, same, same);
}
template <class T, int n, unsigned a, unsigned b>
Dual<T, n, a | b> operator-(const Dual<T, n, a>& x, const Dual<T, n, b>& y) {
  return dual_detail::joined(
      x.value - y.value, x, y, [](T slope) { return slope; }, [](T slope) { return -slope; });
}
template <class T, int n, unsigned a, unsigned b>
Dual<T, n, a | b> operator*(const Dual<T, n, a>& x, const Dual<T, n, b>& y) {
  return dual_detail::joined(
      x.value * y.value, x, y, [&](T slope) { return slope * y.value; },
      [&](T slope) { return x.value * slope; });
}
template <class T, int n, unsigned a, unsigned b>
Dual<T, n, a | b> operator/(const Dual<T, n, a>& x, const Dual<T, n, b>& y) {
  const T inverse = reciprocal(y.value), value = x.value * inverse, by = -value * inverse;
  return dual_detail::joined(
      value, x, y, [&](T slope) { return slope * inverse; }, [&](T slope) { return by * slope; });
}
template <class T, int n, unsigned a, unsigned b>
Dual<T, n, a>& operator+=(Dual<T, n, a>& x, const Dual<T, n, b>& y) {
  return x = x + y;
}
template <class T, int n, unsigned a, unsigned b>
Dual<T, n, a>& operator*=(Dual<T, n, a>& x, const Dual<T, n, b>& y) {
  return x = x * y;
}

// With constants: a double, or (for packs) a pack.
template <class T, int n, class C>
concept ConstantFor = (std::is_same_v<C, double> || std::is_same_v<C, T>)&&n > 0;

template <class T, int n, unsigned on, class C>
requires ConstantFor<T, n, C> Dual<T, n, on>
operator+(Dual<T, n, on> a, C b) {
  a.value += b;
  return a;
}
template <class T, int n, unsigned on, class C>
requires ConstantFor<T, n, C> Dual<T, n, on>
operator+(C a, Dual<T, n, on> b) {
  b.value += a;
  return b;
}
template <class T, int n, unsigned on, class C>
requires ConstantFor<T, n, C> Dual<T, n, on>
operator-(Dual<T, n, on> a, C b) {
  a.value -= b;
  return a;
}
template <class T, int n, unsigned on, class C>
requires ConstantFor<T, n, C> Dual<T, n, on>
operator-(C a, const Dual<T, n, on>& b) {
  return dual_detail::chain(b, T(a - b.value), T{} - 1.0);
}
template <class T, int n, unsigned on, class C>
requires ConstantFor<T, n, C> Dual<T, n, on>
operator*(const Dual<T, n, on>& a, C b) {
  return dual_detail::chain(a, T(a.value * b), T{} + b);
}
template <class T, int n, unsigned on, class C>
requires ConstantFor<T, n, C> Dual<T, n, on>
operator*(C a, const Dual<T, n, on>& b) {
  return b * a;
}
template <class T, int n, unsigned on, class C>
requires ConstantFor<T, n, C> Dual<T, n, on>
operator/(const Dual<T, n, on>& a, C b) {
  return a * T((T{} + 1.0) / b);
}
template <class T, int n, unsigned on, class C>
requires ConstantFor<T, n, C> Dual<T, n, on>
operator/(C a, const Dual<T, n, on>& b) {
  const T inverse = reciprocal(b.value), value = a * inverse;
  return dual_detail::chain(b, value, T(-value * inverse));
}

template <class T, int n, unsigned on, class C>
auto operator<(const Dual<T, n, on>& a, const C& b) {
  return a.value < value_of(b);
}
template <class T, int n, unsigned on, class C>
auto operator>(const Dual<T, n, on>& a, const C& b) {
  return a.value > value_of(b);
}

template <class T, int n, unsigned on, class C>
auto operator>=(const Dual<T, n, on>& a, const C& b) {
  return a.value >= value_of(b);
}

template <class M, class T, int n, unsigned a, unsigned b>
Dual<T, n, a | b> select(M mask, const Dual<T, n, a>& x, const Dual<T, n, b>& y) {
  const Dual<T, n, a | b> first = x, second = y;
  Dual<T, n, a | b> z;
  z.value = select(mask, x.value, y.value);
  for (int i = 0; i < n; ++i)
    if ((a | b) >> i & 1U) z.slope[i] = select(mask, first.slope[i], second.slope[i]);
  return z;
}
template <class T, int n, unsigned a, unsigned b>
auto max(const Dual<T, n, a>& x, const Dual<T, n, b>& y) {
  return select(x.value > y.value, x, y);
}
template <class T, int n, unsigned a, unsigned b>
auto min(const Dual<T, n, a>& x, const Dual<T, n, b>& y) {
  return select(x.value < y.value, x, y);
}
template <class T, int n, unsigned on>
Dual<T, n, on> sqrt(const Dual<T, n, on>& x) {
  const T root = sqrt(x.value);
  return dual_detail::chain(x, root, T(0.5 / root));
}
template <class T, int n, unsigned on>
Dual<T, n, on> reciprocal(const Dual<T, n, on>& x) {
  return 1.0 / x;
}
template <class T, int n, unsigned on>
Dual<T, n, on> inverse_root(const Dual<T, n, on>& x) {
  const T value = inverse_root(x.value);
  return dual_detail::chain(x, value, T(-0.5 * value * value * value));
}
template <class T, int n, unsigned on>
Dual<T, n, on> exp2(const Dual<T, n, on>& x) {
  const T value = exp2(x.value);
  return dual_detail::chain(x, value, T(std::numbers::ln2 * value));
}
template <class T, int n, unsigned on>
Dual<T, n, on> log2(const Dual<T, n, on>& x) {
  return dual_detail::chain(x, log2(x.value), T((1 / std::numbers::ln2) * reciprocal(x.value)));
}
template <class T, int n, unsigned on>
Dual<T, n, on> power(const Dual<T, n, on>& x, double e) {
  const T value = power(x.value, e);
  return dual_detail::chain(x, value, T(e * value * reciprocal(x.value)));
}

}  // namespace cagetol
