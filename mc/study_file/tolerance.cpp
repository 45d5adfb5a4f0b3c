#include "mc/study_file/tolerance.hpp"

#include <fmt/format.h>

#include <cmath>

#include "distributions/iso286.hpp"

namespace cagetol {
namespace {

/// To a micrometre, or a tenth of one where it is half of an odd width.
std::string in_mm(double length) {
  return fmt::format("{:.{}f}", length, std::abs(std::remainder(1e3 * length, 1)) < 1e-6 ? 3 : 4);
}

}  // namespace

std::vector<double> Candidate::all_shifts() const {
  std::vector<double> all;
  for (std::size_t d = 0; d < scales.size(); ++d) all.push_back(shift(d));
  return all;
}

std::optional<Deviations> deviations_of(const std::string& name) {
  Deviations of;
  char more = 0;
  const int read = std::sscanf(name.c_str(), "%lf/%lf%c", &of.upper, &of.lower, &more);
  if (read != 2 || !std::isfinite(of.upper - of.lower) || !(of.upper > of.lower))
    return std::nullopt;
  return of;
}

double zone_middle(const std::string& name, double tolerance_width_mm) {
  if (const auto ends = deviations_of(name)) return (ends->upper + ends->lower) / 2;
  const auto of_class = tolerance_class(name);
  return of_class ? of_class->middle * tolerance_width_mm : 0;
}

std::string drawing_text(const std::string& grade, double tolerance_width_mm) {
  if (deviations_of(grade)) return grade + " mm";
  const std::string half = "±" + in_mm(tolerance_width_mm / 2) + " mm";
  const auto of_class = tolerance_class(grade);
  if (!of_class) return half;
  if (of_class->middle > 0) return grade + " (+" + in_mm(tolerance_width_mm) + "/0 mm)";
  return half + " (" + grade +
         (grade.starts_with("IT") ? fmt::format(", js{}", of_class->grade) : "") + ")";
}

bool is_size(const std::string& key) {
  const std::string name = key.substr(key.rfind('.') + 1);
  const auto has = [&](const char* word) { return name.find(word) != std::string::npos; };
  return name.ends_with("_mm") && !has("film") &&
         (has("diameter") || has("width") || has("length"));
}

}  // namespace cagetol
