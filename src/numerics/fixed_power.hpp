// x^e for one exponent e, as a contact law needs it for every slice of every roller: by tables made
// beforehand, without power(x, e)'s logarithm.
//
//   x = 2^k m, 1 <= m < 2:   x^e = 2^(k e) c^e (1 + r)^e,   r = m/c - 1
// with c the middle of the sixteenth of [1, 2) that m is in, so |r| < 1/32: ten terms of the
// binomial series.
#pragma once

#include <cmath>

#include "src/numerics/pack.hpp"

namespace cagetol {

class FixedPower {
 public:
  explicit FixedPower(double exponent) : exponent_(exponent) {
    for (int i = 0; i < kCells; ++i) {
      inverse_[i] = 1 / (1 + (i + 0.5) / kCells);
      middle_[i] = std::pow(inverse_[i], -exponent);
    }
    for (int k = 0; k < kOctaves; ++k)
      octave_[k] =
          static_cast<double>(std::exp2((k - kLowest) * static_cast<long double>(exponent)));
    series_[0] = 1;
    for (int n = 1; n < kTerms; ++n) series_[n] = series_[n - 1] * (exponent - (n - 1)) / n;
  }

  /// x^e for x > 0; anything for other x (mask it). Relative error below 1e-15 for 2^-16 <= x <
  /// 2^16 and 0 <= e <= 2, elsewhere as power(x, e).
  template <class T>
  [[gnu::always_inline]] T operator()(T x) const {
    const auto bits = bits_of(x);
    const auto octave = shifted_down(bits, 52) - (1023 - kLowest);
    const auto beyond = outside(octave, kOctaves);
    const auto cell = shifted_down(bits, 48) & (kCells - 1);
    const T mantissa = number_of<T>((bits & 0x000FFFFFFFFFFFFFLL) | 0x3FF0000000000000LL);
    const T r = mantissa * look_up(inverse_, cell) - 1.0, r2 = r * r;
    const double(&c)[kTerms] = series_;
    const T low = (c[0] + c[1] * r) + (c[2] + c[3] * r) * r2,
            high = (c[4] + c[5] * r) + (c[6] + c[7] * r) * r2 + (c[8] + c[9] * r) * (r2 * r2);
    const T value = look_up(octave_, octave & (kOctaves - 1)) * look_up(middle_, cell) *
                    (low + high * (r2 * r2));
    return any(beyond) ? select(beyond, power(x, exponent_), value) : value;
  }

 private:
  static constexpr int kCells = 16, kOctaves = 32, kLowest = 16, kTerms = 10;

  double exponent_;
  double inverse_[kCells];   ///< 1/c
  double middle_[kCells];    ///< c^e
  double octave_[kOctaves];  ///< 2^(k e)
  double series_[kTerms];    ///< binomial coefficients of e
};

}  // namespace cagetol
