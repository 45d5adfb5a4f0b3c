// cagetol check FILE: reads a scene or study and says what it amounts to, without simulating.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "analysis/tolerance/campaign_plan.hpp"
#include "analysis/tolerance/jam_onset.hpp"
#include "mc/commands/command.hpp"
#include "mc/commands/judgeable.hpp"
#include "mc/commands/operating_text.hpp"
#include "mc/commands/rare_stages.hpp"
#include "mc/run/clearance_chains.hpp"
#include "mc/run/forecast.hpp"
#include "mc/run/jam_shares.hpp"
#include "mc/study/assumption_ranges.hpp"
#include "mc/study/law_reader.hpp"
#include "mc/study/operating_points.hpp"
#include "mc/study/sample.hpp"
#include "mc/study/study.hpp"
#include "mc/study/tolerance_filling.hpp"
#include "src/quantities/operating_point.hpp"
#include "src/reading/scene_keys.hpp"

namespace cagetol {
namespace {

std::string law_text(const std::optional<Law>& law, const char* scope, const std::string& unit) {
  if (!law) return "";
  const double deviation = standard_deviation(*law), middle = mean(*law);
  return fmt::format("    {:<6} {}, mean {:.6g}, standard deviation {:.6g} {}\n", scope,
                     law_name(*law), std::abs(middle) < 1e-9 * deviation ? 0 : middle, deviation,
                     unit);
}

std::string nominal_text(const UncertainInput& input) {
  if (input.nominal.size() > 1) return fmt::format("{} nominal values", input.nominal.size());
  return fmt::format("nominal {:.10g} {}", input.nominal[0], input.unit);
}

std::string limit_text(const Limit& limit) {
  std::string text = "    " + limit.quantity;
  if (limit.minimum) text += fmt::format(", at least {:.6g}", *limit.minimum);
  if (limit.maximum) text += fmt::format(", at most {:.6g}", *limit.maximum);
  return text + fmt::format(" ({})\n", limit.source);
}

/// Of each dimension that gets a tolerance, how its laws fill their tolerance.
std::string dimensions_text(const Study& study) {
  std::string text;
  for (const ToleranceFilling& filling : tolerance_fillings(study))
    text += fmt::format(
        "  {}: the laws belong to a tolerance of {:.6g} mm and have a standard deviation of {:.4g} "
        "mm: Pp = {:.2f}; both scale with the candidate\n",
        filling.key, filling.tolerance_width_mm, filling.deviation_mm, filling.capability);
  for (const std::string& warning : tolerance_warnings(study)) text += "warning: " + warning + "\n";
  for (const std::string& note : tolerance_notes(study)) text += "note: " + note + "\n";
  return text;
}

/// How many cages of the candidates cannot be assembled or turn: geometry alone decides.
std::string jams_text(const Study& study, const JamShares& jams) {
  const std::vector<double>& shares = jams.candidate;
  if (shares.empty()) return "";
  std::string text = fmt::format(
      "  yield = share of cages that fit x share of these that meet all limits; what does not fit "
      "jams, {}:\n",
      jams.draws > 0 ? fmt::format("of {:.0f} cages drawn", jams.draws) : "by integration");
  for (const JamCurve& curve : jams.curves) {
    std::string points;
    for (const double share : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1})
      if (const auto width = tolerance_of_jams(curve, share))
        points += fmt::format("{} {} from {:.3g} mm", points.empty() ? "" : ",", jam_text(share, 0),
                              *width);
    text += fmt::format("    {}:{}\n", curve.key, points.empty() ? " none" : points);
  }
  auto widest =
      static_cast<std::size_t>(std::min_element(shares.begin(), shares.end()) - shares.begin());
  std::size_t over = 0;
  for (std::size_t k = 0; k < shares.size(); ++k) {
    over += shares[k] > 1 - study.tolerance.target_yield;
    if (shares[k] <= 1 - study.tolerance.target_yield && shares[k] >= shares[widest]) widest = k;
  }
  const std::size_t dimensions = jams.curves.size();
  const Candidate& candidate = study.candidates[widest];
  std::string widths;
  for (std::size_t d = 0; d < dimensions; ++d) {
    widths += fmt::format("{}{:.3g} mm", d > 0 ? " and " : "", candidate.tolerance_widths_mm[d]);
    if (const double shift = candidate.shift(d); shift != 0)
      widths += fmt::format(" with its middle at {:+.3g} mm", shift);
  }
  text += fmt::format("    at {}: {} jam", widths, jam_text(shares[widest], jams.draws));
  for (std::size_t d = 0; d < dimensions; ++d)
    text += fmt::format(
        "; {} off centre by {:.2g} mm {}, its variance all among pockets {}, all from cage to "
        "cage {}",
        jams.curves[d].key, kOffCentre * study.candidates[widest].tolerance_widths_mm[d],
        jam_text(jams.off_centre[widest * dimensions + d], jams.draws),
        jam_text(jams.pockets_alone[widest * dimensions + d], jams.draws),
        jam_text(jams.lots_alone[widest * dimensions + d], jams.draws));
  text += "\n";
  if (over > 0)
    text += fmt::format(
        "warning: {} of {} candidates miss the target yield of {:.6g} % by jams alone, whatever "
        "the limits\n",
        over, shares.size(), 100 * study.tolerance.target_yield);
  return text;
}

/// What `recommend` can decide with the runs that its budget has at most for confirmations.
std::string budget_text(const Study& study, const JamShares& jams) {
  if (study.recommend.budget_samples == 0 || !judgement_faults(study).empty()) return "";
  const std::size_t runs = most_confirming_runs(
      static_cast<std::size_t>(study.recommend.budget_samples), first_runs_of(study));
  return "  " +
         decidable_text(study.candidates, jams.candidate,
                        {study.tolerance.target_yield, study.tolerance.confidence}, runs) +
         "\n";
}

std::string summary(const Study& study) {
  std::string text =
      fmt::format("study {}: {} rows ({}), {} samples in all, hash {}\n", study.name, study.samples,
                  design_name(study.design), sample_count(study), study.hash);
  const Operation& operation = study.scene.operation;
  text += fmt::format(
      "scene {}: {} rollers, {} cage, {:.6g} N{}, {:.6g} rpm\n", study.scene.name,
      study.scene.bearing.roller_count, spelled(study.scene.cage.model), operation.radial_load,
      operation.axial_load == 0 ? "" : fmt::format(" and axially {:.6g} N", operation.axial_load),
      operation.inner_speed / kRpm);
  if (!study.inputs.empty())
    text += fmt::format("uncertain inputs: {} with {} columns\n", study.inputs.size(),
                        design_columns(study));
  for (const auto& input : study.inputs)
    text += fmt::format("  {}, {}\n", input.key, nominal_text(input)) +
            law_text(input.lot, study.cages_per_lot > 1 ? "from lot to lot" : "from cage to cage",
                     input.unit) +
            law_text(input.pocket, "pocket", input.unit) +
            law_text(input.noise, "noise", input.unit);
  if (!study.limits.empty()) text += "limits:\n";
  for (const auto& limit : study.limits) text += limit_text(limit);
  const auto doubts = scene_doubts(study.scene);
  for (const auto& note : study_notes(study))
    text +=
        (std::count(doubts.begin(), doubts.end(), note) > 0 ? "warning: " : "note: ") + note + "\n";
  const JamShares jams = jam_shares(study);
  if (!study.candidates.empty())
    text += fmt::format("candidate tolerances: {} combinations of {} dimensions\n",
                        study.candidates.size(), study.tolerance.dimensions.size()) +
            dimensions_text(study) + jams_text(study, jams) + budget_text(study, jams) +
            rare_budget_text(study);
  if (const std::size_t count = alternatives_of(study).size();
      count > 0 && !study.candidates.empty())
    text += fmt::format(
        "ranges of assumptions: {} alternatives, judged where recommend.assumption_samples is "
        "set\n",
        count);
  for (const InputError& fault : judgement_faults(study))
    text += std::string("warning: ") + fault.what() + "\n";
  text += operating_table(study.scene) + duty_text(study.scene);
  if (!study.inputs.empty()) text += chains_text(clearance_chains(study));
  const SweepForecast forecast = forecast_sweep(study);
  if (const std::string points = operating_points_text(study); !points.empty())
    text += points + "\n";
  for (const OperatingPointPlan& point : study.points)
    for (const std::string& warning : operating_warnings(at_operating_point(study.scene, point)))
      text += "warning: at " + point.name + ": " + warning + "\n";
  for (const std::string& doubt : heat_doubts(study)) text += "warning: " + doubt + "\n";
  if (forecast.samples > 1) text += "a sweep of " + forecast_text(forecast) + "\n";
  if (const double cage = forecast_cage_table(study.scene); cage > 0)
    text += fmt::format("making a table of the flexible cage takes about {:.2g} GB of memory\n",
                        1e-9 * cage);
  return text + (text.find("warning: ") == std::string::npos
                     ? "no mistakes found\n"
                     : "no mistakes found, but see the warnings above\n");
}

}  // namespace

Chosen check_command(CLI::App& command) {
  struct Options {
    std::string file;
    std::vector<std::string> settings;
    bool json = false;
  };
  command.footer("Example:\n  cagetol check inputs/studies/nu205.toml");
  auto options = std::make_shared<Options>();
  command.add_option("FILE", options->file, "Scene or study file")->required();
  command.add_flag("--json", options->json, "Print the resolved study as JSON");
  add_settings_option(command, options->settings);
  return [options] {
    const Study study = read_study(options->file, options->settings);
    require_memory(forecast_sweep(study), 1);
    require_cage_memory(study.scene);
    print(options->json ? study.resolved_json : summary(study));
    return kDone;
  };
}

}  // namespace cagetol
