#include "mc/study/study_keys.hpp"

#include <algorithm>

#include "src/reading/scene_keys.hpp"

namespace cagetol {

// clang-format off
#define AT(member) [](Study& s) -> auto& { return s.member; }
const KeyTable<Study>& study_keys() {
  static const KeyTable<Study> keys = {
      {"name", any_value(), AT(name), "name of the study, for titles"},
      {"seed", within(0, 9007199254740992), AT(seed), "seed of every random number of the study"},
      {"samples", within(1, 1e9), AT(samples), "rows of the design; rounded up where the design needs it"},
      {"extra_replicates", within(0, 1000), AT(extra_replicates), "runs repeated with fresh noise, as a share of the rows; 15: every row 16 times"},
      {"design", any_value(), AT(design), "how the rows fill the space of deviations"},
      {"cages_per_lot", within(1, 1e6), AT(cages_per_lot), "design random: cages that share one draw of the lot"},
      {"redraw_jams", any_value(), AT(redraw_jams), "true: a cage that does not fit (rollers, lips, rings) is drawn again, so that every run is of one that does, and the yields of candidate tolerances are those of cages that fit times the share that fits; the stages of `recommend` do so. false: such a cage is a sample that jams"},
      {"measured_in_turn", any_value(), AT(measured_in_turn), "true: the rows run the measured cages of a CSV file one after the other in place of drawing them, as `sweep --measured FILE` does, and no tolerance is asked for"},
      {"scale_lots", any_value(), AT(scale_lots), "true: a candidate tolerance scales the deviations of lots and pockets; false: of pockets alone, and lots keep their law, as in the stage of `screen`"},
      {"allowed_failure_share", within(0, 1), AT(allowed_failure_share), "failed, censored and poisoned samples beyond this share: exit code 3; `recommend` judges the lower bound of their share in pilot and mixture together, and counts them as failing in confirmations"},
      {"fidelity", one_of({"pinned", "auto"}), AT(fidelity), "pinned: the model that the scene says; auto: the cheapest rung of the model ladder that is good enough for every limited quantity: its mean is unmoved or its limits are settled (`cagetol ladder --help`), the highest where the samples do not tell"},
      {"fidelity_samples", within(2, 1e9), AT(fidelity_samples), "fidelity auto: runs on each rung that is tried; more of them settle limits that are closer"},
      {"fidelity_budget", above(0), AT(fidelity_budget), "fidelity auto: largest shift of a mean, or share beyond a limit, that a rung may cause, in standard errors of the study: of that mean, of its yield"},
      {"cage_check_share", within(0, 1), AT(cage_check_share), "share of samples whose flexible cage is also solved in full, to know the error of the per-sample cage model"},
      {"tolerance.target_yield", above(0, 1), AT(tolerance.target_yield), "share of cages that must meet all limits"},
      {"tolerance.confidence", above(0, 0.999999), AT(tolerance.confidence), "confidence of the bounds"},
      {"recommend.pilot_samples", within(32, 1e9), AT(recommend.pilot_samples), "rows of the pilot, which measures run time and noise"},
      {"recommend.attempts", within(1, 100), AT(recommend.attempts), "confirmations that may fail; each has the share 1 / attempts of the error that the confidence leaves. Where a sequence from narrow to wide takes fewer runs it has the whole error and ends with the first that fails"},
      {"recommend.confirm_samples", within(0, 1e9), AT(recommend.confirm_samples), "most runs of one confirmation; 0: as many as its estimated yield needs and the budget affords; without a budget `samples` runs an attempt on average, or twice as many as can confirm at all, where that is more"},
      {"recommend.budget_samples", within(0, 1e9), AT(recommend.budget_samples), "runs of all stages together, may be raised in the same directory; 0: the mixture has `samples` rows"},
      {"recommend.budget_h", at_least(0), AT(recommend.budget_time), "wall-clock time of all stages together, by the pilot's time of a run, may be raised in the same directory; 0: no such budget"},
      {"recommend.assumption_samples", or_auto(within(0, 1e9)), AT(recommend.assumption_samples), "after the confirmation: runs under each end of each range of an [[assumption]], beyond any budget; may be set and raised in the same directory; auto: as many as settle an alternative whose yield is that of the attempt, up to 100 times as many as confirm the target if none fails, else these; 0: none"},
      {"screen.budget_samples", within(20, 60), AT(screen.budget_samples), "runs of `screen`, eight of them of cages that have run before"},
      {"map.budget_samples", within(20, 60), AT(map.budget_samples), "runs of `map` in each cell, eight of them of cages that have run before"},
      {"map.border_samples", within(20, 60), AT(map.border_samples), "further runs of `map` in a cell with a neighbour that has another answer, or whose runs resolve no answer"},
      {"rare.target_ppm", within(0.001, 100000), AT(rare.target_ppm), "share of bad cages that `rare` is asked about, in parts per million; 63: Cpk 1.33 if normal"},
      {"rare.budget_samples", within(0, 1e9), AT(rare.budget_samples), "runs of `rare`: 50 cages twice, all others fresh; fewer than 1100 extrapolate nothing. Above 0 it is also the last stage of a `recommend` that confirms. May be raised in the same directory; 0: 1100 of `rare`, no stage of `recommend`"},
      {"rare.relative_error", above(0, 1), AT(rare.relative_error), "standard error to which `rare` predicts the runs that measure the target, as a share of it"},
      {"document.customer", within(0, 120), AT(document.customer), "title block: customer that the report is for"},
      {"document.project", within(0, 120), AT(document.project), "title block: project or order"},
      {"document.drawing", within(0, 120), AT(document.drawing), "title block: number of the drawing"},
      {"document.revision", within(0, 120), AT(document.revision), "title block: revision of the drawing"},
      {"document.author", within(0, 120), AT(document.author), "title block: who is responsible for the report"},
      {"document.checked_by", within(0, 120), AT(document.checked_by), "title block: who checked it"},
      {"document.date", within(0, 120), AT(document.date), "title block: date of the report; left out: the day on which its pages are made"},
  };
  return keys;
}
#undef AT

const std::vector<KeyInfo>& limit_keys() {
  static const std::vector<KeyInfo> keys = {
      {"limit.quantity", any_value(), "quantity of interest that is limited", KeyKind::text},
      {"limit.min", any_value(), "smallest value allowed, in the quantity's unit; min or max must be given", KeyKind::number},
      {"limit.max", any_value(), "largest value allowed, in the quantity's unit", KeyKind::number},
      {"limit.max_at_minimum_loads", above(0), "in place of max: what the nominal bearing has under this many times the maker's minimum load, at the limit's operating point and its temperature otherwise; the mean of eight starts with a rigid cage, found before all runs and written to max", KeyKind::number},
      {"limit.operating_point", any_value(), "operating point at which the limit holds, as quantity = \"KEY@POINT\" says, too; left out: at each", KeyKind::text},
      {"limit.source", any_value(), "where the limit comes from", KeyKind::text},
      {"limit.cage_revolutions", at_least(0), "measured cage revolutions for which the limit is meant; 0: not stated", KeyKind::number},
  };
  return keys;
}

const std::vector<KeyInfo>& dimension_keys() {
  static const std::vector<KeyInfo> keys = {
      {"tolerance.dimension.key", any_value(), "uncertain scene key, a length, whose tolerance is asked for", KeyKind::text},
      {"tolerance.dimension.tolerance_width_mm", above(0), "full width of the tolerance to which the study's laws belong", KeyKind::number},
      {"tolerance.dimension.candidates", any_value(), "array of candidate tolerances: full widths in mm, deviations in mm (\"+0.10/0\"), or, of diameters, widths and lengths in mm, ISO 286 grades and classes (\"IT9\", \"js9\", \"H9\"); numbers, IT and js lie about the nominal value", KeyKind::numbers},
      {"tolerance.dimension.centres", any_value(), "array of candidate nominal values in the unit of the key, ascending: centre and tolerance are decided together; left out: the nominal value of the study", KeyKind::numbers},
      {"tolerance.dimension.cost_table", any_value(), "what a tolerance costs, in any one currency: array of [tolerance width in mm, cost], straight lines between them", KeyKind::numbers},
  };
  return keys;
}

const std::vector<KeyInfo>& correlation_keys() {
  static const std::vector<KeyInfo> keys = {
      {"correlation.between", any_value(), "array of two inputs of one scope: \"KEY:lot\" or \"KEY:pocket\"", KeyKind::text},
      {"correlation.rho", within(-1, 1), "correlation of the two deviations (of the same pocket)", KeyKind::number},
  };
  return keys;
}

const std::vector<KeyInfo>& assumption_keys() {
  static const std::vector<KeyInfo> keys = {
      {"assumption.key", any_value(), "scene key whose value nobody measured", KeyKind::text},
      {"assumption.note", any_value(), "why this value was taken; reports print it", KeyKind::text},
      {"assumption.low", any_value(), "smallest value that it may have as well, in the key's unit and range", KeyKind::number},
      {"assumption.high", any_value(), "largest such value", KeyKind::number},
  };
  return keys;
}

const std::vector<KeyInfo>& operating_point_keys() {
  static const std::vector<KeyInfo> keys = {
      {"operating_point.name", any_value(), "name of an operating point at which every sample runs; its quantities are QUANTITY@NAME", KeyKind::text},
      {"operating_point.weight", above(0, 1e12), "share of the time in service, relative to the other points, for mean powers and friction torque; left out: 1", KeyKind::number},
      {"operating_point.minimum_loads", above(0), "in place of load.radial_N: the load is this many times the maker's minimum load at the point's speed (SKF, minimum_load_skf_N of `cagetol check`)", KeyKind::number},
      {"operating_point.limiting_speeds", above(0), "in place of speed.inner_rpm: the speed is this many times bearing.limiting_speed_rpm", KeyKind::number},
      {"operating_point.KEY", any_value(), "any scene key of load, speed, duty, phase, window, start, environment, lubrication or temperature (not lubrication.model, speed.centrifugal_growth, temperature.growth and temperature.reference_C) with its value at the point", KeyKind::number},
  };
  return keys;
}

// clang-format on

bool is_study_section(const std::string& name) {
  static const std::vector<std::string> lists = {"scene",  "limit",      "correlation",
                                                 "inputs", "candidates", "operating_point"};
  if (std::find(lists.begin(), lists.end(), name) != lists.end()) return true;
  return std::any_of(study_keys().begin(), study_keys().end(), [&](const auto& key) {
    return key.name != "name" && key.name.substr(0, key.name.find('.')) == name;
  });
}

bool is_scene_section(const std::string& name) {
  return std::any_of(scene_keys().begin(), scene_keys().end(),
                     [&](const auto& key) { return key.name.starts_with(name + "."); });
}

}  // namespace cagetol
