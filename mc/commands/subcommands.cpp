#include "mc/commands/subcommands.hpp"

#include <fmt/format.h>

#include <vector>

#include "src/input/input_error.hpp"

namespace cagetol {

Chosen animate_command(CLI::App& command);
Chosen bench_command(CLI::App& command);
Chosen cage_command(CLI::App& command);
Chosen chart_command(CLI::App& command);
Chosen check_command(CLI::App& command);
Chosen compare_command(CLI::App& command);
Chosen history_command(CLI::App& command);
Chosen judge_command(CLI::App& command);
Chosen ladder_command(CLI::App& command);
Chosen map_command(CLI::App& command);
Chosen quantities_command(CLI::App& command);
Chosen rare_command(CLI::App& command);
Chosen recommend_command(CLI::App& command);
Chosen replay_command(CLI::App& command);
Chosen report_command(CLI::App& command);
Chosen rig_command(CLI::App& command);
Chosen scene_command(CLI::App& command);
Chosen screen_command(CLI::App& command);
Chosen simulate_command(CLI::App& command);
Chosen stability_command(CLI::App& command);
Chosen sweep_command(CLI::App& command);
Chosen worst_command(CLI::App& command);

namespace {

constexpr const char *kBearing = "One bearing", *kStudy = "A study", *kResults = "Reading results",
                     *kMethods = "Methods";

struct Subcommand {
  const char *group, *name, *summary, *example;
  /// Declares its options; what it returns runs it.
  Chosen (*make)(CLI::App& command);
};

// clang-format off
const std::vector<Subcommand> kSubcommands = {
    {kBearing, "scene", "Write the scene of a bearing by its designation, or list the bearings", "scene NU208 > nu208.toml", scene_command},
    {kBearing, "check", "Check a scene or study without simulating; print its operating point", "check inputs/studies/nu205.toml", check_command},
    {kBearing, "simulate", "Simulate one bearing: a scene, or a sample of a study", "simulate inputs/scenes/nu205.toml --json", simulate_command},
    {kBearing, "cage", "Clearances and drawing of a pocket; modes, compliance, stress and mass of a flexible cage", "cage inputs/scenes/nu205.toml", cage_command},
    {kStudy, "recommend", "Find the tolerance that meets the target, and confirm it with fresh runs", "recommend inputs/studies/nu205.toml -o out/nu205-drawing", recommend_command},
    {kStudy, "screen", "Find which tolerance moves which limited quantity, and what is worth a campaign", "screen inputs/studies/nu205.toml -o out/nu205-screen", screen_command},
    {kStudy, "map", "Map the widest tolerance over two keys, such as load and speed, and what decides there", "map inputs/studies/nu205-map.toml --over load.radial_N=100..10000:6:log --over speed.inner_rpm=1000..14000:6 -o out/nu205-map", map_command},
    {kStudy, "rare", "Bound the share of bad cages in parts per million, each limit by the route that can", "rare inputs/studies/nu205.toml -o out/nu205-rare", rare_command},
    {kStudy, "sweep", "Run every sample of a study; the same command resumes an interrupted sweep", "sweep inputs/studies/nu205.toml -o out/nu205", sweep_command},
    {kResults, "report", "Write report.html, report.json and CSV tables from DIR/study.h5", "report out/nu205", report_command},
    {kResults, "judge", "Judge the runs of a directory by other limits: scatter, margins, which decide, a report", "judge out/nu205 --limit driving_slip_ratio=0.05", judge_command},
    {kResults, "worst", "Print the cages nearest to a limit, with every pocket of theirs, as CSV", "worst out/nu205 -n 3", worst_command},
    {kResults, "compare", "Say whether any statistic of a study has changed between two sweeps", "compare out/yesterday out/today", compare_command},
    {kResults, "history", "Show yields and quantities over studies run again and again, and what has changed", "history out/monday out/tuesday -o out/history", history_command},
    {kResults, "rig", "Hold the model against a rig: measured slip of the cage beside runs of each load and speed", "rig inputs/scenes/nu205.toml rig.csv -o out/rig", rig_command},
    {kResults, "replay", "Run one sample of a sweep again and compare it to the bit with what is stored", "replay out/nu205 --sample 17", replay_command},
    {kResults, "animate", "Write a page that plays the motion of one sample of a sweep", "animate out/nu205 --sample 17", animate_command},
    {kResults, "quantities", "List the quantities of interest: unit, definition, what they need, use", "quantities pocket_force", quantities_command},
    {kMethods, "ladder", "Find the cheapest model that is good enough for each quantity, on the same samples", "ladder inputs/scenes/nu205.toml -o out/ladder", ladder_command},
    {kMethods, "chart", "Chart error against cost of every integration method and tolerance on a scene", "chart inputs/scenes/speed-z16.toml -o out/chart", chart_command},
    {kMethods, "stability", "Map where each integration method is right, degraded, silently wrong, or fails", "stability -o out/stability", stability_command},
    {kMethods, "bench", "Time every integration method on a scene: wall seconds per simulated second", "bench inputs/scenes/speed-z16.toml", bench_command},
};
// clang-format on

/// A command of earlier versions is refused with what became of it.
struct FormerCommand {
  const char *name, *remedy;
};
constexpr FormerCommand kFormerCommands[] = {
    {"limits",
     "`cagetol judge DIR` reads the runs of a directory, `cagetol screen STUDY` looks at a study "
     "before its runs are made"}};

}  // namespace

void add_subcommands(CLI::App& app, Chosen& chosen) {
  std::string examples;
  for (const Subcommand& row : kSubcommands) {
    CLI::App* command = app.add_subcommand(row.name, row.summary)->group(row.group);
    command->callback([&chosen, run = row.make(*command)] { chosen = run; });
    examples += fmt::format("\n  cagetol {}", row.example);
  }
  for (const FormerCommand& former : kFormerCommands)
    app.add_subcommand(former.name)->group("")->allow_extras()->callback([&chosen, former] {
      chosen = [former]() -> int {
        throw InputError({}, former.name, "", "there is no such command any more", former.remedy);
      };
    });
  app.require_subcommand(0, 1);
  app.footer(
      "Exit codes: 0 done, 1 limits not met (compare: changed) where asked to judge, 2 bad input,\n"
      "3 samples failed beyond the allowed share, 70 a fault of the program, 75 interrupted: "
      "start\n"
      "the same command again to go on.\n\nExamples:" +
      examples + "\n  cagetol --dump-default scene");
}

}  // namespace cagetol
