// cagetol cage SCENE: one pocket with its clearances; of a flexible cage also its modes by the
// per-sample model and by a full solve, and what a force on a bar does.
#include <fmt/format.h>

#include <memory>

#include "mc/commands/cage_drawing.hpp"
#include "mc/commands/command.hpp"
#include "mc/commands/output_path.hpp"
#include "mc/host/file_write.hpp"
#include "mc/run/cage_cache.hpp"
#include "mc/study/study.hpp"
#include "src/cage/solve/unsolved_cage.hpp"
#include "src/cage/table/cage_report.hpp"
#include "src/input/input_error.hpp"
#include "src/operation/operating_clearance.hpp"
#include "src/operation/operating_scene.hpp"

namespace cagetol {
namespace {

struct CageArguments {
  std::string file, directory;
  std::vector<std::string> settings;
  long pocket = 0;
  bool json = false;
};

std::string report_text(const Scene& scene, const CageReport& report) {
  const Eigen::Matrix3d inertia = 1e6 * report.body.inertia;
  const Eigen::Vector3d centre = 1e6 * report.body.centre;
  std::string text = fmt::format(
      "flexible cage of {} pockets, mesh density {}: {} nodes, {} elements, {} unknowns\n"
      "mass {:.6g} kg, centre ({:.3g}, {:.3g}, {:.3g}) um\n"
      "inertia {:.6g} kg mm^2 about the axis, {:.6g} and {:.6g} about y and z\n\n"
      "{:>4}  {:<20}{:>14}{:>14}{:>14}{:>12}\n",
      scene.bearing.roller_count, scene.cage.mesh_density, report.nodes, report.elements,
      report.dofs, report.body.mass, centre[0], centre[1], centre[2], inertia(0, 0), inertia(1, 1),
      inertia(2, 2), "mode", "shape", "undeviated Hz", "sample Hz", "full solve Hz", "error");
  for (std::size_t i = 0; i < report.modes.size(); ++i) {
    const ReportedMode& mode = report.modes[i];
    text += fmt::format("{:>4}  {:<20}{:>14.1f}{:>14.1f}{:>14.1f}{:>11.4f} %\n", i + 1, mode.family,
                        mode.undeviated_hz, mode.sample_hz, mode.full_hz,
                        100 * (mode.sample_hz / mode.full_hz - 1));
  }
  text +=
      "\n1 N on the bar that leads the pocket, along the tangent, balanced by the cage's "
      "inertia:\n" +
      fmt::format("{:>8}{:>24}{:>22}{:>12}{:>16}\n", "x mm", "in the modes kept um/N",
                  "left by them um/N", "sum um/N", "stress MPa/N");
  for (const UnitBarLoad& load : report.bar_loads)
    text += fmt::format("{:>8.3f}{:>24.4f}{:>22.4f}{:>12.4f}{:>16.3f}  {}\n", 1e3 * load.x,
                        1e6 * load.kept_compliance, 1e6 * load.other_compliance,
                        1e6 * (load.kept_compliance + load.other_compliance), 1e-6 * load.stress,
                        load.place);
  return text + fmt::format(
                    "\nlargest frequency error up to 20 kHz {:.4f} %\n"
                    "seconds: a sample {:.5f}, its full solve {:.2f} ({:.0f} times), the table of "
                    "this cage {:.1f} when it was made\n",
                    100 * report.largest_error, report.seconds_sample, report.seconds_full,
                    report.seconds_full / report.seconds_sample, report.seconds_table);
}

Json report_json(const CageReport& report) {
  Json json;
  for (const ReportedMode& mode : report.modes) {
    json["modes_Hz"].push_back(mode.sample_hz);
    json["modes_full_Hz"].push_back(mode.full_hz);
    json["modes_undeviated_Hz"].push_back(mode.undeviated_hz);
    json["shapes"].push_back(mode.family);
  }
  for (const UnitBarLoad& load : report.bar_loads)
    json["bar_loads"].push_back({{"x_mm", 1e3 * load.x},
                                 {"kept_compliance_um_N", 1e6 * load.kept_compliance},
                                 {"other_compliance_um_N", 1e6 * load.other_compliance},
                                 {"stress_MPa_N", 1e-6 * load.stress},
                                 {"place", load.place}});
  json["mass_kg"] = report.body.mass;
  for (int i = 0; i < 3; ++i) {
    json["mass_centre_m"].push_back(report.body.centre[i]);
    json["inertia_kg_m2"].push_back(
        {report.body.inertia(i, 0), report.body.inertia(i, 1), report.body.inertia(i, 2)});
  }
  json["nodes"] = report.nodes;
  json["elements"] = report.elements;
  json["dofs"] = report.dofs;
  json["largest_frequency_error"] = report.largest_error;
  json["seconds_sample"] = report.seconds_sample;
  json["seconds_full"] = report.seconds_full;
  json["seconds_table"] = report.seconds_table;
  return json;
}

CageReport flexible_report(const Scene& scene, const CageArguments& options) {
  try {
    const auto table = CageTables(scene).of(scene);
    auto result = cage_report(*table, pocket_deviations(scene, table->cage), scene.cage.modes,
                              options.pocket);
    if (const auto* fault = std::get_if<CageFault>(&result))
      throw InputError({options.file, 0}, fmt::format("pocket {} (the first is 0)", fault->pocket),
                       "", fault->reason, "give this pocket smaller deviations");
    return std::get<CageReport>(std::move(result));
  } catch (const UnsolvedCage& problem) {
    throw InputError(
        {options.file, 0}, "", "",
        std::string("the finite elements of the deviated cage cannot be solved: ") + problem.what(),
        "give pockets smaller deviations, or choose another cage.mesh_density");
  }
}

int run_cage(const CageArguments& options) {
  const Scene scene = read_study(options.file, options.settings).scene;
  if (options.pocket < 0 || options.pocket >= scene.bearing.roller_count)
    throw InputError({}, "--pocket", std::to_string(options.pocket), "the cage has no such pocket",
                     fmt::format("give 0 to {}", scene.bearing.roller_count - 1));
  Json json{{"kind", "cage"}, {"drawing", pocket_drawing_json(scene, options.pocket)}};
  const char* state =
      changes_in_operation(scene) ? " in operation (fits, heat, moisture, rotation)" : "";
  std::string text = "scene " + scene.name + state + "\n" + clearances_text(json["drawing"]) + "\n";
  if (is_flexible(scene)) {
    const CageReport report = flexible_report(scene, options);
    json.update(report_json(report));
    text += report_text(scene, report);
  } else {
    text += "no modes: the cage of this scene is rigid (cage.model)\n";
  }
  if (options.directory.empty()) {
    text += "no drawing: -o DIR asks for one\n";
  } else {
    make_directory(options.directory);
    const std::filesystem::path file = std::filesystem::path(options.directory) / "cage.json";
    replace_file(file, json.dump(1) + "\n");
    text += "drawing: " + draw_beside(file) + "/pocket.svg\n";
  }
  print(options.json ? json.dump(2) + "\n" : text);
  return kDone;
}

}  // namespace

Chosen cage_command(CLI::App& command) {
  command.footer(
      "Examples:\n  cagetol cage inputs/scenes/nu205.toml -o out/nu205-cage\n"
      "  cagetol cage inputs/scenes/nu205-thin.toml --json\n"
      "\nCage tables are kept in $CAGETOL_CACHE, $XDG_CACHE_HOME/cagetol or "
      "~/.cache/cagetol.");
  auto options = std::make_shared<CageArguments>();
  command.add_option("SCENE", options->file, "Scene or study file")->required();
  add_output_directory(command, options->directory,
                       "Directory of cage.json and figures/pocket.svg, the drawing")
      ->required(false);
  command.add_option("--pocket", options->pocket, "Pocket to draw and to load, from 0")
      ->capture_default_str();
  command.add_flag("--json", options->json, "Print everything as JSON");
  add_settings_option(command, options->settings);
  return [options] { return run_cage(*options); };
}

}  // namespace cagetol
