#include "mc/study/map_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <regex>
#include <set>

#include "mc/study/operating_points.hpp"
#include "src/quantities/quantity_labels.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

constexpr long kMostValues = 40;
constexpr const char* kNumber = R"(([-+]?\d+\.?\d*(?:[eE][-+]?\d+)?))";

/// Of "A..B:N[:log]" or "A,B,C"; empty where it is neither.
std::vector<double> axis_values(const std::string& text, bool& logarithmic) {
  static const std::regex range(fmt::format(R"({0}\.\.{0}:(\d{{1,9}})(:log)?)", kNumber)),
      list(fmt::format("(?:{0},)+{0}", kNumber)), number(kNumber);
  std::smatch found;
  std::vector<double> values;
  if (std::regex_match(text, list))
    for (std::sregex_iterator next(text.begin(), text.end(), number), end; next != end; ++next)
      values.push_back(std::stod(next->str()));
  logarithmic = !values.empty() && values.front() > 0 && values.back() > 10 * values.front();
  if (!std::regex_match(text, found, range)) return values;
  const double first = std::stod(found[1]), last = std::stod(found[2]);
  const long count = std::min(std::stol(found[3]), kMostValues + 1);
  logarithmic = found[4].matched;
  for (long i = 0; i < count; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(count - 1),
                 value = logarithmic ? first * std::pow(last / first, part)
                                     : first + part * (last - first);
    const bool at_end = i == 0 || i == count - 1;
    values.push_back(at_end ? (i == 0 ? first : last)
                            : std::strtod(fmt::format("{:.4g}", value).c_str(), nullptr));
  }
  return values;
}

/// Points that are the same are the first of them; one alone is no point but the scene's own
/// operation.
void merge_points(Study& study) {
  std::vector<OperatingPointPlan> points;
  for (const OperatingPointPlan& point : study.points) {
    const auto same = std::ranges::find(points, point.settings, &OperatingPointPlan::settings);
    if (same == points.end()) {
      points.push_back(point);
      continue;
    }
    for (Limit& limit : study.limits)
      if (const auto [key, label] = labelled_key(limit.quantity); label == point.name)
        limit.quantity = labelled_name(key, same->name);
  }
  if (points.size() == 1 && study.scene.phase.name.empty()) {
    study.scene = at_operating_point(study.scene, points[0]);
    points.clear();
    for (Limit& limit : study.limits) limit.quantity = labelled_key(limit.quantity).key;
  }
  study.points = points;
  std::set<std::tuple<std::string, std::optional<double>, std::optional<double>>> seen;
  std::erase_if(study.limits, [&](const Limit& limit) {
    return !seen.emplace(limit.quantity, limit.minimum, limit.maximum).second;
  });
}

}  // namespace

MapAxis read_map_axis(const std::string& text, const Study& study) {
  const auto wrong = [&](const std::string& problem) {
    return InputError({}, "--over", text, problem,
                      "write it as --over load.radial_N=100..10000:6:log, speed.inner_rpm="
                      "1000..14000:6 or speed.inner_rpm=1000,3000,9000");
  };
  MapAxis axis{text.substr(0, text.find('=')), false, {}};
  axis.values =
      axis_values(text.substr(std::min(axis.key.size() + 1, text.size())), axis.logarithmic);
  if (axis.key.starts_with("scene.")) axis.key.erase(0, 6);
  if (axis.values.size() < 2) throw wrong("this is no key with two or more values");
  if (axis.values.size() > kMostValues)
    throw wrong(fmt::format("more than {} values", kMostValues));
  if (axis.logarithmic && axis.values.front() <= 0)
    throw wrong("logarithms are of numbers above 0");
  if (std::ranges::adjacent_find(axis.values, std::greater_equal<>()) != axis.values.end())
    throw wrong("the values do not ascend");
  for (const double value : axis.values) {
    read_operating_point(toml::table{{"name", "cell"}, {axis.key, value}}, "--over", study);
    const auto* key = find_key(scene_keys(), axis.key);
    if (key == nullptr || key->kind != KeyKind::number)
      throw wrong("this key does not hold one number");
  }
  return axis;
}

Study study_at(const Study& study, const std::vector<MapAxis>& axes,
               const std::vector<double>& values) {
  return changed_study(study, [&](Study& cell) {
    forget_temperatures(cell);
    for (std::size_t d = 0; d < axes.size(); ++d) {
      set_key_numbers(*find_key(scene_keys(), axes[d].key), {values[d]}, cell.scene);
      for (OperatingPointPlan& point : cell.points)
        std::erase_if(point.settings, [&](const auto& of) { return of.first == axes[d].key; });
    }
    for (Limit& limit : cell.limits)
      if (limit.minimum_loads) limit.maximum.reset();
    merge_points(cell);
  });
}

}  // namespace cagetol
