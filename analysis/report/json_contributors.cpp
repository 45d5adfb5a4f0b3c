// Which features of a cage drive which quantity.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/json_parts.hpp"
#include "analysis/sensitivity/binned_shares.hpp"
#include "analysis/sensitivity/features.hpp"
#include "analysis/sensitivity/unexplained_share.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kResponsePoints = 12;

/// A quantity, or an indicator of the outcome.
struct Output {
  std::string name, unit, definition;
  std::vector<double> values;
};

std::vector<Output> outputs_of(const ReportBasis& basis) {
  std::vector<Output> outputs;
  Output meets{
      "meets all limits",
      "-",
      "1 when the run meets every limit, 0 when it misses one or jams; undefined without a result",
      {}};
  Output jams{"jams", "-", "1 when a roller does not fit its pocket, else 0; over all runs", {}};
  for (std::size_t i = 0; i < basis.runs.size(); ++i) {
    meets.values.push_back(
        basis.joint[i] == Judgement::unknown ? kUndefined : basis.joint[i] == Judgement::meets);
    jams.values.push_back(basis.runs.status[i] == RunStatus::jammed);
  }
  if (!basis.study.plan.limits.empty()) outputs.push_back(std::move(meets));
  outputs.push_back(std::move(jams));
  for (const Column& column : basis.runs.quantities)
    outputs.push_back({column.name, column.unit, column.description, column.values});
  std::erase_if(outputs, [](const Output& output) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const double y : output.values)
      if (!std::isnan(y)) low = std::min(low, y), high = std::max(high, y);
    return !(high > low);
  });
  return outputs;
}

Json response_json(const Feature& feature, const Output& output,
                   const std::vector<std::size_t>& lot_of) {
  Json points = Json::array();
  for (const ResponsePoint& point :
       response_curve(feature.values, output.values, kResponsePoints, lot_of))
    points.push_back({{"feature", number(point.feature)},
                      {"mean", number(point.mean)},
                      {"standard_error", number(point.standard_error)}});
  return points;
}

/// A pocket stands out when its share exceeds the median pocket's by more than 3.5 standard errors:
/// about one false alarm in a hundred maps. Every pocket mattering alike is no map worth printing.
bool stands_out(std::vector<double> shares, std::size_t runs) {
  std::sort(shares.begin(), shares.end());
  const double median = std::max(shares[shares.size() / 2], 0.0), count = static_cast<double>(runs);
  const double bins = static_cast<double>(bin_count(runs));
  const double error =
      std::sqrt(2 * (bins - 1) + 4 * median * (1 - median) * (1 - median) * count) / count;
  return shares.back() > median + 3.5 * error;
}

/// Share of each single pocket's deviation; an output moved by one pocket more than by the others
/// shows here.
Json pockets_json(const ReportBasis& basis, const std::vector<Output>& outputs) {
  Json list = Json::array();
  const std::vector<double> equal(basis.runs.size(), 1.0);
  for (const InputColumns& input : basis.runs.inputs) {
    std::vector<Binning> binnings;
    for (const Feature& feature : pocket_features(basis.runs, input)) {
      binnings.push_back(make_binning(feature.values));
      // Class means, not lines: the scatter of their shares does not depend on the output's law,
      // which may be that of rare jams.
      std::fill(binnings.back().offset.begin(), binnings.back().offset.end(), 0.0);
    }
    for (const Output& output : outputs) {
      std::vector<double> shares;
      for (const Binning& binning : binnings)
        shares.push_back(binned_share(binning, output.values, equal));
      if (shares.empty() || !stands_out(shares, basis.runs.size())) continue;
      list.push_back({{"input", input.key},
                      {"name", plain_name(input.key)},
                      {"output", output.name},
                      {"shares", shares}});
    }
  }
  return list;
}

/// Whose scatter the shares are of.
std::string variance_of(const StudyData& runs) {
  const bool mixed = std::ranges::any_of(runs.candidate, [](auto k) { return k >= 0; });
  const char* drawn = mixed ? "their tolerances drawn from all candidates" : "drawn by their laws";
  return fmt::format("one run of each of {} cages, {}", runs.size(),
                     rows_follow_laws(runs) ? drawn : "at levels that the design sets");
}

}  // namespace

Json contributors_json(const ReportBasis& basis) {
  const bool told = basis.runs.size() >= kMinimumEffectiveRuns;
  const auto features = told ? cage_features(basis.runs) : std::vector<Feature>();
  const auto outputs = outputs_of(basis);
  std::vector<Binning> binnings;
  Json feature_list = Json::array();
  for (const Feature& feature : features) {
    binnings.push_back(make_binning(feature.values, 0, basis.resampling.lot_of()));
    feature_list.push_back({{"name", feature.name},
                            {"input", feature.input},
                            {"unit", feature.unit},
                            {"definition", feature.definition}});
  }
  Json matrix = Json::array();
  for (const Output& output : outputs) {
    Json shares = Json::array();
    std::size_t top = 0;
    double largest = -1;
    for (std::size_t f = 0; f < features.size(); ++f) {
      const Estimate share =
          binned_share_estimate(binnings[f], output.values, basis.resampling, basis.confidence);
      Json entry = to_json(share);
      entry["feature"] = features[f].name;
      shares.push_back(std::move(entry));
      if (share.value > largest) largest = share.value, top = f;
    }
    Json entry{{"output", output.name},
               {"unit", output.unit},
               {"definition", output.definition},
               {"shares", shares},
               {"not_explained", to_json(unexplained_share(features, output.values,
                                                           basis.resampling, basis.confidence))}};
    if (!features.empty())
      entry["response"] = {
          {"feature", features[top].name},
          {"unit", features[top].unit},
          {"points", response_json(features[top], output, basis.resampling.lot_of())}};
    matrix.push_back(std::move(entry));
  }
  return {{"features", feature_list},
          {"variance_of", variance_of(basis.runs)},
          {"outputs", matrix},
          {"pockets", pockets_json(basis, outputs)}};
}

}  // namespace cagetol
