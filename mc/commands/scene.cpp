// cagetol scene DESIGNATION: writes the scene of a catalogue bearing; --list prints the table.
#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "mc/commands/command.hpp"
#include "src/catalogue/bearing_scene.hpp"
#include "src/input/input_error.hpp"
#include "src/input/unit.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

/// Texts of the command line, parsed by request_of().
struct Options {
  std::vector<std::string> designation;
  std::string make, guidance, clearance = spelled(ClearanceClass::CN);
  std::optional<std::string> lubricant;
  std::optional<double> temperature, load, axial, rpm;
  bool rigid = false, list = false;

  std::string name() const {
    std::string joined;
    for (const std::string& word : designation) joined += (joined.empty() ? "" : " ") + word;
    return joined;
  }
};

SceneRequest request_of(const Options& options) {
  SceneRequest request;
  request.designation = options.name();
  if (!options.make.empty()) request.make = choice_of<CageMake>(options.make);
  if (!options.guidance.empty()) request.guidance = choice_of<Guidance>(options.guidance);
  request.clearance = choice_of<ClearanceClass>(options.clearance);
  request.lubricant = options.lubricant;
  request.temperature = options.temperature;
  request.load = options.load;
  request.axial = options.axial;
  if (options.rpm) request.speed = *options.rpm * kRpm;
  if (options.rigid) request.model = CageKind::rigid;
  return request;
}

std::string in_mm_or_dash(double length) {
  return std::isnan(length) ? "-" : fmt::format("{:g}", std::round(1e6 * length) / 1e3);
}

std::string list_line(const CatalogueRow& row) {
  const CageMake make = usual_make(row.designation);
  const RatedSet set = designed_bearing(row, make, cage_rule(make).guidance).set;
  return fmt::format(
      "{:<13}{:>4} {:>4} {:>4} {:>6} {:>6} {:>6g} {:>6g} {:>6.0f}   {:>2} x {:>4} x {:<5} "
      "{:>+5.1f} "
      "{:>+5.1f}   {}\n",
      row.designation, in_mm_or_dash(row.bore), in_mm_or_dash(row.outside),
      in_mm_or_dash(row.width), in_mm_or_dash(row.inner_raceway), in_mm_or_dash(row.outer_raceway),
      1e-3 * row.dynamic_rating, 1e-3 * row.static_rating, row.limiting_speed / kRpm,
      set.rollers.count, in_mm_or_dash(set.rollers.diameter), in_mm_or_dash(set.rollers.length),
      100 * set.dynamic_error, 100 * set.static_error, spelled(make));
}

/// Dimensions in mm, ratings in kN, the rollers derived from them, in how far they miss C and C0.
std::string listing(const std::string& part) {
  const auto rows = matching_rows(part);
  if (rows.empty()) catalogue_row(part);  // throws, with near ones
  std::string text =
      fmt::format("{:<13}{:>4} {:>4} {:>4} {:>6} {:>6} {:>6} {:>6} {:>6}   {}\n", "", "d", "D", "B",
                  "F", "E", "C/kN", "C0/kN", "n_lim", "Z x D_we x L_we  C/%  C0/%   cage");
  for (const CatalogueRow* row : rows) text += list_line(*row);
  return text;
}

int run_scene(const Options& options) {
  if (options.list) {
    print(listing(options.name()));
    return kDone;
  }
  if (options.designation.empty())
    throw InputError({}, "DESIGNATION", "", "no bearing is named",
                     "give one, for example `cagetol scene NU208`; `cagetol scene --list` prints "
                     "all");
  print(bearing_scene(request_of(options)));
  return kDone;
}

}  // namespace

Chosen scene_command(CLI::App& command) {
  command.footer(
      "Rollers follow from the load ratings, the cage from design rules: the file says where each\n"
      "number is from. Examples:\n"
      "  cagetol scene NU208 > nu208.toml\n"
      "  cagetol scene NU 2310 --cage brass-machined --guidance outer --clearance C3\n"
      "  cagetol scene NU1014 --cage peek-machined --lubricant iso-vg-32 --speed 6000 --load 2000\n"
      "  cagetol scene NJ308 --axial 300\n"
      "  cagetol scene --list 22");
  auto options = std::make_shared<Options>();
  command.add_option(
      "DESIGNATION", options->designation,
      "Designation, in any case, with or without blanks and suffix; with --list a part of it");
  command.add_option("--cage", options->make, "Make of the cage; left out: by the suffix")
      ->check(CLI::IsMember(choice_texts<CageMake>()));
  command.add_option("--guidance", options->guidance, "What guides the cage; left out: outer")
      ->check(CLI::IsMember(choice_texts<Guidance>()));
  command.add_option("--clearance", options->clearance, "Class of internal clearance (ISO 5753-1)")
      ->transform(CLI::IsMember(choice_texts<ClearanceClass>(), CLI::ignore_case))
      ->capture_default_str();
  command
      .add_option("--lubricant", options->lubricant,
                  fmt::format("Oil; left out: {}", kUsualLubricant))
      ->check(CLI::IsMember(find_key(scene_keys(), "lubrication.lubricant")->range.choices));
  command
      .add_option("--temperature", options->temperature,
                  "Of the oil [degC]; left out: found from the heat that the bearing loses")
      ->check(CLI::Range(-60.0, 250.0));
  command.add_option("--load", options->load, "Radial load [N]; left out: 0.1 C");
  command
      .add_option("--axial", options->axial,
                  "Axial load [N] that flanges of both rings carry (NJ, NUP); left out: none")
      ->check(CLI::PositiveNumber);
  command.add_option("--speed", options->rpm,
                     "Speed of the inner ring [r/min]; left out: half the limiting speed");
  command.add_flag("--rigid", options->rigid, "A rigid cage instead of a flexible one");
  command.add_flag("--list", options->list, "Print the bearings, or those that hold DESIGNATION");
  return [options] { return run_scene(*options); };
}

}  // namespace cagetol
