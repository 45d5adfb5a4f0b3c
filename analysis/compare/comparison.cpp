#include "analysis/compare/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "analysis/compare/change_tests.hpp"
#include "analysis/compare/holm.hpp"
#include "analysis/compare/permutation_test.hpp"
#include "analysis/statistics/order_statistics.hpp"
#include "analysis/statistics/paired_share.hpp"
#include "analysis/statistics/summary.hpp"
#include "analysis/study/judgement.hpp"
#include "analysis/study/refused.hpp"
#include "distributions/basics/random_stream.hpp"

namespace cagetol {
namespace {

constexpr double kLevels[] = {0.05, 0.50, 0.95};
constexpr std::size_t kFewRuns = 32;  ///< below it Student's t is wrong for a mean of heavy tails

/// Parts of a study that may differ: they say how much is run, not what.
const std::set<std::string> kFree = {"name",
                                     "seed",
                                     "samples",
                                     "extra_replicates",
                                     "allowed_failure_share",
                                     "scrambles",
                                     "recommend",
                                     "screen",
                                     "map",
                                     "rare",
                                     "document"};
/// Of a statistic, relative: what rounding of another order of sums may move it by.
constexpr double kRounding = 1e-9;

void collect_differences(const nlohmann::ordered_json& a, const nlohmann::ordered_json& b,
                         const std::string& path, std::vector<std::string>& differences,
                         std::vector<std::string>& notes) {
  if (a.is_object() && b.is_object()) {
    std::set<std::string> keys;
    for (const auto& [key, value] : a.items()) keys.insert(key);
    for (const auto& [key, value] : b.items()) keys.insert(key);
    for (const std::string& key : keys) {
      if (path.empty() && kFree.contains(key)) continue;
      const std::string below = path.empty() ? key : path + "." + key;
      if (below == "scene.name") continue;
      if (a.contains(key) && b.contains(key))
        collect_differences(a.at(key), b.at(key), below, differences, notes);
      else
        notes.push_back(below + " is a key of only one of the two");
    }
    return;
  }
  if (a == b) return;
  if (a.is_array() && b.is_array() && a.size() == b.size() && a[0].is_object()) {
    for (std::size_t i = 0; i < a.size(); ++i)
      collect_differences(a[i], b[i],
                          fmt::format("{}[{}]", path, a[i].value("key", std::to_string(i))),
                          differences, notes);
    return;
  }
  const auto shown = [](const nlohmann::ordered_json& value) {
    std::string text = value.dump();
    return text.size() > 60 ? text.substr(0, 57) + "..." : text;
  };
  differences.push_back(fmt::format("{}: {} and {}", path, shown(a), shown(b)));
}

/// The runs of one study that are compared, and the clusters they come in.
struct Runs {
  StudyData data;
  std::vector<std::int64_t> cluster;
};

Runs runs_of(const StudyData& study, const char* which) {
  Runs runs{select_samples(study, first_runs(study)), {}};
  if (runs.data.size() < 2)
    throw Refused(fmt::format("the {} study has fewer than two runs", which));
  runs.cluster = runs.data.lot;
  return runs;
}

/// The mean. Runs without a value do not enter.
Linearised linearised(const Runs& runs, const std::vector<double>& values) {
  const double mean = weighted_mean(values, std::vector<double>(values.size(), 1.0));
  const auto defined = static_cast<double>(
      std::count_if(values.begin(), values.end(), [](double y) { return !std::isnan(y); }));
  Linearised result{mean, runs.cluster, std::vector<double>(values.size(), 0.0)};
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isnan(values[i])) result.influence[i] = (values[i] - mean) / defined;
  return result;
}

std::vector<double> joined(std::vector<double> values, const std::vector<double>& others) {
  values.insert(values.end(), others.begin(), others.end());
  return values;
}

double median_of(const std::vector<double>& values) {
  return weighted_quantile(values, ascending_order(values), std::vector<double>(values.size(), 1.0),
                           0.5);
}

/// Distances from a middle: a wider scatter makes their mean larger.
std::vector<double> distances(const std::vector<double>& values, double middle) {
  std::vector<double> result;
  for (const double y : values) result.push_back(std::abs(y - middle));
  return result;
}

/// Whether half of all runs or more have one and the same value: a variance says little then.
bool hardly_varies(const std::vector<double>& before, const std::vector<double>& after) {
  std::map<double, std::size_t> count;
  std::size_t defined = 0, most = 0;
  for (const auto* values : {&before, &after})
    for (const double y : *values)
      if (!std::isnan(y)) ++defined, most = std::max(most, ++count[y]);
  return 2 * most >= defined;
}

class Comparer {
 public:
  Comparer(Runs before, Runs after, Comparison& result)
      : before_(std::move(before)), after_(std::move(after)), result_(result) {
    const auto alone = [](const Runs& runs) {
      const std::set<std::int64_t> labels(runs.cluster.begin(), runs.cluster.end());
      return labels.size() == runs.cluster.size();
    };
    exact_ = alone(before_) && alone(after_);
    const auto clusters = [](const Runs& runs) {
      return std::set<std::int64_t>(runs.cluster.begin(), runs.cluster.end()).size();
    };
    // Few clusters can be dealt out in so few ways that no change would ever be seen. They are
    // means of many runs, close to normal.
    constexpr std::size_t few = 20;
    permuted_ = exact_ || std::min(clusters(before_), clusters(after_)) >= few;
  }

