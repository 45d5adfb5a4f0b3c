// As many doubles side by side as a register holds: the lanes over which rollers are computed. GCC
// vector types, so +, -, *, / and comparisons are the language's own (of wider ones than a register
// it compares and selects lane by lane). Always whole packs, so that a result does not depend on
// the lane it is computed in.
#pragma once

#include <cstdint>
#include <cstring>
#include <initializer_list>

#ifndef __AVX2__
#error "compile for processors with AVX2: -march=native or -march=x86-64-v3"
#endif
#include <immintrin.h>

namespace cagetol {

#ifdef __AVX512F__
inline constexpr int kLanes = 8;
#else
inline constexpr int kLanes = 4;
#endif
typedef double Pack __attribute__((vector_size(kLanes * sizeof(double))));
/// All bits set where true.
typedef std::int64_t Mask __attribute__((vector_size(kLanes * sizeof(double))));
inline constexpr int kEight = 8;
/// Over the directions of one roller, zeros behind them; where a register holds fewer, in two.
/// Adds and multiplies only.
typedef double Eight __attribute__((vector_size(kEight * sizeof(double))));

inline Pack splat(double x) {
  return Pack{} + x;
}
/// A pack wherever doubles may stand (GCC lets vectors alias what they are made of). Not memcpy: by
/// the compiler's reckoning that may change anything, so that where slots of the state are would be
/// worked out anew behind each store.
typedef double LoosePack
    __attribute__((vector_size(kLanes * sizeof(double)), aligned(alignof(double))));
inline Pack load(const double* p) {
  return *reinterpret_cast<const LoosePack*>(p);
}
inline Eight load_eight(const double* p) {
  Eight x;
  std::memcpy(&x, p, sizeof x);
  return x;
}
inline void store(double* p, Pack x) {
  *reinterpret_cast<LoosePack*>(p) = x;
}
/// The first n of them, n up to kLanes or beyond; zero behind these.
inline Pack load_first(const double* p, int n) {
#ifdef __AVX512F__
  const auto mask = static_cast<__mmask8>(n < kLanes ? (1 << n) - 1 : 0xFF);
  return reinterpret_cast<Pack>(_mm512_maskz_loadu_pd(mask, p));
#else
  const Mask wanted = Mask{0, 1, 2, 3} < n;
  return reinterpret_cast<Pack>(_mm256_maskload_pd(p, reinterpret_cast<__m256i>(wanted)));
#endif
}
inline void store_first(double* p, Pack x, int n) {
#ifdef __AVX512F__
  const auto mask = static_cast<__mmask8>(n < kLanes ? (1 << n) - 1 : 0xFF);
  _mm512_mask_storeu_pd(p, mask, reinterpret_cast<__m512d>(x));
#else
  const Mask wanted = Mask{0, 1, 2, 3} < n;
  _mm256_maskstore_pd(p, reinterpret_cast<__m256i>(wanted), reinterpret_cast<__m256d>(x));
#endif
}
inline Pack select(Mask m, Pack a, Pack b) {
  return m ? a : b;
}
inline Pack max(Pack a, Pack b) {
  return a > b ? a : b;
}
inline Pack min(Pack a, Pack b) {
  return a < b ? a : b;
}

// The same names for one double, so that a law is written once for both.
inline double select(bool m, double a, double b) {
  return m ? a : b;
}
inline double max(double a, double b) {
  return a > b ? a : b;
}
inline double min(double a, double b) {
  return a < b ? a : b;
}
inline bool any(bool m) {
  return m;
}
inline double sqrt(double x) {
  return __builtin_sqrt(x);
}
inline double power(double x, double e) {
  return __builtin_pow(x, e);
}
inline double log2(double x) {
  return __builtin_log2(x);
}
inline double exp2(double x) {
  return __builtin_exp2(x);
}
inline double abs(double x) {
  return __builtin_fabs(x);
}
/// Whole part of x >= 0, for gather(); the rest into `share`.
inline std::int64_t cell(double x, double& share) {
  const auto whole = static_cast<std::int64_t>(x);
  share = x - static_cast<double>(whole);
  return whole;
}
inline double gather(const double* table, std::int64_t at) {
  return table[at];
}

inline bool any(Mask m) {
#ifdef __AVX512F__
  return _mm512_test_epi64_mask(reinterpret_cast<__m512i>(m), reinterpret_cast<__m512i>(m)) != 0;
#else
  return !_mm256_testz_si256(reinterpret_cast<__m256i>(m), reinterpret_cast<__m256i>(m));
#endif
}

inline Pack sqrt(Pack x) {
#ifdef __AVX512F__
  return reinterpret_cast<Pack>(_mm512_maskz_sqrt_pd(0xFF, reinterpret_cast<__m512d>(x)));
#else
  return reinterpret_cast<Pack>(_mm256_sqrt_pd(reinterpret_cast<__m256d>(x)));
#endif
}

/// Root of x > 0 and its reciprocal, without waiting for a division.
inline Pack sqrt(Pack x, Pack& inverse) {
#ifdef __AVX512F__
  // Two Newton steps from 14 bits, then the root's own residual.
  const __m512d v = reinterpret_cast<__m512d>(x), half = _mm512_mul_pd(_mm512_set1_pd(0.5), v);
  __m512d r = _mm512_rsqrt14_pd(v);
  for (int step = 0; step < 2; ++step)
    r = _mm512_mul_pd(r, _mm512_fnmadd_pd(_mm512_mul_pd(half, r), r, _mm512_set1_pd(1.5)));
  const __m512d root = _mm512_mul_pd(v, r);
  inverse = reinterpret_cast<Pack>(r);
  return reinterpret_cast<Pack>(_mm512_fmadd_pd(_mm512_mul_pd(_mm512_set1_pd(0.5), r),
                                                _mm512_fnmadd_pd(root, root, v), root));
#else
  const Pack root = sqrt(x);
  inverse = 1.0 / root;
  return root;
#endif
}

/// Sum of the lanes, always in the same order.
inline double sum(Pack x) {
#ifdef __AVX512F__
  const __m512d all = reinterpret_cast<__m512d>(x);
  const __m256d four = _mm512_castpd512_pd256(all) + _mm512_extractf64x4_pd(all, 1);
#else
  const __m256d four = reinterpret_cast<__m256d>(x);
#endif
  const __m128d two = _mm256_castpd256_pd128(four) + _mm256_extractf128_pd(four, 1);
  return two[0] + two[1];
}
inline double largest(Pack x) {
  double most[kLanes];
  store(most, x);
  for (int half = kLanes / 2; half > 0; half /= 2)
    for (int i = 0; i < half; ++i) most[i] = most[i + half] > most[i] ? most[i + half] : most[i];
  return most[0];
}
inline double smallest(Pack x) {
  return -largest(-x);
}

#ifdef __AVX512F__
/// Exchanges blocks of `distance` between columns that far apart; Low: what the first of them keeps
/// of both.
template <int distance, int... Low>
void exchange(Pack (&columns)[kEight]) {
  for (int i = 0; i < kLanes; ++i) {
    if (i & distance) continue;
    const Pack x = columns[i], y = columns[i + distance];
    columns[i] = __builtin_shufflevector(x, y, Low...);
    columns[i + distance] = __builtin_shufflevector(x, y, (Low + distance)...);
  }
}
#endif

/// Rows to columns.
inline void transpose(const Eight (&rows)[kLanes], Pack (&columns)[kEight]) {
#ifdef __AVX512F__
  for (int i = 0; i < kLanes; ++i) columns[i] = rows[i];
  exchange<1, 0, 8, 2, 10, 4, 12, 6, 14>(columns);
  exchange<2, 0, 1, 8, 9, 4, 5, 12, 13>(columns);
  exchange<4, 0, 1, 2, 3, 8, 9, 10, 11>(columns);
#else
  for (int i = 0; i < kEight; ++i)
    for (int lane = 0; lane < kLanes; ++lane) columns[i][lane] = rows[lane][i];
#endif
}

/// c[0] + c[1] x + ... by pairs (Estrin): the chain of dependent operations is four long where
/// Horner's is n.
template <int n>
inline Pack polynomial(const double (&c)[n], Pack x) {
  static_assert(n >= 9 && n <= 16);
  const auto pair = [&](int i) { return i + 1 < n ? c[i] + c[i + 1] * x : splat(c[i]); };
  const Pack x2 = x * x, x4 = x2 * x2, x8 = x4 * x4;
  const auto four = [&](int i) { return i + 2 < n ? pair(i) + pair(i + 2) * x2 : pair(i); };
  const Pack low = four(0) + four(4) * x4;
  return low + (n > 12 ? four(8) + four(12 < n ? 12 : 8) * x4 : four(8)) * x8;
}

typedef std::uint64_t Unsigned __attribute__((vector_size(sizeof(Mask))));
/// Whether a whole number is negative or at least n.
inline Mask outside(Mask x, std::int64_t n) {
  return reinterpret_cast<Unsigned>(x) >= static_cast<std::uint64_t>(n);
}
inline bool outside(std::int64_t x, std::int64_t n) {
  return static_cast<std::uint64_t>(x) >= static_cast<std::uint64_t>(n);
}
/// Bits moved down, zeros behind them. (AVX2 moves no signs down.)
inline Mask shifted_down(Mask bits, int by) {
  return reinterpret_cast<Mask>(reinterpret_cast<Unsigned>(bits) >> by);
}
inline std::int64_t shifted_down(std::int64_t bits, int by) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(bits) >> by);
}
/// Whole numbers below 2^52, not negative, as doubles.
inline Pack real(Mask whole) {
#ifdef __AVX512DQ__
  return __builtin_convertvector(whole, Pack);
#else
  return reinterpret_cast<Pack>(whole | 0x4330000000000000LL) - 0x1p52;
#endif
}

