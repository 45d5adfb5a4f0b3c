// How likely a sample's deviations are under a tolerance: the density that weights are made of.
//
// A tolerance scales the study's laws: deviation x of a key with scale s has the density p(x/s)/s,
// and p((x-c)/s)/s when the middle of its zone lies c beside the nominal value.
// Only the parts that a tolerance scales enter: the lot and pocket deviations of its dimensions;
// everything else has the same density under every tolerance and cancels. Keys tied to them by a
// Gaussian copula enter through the copula: with z_i = Phi^-1(F_i(x_i/s_i)),
//   log c(z) = -1/2 log det R - 1/2 z' (R^-1 - 1) z.
#pragma once

#include <span>
#include <vector>

#include "analysis/study/study_data.hpp"
#include "distributions/law.hpp"

namespace cagetol {

class ToleranceDensity {
 public:
  /// Throws Refused where a law of a tolerance dimension has no density (measured values).
  explicit ToleranceDensity(const StudyData& runs);

  /// Logarithm of the density of sample i when dimension d is scaled by scales[d] and then moved
  /// by shifts[d], in the unit of its key; -inf where it cannot occur. The lot moves, or every
  /// pocket where the key has no lot part. Empty shifts: none.
  double log_density(std::size_t sample, std::span<const double> scales,
                     std::span<const double> shifts = {}) const;

 private:
  /// One scope (lot, or all pockets) of one key.
  struct Part {
    Law law;
    int dimension =
        -1;  ///< index of the tolerance dimension; -1: not scaled, here for the copula only
    std::span<const double> values;  ///< N x width
    std::size_t width = 1;
    bool moves = false;  ///< a shift of its dimension moves this part
    double standard(double value, std::span<const double> scales,
                    std::span<const double> shifts) const;
  };
  /// Parts of one scope that a copula ties together.
  struct Copula {
    std::vector<std::size_t> parts;
    std::vector<double> inverse_minus_one;  ///< R^-1 - 1, row-major
    double log_determinant = 0;
  };

  void add_parts(const StudyData& runs, bool lot_scope);
  double log_copula(const Copula& copula, std::size_t sample, std::span<const double> scales,
                    std::span<const double> shifts) const;

  std::vector<Part> parts_;
  std::vector<Copula> copulas_;
};

}  // namespace cagetol
