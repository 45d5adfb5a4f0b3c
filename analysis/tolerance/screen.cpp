#include "analysis/tolerance/screen.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_multifit.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <numeric>

#include "analysis/statistics/summary.hpp"
#include "analysis/study/refused.hpp"
#include "analysis/tolerance/jam_onset.hpp"

namespace cagetol {
namespace {

using Values = std::vector<double>;

constexpr double kResolvedOfShift = 0.3, kResolvedOfDistance = 0.05;
constexpr double kWithoutCurve = 2.5;  ///< widths screened that are searched where nothing jams
/// Smallest singular value of the terms, as a share of the largest, that is fitted.
constexpr double kSmallestDirection = 1e-4;
constexpr double kLeastFreedom = 0.05;  ///< of a single row, beside the fit
constexpr int kSteps = 400;             ///< of the search for a width

/// A term of the fit, by run; `dimension` is -1 for other inputs.
struct Term {
  enum class Kind { constant, mean, scatter, square, other } kind;
  long dimension = -1;
  Values values = {};
};

double mean_of(const Values& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double variance_of(const Values& values) {
  const double mean = mean_of(values);
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum / std::max(1.0, static_cast<double>(values.size()) - 1);
}

/// Terms in the order of their importance.
std::vector<Term> terms_of(const StudyData& runs, const std::vector<ScreenDimension>& dimensions) {
  using enum Term::Kind;
  std::vector<Term> terms = {{constant, -1, Values(runs.size(), 1)}}, squares, others;
  for (const InputColumns& input : runs.inputs) {
    const auto found = std::find_if(dimensions.begin(), dimensions.end(),
                                    [&](const auto& of) { return of.key == input.key; });
    const long d = found == dimensions.end() ? -1 : found - dimensions.begin();
    Values mean, scatter, square;
    const std::size_t width = input.value.size() / std::max<std::size_t>(runs.size(), 1);
    for (std::size_t i = 0; i < runs.size() && d >= 0; ++i) {
      Values deviations(width);
      for (std::size_t j = 0; j < width; ++j)
        deviations[j] = input.value[i * width + j] -
                        input.nominal[input.nominal.size() == 1 ? 0 : j] - found->middle;
      mean.push_back(mean_of(deviations));
      scatter.push_back(std::sqrt(variance_of(deviations)));
      square.push_back(mean.back() * mean.back());
    }
    if (d >= 0 && found->lot_sigma > 0) {
      terms.push_back({Term::Kind::mean, d, mean});
      squares.push_back({Term::Kind::square, d, square});
    }
    if (d >= 0 && found->pocket_sigma > 0) terms.push_back({Term::Kind::scatter, d, scatter});
    if (d < 0 && !input.lot.empty() && variance_of(input.lot) > 0) {
      Values centred = input.lot;
      for (double& value : centred) value -= mean_of(input.lot);
      others.push_back({other, -1, centred});
    }
  }
  for (auto* more : {&squares, &others}) terms.insert(terms.end(), more->begin(), more->end());
  return terms;
}

/// Runs of one row with a result.
struct Row {
  std::size_t first = 0;  ///< run
  Values values = {};
};

struct Fit {
  Values coefficients;  ///< and, last, the variance of the residuals
  std::vector<Values> covariance;
  double freedom = 0;
  double start_variance = 0;

  double error(std::size_t i) const { return std::sqrt(covariance[i][i]); }
};

/// Least squares with weights 1 / variance up to a factor.
Fit weighted_fit(const std::vector<Term>& terms, const std::vector<Row>& rows,
                 const Values& weights) {
  const std::size_t n = rows.size(), p = terms.size();
  const auto matrix = [](std::size_t lines, std::size_t columns) {
    return std::unique_ptr<gsl_matrix, void (*)(gsl_matrix*)>(gsl_matrix_alloc(lines, columns),
                                                              gsl_matrix_free);
  };
  const auto x = matrix(n, p), covariance = matrix(p, p);
  Values y(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double by = std::sqrt(weights[i]);
    y[i] = by * mean_of(rows[i].values);
    for (std::size_t k = 0; k < p; ++k)
      gsl_matrix_set(x.get(), i, k, by * terms[k].values[rows[i].first]);
  }
  Fit fit;
  fit.coefficients.resize(p);
  fit.covariance.assign(p + 1, Values(p + 1));
  fit.freedom = static_cast<double>(n - p);
  gsl_vector_view target = gsl_vector_view_array(y.data(), n),
                  c = gsl_vector_view_array(fit.coefficients.data(), p);
  const std::unique_ptr<gsl_multifit_linear_workspace, void (*)(gsl_multifit_linear_workspace*)>
      workspace(gsl_multifit_linear_alloc(n, p), gsl_multifit_linear_free);
  double squares = 0;
  std::size_t rank = 0;
  gsl_multifit_linear_tsvd(x.get(), &target.vector, kSmallestDirection, &c.vector, covariance.get(),
                           &squares, &rank, workspace.get());
  for (std::size_t i = 0; i < p; ++i)
    for (std::size_t k = 0; k < p; ++k)
      fit.covariance[i][k] = gsl_matrix_get(covariance.get(), i, k);
  const double residual = squares / fit.freedom;
  Values widened(p);  // HC3 variances
  for (std::size_t i = 0; i < n && residual > 0; ++i) {
    Values lever(p);
    double leverage = 0, error = y[i];
    for (std::size_t k = 0; k < p; ++k) {
      for (std::size_t m = 0; m < p; ++m)
        lever[k] +=
            gsl_matrix_get(covariance.get(), k, m) / residual * gsl_matrix_get(x.get(), i, m);
      leverage += lever[k] * gsl_matrix_get(x.get(), i, k);
      error -= gsl_matrix_get(x.get(), i, k) * fit.coefficients[k];
    }
    error /= std::max(1 - leverage, kLeastFreedom);
    for (std::size_t k = 0; k < p; ++k) widened[k] += lever[k] * lever[k] * error * error;
  }
  for (std::size_t k = 0; k < p; ++k) {
    const double usual = fit.covariance[k][k],
                 by = usual > 0 ? std::sqrt(std::max(1.0, widened[k] / usual)) : 1;
    for (std::size_t m = 0; m < p; ++m) fit.covariance[k][m] *= by, fit.covariance[m][k] *= by;
  }
  fit.coefficients.push_back(residual);
  fit.covariance[p][p] = 2 * residual * residual / fit.freedom;
  return fit;
}

/// Of `values` by run, NaN without a result. Drops terms that the rows cannot carry.
Fit fit_of(const StudyData& runs, const Values& values, std::vector<Term>& terms) {
  std::map<std::int64_t, Row> by_row;
  double within = 0, repeats = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (std::isnan(values[i])) continue;
    Row& row = by_row[runs.row[i]];
    if (row.values.empty()) row.first = i;
    row.values.push_back(values[i]);
  }
  std::vector<Row> rows;
  for (auto& [number, row] : by_row) {
    const auto more = static_cast<double>(row.values.size()) - 1;
    if (more > 0) within += more * variance_of(row.values), repeats += more;
    rows.push_back(std::move(row));
  }
  if (terms.size() > rows.size() / 2) terms.resize(rows.size() / 2);
  if (terms.size() < 2)
    throw Refused(fmt::format("{} cages with a result are too few to tell what moves a quantity",
                              rows.size()));
  const double start = repeats > 0 ? within / repeats : 0;
  Values weights(rows.size(), 1);
  Fit fit;
  for (int pass = 0; pass < 2; ++pass) {
    fit = weighted_fit(terms, rows, weights);
    const double residual = fit.coefficients.back(),
                 again = residual > 0 ? std::clamp(1 - start / residual, 0.0, 1.0) : 1;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto n = static_cast<double>(rows[i].values.size());
      weights[i] = n / (1 + (n - 1) * again);
    }
  }
  fit.start_variance = start;
  return fit;
}

/// A limited quantity as it follows from coefficients, turned so that its bound is a maximum.
class LimitModel {
 public:
  LimitModel(const StudyData& runs, const std::vector<ScreenDimension>& dimensions,
             const Values& values, double bound, double side)
      : dimensions_(dimensions),
        pockets_(static_cast<double>(runs.pockets)),
        bound_(side * bound),
        terms_(terms_of(runs, dimensions)) {
    Values turned = values;
    for (double& value : turned) value *= side;
    fit_ = fit_of(runs, turned, terms_);
    both_ = gsl_cdf_tdist_Pinv(0.5 + 0.5 * runs.plan.confidence, fit_.freedom);
  }

