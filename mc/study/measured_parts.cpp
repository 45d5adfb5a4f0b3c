#include "mc/study/measured_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "distributions/variance_parts.hpp"
#include "mc/host/build_info.hpp"
#include "src/input/measurement_csv.hpp"

namespace cagetol {
namespace {

/// Robust standard deviations from the median of its cage: one in 150,000 normal parts is as far.
constexpr double kOutlier = 4.5;
constexpr double kSigmaOverMedian = 1.4826;

double median(const std::vector<double>& values) {
  return quantile(make_empirical(values), 0.5);
}

void check_groups(const MeasuredParts& parts, const MeasuredColumn& column, const std::string& path,
                  const std::string& key) {
  const bool of_pockets = key.ends_with(".pocket");
  if (!of_pockets && parts.is_grouped())
    throw InputError({}, key + ".group", parts.group, "only a law of pockets has groups",
                     "use the scope pocket, or take group out");
  if (of_pockets && !parts.ungrouped && !parts.is_grouped() && !column.label_columns.empty())
    throw InputError(
        {path, 0}, key, "",
        fmt::format("columns may say which parts are of one cage ({}): its pockets are "
                    "alike, and drawn one by one all cages would be near the mean",
                    fmt::join(column.label_columns, ", ")),
        "add group = \"" + column.label_columns[0] +
            "\" or another one, or group = false if parts share nothing");
}

/// Cages, gaps, and remarks on lines that are left out.
void sort_parts(const MeasuredColumn& column, MeasuredParts& parts) {
  for (std::size_t i = 0; i < column.lines.size(); ++i) {
    const std::string name = parts.is_grouped() ? column.labels[i] : "";
    const auto cage = std::ranges::find(parts.names, name) - parts.names.begin();
    if (cage == std::ssize(parts.names)) parts.names.push_back(name);
    parts.cage.values.push_back(static_cast<double>(cage));
    const bool gap =
        std::isnan(column.values[i]) || std::ranges::count(parts.exclude, column.lines[i]) > 0;
    parts.values.values.push_back(gap ? 0 : column.values[i]);
    if (!gap) continue;
    parts.gaps.values.push_back(static_cast<double>(i));
    parts.remarks.push_back(fmt::format("line {} is left out", column.lines[i]));
  }
}

void check_sizes(const MeasuredParts& parts, const std::vector<int>& lines, const std::string& path,
                 const std::string& key, std::size_t pockets) {
  const auto cages = parts.by_cage();
  for (std::size_t c = 0; parts.is_grouped() && !parts.resample && c < cages.size(); ++c)
    if (pockets > 0 && cages[c].size() != pockets)
      throw InputError(
          {path, lines[std::ranges::find(parts.cage.values, static_cast<double>(c)) -
                       parts.cage.values.begin()]},
          key + ".group", parts.names[c],
          fmt::format("{} parts are of this cage, but that of the scene has {} pockets",
                      cages[c].size(), pockets),
          "leave one line for each pocket, or give resample = true beside file: another number of "
          "pockets is then drawn from each cage");
}

std::vector<double> known_of(std::vector<double> values) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  return values;
}

std::vector<double> known_parts(const MeasuredParts& parts) {
  std::vector<double> all;
  for (const auto& cage : parts.by_cage()) all.insert(all.end(), cage.begin(), cage.end());
  return known_of(all);
}

void remark_outliers(const std::vector<int>& lines, MeasuredParts& parts) {
  std::vector<double> distances, medians;
  for (const auto& cage : parts.by_cage()) medians.push_back(median(known_of(cage)));
  for (std::size_t i = 0; i < lines.size(); ++i)
    distances.push_back(
        std::abs(parts.values[i] - medians[static_cast<std::size_t>(parts.cage[i])]));
  for (const double gap : parts.gaps.values) distances[static_cast<std::size_t>(gap)] = NAN;
  const double sigma = kSigmaOverMedian * median(known_of(distances));
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (sigma > 0 && distances[i] > kOutlier * sigma)
      parts.remarks.push_back(
          fmt::format("line {} is an outlier, {:.0f} standard deviations from "
                      "the median of its cage; it is kept unless exclude = [{}]",
                      lines[i], distances[i] / sigma, lines[i]));
}

}  // namespace

const KeyTable<MeasuredParts>& measured_keys() {
#define AT(member)                     \
  [](MeasuredParts & parts) -> auto& { \
    return parts.member;               \
  }
  static const KeyTable<MeasuredParts> keys = {
      {"file", any_value(), AT(file), "CSV file"},
      {"hash", any_value(), AT(hash), "of its bytes"},
      {"column", any_value(), AT(column), "column measured"},
      {"group", any_value(), AT(group), "column of cages"},
      {"fitted", any_value(), AT(fitted), "normal laws are fitted"},
      {"centred", any_value(), AT(centred), "the mean is subtracted"},
      {"offset", any_value(), AT(offset), "mean deviation as measured"},
      {"names", any_value(), AT(names), "of the cages"},
      {"values", any_value(), AT(values), "deviations"},
      {"cage", at_least(0), AT(cage), "of each"},
      {"gaps", at_least(0), AT(gaps), "parts without a value"},
      {"remarks", any_value(), AT(remarks), "on single lines"},
  };
#undef AT
  return keys;
}

