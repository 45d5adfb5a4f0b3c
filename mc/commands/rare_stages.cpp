#include "mc/commands/rare_stages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/statistics/binomial_bounds.hpp"
#include "analysis/tolerance/campaign_plan.hpp"
#include "analysis/tolerance/rare.hpp"
#include "mc/commands/command.hpp"
#include "mc/commands/stage_study.hpp"
#include "mc/host/file_write.hpp"
#include "mc/host/json_number.hpp"
#include "mc/sweep/adopted_runs.hpp"
#include "mc/sweep/sweep_directory.hpp"

namespace cagetol {
namespace {

using Json = nlohmann::ordered_json;

constexpr long kPilotRows = 50, kUsualBudget = 1100;  // rows of the pilot run twice

RareSettings settings_of(const Study& study) {
  const long runs = study.rare.budget_samples > 0 ? study.rare.budget_samples : kUsualBudget;
  return {1e-6 * study.rare.target_ppm,
          static_cast<std::size_t>(std::max(runs - 2 * kPilotRows, 1L))};
}

std::string how(const RareLimit& limit, double runs) {
  if (limit.route == RareRoute::unstated)
    return fmt::format(
        "cannot be stated by so few runs: {} of {} miss it, {:.3g} standard deviations away",
        limit.missed, runs, limit.distance);
  if (limit.route == RareRoute::counted || limit.missed > 0)
    return fmt::format("{} of {} runs miss it (Clopper-Pearson)", limit.missed, runs);
  return fmt::format("extrapolated from the tail of {} runs; blind to another kind of failure",
                     runs);
}

/// What every row of the table has.
Json row_json(const std::string& name, double lower, double upper, double exact,
              const std::string& how) {
  return {{"name", name},
          {"lower", json_number(lower)},
          {"upper", json_number(upper)},
          {"exact_upper", exact},
          {"how", how}};
}

Json limit_json(const RareLimit& limit, double runs) {
  const std::string name = fmt::format("{}, at {} {:.4g}", limit.quantity,
                                       limit.is_maximum ? "most" : "least", limit.bound);
  Json row = row_json(name, limit.exact_lower, limit.upper, limit.exact_upper, how(limit, runs));
  row.update({{"quantity", limit.quantity},
              {"if_normal", limit.if_normal},
              {"distance", json_number(limit.distance)},
              {"noise_share", json_number(limit.noise)},
              {"upper_at", limit.upper_at}});
  return row;
}

Json dimensions_json(const StudyData& runs) {
  Json dimensions = Json::array();
  for (std::size_t d = 0; d < runs.plan.dimensions.size(); ++d) {
    const double width = runs.plan.candidates.front().tolerance_widths_mm[d];
    Json json = {{"key", runs.plan.dimensions[d].key}, {"width_mm", width}};
    for (const double share : kRareWidths) json["widths_mm"].push_back(share * width);
    const JamCurve jams = d < runs.jam.curves.size() ? runs.jam.curves[d] : JamCurve{};
    json["jams"] = {{"widths_mm", jams.tolerance_width_mm}, {"share", jams.share}};
    dimensions.push_back(std::move(json));
  }
  return dimensions;
}

Json rare_json(const Rare& rare, double p, double r, const StudyData& runs, double seconds) {
  const double counting = showing_runs(p, runs.plan.confidence);
  const char* how = rare.draws > 0 ? "exact: geometry of drawn cages" : "exact: geometry";
  const double least = std::max(2 * rare.jams - rare.jams_upper, 0.0);
  Json rows = Json::array();
  rows.push_back(row_json("cages that do not fit", least, rare.jams_upper, rare.jams_upper, how));
  for (const RareLimit& limit : rare.limits) rows.push_back(limit_json(limit, rare.runs));
  const char* sum =
      std::isnan(rare.upper) ? "cannot be stated" : "sum, each at its share of the error";
  rows.push_back(row_json("all together", least, rare.upper, rare.exact_upper, sum));
  return {{"kind", "rare"},
          {"judgement", judgement_of(runs.plan)},
          {"runs", rare.runs},
          {"lost", rare.lost},
          {"target", p},
          {"relative_error", r},
          {"counting_runs", counting},
          {"counting_hours", json_number(counting * seconds / 3600)},
          {"measuring_runs", std::ceil((1 - p) / (p * r * r))},
          {"rows", rows},
          {"dimensions", dimensions_json(runs)}};
}

std::string rare_text(const Json& json) {
  const auto text_of = [](const Json& of, const char* key, double unit) {
    const Json value = of.value(key, Json());
    if (value.is_null()) return std::string("-");
    const double number = unit * value.get<double>();
    return number < 100 ? fmt::format("{:.2g}", number) : fmt::format("{:.0f}", number);
  };
  std::string text = "  at least  at most  exact bound  if normal  [ppm]\n";
  for (const Json& row : json["rows"])
    text += fmt::format("{}\n{:>10} {:>8} {:>12} {:>10}  {}\n", row["name"].get<std::string>(),
                        text_of(row, "lower", 1e6), text_of(row, "upper", 1e6),
                        text_of(row, "exact_upper", 1e6), text_of(row, "if_normal", 1e6),
                        row["how"].get<std::string>());
  return text + fmt::format("counting: {} runs without a miss show {} ppm, {} h\n",
                            text_of(json, "counting_runs", 1), text_of(json, "target", 1e6),
                            text_of(json, "counting_hours", 1));
}

}  // namespace

int rare_stage(const Study& base, const std::string& directory,
               const std::vector<RecommendedTolerance>& tolerances, StagedSweeps& stages) {
  RareSettings settings = settings_of(base);
  const std::string first = directory + "/pilot", tail = directory + "/tail";
  const Study twice = changed_study(stage_study(base, {"rare-pilot", kPilotRows, tolerances}),
                                    [](Study& study) { study.extra_replicates = 1; });
  if (const int code = stages.sweep(twice, first)) return code;
  const StudyData pilot = read_study_data(study_file_path(first));
  StudyData runs = select_samples(pilot, first_runs(pilot));
  settings.fresh_runs = std::max(settings.fresh_runs, static_cast<std::size_t>(stored_rows(tail)));
  const auto routes = rare_routes(pilot, settings);
  const auto is_stated = [](const RareLimit& of) { return of.route != RareRoute::unstated; };
  if (std::any_of(routes.begin(), routes.end(), is_stated)) {
    const Study fresh = stage_study(base, {"rare-tail", settings.fresh_runs, tolerances});
    if (const int code = sweep_grown(fresh, tail, stages)) return code;
    runs = read_study_data(study_file_path(tail));
  }
  const Json json =
      rare_json(judge_rare(pilot, runs, settings), settings.target, base.rare.relative_error, runs,
                seconds_per_run(pilot) / stages.ranks());
  replace_file(directory + "/rare.json", json.dump(1) + "\n");
  print(rare_text(json));
  return kDone;
}

int run_rare(const std::function<Study()>& read, const MakePlan& make_plan,
             const std::string& directory, ProgressStyle progress) {
  const auto lead = [&](const Study& base, StagedSweeps& stages) {
    std::vector<RecommendedTolerance> tolerances;
    for (const ToleranceDimension& dimension : base.tolerance.dimensions)
      tolerances.push_back({dimension.key, "", false, dimension.tolerance_width_mm, ""});
    const std::string folder = directory + "/rare";
    const int code = rare_stage(base, folder, tolerances, stages);
    if (code == kDone) print("rare: " + draw_beside(folder + "/rare.json") + "\n");
    return code;
  };
  return run_staged_study(read, make_plan, directory, progress, lead);
}

std::string rare_budget_text(const Study& study) {
  const auto runs = static_cast<double>(settings_of(study).fresh_runs);
  return fmt::format(
      "  rare failures: {} fresh runs can show at most {:.4g} ppm by counting, {:.2g} ppm of a "
      "limit that is 7 standard deviations away by extrapolation\n",
      runs, 1e6 * clopper_pearson_upper(0, runs, study.tolerance.confidence), 1e3 / runs);
}

}  // namespace cagetol