  const std::vector<Term>& terms() const { return terms_; }
  const Fit& fit() const { return fit_; }
  /// Standard errors from the estimate to an end of its interval.
  double both() const { return both_; }
  double rest(const Values& c) const {
    double variance = std::max(c.back(), 0.0);
    for (std::size_t k = 0; k < terms_.size(); ++k)
      if (terms_[k].kind == Term::Kind::other)
        variance += c[k] * c[k] * variance_of(terms_[k].values);
    return variance;
  }
  struct Moments {
    double mean = 0, deviation = 0;
  };
  /// Of cages, where tolerances have these widths, as shares of the screened.
  Moments moments(const Values& c, const Values& widths) const {
    double mean = c[0], variance = rest(c);
    Values slopes(dimensions_.size());  // of a square, its mean stands before it
    for (std::size_t k = 0; k < terms_.size(); ++k) {
      const Term& term = terms_[k];
      if (term.dimension < 0) continue;
      const auto d = static_cast<std::size_t>(term.dimension);
      const ScreenDimension& of = dimensions_[d];
      const double v = widths[d] * widths[d] *
                       (of.lot_sigma * of.lot_sigma + of.pocket_sigma * of.pocket_sigma / pockets_);
      const double moved = (widths[d] - 1) * of.middle;
      if (term.kind == Term::Kind::mean)
        slopes[d] = c[k], mean += c[k] * moved, variance += c[k] * c[k] * v;
      if (term.kind == Term::Kind::scatter) mean += c[k] * widths[d] * of.pocket_sigma;
      if (term.kind == Term::Kind::square)
        mean += c[k] * (v + moved * moved),
            variance += 2 * c[k] * c[k] * v * v + 4 * c[k] * moved * (slopes[d] + c[k] * moved) * v;
    }
    return {mean, std::sqrt(variance)};
  }
  /// Standard deviations z by which the mean lies within the bound, less `errors` of their standard
  /// errors: mean + z deviation meets the bound with so many standard errors of that sum (Fieller).
  double margin_less(const Values& widths, double errors) const {
    const Values& c = fit_.coefficients;
    const auto [mean, deviation] = moments(c, widths);
    const double room = bound_ - mean;
    if (deviation == 0) return std::copysign(HUGE_VAL, room);
    if (errors == 0) return room / deviation;
    double of_mean = 0, of_both = 0, of_deviation = 0;  // covariances
    std::vector<Moments> slopes(c.size());
    for (std::size_t i = 0; i < c.size(); ++i) {
      const double step = 1e-3 * fit_.error(i);
      Values up = c, down = c;
      up[i] += step, down[i] -= step;
      const Moments above = moments(up, widths), below = moments(down, widths);
      if (step > 0)
        slopes[i] = {(above.mean - below.mean) / (2 * step),
                     (above.deviation - below.deviation) / (2 * step)};
    }
    for (std::size_t i = 0; i < c.size(); ++i)
      for (std::size_t k = 0; k < c.size(); ++k) {
        const double of = fit_.covariance[i][k];
        of_mean += slopes[i].mean * of * slopes[k].mean;
        of_both += slopes[i].mean * of * slopes[k].deviation;
        of_deviation += slopes[i].deviation * of * slopes[k].deviation;
      }
    // a z^2 - 2 b z + d <= 0. a <= 0: the deviation may be none, and z is without end on its side of
    // zero; beyond zero it ends where the mean is surely on its side of the bound, d > 0.
    const double e = errors * errors, a = deviation * deviation - e * of_deviation,
                 b = room * deviation + e * of_both, d = room * room - e * of_mean,
                 root = std::sqrt(std::max(b * b - a * d, 0.0));
    if (errors > 0) {
      if (a <= 0 && (room <= 0 || d <= 0)) return -HUGE_VAL;
      return b + root > 0 ? d / (b + root) : (b - root) / a;
    }
    if (a <= 0 && (room >= 0 || d <= 0)) return HUGE_VAL;
    return a > 0 ? (b + root) / a : d / (b - root);
  }