  void compare_quantity(const Column& column);
  void compare_outcomes();

 private:
  /// -1 where the run does not enter, otherwise whether it has the property.
  using Property = std::vector<int>;

  void add(const std::string& quantity, const std::string& unit, const std::string& statistic,
           double before, double after, double p_value);
  double mean_p_value(const std::vector<double>& before, const std::vector<double>& after,
                      const std::string& what, bool permuted) const;
  double share_p_value(const Property& before, const Property& after) const;
  void add_share(const std::string& quantity, const std::string& statistic, const Property& before,
                 const Property& after);

  Runs before_, after_;
  Comparison& result_;
  bool exact_ = false;     ///< every run is independent of the others
  bool permuted_ = false;  ///< enough clusters for a permutation test
};

void Comparer::add(const std::string& quantity, const std::string& unit,
                   const std::string& statistic, double before, double after, double p_value) {
  result_.statistics.push_back({quantity, unit, statistic, before, after, p_value, 1, false});
}

/// `what` chooses the draws of a permutation test, with the seed of the study.
double Comparer::mean_p_value(const std::vector<double>& before, const std::vector<double>& after,
                              const std::string& what, bool permuted) const {
  if (!permuted)
    return change_p_value(linearised(before_, before), linearised(after_, after), result_.paired);
  const std::uint64_t seed =
      static_cast<std::uint64_t>(before_.data.provenance.seed) << 32 | stream_address(what);
  return permutation_p_value({before_.cluster, before}, {after_.cluster, after}, result_.paired,
                             seed);
}

double Comparer::share_p_value(const Property& before, const Property& after) const {
  if (!exact_) {
    const auto values = [](const Property& property) {
      std::vector<double> numbers;
      for (const int has : property) numbers.push_back(has < 0 ? kUndefined : has);
      return numbers;
    };
    return change_p_value(linearised(before_, values(before)), linearised(after_, values(after)),
                          result_.paired);
  }
  if (!result_.paired) {
    const auto share = [](const Property& property) {
      Share counted;
      for (const int has : property) counted.runs += has >= 0, counted.count += has > 0;
      return counted;
    };
    return fisher_p_value(share(before), share(after));
  }
  std::map<std::int64_t, int> earlier;
  for (std::size_t i = 0; i < before.size(); ++i) earlier[before_.data.row[i]] = before[i];
  std::size_t gained = 0, lost = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    const auto found = earlier.find(after_.data.row[i]);
    if (found == earlier.end() || found->second < 0 || after[i] < 0) continue;
    gained += after[i] > found->second;
    lost += after[i] < found->second;
  }
  return mcnemar_p_value(gained, lost);
}

void Comparer::add_share(const std::string& quantity, const std::string& statistic,
                         const Property& before, const Property& after) {
  const auto share = [](const Property& property) {
    double count = 0, runs = 0;
    for (const int has : property) runs += has >= 0, count += has > 0;
    return runs > 0 ? count / runs : kUndefined;
  };
  add(quantity, "-", statistic, share(before), share(after), share_p_value(before, after));
}

void Comparer::compare_quantity(const Column& column) {
  const std::vector<double>& old_values = column.values;
  const std::vector<double>& new_values = find_quantity(after_.data, column.name)->values;
  const auto old_order = ascending_order(old_values), new_order = ascending_order(new_values);
  if (old_order.size() < 2 || new_order.size() < 2) return;
  const std::vector<double> old_ones(old_values.size(), 1.0), new_ones(new_values.size(), 1.0);
  const std::vector<double> both = joined(old_values, new_values);
  // One middle for both: only so are the distances exchangeable where nothing has changed.
  const double middle = median_of(both);
  add(column.name, column.unit, "mean", weighted_mean(old_values, old_ones),
      weighted_mean(new_values, new_ones),
      mean_p_value(old_values, new_values, column.name + " mean",
                   permuted_ && (hardly_varies(old_values, new_values) ||
                                 std::min(old_order.size(), new_order.size()) < kFewRuns)));
  add(column.name, column.unit, "standard deviation",
      weighted_standard_deviation(old_values, old_ones),
      weighted_standard_deviation(new_values, new_ones),
      mean_p_value(distances(old_values, middle), distances(new_values, middle),
                   column.name + " scatter", permuted_));
  const auto order = ascending_order(both);
  const std::vector<double> ones(both.size(), 1.0);
  for (const double level : kLevels) {
    const double border = weighted_quantile(both, order, ones, level);
    const auto beyond = [&](const std::vector<double>& values) {
      Property property;
      for (const double y : values) property.push_back(std::isnan(y) ? -1 : y > border);
      return property;
    };
    add(column.name, column.unit, fmt::format("{:g} % quantile", 100 * level),
        weighted_quantile(old_values, old_order, old_ones, level),
        weighted_quantile(new_values, new_order, new_ones, level),
        share_p_value(beyond(old_values), beyond(new_values)));
  }
}

