#include "analysis/tolerance/centre_response.hpp"

#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cagetol {
namespace {

constexpr std::size_t kPowers = 3, kCurvePoints = 81;
constexpr std::size_t kRunsPerTerm = 8;

/// Value, place and tolerance of each run with a result.
struct Points {
  std::vector<std::size_t> run;
  std::vector<double> u, value;
  std::vector<std::size_t> width;
  std::size_t widths = 0;
};

/// Centre of the cage of each run: its lot, or the centre of its candidate where pockets alone
/// scatter.
std::vector<double> centres_of_runs(const StudyData& runs, const InputColumns& input,
                                    std::size_t dimension) {
  std::vector<double> centres(runs.size());
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const auto k = static_cast<std::size_t>(runs.candidate[i]);
    centres[i] = input.nominal.front() +
                 (input.lot.empty() ? runs.plan.candidates[k].shift(dimension) : input.lot[i]);
  }
  return centres;
}

Points points_of(const StudyData& runs, const Column& column, const std::vector<double>& centres,
                 std::size_t dimension, double middle, double half) {
  std::vector<double> widths;
  for (const Candidate& candidate : runs.plan.candidates)
    if (std::count(widths.begin(), widths.end(), candidate.tolerance_widths_mm[dimension]) == 0)
      widths.push_back(candidate.tolerance_widths_mm[dimension]);
  Points points;
  points.widths = widths.size();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const double u = (centres[i] - middle) / half;
    if (runs.status[i] != RunStatus::ok || std::isnan(column.values[i]) || std::abs(u) > 1.25)
      continue;
    const double width = runs.plan.candidates[static_cast<std::size_t>(runs.candidate[i])]
                             .tolerance_widths_mm[dimension];
    points.run.push_back(i);
    points.u.push_back(u);
    points.value.push_back(column.values[i]);
    points.width.push_back(
        static_cast<std::size_t>(std::find(widths.begin(), widths.end(), width) - widths.begin()));
  }
  return points;
}

/// Coefficients of the tolerances' levels, then of u, u^2, u^3; empty where the runs do not tell
/// them.
std::vector<double> fit(const Points& points, std::span<const double> weights) {
  const std::size_t terms = points.widths + kPowers;
  std::vector<double> normal(terms * terms, 0.0), right(terms, 0.0), row(terms), solution(terms);
  for (std::size_t p = 0; p < points.run.size(); ++p) {
    const double w = weights[points.run[p]];
    if (!(w > 0)) continue;
    std::fill(row.begin(), row.end(), 0.0);
    row[points.width[p]] = 1;
    double power = 1;
    for (std::size_t k = 0; k < kPowers; ++k) row[points.widths + k] = power *= points.u[p];
    for (std::size_t a = 0; a < terms; ++a) {
      if (row[a] == 0) continue;
      right[a] += w * row[a] * points.value[p];
      for (std::size_t b = 0; b < terms; ++b) normal[a * terms + b] += w * row[a] * row[b];
    }
  }
  for (std::size_t a = 0; a < points.widths; ++a)  // a tolerance that no run of this resample has
    if (normal[a * terms + a] == 0) normal[a * terms + a] = 1;
  gsl_matrix_view matrix = gsl_matrix_view_array(normal.data(), terms, terms);
  gsl_vector_const_view known = gsl_vector_const_view_array(right.data(), terms);
  gsl_vector_view unknown = gsl_vector_view_array(solution.data(), terms);
  gsl_error_handler_t* handler = gsl_set_error_handler_off();
  const bool solved =
      gsl_linalg_cholesky_decomp1(&matrix.matrix) == 0 &&
      gsl_linalg_cholesky_solve(&matrix.matrix, &known.vector, &unknown.vector) == 0;
  gsl_set_error_handler(handler);
  return solved ? solution : std::vector<double>{};
}

double place(std::size_t point) {
  return -1 + 2 * static_cast<double>(point) / (kCurvePoints - 1);
}