 private:
  const std::vector<ScreenDimension>& dimensions_;
  double pockets_, bound_, both_ = 0;
  std::vector<Term> terms_;
  Fit fit_;
};

/// Whether the target is missed at widths, as shares of those screened; `side` 0: by the estimate,
/// 1 and -1: at the ends of its interval, the worse one first.
using Misses = std::function<bool(const Values& widths, double side)>;

/// Widths are those of a step each: the first at which the target is missed.
LimitReach reach_of(const std::vector<ScreenDimension>& dimensions, std::size_t d, double target,
                    const Misses& misses) {
  const ScreenDimension& own = dimensions[d];
  LimitReach reach{.key = own.key};
  reach.searched_mm = own.jams.tolerance_width_mm.empty() ? kWithoutCurve * own.width_mm
                                                          : own.jams.tolerance_width_mm.back();
  if (!own.jams.share.empty()) reach.jam_mm = tolerance_of_jams(own.jams, 1 - target);
  Values widths;
  for (const ScreenDimension& each : dimensions)
    widths.push_back(each.narrowest_mm / each.width_mm);
  for (int step = 0; step <= kSteps; ++step) {
    const double width = reach.searched_mm * step / kSteps;
    widths[d] = width / own.width_mm;
    const auto note = [&](std::optional<double>& at, double side) {
      if (!at && misses(widths, side)) at = width;
    };
    note(reach.width_mm, 0);
    note(reach.lower_mm, 1);
    note(reach.upper_mm, -1);
  }
  return reach;
}

ScreenedLimit screened(const StudyData& runs, const std::vector<ScreenDimension>& dimensions,
                       const LimitModel& model, const Column& column, double bound,
                       bool is_maximum) {
  const double side = is_maximum ? 1 : -1, target = runs.plan.target_yield,
               wanted = gsl_cdf_ugaussian_Pinv(target);
  const Fit& fit = model.fit();
  const Values& c = fit.coefficients;
  ScreenedLimit limit{.quantity = column.name, .unit = column.unit, .bound = bound};
  limit.is_maximum = is_maximum;
  limit.level = side * c[0];
  limit.level_error = fit.error(0);
  limit.start_noise = std::sqrt(fit.start_variance);
  limit.scatter = std::sqrt(model.rest(c));
  for (std::size_t k = 0; k < model.terms().size(); ++k) {
    const Term& term = model.terms()[k];
    if (term.kind != Term::Kind::mean && term.kind != Term::Kind::scatter) continue;
    const ScreenDimension& of = dimensions[static_cast<std::size_t>(term.dimension)];
    PartShift part{of.key, term.kind == Term::Kind::mean ? "lot" : "pocket",
                   side * c[k] * of.hundredth, fit.error(k) * of.hundredth};
    part.resolved = part.error <= kResolvedOfShift * std::abs(part.shift) ||
                    part.error <= kResolvedOfDistance * std::abs(bound - limit.level);
    for (std::size_t q = 0; q < model.terms().size() && part.part == "lot"; ++q)
      if (model.terms()[q].kind == Term::Kind::square &&
          model.terms()[q].dimension == term.dimension)
        part.bent =
            std::abs(c[q]) > 2 * fit.error(q) && std::abs(c[q]) * of.lot_sigma > std::abs(c[k]);
    limit.parts.push_back(std::move(part));
  }
  const double one = gsl_cdf_tdist_Pinv(runs.plan.confidence, fit.freedom);
  for (std::size_t d = 0; d < dimensions.size(); ++d)
    limit.reach.push_back(reach_of(dimensions, d, target, [&](const Values& at, double end) {
      return model.margin_less(at, end * model.both()) < wanted;
    }));
  const Values widest(dimensions.size(), 1);
  limit.margin = model.margin_less(widest, 0);
  limit.missed = gsl_cdf_ugaussian_Q(limit.margin);
  limit.missed_upper = gsl_cdf_ugaussian_Q(model.margin_less(widest, one));
  return limit;
}

}  // namespace

