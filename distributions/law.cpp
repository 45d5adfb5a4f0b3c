#include "distributions/law.hpp"

#include <array>
#include <sstream>
#include <stdexcept>

namespace cagetol {

void check(const Law& law) {
  std::visit([](const auto& of) { check(of); }, law);
}

double quantile(const Law& law, double p) {
  if (!(p >= 0 && p <= 1)) {
    std::ostringstream message;
    message << "quantile of the probability " << p << ", which is not within 0 .. 1";
    throw std::domain_error(message.str());
  }
  return std::visit([p](const auto& of) { return quantile(of, p); }, law);
}

double cdf(const Law& law, double x) {
  return std::visit([x](const auto& of) { return cdf(of, x); }, law);
}

double pdf(const Law& law, double x) {
  return std::visit([x](const auto& of) { return pdf(of, x); }, law);
}

double mean(const Law& law) {
  return std::visit([](const auto& of) { return mean(of); }, law);
}

double standard_deviation(const Law& law) {
  return std::visit([](const auto& of) { return standard_deviation(of); }, law);
}

Interval support(const Law& law) {
  return std::visit([](const auto& of) { return support(of); }, law);
}

std::string_view law_name(const Law& law) {
  // In the order of the variant.
  static constexpr std::array<std::string_view, std::variant_size_v<Law>> names = {
      "normal",  "truncated_normal", "uniform",   "triangular", "lognormal",
      "weibull", "histogram",        "empirical", "capability"};
  return names[law.index()];
}

}  // namespace cagetol