/// log2(x) for finite x > 0, within 2 units in the last place of max(1, |log2 x|).
inline Pack log2(Pack x) {
  // Mantissa in [sqrt(1/2), sqrt(2)): subtract the bits of sqrt(1/2), take the exponent, put the
  // rest back.
  const std::uint64_t half_root = 0x3FE6A09E667F3BCDLL;
  const Unsigned shifted = reinterpret_cast<Unsigned>(x) - half_root;
  constexpr std::int64_t bias = 1023;  // makes every exponent positive
  const Mask exponents = reinterpret_cast<Mask>((shifted + (std::uint64_t{bias} << 52)) >> 52);
  const Pack exponent = real(exponents) - double{bias};
  const Pack m = reinterpret_cast<Pack>((shifted & 0x000FFFFFFFFFFFFFULL) + half_root);
  const Pack s = (m - 1.0) / (m + 1.0), z = s * s;
  constexpr double c[] = {1.0 / 3,  1.0 / 5,  1.0 / 7,  1.0 / 9,  1.0 / 11,
                          1.0 / 13, 1.0 / 15, 1.0 / 17, 1.0 / 19, 1.0 / 21};
  const Pack ln = 2.0 * (s + s * z * polynomial(c, z));
  return ln * 1.4426950408889634074 + exponent;
}

