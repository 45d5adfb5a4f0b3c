// The measured parts that laws were read from: how they scatter, what their process is capable of,
// and, where the measured cages ran themselves, which of them miss limits.
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/json_parts.hpp"
#include "analysis/sensitivity/features.hpp"
#include "analysis/tolerance/limit_margin.hpp"
#include "distributions/laws/empirical.hpp"
#include "distributions/variance_parts.hpp"

namespace cagetol {
namespace {

/// Values of each cage, of those that have one.
std::vector<std::vector<double>> groups_of(const Json& measured) {
  const auto gaps = measured.at("gaps").get<std::vector<double>>();
  const auto values = measured.at("values").get<std::vector<double>>();
  const auto cage = measured.at("cage").get<std::vector<std::size_t>>();
  std::vector<std::vector<double>> groups(measured.at("names").size());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::ranges::count(gaps, static_cast<double>(i)) == 0)
      groups.at(cage.at(i)).push_back(values[i]);
  return groups;
}

/// Full width of the tolerance that the laws of a key belong to, in its unit; 0: not stated.
double tolerance_width(const StudyPlan& plan, const Json& input) {
  for (const ToleranceDimension& dimension : plan.dimensions)
    if (dimension.key == input["key"])
      return dimension.tolerance_width_mm * (input["unit"] == "um" ? 1000 : 1);
  return 0;
}

/// Cp and Cpk take the scatter within cages, Pp, Ppk and the parts outside all of it.
Json process_json(const VarianceParts& parts, double offset, double width, double confidence) {
  const auto estimate = [&](const std::function<double(const PartsProcess&)>& value) {
    const Interval ends = interval_of(parts.allowed, value, confidence);
    return to_json(Estimate{value(parts.estimate), ends.lower, ends.upper});
  };
  const auto near = [=](const PartsProcess& of) { return width / 2 - std::abs(of.mean + offset); };
  Json json = {{"cage_sigma", estimate([](const PartsProcess& of) { return of.group_sigma; })},
               {"pocket_sigma", estimate([](const PartsProcess& of) { return of.own_sigma; })},
               {"mean", estimate([=](const PartsProcess& of) { return of.mean + offset; })},
               {"tolerance_width", width > 0 ? Json(width) : Json()}};
  if (width <= 0) return json;
  json["cp"] = estimate([=](const PartsProcess& of) { return width / 6 / of.own_sigma; });
  json["cpk"] = estimate([=](const PartsProcess& of) { return near(of) / 3 / of.own_sigma; });
  json["pp"] = estimate([=](const PartsProcess& of) { return width / 6 / of.total_sigma(); });
  json["ppk"] = estimate([=](const PartsProcess& of) { return near(of) / 3 / of.total_sigma(); });
  json["outside_ppm"] = estimate([=](const PartsProcess& of) {
    return 1e6 * (gsl_cdf_gaussian_Q(near(of), of.total_sigma()) +
                  gsl_cdf_gaussian_Q(width - near(of), of.total_sigma()));
  });
  return json;
}

/// Change from the first to the last of these means, by a straight line; null for fewer than three.
Json drift_json(const std::vector<double>& means, double confidence) {
  if (means.size() < 3) return {};
  const auto last = static_cast<double>(means.size() - 1);
  std::vector<double> order;
  for (std::size_t c = 0; c < means.size(); ++c) order.push_back(static_cast<double>(c) / last);
  double constant = 0, slope = 0, other = 0, variance = 0, squares = 0;
  gsl_fit_linear(order.data(), 1, means.data(), 1, means.size(), &constant, &slope, &other, &other,
                 &variance, &squares);
  const double reach = std::sqrt(variance) * gsl_cdf_tdist_Pinv((1 + confidence) / 2, last - 1);
  return to_json(Estimate{slope, slope - reach, slope + reach});
}

}  // namespace

Json measured_json(const ReportBasis& basis) {
  const Json& plan = basis.study.plan.whole;
  Json list = Json::array();
  for (const Json& input : plan.is_object() ? plan.value("inputs", list) : list) {
    if (!input.contains("measured")) continue;
    Json measured = input["measured"];
    const auto groups = groups_of(measured);
    std::vector<double> means, scatter;
    for (const auto& group : groups) {
      means.push_back(mean(Empirical{group}));
      scatter.push_back(standard_deviation(Empirical{group}));
    }
    const double offset = measured["centred"] == true ? measured["offset"].get<double>() : 0;
    measured.update(
        {{"key", input["key"]},
         {"name", plain_name(input["key"])},
         {"unit", input["unit"]},
         {"parts", measured["values"].size() - measured["gaps"].size()},
         {"means", means},
         {"scatter", scatter},
         {"process", process_json(variance_parts(groups), offset,
                                  tolerance_width(basis.study.plan, input), basis.confidence)},
         {"drift", drift_json(means, basis.confidence)}});
    list.push_back(std::move(measured));
  }
  return list;
}

Json measured_cages_json(const ReportBasis& basis, const Json& measured) {
  std::vector<Json> list;
  const auto grouped =
      std::ranges::find_if(measured, [](const Json& of) { return of["group"] != ""; });
  if (grouped == measured.end() || basis.study.plan.limits.empty() ||
      !basis.study.plan.whole.value("measured_in_turn", false))
    return list;
  const Json& names = (*grouped)["names"];
  for (std::size_t c = 0; c < names.size(); ++c) {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < basis.study.size(); ++i)
      if (static_cast<std::size_t>(basis.study.row[i]) % names.size() == c) rows.push_back(i);
    const StudyData runs = select_samples(basis.study, rows);
    const auto margins = limit_margins(runs);
    const auto nearest = std::ranges::min_element(margins, {}, [](const LimitMargin& margin) {
      return std::pair(-static_cast<double>(margin.missed), margin.extreme_margin);
    });
    list.push_back({{"cage", names[c]},
                    {"place", c},
                    {"runs", runs.size()},
                    {"missed", std::ranges::count(judge_all(runs), Judgement::misses)},
                    {"quantity", nearest->limit.quantity},
                    {"extreme", number(nearest->extreme)},
                    {"margin", number(nearest->extreme_margin)}});
  }
  std::ranges::stable_sort(list, {}, [](const Json& entry) {
    return std::pair(-entry["missed"].get<double>(),
                     entry["margin"].is_null() ? 0 : entry["margin"].get<double>());
  });
  return list;
}

}  // namespace cagetol