void Comparer::compare_outcomes() {
  const auto meets = [](const std::vector<Judgement>& judgements) {
    Property property;
    for (const Judgement judgement : judgements) property.push_back(judgement == Judgement::meets);
    return property;
  };
  if (!before_.data.plan.limits.empty())
    add_share("all limits", "yield", meets(judge_all(before_.data)), meets(judge_all(after_.data)));
  for (const Limit& limit : before_.data.plan.limits)
    add_share(limit.quantity, "yield of its limit", meets(judge(before_.data, limit)),
              meets(judge(after_.data, limit)));
  const auto with_status = [](const StudyData& data, bool jams) {
    Property property;
    for (const RunStatus status : data.status)
      property.push_back(jams ? status == RunStatus::jammed
                              : status != RunStatus::ok && status != RunStatus::jammed);
    return property;
  };
  add_share("outcome", "share of jams", with_status(before_.data, true),
            with_status(after_.data, true));
  add_share("outcome", "share without result", with_status(before_.data, false),
            with_status(after_.data, false));
}

}  // namespace

nlohmann::ordered_json to_json(const StatisticChange& change) {
  return {{"quantity", change.quantity},
          {"unit", change.unit},
          {"statistic", change.statistic},
          {"old", change.before},
          {"new", change.after},
          {"p_value", change.p_value},
          {"adjusted_p_value", change.adjusted_p_value},
          {"changed", change.changed}};
}

void require_comparable(const StudyData& before, const StudyData& after, bool despite_keys,
                        std::vector<std::string>& notes) {
  std::vector<std::string> differences;
  collect_differences(before.plan.whole, after.plan.whole, "", differences, notes);
  if (despite_keys) {
    notes.insert(notes.end(), differences.begin(), differences.end());
  } else if (!differences.empty()) {
    std::string text = "these are not runs of one study:";
    for (std::size_t i = 0; i < std::min<std::size_t>(differences.size(), 8); ++i)
      text += "\n  " + differences[i];
    if (differences.size() > 8) text += fmt::format("\n  and {} more", differences.size() - 8);
    throw Refused(text + "\n  remedy: --despite-keys compares them all the same");
  }
  const std::string& design = before.design.kind;
  if (design != "random" && design != "lhs")
    throw Refused("the rows of a `" + design +
                  "` design have no random scatter to compare a change with");
  for (const Column& column : before.quantities)
    if (const Column* other = find_quantity(after, column.name);
        other != nullptr && other->unit != column.unit)
      throw Refused(fmt::format("{} is in {} in one and in {} in the other", column.name,
                                column.unit, other->unit));
}

bool same_cages(const StudyData& before, const StudyData& after) {
  return before.provenance.seed == after.provenance.seed &&
         before.design.rows_planned == after.design.rows_planned;
}

bool Comparison::same() const {
  return std::none_of(statistics.begin(), statistics.end(),
                      [](const StatisticChange& change) { return change.changed; });
}

Comparison compare_studies(const StudyData& before, const StudyData& after, double error_rate,
                           bool despite_keys) {
  Comparison result;
  result.error_rate = error_rate;
  require_comparable(before, after, despite_keys, result.notes);
  result.paired = same_cages(before, after);
  Runs old_runs = runs_of(before, "old"), new_runs = runs_of(after, "new");
  const std::vector<Column> quantities = old_runs.data.quantities;
  Comparer comparer(std::move(old_runs), std::move(new_runs), result);
  for (const Column& column : quantities) {
    if (find_quantity(after, column.name) != nullptr)
      comparer.compare_quantity(column);
    else
      result.notes.push_back(column.name + " is a quantity of only one of the two");
  }
  comparer.compare_outcomes();
  std::vector<double> p_values;
  for (const StatisticChange& change : result.statistics) p_values.push_back(change.p_value);
  const auto adjusted = holm_adjusted(p_values);
  for (std::size_t i = 0; i < adjusted.size(); ++i) {
    StatisticChange& change = result.statistics[i];
    change.adjusted_p_value = adjusted[i];
    const double moved = std::abs(change.after - change.before);
    change.changed =
        adjusted[i] <= error_rate &&
        !(moved <= kRounding * std::max(std::abs(change.after), std::abs(change.before)));
  }
  std::stable_sort(
      result.statistics.begin(), result.statistics.end(),
      [](const StatisticChange& a, const StatisticChange& b) { return a.p_value < b.p_value; });
  return result;
}

}  // namespace cagetol
