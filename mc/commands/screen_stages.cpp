#include "mc/commands/screen_stages.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>

#include "analysis/study/refused.hpp"
#include "analysis/tolerance/jam_onset.hpp"
#include "mc/commands/command.hpp"
#include "mc/commands/stage_study.hpp"
#include "mc/host/file_write.hpp"
#include "mc/host/json_number.hpp"
#include "mc/run/jam_shares.hpp"
#include "mc/sweep/sweep_directory.hpp"
#include "src/input/input_error.hpp"
#include "src/input/unit.hpp"

namespace cagetol {
namespace {

using Json = nlohmann::ordered_json;

constexpr long kRepeats = 8;
constexpr double kFewJams = 0.01;
/// Width of a candidate without scatter, as a share of the other one.
constexpr double kNoScatter = 1e-3;

/// The widest candidate of which few jam, whatever the target: other limits and targets go on with
/// these runs. Else the one of which fewest do.
std::size_t screened_candidate(const Study& study, const JamShares& jams) {
  const auto share = [&](std::size_t k) { return jams.candidate.empty() ? 0 : jams.candidate[k]; };
  std::size_t best = 0;
  double widest = 0;
  for (std::size_t k = 0; k < study.candidates.size(); ++k) {
    double width = 1;
    for (const double each : study.candidates[k].tolerance_widths_mm) width *= each;
    const bool fits = share(k) <= kFewJams;
    if (fits ? width > widest : widest == 0 && share(k) < share(best)) best = k;
    if (fits) widest = std::max(widest, width);
  }
  return best;
}

}  // namespace

ScreenDesign screen_design(const Study& base, const ScreenStage& planned) {
  const Study plain = changed_study(base, [](Study& study) {
    for (ToleranceDimension& dimension : study.tolerance.dimensions) dimension.centres.clear();
  });
  const JamShares jams = jam_shares(plain);
  const std::size_t chosen = screened_candidate(plain, jams);
  const Candidate& candidate = plain.candidates[chosen];
  ScreenDesign design;
  if (!jams.candidate.empty()) design.jams = jams.candidate[chosen], design.draws = jams.draws;
  const long rows = planned.runs - kRepeats;
  const Study stage = stage_study(plain, {planned.name, static_cast<std::size_t>(rows), {}});
  design.study = changed_study(stage, [&](Study& study) {
    study.design = DesignKind::lhs;
    study.cages_per_lot = 1;
    study.extra_replicates = static_cast<double>(kRepeats) / static_cast<double>(rows);
    study.scale_lots = false;
    for (std::size_t d = 0; d < study.tolerance.dimensions.size(); ++d) {
      ToleranceDimension& dimension = study.tolerance.dimensions[d];
      UncertainInput& input =
          *std::find_if(study.inputs.begin(), study.inputs.end(),
                        [&](const auto& of) { return of.key == dimension.key; });
      const double width = candidate.tolerance_widths_mm[d], scale = candidate.scales[d];
      ScreenDimension screened{dimension.key, from_si(1e-5, unit_of(dimension.key).to_si), width,
                               width};
      for (const Candidate& each : plain.candidates)
        screened.narrowest_mm = std::min(screened.narrowest_mm, each.tolerance_widths_mm[d]);
      if (!jams.curves.empty()) screened.jams = jams.curves[d];
      if (input.pocket) screened.pocket_sigma = scale * standard_deviation(*input.pocket);
      if (input.measured) input.measured->fitted = true;  // lots and pockets are drawn apart
      if (input.lot && standard_deviation(*input.lot) > 0) {
        screened.lot_sigma = scale * standard_deviation(*input.lot);
        input.lot = Normal{scale * mean(*input.lot), screened.lot_sigma};
      }
      dimension.cost.clear();
      screened.middle = candidate.middle(d);
      const double middle = zone_middle(candidate.grades[d], width);
      const auto zone = [middle](double wide) {
        return middle == 0 ? number_text(wide)
                           : fmt::format("{}/{}", middle + wide / 2, middle - wide / 2);
      };
      dimension.candidates = {zone(width)};
      if (screened.pocket_sigma > 0)
        dimension.candidates.insert(dimension.candidates.begin(), zone(kNoScatter * width));
      std::erase_if(study.correlations, [&](const Correlation& pair) {
        return pair.first == dimension.key + ":lot" || pair.second == dimension.key + ":lot";
      });
      design.dimensions.push_back(std::move(screened));
    }
  });
  if (design.study.candidates.size() > static_cast<std::size_t>(rows))
    throw Refused(fmt::format("{} = {}: so few runs cannot tell {} tolerances apart", planned.key,
                              planned.runs, design.dimensions.size()));
  return design;
}

namespace {

std::string width_text(const std::optional<double>& width, double searched) {
  return width ? fmt::format("{:.3g}", *width) : fmt::format("beyond {:.3g}", searched);
}

/// What ends a tolerance: this limit, jams, or nothing within the widths searched.
std::string standing(const LimitReach& reach) {
  const auto interval = [&] {
    return fmt::format("{} to {} mm", width_text(reach.lower_mm, reach.searched_mm),
                       width_text(reach.upper_mm, reach.searched_mm));
  };
  if (reach.width_mm == 0.0)
    return reach.upper_mm == 0.0
               ? "missed at any width"
               : (reach.upper_mm ? "reached at 0 mm (" : "not resolved (") + interval() + ")";
  if (reach.width_mm && (!reach.jam_mm || *reach.width_mm < *reach.jam_mm))
    return fmt::format("reached at {:.3g} mm ({})", *reach.width_mm, interval());
  const bool earlier = reach.lower_mm && (!reach.jam_mm || *reach.lower_mm < *reach.jam_mm);
  return (reach.jam_mm ? fmt::format("a jam comes first, at {:.3g} mm", *reach.jam_mm)
                       : fmt::format("not reached up to {:.3g} mm", reach.searched_mm)) +
         (earlier ? fmt::format(" (may be reached from {:.3g} mm)", *reach.lower_mm) : "");
}

std::string question(const Screen& screen) {
  if (screen.limits.empty()) return "";
  const ScreenedLimit& nearest = screen.limits[screen.nearest];
  const auto share = [](double of) {
    return of < 1e-6 ? std::string("less than 1 ppm") : fmt::format("{:.2g} %", 100 * of);
  };
  const std::string where = fmt::format(
      "at the widths screened the nearest limit is that of {}, {:.3g} standard deviations away: "
      "by estimate {} of the cages that fit miss it, by its upper bound {}",
      nearest.quantity, nearest.margin, share(nearest.missed), share(nearest.missed_upper));
  return (screen.jams_alone
              ? "jams alone can decide: the cage's geometry knows the answer, no campaign is worth "
                "its runs; "
              : fmt::format("worth a campaign: the limit of {}; ", nearest.quantity)) +
         where;
}

Json screen_json(const Screen& screen, const ScreenDesign& design) {
  Json json = {{"kind", "screen"},
               {"study", design.study.name},
               {"runs", screen.runs},
               {"lost", screen.lost},
               {"target_yield", screen.target_yield},
               {"definition",
                "shift by 0.01 mm: lot, all pockets of a cage larger by it; pocket, their standard "
                "deviation within the cage larger by it; error: one standard error"},
               {"jams_alone", screen.jams_alone},
               {"question", question(screen)}};
  for (const ScreenDimension& each : design.dimensions)
    json["dimensions"].push_back({{"key", each.key},
                                  {"screened_width_mm", each.width_mm},
                                  {"narrowest_mm", each.narrowest_mm}});
  json["limits"] = Json::array();
  for (const ScreenedLimit& limit : screen.limits) {
    Json entry = {{"quantity", limit.quantity},
                  {"unit", limit.unit},
                  {limit.is_maximum ? "max" : "min", limit.bound},
                  {"level", json_number(limit.level)},
                  {"level_error", json_number(limit.level_error)},
                  {"start_noise", json_number(limit.start_noise)},
                  {"other_scatter", json_number(limit.scatter)},
                  {"margin", json_number(limit.margin)},
                  {"missed_share", json_number(limit.missed)},
                  {"missed_share_upper", json_number(limit.missed_upper)}};
    for (const PartShift& part : limit.parts)
      entry["shifts"].push_back({{"key", part.key},
                                 {"part", part.part},
                                 {"shift", json_number(part.shift)},
                                 {"error", json_number(part.error)},
                                 {"bent", part.bent},
                                 {"resolved", part.resolved}});
    for (const LimitReach& reach : limit.reach)
      entry["reach"].push_back({{"key", reach.key},
                                {"width_mm", json_number(reach.width_mm.value_or(kUndefined))},
                                {"lower_mm", json_number(reach.lower_mm.value_or(kUndefined))},
                                {"upper_mm", json_number(reach.upper_mm.value_or(kUndefined))},
                                {"jam_mm", json_number(reach.jam_mm.value_or(kUndefined))},
                                {"searched_mm", reach.searched_mm},
                                {"standing", standing(reach)}});
    json["limits"].push_back(std::move(entry));
  }
  return json;
}

std::string part_text(const ScreenedLimit& limit, const std::string& key, const char* part) {
  for (const PartShift& each : limit.parts)
    if (each.key == key && each.part == part)
      return fmt::format("{:+.3g} +-{:.2g}{}", each.shift, each.error,
                         each.bent       ? " ~"
                         : each.resolved ? ""
                                         : " ?");
  return "-";
}

std::string screen_text(const Screen& screen, const ScreenDesign& design) {
  std::string text = fmt::format("screen: {} runs, {} without a result, at tolerance widths of\n",
                                 screen.runs, screen.lost);
  for (const ScreenDimension& each : design.dimensions)
    text += fmt::format("  {:.3g} mm  {}\n", each.width_mm, each.key);
  text += fmt::format(
      "{} of the cages jam there. Shift by 0.01 mm: lot, all pockets of a cage larger by it;\n"
      "pocket, their standard deviation within the cage larger by it; +- one standard error;\n"
      "?: not resolved, error above 30 % of the shift and 5 % of the distance to the limit;\n"
      "~: bent, one lot sigma away the square of the lot moves the quantity more.\n"
      "Limit reached: by {:.3g} % of the cages, this tolerance alone widened.\n",
      jam_text(screen.jams, design.draws), 100 * (1 - screen.target_yield));
  for (const ScreenedLimit& limit : screen.limits) {
    text += fmt::format(
        "{}, at {} {:.4g}{}: {:.4g} +-{:.2g} without deviations; noise of the start {:.2g}\n",
        limit.quantity, limit.is_maximum ? "most" : "least", limit.bound,
        limit.unit == "-" ? "" : " " + limit.unit, limit.level, limit.level_error,
        limit.start_noise);
    for (const LimitReach& reach : limit.reach)
      text += fmt::format("  {:<32} lot {:<20} pocket {:<20} {}\n", reach.key,
                          part_text(limit, reach.key, "lot"), part_text(limit, reach.key, "pocket"),
                          standing(reach));
  }
  return text + question(screen) + "\n";
}

}  // namespace

std::variant<Screen, int> screen_stage(const Study& base, const std::string& directory,
                                       StagedSweeps& stages) {
  try {
    const ScreenDesign design =
        screen_design(base, {"screen", "screen.budget_samples", base.screen.budget_samples});
    if (const int code = stages.sweep(design.study, directory); code != kDone) return code;
    const Screen screen =
        screen_limits(read_study_data(study_file_path(directory)), design.dimensions, design.jams);
    replace_file(directory + "/screen.json", screen_json(screen, design).dump(1) + "\n");
    print(screen_text(screen, design));
    return screen;
  } catch (const Refused& refusal) {
    spdlog::error("no screen: {}", refusal.what());
    return static_cast<int>(kSamplesFailed);
  }
}

int run_screen(const std::function<Study()>& read, const MakePlan& make_plan,
               const std::string& directory, ProgressStyle progress) {
  const auto lead = [&](const Study& base, StagedSweeps& stages) -> int {
    const std::string folder = directory + "/screen";
    const auto found = screen_stage(base, folder, stages);
    if (const int* code = std::get_if<int>(&found)) return *code;
    print("screen: " + draw_beside(folder + "/screen.json") + "\n");
    return kDone;
  };
  return run_staged_study(read, make_plan, directory, progress, lead);
}

}  // namespace cagetol
