#include "analysis/sensitivity/features.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

namespace cagetol {
namespace {

/// The load presses the inner ring along -z: the loaded rollers sit at 270 degrees, counted from y
/// towards z.
constexpr double kLoadZone_deg = 270;

bool varies(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(),
                     [&](double value) { return value != values.front(); });
}

/// Angle by which each sample's cage is turned at the start [deg].
std::vector<double> start_phase_deg(const StudyData& study) {
  const InputColumns* phase = find_input(study, "start.cage_phase_deg");
  if (phase != nullptr && !phase->per_pocket) return phase->value;
  double fixed = 0;
  const auto& scene = study.plan.scene;
  if (scene.contains("start") && scene.at("start").contains("cage_phase_deg") &&
      scene.at("start").at("cage_phase_deg").is_number())
    fixed = scene.at("start").at("cage_phase_deg").get<double>();
  return std::vector<double>(study.size(), fixed);
}

std::size_t load_zone_pocket(double phase_deg, std::size_t pockets) {
  const double pitch = 360.0 / static_cast<double>(pockets);
  const double steps = std::round((kLoadZone_deg - phase_deg) / pitch);
  const double turn = static_cast<double>(pockets);
  return static_cast<std::size_t>(steps - turn * std::floor(steps / turn)) % pockets;
}

double scatter(std::span<const double> values) {
  double mean = 0, square = 0;
  const auto count = static_cast<double>(values.size());
  for (const double value : values) mean += value / count;
  for (const double value : values) square += (value - mean) * (value - mean);
  return std::sqrt(square / std::max(count - 1, 1.0));
}

double largest_magnitude(std::span<const double> values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

void add_pocket_features(const StudyData& study, const InputColumns& input,
                         std::vector<Feature>& features) {
  const std::string plain = plain_name(input.key);
  const std::size_t width = study.pockets;
  const auto add = [&](const std::string& name, const std::string& definition,
                       const auto& of_cage) {
    Feature feature{input.key, plain + ": " + name, definition, input.unit, {}};
    for (std::size_t i = 0; i < study.size(); ++i)
      feature.values.push_back(of_cage(i, std::span(input.value).subspan(i * width, width)));
    if (varies(feature.values)) features.push_back(std::move(feature));
  };
  add("within-cage scatter",
      fmt::format("standard deviation of the {} over the pockets of one cage", plain),
      [](std::size_t, std::span<const double> cage) { return scatter(cage); });
  const bool around_zero = std::all_of(input.nominal.begin(), input.nominal.end(),
                                       [](double nominal) { return nominal == 0; });
  if (around_zero)
    add("largest deviation", fmt::format("largest {} of the cage's pockets, in magnitude", plain),
        [](std::size_t, std::span<const double> cage) { return largest_magnitude(cage); });
  else
    add("smallest pocket", fmt::format("smallest {} of the cage's pockets", plain),
        [](std::size_t, std::span<const double> cage) {
          return *std::min_element(cage.begin(), cage.end());
        });
  const auto phase = start_phase_deg(study);
  add("pocket in load zone",
      fmt::format("{} of the pocket that is nearest to the load when the run starts", plain),
      [&](std::size_t i, std::span<const double> cage) {
        return cage[load_zone_pocket(phase[i], width)];
      });
}

}  // namespace

std::string plain_name(const std::string& key) {
  static const std::set<std::string> units = {"mm",  "um",  "mrad", "deg", "N", "rpm", "Nmm",
                                              "MPa", "GPa", "s",    "kg",  "m", "C",   "s2"};
  const std::size_t dot = key.rfind('.');
  std::string name = dot == std::string::npos ? key : key.substr(dot + 1);
  for (std::size_t last = name.rfind('_');
       last != std::string::npos && units.count(name.substr(last + 1)) > 0; last = name.rfind('_'))
    name.resize(last);
  const std::string section = dot == std::string::npos ? "" : key.substr(0, dot);
  const bool of_pocket = section == "cage" && name.starts_with("pocket_");
  if (section == "load")
    name += " load";
  else if (!section.empty() && !of_pocket)
    name = section + " " + name;
  for (const char mark : {'_', '.'}) std::replace(name.begin(), name.end(), mark, ' ');
  return name;
}

std::vector<Feature> cage_features(const StudyData& study) {
  std::vector<Feature> features;
  const bool one_cage = study.plan.cages_per_lot == 1;
  for (const InputColumns& input : study.inputs) {
    const std::string plain = plain_name(input.key);
    if (!input.lot.empty() && varies(input.lot))
      features.push_back({input.key,
                          plain + (one_cage ? ": from cage to cage" : ": from lot to lot"),
                          fmt::format("deviation of the {} shared by the whole {}", plain,
                                      one_cage ? "cage" : "lot"),
                          input.unit, input.lot});
    if (input.per_pocket && !input.pocket.empty()) add_pocket_features(study, input, features);
    if (!input.noise.empty() && varies(input.noise))
      features.push_back({input.key, plain, fmt::format("{}, drawn for each run", plain),
                          input.unit, input.noise});
  }
  return features;
}

std::vector<Feature> pocket_features(const StudyData& study, const InputColumns& input) {
  std::vector<Feature> features;
  if (!input.per_pocket || input.pocket.empty()) return features;
  for (std::size_t j = 0; j < study.pockets; ++j) {
    Feature feature{input.key,
                    fmt::format("{}: pocket {}", plain_name(input.key), j),
                    "deviation of this pocket from the rest of the cage",
                    input.unit,
                    {}};
    for (std::size_t i = 0; i < study.size(); ++i)
      feature.values.push_back(input.pocket[i * study.pockets + j]);
    features.push_back(std::move(feature));
  }
  return features;
}

}  // namespace cagetol
