#include "analysis/tolerance/campaign_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "analysis/sensitivity/noise_share.hpp"
#include "analysis/statistics/summary.hpp"
#include "analysis/study/refused.hpp"
#include "analysis/tolerance/binding.hpp"

namespace cagetol {
namespace {

/// Shares of a budget that the mixture gets at most and at least; the confirmations have the rest.
constexpr double kMostMixture = 0.5, kMinimumMixture = 0.25;
/// Rows for each candidate, or tolerance of one dimension, that a mixture has where half of the
/// budget affords them.
constexpr double kFirstRows = 40;

/// Runs of a mixture of so many rows, noise replicates included.
double runs_of_rows(const StudyPlan& study, double rows) {
  return rows * (1 + study.extra_replicates);
}

/// Of the mixture: they are run again where it grows.
double repeats_of(const StudyPlan& study, const CampaignPlan& plan) {
  return std::ceil(study.extra_replicates * static_cast<double>(plan.mixture_rows));
}

/// Candidates that the mixture judges by rows of their own: of several dimensions the tolerances and
/// centres of the one that has most (yield_curve.hpp).
double judged_tolerances(const StudyPlan& study) {
  std::size_t most = 0;
  for (std::size_t d = 0; d < study.dimensions.size(); ++d) {
    std::set<std::pair<double, double>> levels;
    for (const Candidate& each : study.candidates)
      levels.insert({each.tolerance_widths_mm[d], each.shift(d)});
    most = std::max(most, levels.size());
  }
  return static_cast<double>(most);
}

/// One attempt alone has the whole error.
ConfirmationRules undivided(ConfirmationRules rules) {
  rules.attempts = 1;
  return rules;
}

/// Runs that the budgets leave after the pilot; nothing where there is no budget.
std::optional<double> runs_left(const StudyData& pilot, const CampaignPlan& plan) {
  std::optional<double> left;
  const auto at_most = [&](double runs) { left = left ? std::min(*left, runs) : runs; };
  const double spent =
      static_cast<double>(pilot.size() + plan.settings.screen_samples) + plan.repeats_lost;
  if (plan.settings.budget_samples > 0)
    at_most(static_cast<double>(plan.settings.budget_samples) - spent);
  if (plan.settings.budget_h > 0 && plan.seconds_per_run > 0)
    at_most(3600 * plan.settings.budget_h * plan.processes / plan.seconds_per_run - spent);
  return left;
}

/// Runs with which the candidates that the pilot takes for good would probably be confirmed: the
/// most that any of them needs. More than any budget where one cannot be told from the target.
double confirming_need(const StudyData& pilot, const ConfirmationRules& rules) {
  const StudyData runs = select_samples(pilot, first_runs(pilot));
  const Resampling resampling(runs, kUsualResamples);
  const YieldCurves curves =
      yield_curves(runs, mixture_weights(runs), judge_all(runs), resampling, runs.plan.confidence);
  auto need = static_cast<double>(confirming_runs(0, rules));
  for (std::size_t k = 0; k < curves.candidates.size(); ++k) {
    const Yield& yield = curves.candidates[k];
    const ConfirmationRules rules_of = rules_for(rules, runs, k);
    if (yield.if_unknown_fail < rules.target_yield || !can_confirm(rules_of)) continue;
    // Of a pilot without a failing run the bound says how short it was, not how near the target is.
    const double expected = yield.missing_runs > 0
                                ? expected_yield(yield)
                                : std::min(0.5 * (1 + rules.target_yield), yield.fits);
    if (expected <= rules.target_yield) return std::numeric_limits<double>::infinity();
    need = std::max(need, static_cast<double>(confirmation_size(expected, rules_of)));
  }
  return need;
}

std::string noise_text(const StudyData& pilot) {
  std::string text;
  for (const Limit& limit : pilot.plan.limits) {
    const Column* column = find_quantity(pilot, limit.quantity);
    if (column == nullptr) continue;
    const NoiseShare noise = noise_share(pilot, column->values, pilot.plan.confidence);
    if (!(noise.share.value > 0)) continue;
    text += fmt::format(
        "\n  noise of the start owns {:.0f} % of the variance of {} over the pilot's cages "
        "({:.0f} to {:.0f} %): no design lowers the variance of its mean more than {:.1f} times",
        100 * noise.share.value, limit.quantity, 100 * noise.share.lower, 100 * noise.share.upper,
        1 / noise.share.value);
  }
  return text;
}

/// What is left must afford one attempt at least, and its mixture rows to judge one candidate.
void require_runs(const StudyData& pilot, const CampaignPlan& plan,
                  const ConfirmationRules& rules) {
  const std::size_t fewest = confirming_runs(0, undivided(rules));
  if (plan.confirm_runs >= fewest &&
      static_cast<double>(plan.mixture_rows) >= kMinimumEffectiveRuns)
    return;
  throw Refused(fmt::format(
      "the budget leaves {} rows to compare {} candidates and {} runs for up to {} attempts to "
      "confirm; with no failing run at all, {} runs are needed to confirm {:g} % with {:g} % "
      "confidence. {} runs in all are the least, about {:.0f} would do",
      plan.mixture_rows, pilot.plan.candidates.size(), plan.confirm_runs, rules.attempts, fewest,
      100 * rules.target_yield, 100 * rules.confidence,
      minimum_budget(rules, pilot.plan.extra_replicates,
                     pilot.size() + plan.settings.screen_samples),
      static_cast<double>(pilot.size() + plan.settings.screen_samples) +
          2 * std::max(
                  runs_of_rows(pilot.plan, kFewestEffectiveRuns *
                                               static_cast<double>(pilot.plan.candidates.size())),
                  2 * static_cast<double>(rules.attempts * fewest))));
}

/// Shares what the settings afford out between confirmations and a mixture that keeps the rows it
/// has: it grows until an attempt is decided, where its design lets it.
void share_out(CampaignPlan& plan, const StudyData& pilot, std::size_t study_rows) {
  const StudyPlan& study = pilot.plan;
  auto rules = confirmation_rules(study, 0);
  const auto attempts = static_cast<double>(rules.attempts);
  const std::size_t fewest = confirming_runs(0, rules);
  const CampaignSettings& settings = plan.settings;
  const auto left = runs_left(pilot, plan);
  if (!left) {
    plan.mixture_rows = study_rows;
    plan.confirm_runs =
        rules.attempts * (settings.confirm_samples > 0 ? settings.confirm_samples
                                                       : std::max(study_rows, 2 * fewest));
  } else {
    rules.most_runs = static_cast<std::size_t>(std::max(0.0, *left));
    const double wanted = settings.confirm_samples > 0
                              ? static_cast<double>(settings.confirm_samples)
                              : confirming_need(pilot, rules);
    const double least = kMinimumMixture * *left,
                 most = std::clamp(*left - attempts * static_cast<double>(fewest), least,
                                   kMostMixture * *left),
                 first = runs_of_rows(study, kFirstRows * judged_tolerances(study)),
                 mixture =
                     settings.jams_alone
                         ? std::min(first, most)
                         : std::clamp(std::max(*left - attempts * wanted, first), least, most);
    const auto rows = static_cast<std::size_t>(std::max(0.0, mixture / runs_of_rows(study, 1)));
    const double lost = repeats_of(study, plan);
    const bool extensible = plan.attempts.empty() && pilot.design.kind == "random";
    const bool grows = (plan.mixture_rows == 0 || extensible) && rows > plan.mixture_rows;
    if (grows) plan.repeats_lost += lost, plan.mixture_rows = rows;
    plan.confirm_runs = static_cast<std::size_t>(std::max(
        0.0,
        *left - (grows ? lost : 0) - runs_of_rows(study, static_cast<double>(plan.mixture_rows))));
  }
}

}  // namespace

double seconds_per_run(const StudyData& runs) {
  for (const Column& column : runs.timing)
    if (column.name == "wall_s" && runs.size() > 0) {
      const std::vector<double> equal(runs.size(), 1.0);
      return weighted_mean(column.values, equal);
    }
  return 0;
}

std::string duration_text(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

double expected_yield(const Yield& yield) {
  return 0.5 * (yield.if_unknown_fail + yield.lower_bound);
}

std::size_t decided_runs(const CampaignPlan& plan) {
  std::size_t runs = 0;
  for (const PlannedAttempt& attempt : plan.attempts) runs += attempt.spent;
  return runs;
}

ConfirmationRules attempt_rules(const CampaignPlan& plan, const StudyPlan& study) {
  ConfirmationRules rules = confirmation_rules(study, 0);
  rules.attempts = plan.error_shares;
  return rules;
}

bool affords_attempt(const CampaignPlan& plan, const StudyPlan& study) {
  return plan.confirm_runs >= decided_runs(plan) + confirming_runs(0, attempt_rules(plan, study));
}

bool extend_mixture(CampaignPlan& plan, const StudyData& mixture) {
  const bool budget = plan.settings.budget_samples > 0 || plan.settings.budget_h > 0;
  if (!budget || !affords_attempt(plan, mixture.plan) || mixture.design.kind != "random")
    return false;
  const auto left = static_cast<double>(plan.confirm_runs - decided_runs(plan) -
                                        confirming_runs(0, attempt_rules(plan, mixture.plan)));
  const double lost = repeats_of(mixture.plan, plan);
  const auto rows = std::min(
      plan.mixture_rows,
      static_cast<std::size_t>(std::max(0.0, (left - lost) / runs_of_rows(mixture.plan, 1))));
  if (10 * rows < plan.mixture_rows) return false;
  plan.repeats_lost += lost;
  plan.mixture_rows += rows;
  plan.confirm_runs -= static_cast<std::size_t>(
      std::min(left, std::ceil(lost + runs_of_rows(mixture.plan, static_cast<double>(rows)))));
  return true;
}

std::size_t most_confirming_runs(std::size_t budget, std::size_t pilot_runs) {
  const auto left = static_cast<double>(budget - std::min(budget, pilot_runs));
  return static_cast<std::size_t>((1 - kMinimumMixture) * left);
}

std::size_t minimum_budget(const ConfirmationRules& rules, double extra_replicates,
                           std::size_t pilot_runs) {
  const std::size_t fewest = confirming_runs(0, undivided(rules));
  const double mixture = kMinimumEffectiveRuns * (1 + extra_replicates);
  // The mixture gets no more than its share.
  return pilot_runs + std::max(static_cast<std::size_t>(std::ceil(mixture / kMinimumMixture)),
                               static_cast<std::size_t>(
                                   std::ceil(static_cast<double>(fewest) / (1 - kMinimumMixture))));
}

CampaignPlan plan_campaign(const StudyData& pilot, const CampaignSettings& settings,
                           std::size_t study_rows, double processes) {
  CampaignPlan plan{0, 0, 1, seconds_per_run(pilot), processes, settings};
  plan.judgement = judgement_of(pilot.plan);
  share_out(plan, pilot, study_rows);
  require_runs(pilot, plan, confirmation_rules(pilot.plan, 0));
  return plan;
}

CampaignPlan with_settings(const CampaignPlan& plan, const StudyData& pilot,
                           const CampaignSettings& settings) {
  CampaignPlan changed = plan;
  changed.settings = settings;
  share_out(changed, pilot, plan.mixture_rows);
  const std::size_t decided = decided_runs(plan);
  if (changed.confirm_runs < decided)
    throw Refused(
        fmt::format("{} confirming runs are decided already, the budget leaves {}: it "
                    "may be raised, not lowered",
                    decided, changed.confirm_runs));
  require_runs(pilot, changed, confirmation_rules(pilot.plan, 0));
  return changed;
}

CampaignPlan with_judgement(CampaignPlan plan, const StudyData& pilot,
                            const CampaignSettings& settings) {
  plan.attempts.clear();
  plan.error_shares = 1;
  plan.judgement = judgement_of(pilot.plan);
  return with_settings(plan, pilot, settings);
}

nlohmann::ordered_json to_json(const CampaignPlan& plan) {
  auto attempts = nlohmann::ordered_json::array();
  for (const PlannedAttempt& attempt : plan.attempts)
    attempts.push_back({{"candidate", attempt.candidate}, {"runs", attempt.runs}});
  return {{"mixture_rows", plan.mixture_rows},
          {"confirm_runs", plan.confirm_runs},
          {"error_shares", plan.error_shares},
          {"repeats_lost", plan.repeats_lost},
          {"seconds_per_run", plan.seconds_per_run},
          {"processes", plan.processes},
          {"confirm_samples", plan.settings.confirm_samples},
          {"budget_samples", plan.settings.budget_samples},
          {"budget_h", plan.settings.budget_h},
          {"screen_samples", plan.settings.screen_samples},
          {"jams_alone", plan.settings.jams_alone},
          {"judgement", plan.judgement},
          {"attempts", attempts}};
}

CampaignPlan campaign_plan_of(const nlohmann::ordered_json& json) {
  CampaignPlan plan;
  json.at("mixture_rows").get_to(plan.mixture_rows);
  json.at("confirm_runs").get_to(plan.confirm_runs);
  json.at("error_shares").get_to(plan.error_shares);
  json.at("repeats_lost").get_to(plan.repeats_lost);
  json.at("seconds_per_run").get_to(plan.seconds_per_run);
  json.at("processes").get_to(plan.processes);
  json.at("confirm_samples").get_to(plan.settings.confirm_samples);
  json.at("budget_samples").get_to(plan.settings.budget_samples);
  json.at("budget_h").get_to(plan.settings.budget_h);
  json.at("screen_samples").get_to(plan.settings.screen_samples);
  plan.settings.jams_alone = json.value("jams_alone", false);
  plan.judgement = json.at("judgement");
  for (const auto& attempt : json.at("attempts")) {
    const auto runs = attempt.at("runs").get<std::size_t>();
    plan.attempts.push_back({attempt.at("candidate").get<std::size_t>(), runs, runs});
  }
  return plan;
}

std::string decidable_text(const std::vector<Candidate>& candidates,
                           const std::vector<double>& jams, ConfirmationRules rules,
                           std::size_t runs) {
  rules = undivided(rules);
  const auto allowed = allowed_failures(runs, rules);
  const std::string with = fmt::format("with {} confirming runs: ", runs),
                    to = fmt::format(" to {:.6g} %", 100 * rules.target_yield);
  if (!allowed)
    return with + fmt::format("nothing{}, which takes {}", to, confirming_runs(0, rules));
  std::string name = "no candidate, for jams alone,";
  double most = 0;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    double width = 1;
    for (const double each : candidates[k].tolerance_widths_mm) width *= each;
    const double fitting = k < jams.size() ? 1 - jams[k] : 1;
    rules.fit = {fitting, std::max(fitting - 1e-6, 0.0), 1};
    if (width <= most || confirming_probability(fitting, runs, rules) < kWantedPower) continue;
    most = width;
    name.clear();
    for (std::size_t d = 0; d < candidates[k].grades.size(); ++d)
      name += (d == 0 ? "" : " and ") +
              tolerance_name(candidates[k].grades[d], candidates[k].tolerance_widths_mm[d]);
  }
  return with + name + to + fmt::format(", where at most {} of them miss a limit", *allowed);
}

std::string plan_text(const StudyData& pilot, const CampaignPlan& plan) {
  const StudyPlan& study = pilot.plan;
  const auto rules = confirmation_rules(study, plan.confirm_runs);
  const double mixture = runs_of_rows(study, static_cast<double>(plan.mixture_rows));
  const auto confirm = static_cast<double>(plan.confirm_runs);
  const double each = plan.seconds_per_run / plan.processes;
  std::string text = fmt::format(
      "plan, by the pilot's {:.3g} s a run on {:g} processes:\n"
      "  mixture: {} rows over {} candidates, {:.0f} runs, {}\n"
      "  confirmation: at most {} attempts at {:.6g} % confidence each, from {} runs for one to {} "
      "for all, up to {}",
      plan.seconds_per_run, plan.processes, plan.mixture_rows, study.candidates.size(), mixture,
      duration_text(each * mixture), rules.attempts, 100 * attempt_confidence(rules),
      confirming_runs(0, rules), plan.confirm_runs, duration_text(each * confirm));
  text += "\n  " + decidable_text(study.candidates, pilot.jam.candidate, rules, plan.confirm_runs);
  const auto rows = static_cast<double>(plan.mixture_rows),
             candidates = static_cast<double>(study.candidates.size());
  // Candidates of several dimensions borrow from their tolerances (yield_curve.hpp).
  if (study.dimensions.size() == 1 && rows < kMinimumEffectiveRuns * candidates)
    text += fmt::format(
        "\n  fewer than {:.0f} rows for each candidate: some or all will have too few effective "
        "runs to be judged; recommend.budget_samples = {:.0f} gives them",
        kMinimumEffectiveRuns,
        std::ceil(std::max(runs_of_rows(study, kMinimumEffectiveRuns * candidates) / kMostMixture,
                           runs_of_rows(study, kMinimumEffectiveRuns * candidates) +
                               static_cast<double>(rules.attempts * confirming_runs(0, rules)))) +
            static_cast<double>(pilot.size() + plan.settings.screen_samples));
  else if (rows < kFewestEffectiveRuns * candidates)
    text += fmt::format(
        "\n  fewer than {:.0f} rows for each candidate: with so few effective runs their yields "
        "are rough",
        kFewestEffectiveRuns);
  return text + noise_text(pilot);
}

}  // namespace cagetol
