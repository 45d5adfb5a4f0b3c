#include "src/quantities/cage_fatigue.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "src/quantities/von_mises.hpp"

namespace cagetol {
namespace {

constexpr double kQuantile = 0.99;
constexpr long kPairs = 15;  // of six components

/// Place of the components c and d among (0,1), (0,2), ..., (0,5), (1,2), ..., (4,5).
long pair_of(long c, long d) {
  const long first = std::min(c, d), second = std::max(c, d);
  return first * (11 - first) / 2 + second - first - 1;
}

double largest_principal(const double (&s)[6]) {
  Eigen::Matrix3d tensor;
  tensor << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4], s[2];
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor, Eigen::EigenvaluesOnly)
      .eigenvalues()[2];
}

/// Smallest value that at least kQuantile of all do not exceed.
float high_quantile(std::vector<float>& values) {
  const auto rank =
      static_cast<std::ptrdiff_t>(std::ceil(kQuantile * static_cast<double>(values.size())));
  const auto at = values.begin() + rank - 1;
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

CageFatigue::CageFatigue(long stations, long sectors) : stations_(stations), sectors_(sectors) {
  lowest_.setZero(6 * stations * sectors);
  highest_ = first_ = sums_ = lowest_;
  products_.setZero(kPairs * stations * sectors);
  means_.setZero(lowest_.size());
}

void CageFatigue::add(const Eigen::VectorXf& stress) {
  if (instants_++ == 0) {
    first_ = lowest_ = highest_ = stress;
    sums_.setZero();
    products_.setZero();
    return;
  }
  lowest_ = lowest_.cwiseMin(stress);
  highest_ = highest_.cwiseMax(stress);
  sums_ += stress - first_;
  for (long k = 0; k < sectors_; ++k) {
    const auto part = [&](long c) {
      const long row = stations_ * (6 * k + c);
      return (stress.segment(row, stations_) - first_.segment(row, stations_)).array();
    };
    for (long c = 0, pair = 0; c < 6; ++c)
      for (long d = c + 1; d < 6; ++d, ++pair)
        products_.segment(stations_ * (kPairs * k + pair), stations_).array() += part(c) * part(d);
  }
}

Eigen::VectorXf CageFatigue::amplitudes() const {
  Eigen::VectorXf half = 0.5F * (highest_ - lowest_), amplitude(stations_ * sectors_);
  for (long k = 0; k < sectors_; ++k) {
    for (long i = 0; i < stations_; ++i) {
      const auto at = [&](long c) { return stations_ * (6 * k + c) + i; };
      long widest = 0;
      for (long c = 1; c < 6; ++c)
        if (half[at(c)] > half[at(widest)]) widest = c;
      for (long c = 0; c < 6; ++c) {
        if (c == widest) continue;
        const float product = products_[stations_ * (kPairs * k + pair_of(c, widest)) + i];
        if (product < sums_[at(c)] * sums_[at(widest)] / static_cast<float>(instants_))
          half[at(c)] = -half[at(c)];
      }
    }
    amplitude.segment(k * stations_, stations_) =
        von_mises_squared(half.segment(6 * stations_ * k, 6 * stations_)).sqrt();
  }
  return amplitude;
}

void CageFatigue::end_revolution() {
  if (instants_ == 0) return;
  amplitude_.push_back(amplitudes());
  means_ += (0.5F * (lowest_ + highest_)).cast<double>();
  instants_ = 0;
}

CageFatigue::Place CageFatigue::worst(const Strength& strength) const {
  if (amplitude_.empty() && instants_ > 0) {
    CageFatigue part = *this;
    part.end_revolution();
    return part.worst(strength);
  }
  Place worst;
  std::vector<float> values(amplitude_.size());
  for (long k = 0; k < sectors_ && !values.empty(); ++k) {
    for (long i = 0; i < stations_; ++i) {
      for (std::size_t n = 0; n < values.size(); ++n) values[n] = amplitude_[n][k * stations_ + i];
      double mean[6];
      for (long c = 0; c < 6; ++c)
        mean[c] = means_[stations_ * (6 * k + c) + i] / static_cast<double>(amplitude_.size());
      const double amplitude = static_cast<double>(high_quantile(values)),
                   opening = std::max(0.0, largest_principal(mean)),
                   utilisation = amplitude / strength.fatigue + opening / strength.tensile;
      if (utilisation > worst.utilisation) worst = {utilisation, amplitude, opening, k, i};
    }
  }
  return worst;
}

}  // namespace cagetol