/// 2^y for |y| < 1000, within 2 units in the last place.
inline Pack exp2(Pack y) {
  const double magic =
      6755399441055744.0;  // 1.5 * 2^52: adding it rounds to an integer kept in the low bits
  const Pack rounded = y + magic;
  const Unsigned n = reinterpret_cast<Unsigned>(rounded) << 52;
  const Pack f = (y - (rounded - magic)) * 0.69314718055994530942;
  constexpr double c[] = {1,
                          0.5,
                          1.0 / 6,
                          1.0 / 24,
                          1.0 / 120,
                          1.0 / 720,
                          1.0 / 5040,
                          1.0 / 40320,
                          1.0 / 362880,
                          1.0 / 3628800,
                          1.0 / 39916800,
                          1.0 / 479001600,
                          1.0 / 6227020800.0};
  const Pack value = 1.0 + f * polynomial(c, f);
  return reinterpret_cast<Pack>(reinterpret_cast<Unsigned>(value) + n);
}

/// x^e for x > 0; anything for other x (mask it). Relative error below 1e-15 for |e log2 x| < 8,
/// and 6e-15 for |e log2 x| < 60, where the rounding of the product counts (unless the compiler
/// fuses it).
inline Pack power(Pack x, double e) {
  return exp2(log2(x) * e);
}