std::vector<std::vector<double>> MeasuredParts::by_cage() const {
  std::vector<std::vector<double>> cages(names.size());
  bool sound = values.size() == cage.size() && values.size() > gaps.size() + 1;
  for (std::size_t i = 0; i < values.size() && sound; ++i)
    if (sound = cage[i] < static_cast<double>(cages.size()); sound)
      cages[static_cast<std::size_t>(cage[i])].push_back(
          std::ranges::count(gaps.values, static_cast<double>(i)) > 0 ? NAN : values[i]);
  for (const auto& of : cages) sound = sound && !known_of(of).empty();
  if (sound) return cages;
  throw InputError({}, file, "", "a cage has no measured value, or there is one in all",
                   "measure more, or remove the lines of the cage");
}

bool MeasuredKey::is_size(double value) const {
  return nominal != 0 && std::abs(value - nominal) <= 0.2 * std::abs(nominal);
}

MeasuredParts read_measured_parts(const std::string& bytes, const std::string& path,
                                  const StatedFile& stated, const std::string& key,
                                  const std::string& unit, const MeasuredKey& of) {
  MeasuredParts parts;
  static_cast<StatedFile&>(parts) = stated;
  parts.hash = text_hash(bytes);
  const MeasuredColumn column = measured_column(
      bytes, path,
      {parts.column, unit, parts.decimal == ",", parts.missing == "skip", parts.group});
  check_groups(parts, column, path, key);
  for (const double line : parts.exclude)
    if (std::ranges::count(column.lines, line) == 0)
      throw InputError({path, static_cast<int>(line)}, key + ".exclude", number_text(line),
                       "this line holds no part", "give numbers of lines as an editor counts them");
  sort_parts(column, parts);
  check_sizes(parts, column.lines, path, key, of.pockets);
  if (parts.is_grouped() && parts.names.size() < kFewGroups)
    parts.remarks.push_back("fewer than 10 cages say little of how cages differ");
  const std::vector<double> known = known_parts(parts);
  const double from = of.is_size(median(known)) ? of.nominal : 0;
  parts.offset = mean(Empirical{known}) - from;
  for (double& value : parts.values.values) value -= from + (parts.centred ? parts.offset : 0);
  remark_outliers(column.lines, parts);
  return parts;
}

MeasuredLaws laws_of(const MeasuredParts& parts) {
  const auto cages = parts.by_cage();
  const PartsProcess process = variance_parts(cages).estimate;
  if (parts.fitted)
    return {Normal{process.mean, process.group_sigma},
            Normal{parts.is_grouped() ? 0 : process.mean, process.own_sigma}};
  std::vector<double> means, own;
  for (std::size_t c = 0; c < cages.size(); ++c) {
    const std::vector<double> cage = cage_at(cages, static_cast<double>(c), cages[c].size());
    means.push_back(mean(Empirical{cage}));
    for (const double value : cage) own.push_back(value - means.back());
  }
  return {make_empirical(means), make_empirical(parts.is_grouped() ? own : known_parts(parts))};
}

std::vector<double> cage_at(const std::vector<std::vector<double>>& cages, double place,
                            std::size_t pockets) {
  const double index = std::min(std::floor(place), static_cast<double>(cages.size() - 1));
  const auto& cage = cages[static_cast<std::size_t>(index)];
  const double turned = (place - index) * static_cast<double>(cage.size());
  std::size_t at = cage.size() == pockets ? 0 : static_cast<std::size_t>(turned);
  std::vector<double> values;
  for (std::size_t j = 0; j < pockets; ++j, ++at) {
    std::size_t next = at;
    while (std::isnan(cage[next % cage.size()])) ++next;
    values.push_back(cage[next % cage.size()]);
  }
  return values;
}

std::vector<std::string> measured_notes(const MeasuredParts& parts, const std::string& key,
                                        const std::string& unit) {
  std::vector<std::string> notes = {
      fmt::format("{} parts{} were measured; their mean deviation, {:+.4g} {}, is {}",
                  parts.values.size() - parts.gaps.size(),
                  parts.is_grouped() ? fmt::format(" of {} cages", parts.names.size()) : "",
                  parts.offset, unit, parts.centred ? "subtracted" : "kept")};
  notes.insert(notes.end(), parts.remarks.begin(), parts.remarks.end());
  for (std::string& note : notes) note = key + ": " + parts.file + ": " + note;
  return notes;
}

}  // namespace cagetol
