#include "src/quantities/centre_path.hpp"

#include <gsl/gsl_fft_complex.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <numbers>

namespace cagetol {
namespace {

constexpr double kWhirlBegins = 1.5;                    // of the cage's speed
constexpr double kCirclesFrom = 0.8, kCirclesTo = 1.2;  // of the cage's speed
constexpr double kLineWidth = 2;     // lines on either side that a Hann window spreads a line over
constexpr std::size_t kFactor = 64;  // of the number of samples, for a fast transform

using Path = Eigen::VectorXcd;

/// Mean squares of `path` by frequency, through a Hann window; forward ones first.
std::vector<double> spectrum(const Path& path) {
  const auto count = static_cast<std::size_t>(path.size());
  std::vector<double> values(2 * count);
  double weights = 0;
  for (std::size_t n = 0; n < count; ++n) {
    const double at = 2 * std::numbers::pi * static_cast<double>(n) / static_cast<double>(count),
                 weight = (1 - std::cos(at)) / 2;
    const std::complex<double> value = weight * path[static_cast<Eigen::Index>(n)];
    values[2 * n] = value.real();
    values[2 * n + 1] = value.imag();
    weights += weight * weight;
  }
  const std::unique_ptr<gsl_fft_complex_wavetable, void (*)(gsl_fft_complex_wavetable*)> table(
      gsl_fft_complex_wavetable_alloc(count), gsl_fft_complex_wavetable_free);
  const std::unique_ptr<gsl_fft_complex_workspace, void (*)(gsl_fft_complex_workspace*)> work(
      gsl_fft_complex_workspace_alloc(count), gsl_fft_complex_workspace_free);
  gsl_fft_complex_forward(values.data(), 1, count, table.get(), work.get());
  std::vector<double> powers(count);
  for (std::size_t k = 0; k < count; ++k)
    powers[k] = (values[2 * k] * values[2 * k] + values[2 * k + 1] * values[2 * k + 1]) /
                (static_cast<double>(count) * weights);
  return powers;
}

}  // namespace

void CentrePath::record(double t, const Seen& seen) {
  if (path_.empty()) begin_ = t;
  for (double next; (next = begin_ + static_cast<double>(path_.size()) * interval_) <= t;) {
    const double share = path_.empty() ? 1 : (next - time_) / (t - time_);
    path_.push_back({last_.centre + share * (seen.centre - last_.centre),
                     last_.cage + share * (seen.cage - last_.cage)});
  }
  time_ = t;
  last_ = seen;
}

CentreMotion CentrePath::motion(double load_speed) const {
  using namespace std::complex_literals;
  const std::size_t count = path_.size() / kFactor * kFactor;
  const auto rows = static_cast<Eigen::Index>(count);
  Path rest(rows);
  Eigen::MatrixXcd fitted(rows, load_speed != 0 ? 3 : 2);
  for (Eigen::Index n = 0; n < rows; ++n) {
    const Seen& seen = path_[static_cast<std::size_t>(n)];
    rest[n] = seen.centre;
    fitted(n, 0) = 1;
    fitted(n, 1) = std::exp(1i * seen.cage);
    if (load_speed != 0)
      fitted(n, 2) = std::exp(1i * load_speed * interval_ * static_cast<double>(n));
  }
  const Path parts = fitted.colPivHouseholderQr().solve(rest);
  rest -= fitted * parts;
  const double turned = (path_[count - 1].cage - path_.front().cage) / (2 * std::numbers::pi);
  const double load_turned =
      load_speed * interval_ * static_cast<double>(count) / (2 * std::numbers::pi);
  const std::vector<double> powers = spectrum(rest);
  double whirl = 0, load_line = 0, circling = std::norm(parts[1]), most = -1;
  CentreMotion motion;
  for (std::size_t k = 0; k < count; ++k) {
    const double turns = k <= count / 2 ? static_cast<double>(k)
                                        : static_cast<double>(k) - static_cast<double>(count),
                 speed = turns / turned;
    if (speed >= kCirclesFrom && speed <= kCirclesTo) circling += powers[k];
    if (std::abs(speed) < kWhirlBegins) continue;
    whirl += powers[k];
    if (load_speed != 0 && std::abs(turns - load_turned) <= kLineWidth) load_line += powers[k];
    if (powers[k] <= most) continue;
    most = powers[k];
    motion.strongest = speed;
  }
  motion.whirl = std::sqrt(whirl);
  motion.load_line = std::sqrt(load_line);
  motion.circling = std::sqrt(circling);
  return motion;
}

const char* whirl_class(double whirl_ratio, double load_line_ratio, double circling_ratio) {
  if (std::isnan(whirl_ratio)) return "unknown";
  const double apart = whirl_ratio * whirl_ratio - load_line_ratio * load_line_ratio;
  if (apart > kWhirlMax * kWhirlMax) return "whirling";
  if (whirl_ratio > kWhirlMax) return "not separable";
  return circling_ratio > kWhirlMax ? "circling" : "stable";
}

}  // namespace cagetol