/// The fit without the tolerances' levels.
double curve(const std::vector<double>& coefficients, std::size_t widths, double u) {
  return u * (coefficients[widths] + u * (coefficients[widths + 1] + u * coefficients[widths + 2]));
}

double minimum_place(const Points& points, std::span<const double> weights) {
  const auto coefficients = fit(points, weights);
  if (coefficients.empty()) return kUndefined;
  double best = 0, minimum = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < kCurvePoints; ++p) {
    const double value = curve(coefficients, points.widths, place(p));
    if (value >= minimum) continue;
    minimum = value;
    best = place(p);
  }
  return best;
}

std::vector<CentreMean> means_by_centre(const std::vector<double>& centres, const Points& points,
                                        double middle, double half) {
  std::vector<CentreMean> means;
  for (const double centre : centres) means.push_back({centre});
  std::vector<double> squares(centres.size(), 0.0);
  const auto nearest = [&](double u) {
    const double x = middle + half * u;
    return static_cast<std::size_t>(
        std::min_element(centres.begin(), centres.end(),
                         [&](double a, double b) { return std::abs(a - x) < std::abs(b - x); }) -
        centres.begin());
  };
  for (std::size_t p = 0; p < points.u.size(); ++p) {
    CentreMean& mean = means[nearest(points.u[p])];
    ++mean.runs;
    mean.mean += (points.value[p] - mean.mean) / static_cast<double>(mean.runs);
  }
  for (std::size_t p = 0; p < points.u.size(); ++p) {
    const std::size_t c = nearest(points.u[p]);
    squares[c] += (points.value[p] - means[c].mean) * (points.value[p] - means[c].mean);
  }
  for (std::size_t c = 0; c < means.size(); ++c) {
    const auto n = static_cast<double>(means[c].runs);
    means[c].standard_error = n > 1 ? std::sqrt(squares[c] / (n - 1) / n) : kUndefined;
  }
  return means;
}

}  // namespace

std::optional<CentreResponse> centre_response(const StudyData& runs, std::size_t dimension,
                                              const Resampling& resampling, double confidence) {
  const ToleranceDimension& plan = runs.plan.dimensions[dimension];
  const Column* column = find_quantity(runs, kCentreQuantity);
  const InputColumns* input = find_input(runs, plan.key);
  if (plan.centres.size() < 3 || column == nullptr || input == nullptr || input->nominal.empty())
    return std::nullopt;
  const double middle = 0.5 * (plan.centres.front() + plan.centres.back()),
               half = 0.5 * (plan.centres.back() - plan.centres.front());
  const Points points =
      points_of(runs, *column, centres_of_runs(runs, *input, dimension), dimension, middle, half);
  if (points.run.size() < kRunsPerTerm * (points.widths + kPowers)) return std::nullopt;
  const std::vector<double> equal(runs.size(), 1.0);
  const auto coefficients = fit(points, equal);
  if (coefficients.empty()) return std::nullopt;

  CentreResponse response{
      plan.key, input->unit, column->unit, means_by_centre(plan.centres, points, middle, half),
      {},       {},          {},           false};
  double level = 0;
  for (const std::size_t width : points.width)
    level += coefficients[width] / static_cast<double>(points.width.size());
  for (std::size_t p = 0; p < kCurvePoints; ++p) {
    response.at.push_back(middle + half * place(p));
    response.fitted.push_back(level + curve(coefficients, points.widths, place(p)));
  }
  response.optimum = resampling.estimate(
      [&](std::span<const double> weights) {
        return middle + half * minimum_place(points, weights);
      },
      confidence);
  const double step = (plan.centres.back() - plan.centres.front()) / (kCurvePoints - 1);
  response.at_end = response.optimum.lower < plan.centres.front() + step ||
                    response.optimum.upper > plan.centres.back() - step;
  return response;
}

}  // namespace cagetol