void add_runs(StudyData& runs, const StudyData& more) {
  if (runs.size() == 0) {
    runs = more;
    return;
  }
  const auto add = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  const std::int64_t rows = 1 + *std::ranges::max_element(runs.row);
  for (const std::int64_t row : more.row) runs.row.push_back(rows + row);
  add(runs.id, more.id);
  add(runs.status, more.status);
  for (std::size_t i = 0; i < runs.inputs.size(); ++i)
    add(runs.inputs[i].lot, more.inputs[i].lot), add(runs.inputs[i].value, more.inputs[i].value);
  for (std::size_t q = 0; q < runs.quantities.size(); ++q)
    add(runs.quantities[q].values, more.quantities[q].values);
}

Screen screen_limits(const StudyData& runs, const std::vector<ScreenDimension>& dimensions,
                     double jams) {
  Screen screen{.runs = runs.size(), .target_yield = runs.plan.target_yield, .jams = jams};
  for (const RunStatus status : runs.status) screen.lost += status != RunStatus::ok;
  std::vector<LimitModel> models;
  double missed = 0;
  for (const Limit& limit : runs.plan.limits) {
    const Column* column = find_quantity(runs, limit.quantity);
    for (const bool is_maximum : {false, true}) {
      const auto& bound = is_maximum ? limit.maximum : limit.minimum;
      if (!bound || column == nullptr) continue;
      models.emplace_back(runs, dimensions, ok_values(runs, column->values), *bound,
                          is_maximum ? 1 : -1);
      screen.limits.push_back(
          screened(runs, dimensions, models.back(), *column, *bound, is_maximum));
      const ScreenedLimit& last = screen.limits.back();
      missed += last.missed_upper;
      if (last.margin < screen.limits[screen.nearest].margin)
        screen.nearest = screen.limits.size() - 1;
    }
  }
  for (std::size_t d = 0; d < dimensions.size(); ++d)
    screen.together.push_back(
        reach_of(dimensions, d, screen.target_yield, [&](const Values& widths, double side) {
          double missing = 0;
          for (const LimitModel& model : models)
            missing += gsl_cdf_ugaussian_Q(model.margin_less(widths, side * model.both()));
          return (1 - share_of_jams(dimensions[d].jams, widths[d] * dimensions[d].width_mm)) *
                     (1 - missing) <
                 screen.target_yield;
        }));
  screen.jams_alone = jams + missed <= 1 - screen.target_yield;
  return screen;
}

}  // namespace cagetol