inline Pack abs(Pack x) {
  return reinterpret_cast<Pack>(reinterpret_cast<Mask>(x) & 0x7FFFFFFFFFFFFFFFLL);
}

inline Mask cell(Pack x, Pack& share) {
#ifdef __AVX512DQ__
  const Mask whole = __builtin_convertvector(x, Mask);
  share = x - __builtin_convertvector(whole, Pack);
  return whole;
#else
  const Pack near = (x + 0x1p52) - 0x1p52, whole = near - select(near > x, splat(1.0), Pack{});
  share = x - whole;
  return reinterpret_cast<Mask>(whole + 0x1p52) & 0x000FFFFFFFFFFFFFLL;
#endif
}
/// table[at] of every lane.
inline Pack gather(const double* table, Mask at) {
#ifdef __AVX512F__
  return reinterpret_cast<Pack>(
      _mm512_i64gather_pd(reinterpret_cast<__m512i>(at), table, sizeof(double)));
#else
  return reinterpret_cast<Pack>(
      _mm256_i64gather_pd(table, reinterpret_cast<__m256i>(at), sizeof(double)));
#endif
}

inline std::int64_t bits_of(double x) {
  std::int64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}
inline Mask bits_of(Pack x) {
  return reinterpret_cast<Mask>(x);
}
template <class T>
T number_of(std::int64_t bits) {
  double x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}
template <class T>
T number_of(Mask bits) {
  return reinterpret_cast<Pack>(bits);
}
/// As gather(), of tables so small that they fit into registers.
template <int n>
double look_up(const double (&table)[n], std::int64_t at) {
  return table[at];
}
template <int n>
Pack look_up(const double (&table)[n], Mask at) {
#ifdef __AVX512F__
  static_assert(n == 16 || n == 32);
  const auto half = [&](int from) {
    return _mm512_permutex2var_pd(_mm512_loadu_pd(table + from), reinterpret_cast<__m512i>(at),
                                  _mm512_loadu_pd(table + from + kLanes));
  };
  if constexpr (n == 16) return reinterpret_cast<Pack>(half(0));
  return select(at < 16, reinterpret_cast<Pack>(half(0)), reinterpret_cast<Pack>(half(n - 16)));
#else
  return gather(table, at);
#endif
}

/// Sine and cosine, absolute error below 3e-16 for |x| < 1e5.
inline void sine_cosine(Pack x, Pack& s, Pack& c) {
  const double magic = 6755399441055744.0;
  const Pack rounded = x * 0.63661977236758134308 + magic;
  const Mask quadrant = reinterpret_cast<Mask>(rounded);
  const Pack n = rounded - magic;
  // pi/2 in three parts (Cody and Waite); n has at most 17 bits, so each product is exact.
  const Pack r =
      ((x - n * 1.5707963267341256142) - n * 6.0771005063039659e-11) - n * 2.0222662487959505e-21;
  const Pack z = r * r;
  // On |r| <= pi/4 (the coefficients of fdlibm), by pairs.
  const Pack z2 = z * z, z4 = z2 * z2;
  const auto six = [&](double c0, double c1, double c2, double c3, double c4, double c5) {
    return ((c0 + c1 * z) + (c2 + c3 * z) * z2) + (c4 + c5 * z) * z4;
  };
  const Pack ps =
      six(-1.66666666666666324348e-01, 8.33333333332248946124e-03, -1.98412698298579493134e-04,
          2.75573137070700676789e-06, -2.50507602534068634195e-08, 1.58969099521155010221e-10);
  const Pack pc =
      six(4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05,
          -2.75573143513906633035e-07, 2.08757232129817482790e-09, -1.13596475577881948265e-11);
  const Pack sine = r + r * z * ps, cosine = (1.0 - 0.5 * z) + z2 * pc;
  const Mask swap = -(quadrant & 1);
  const Mask flip_s = (quadrant & 2) << 62, flip_c = ((quadrant + 1) & 2) << 62;
  s = reinterpret_cast<Pack>(reinterpret_cast<Mask>(select(swap, cosine, sine)) ^ flip_s);
  c = reinterpret_cast<Pack>(reinterpret_cast<Mask>(select(swap, sine, cosine)) ^ flip_c);
}

}  // namespace cagetol
