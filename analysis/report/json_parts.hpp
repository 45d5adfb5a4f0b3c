// The chapters of report.json. Each takes what it needs and returns one object or list.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/report/assumption_runs.hpp"
#include "analysis/statistics/resampling.hpp"
#include "analysis/statistics/yield.hpp"
#include "analysis/study/study_data.hpp"
#include "analysis/tolerance/attempt_choice.hpp"

namespace cagetol {

using Json = nlohmann::ordered_json;

/// What every chapter works on.
struct ReportBasis {
  const StudyData& study;  ///< all samples, noise replicates included
  const StudyData& runs;   ///< the first run of each row that has an outcome
  const std::vector<Judgement>& joint;
  const Resampling& resampling;
  double confidence = 0.95;
  std::string directory = "DIR";  ///< of the runs, as replay commands name it
};

Json to_json(const Estimate& estimate);
Json to_json(const Yield& yield);
/// NaN and infinities become null.
Json number(double value);

Json provenance_json(const StudyData& study);
Json assumptions_json(const StudyData& study);
/// The model that a pilot has chosen, with its evidence; null where the study pins it.
Json fidelity_json(const StudyData& study);
Json outcomes_json(const ReportBasis& basis);
Json limits_json(const ReportBasis& basis);
Json quantities_json(const ReportBasis& basis);
/// From quantities_json and what read_refining_ladder (refining_ladder.hpp) found.
Json error_budget_json(const ReportBasis& basis, const Json& quantities, const Json& ladder);
/// Distances of the limits from the runs at the tolerance decided for: those of the last attempt to
/// confirm, without any all of the study.
Json margins_json(const ReportBasis& basis, const std::vector<StudyData>& confirmations,
                  const Json& ladder);
/// Headline, grounds and next steps of the verdict, and what follows from it in other chapters.
void finish_verdict(const ReportBasis& basis, Json& report);
/// "at least 1 N and at most 2 N".
std::string limit_text(const Limit& limit, const std::string& unit);
Json capability_json(const ReportBasis& basis);
Json convergence_json(const ReportBasis& basis);
Json health_json(const ReportBasis& basis);
Json failures_json(const ReportBasis& basis);
Json worst_samples_json(const ReportBasis& basis);
Json contributors_json(const ReportBasis& basis);
/// null where the cage is rigid. `peak` is what read_cage_peak found.
Json cage_json(const ReportBasis& basis, const Json& peak);
/// Of each key whose laws were read from measured parts: file, scatter, capability and drift.
Json measured_json(const ReportBasis& basis);
/// Where the measured cages ran one after the other: runs of each that miss a limit and the nearest
/// limit, those at risk first. `measured`: that of measured_json.
Json measured_cages_json(const ReportBasis& basis, const Json& measured);
/// The title block as the study states it, with a number from study and build.
Json document_json(const StudyData& study);

/// Gives each entry of a chapter's `list` of assumptions whose value `name` is null the one that
/// runs take (`assumed` of the bearing), and `automatic`: whether the scene leaves it to auto.
void add_used_values(const Json& bearing, const char* list, const char* name, Json& chapter);

/// Yield curves, binding tests and recommendation, and the verdict drawn from them.
struct TolerancePart {
  Json tolerance, verdict;
  std::vector<PassedOver> passed_over;  ///< where there were attempts to confirm
};
TolerancePart tolerance_json(const ReportBasis& basis, const std::vector<StudyData>& confirmations);

/// Each limited quantity over the widths of each dimension, from the runs of a mixture.
Json width_curves_json(const ReportBasis& basis);

/// "pocket width IT13, pocket length 0.2 mm about 9".
std::string candidate_name(const StudyData& runs, const Candidate& candidate);

/// "7.65 ±0.045 mm (IT11, js11)": what a drawing says of a dimension whose centre is moved so far.
std::string drawing_of(const StudyData& runs, std::size_t dimension, const std::string& grade,
                       double tolerance_width_mm, double centre_shift);

/// Of a study that is judged again: what is other than stored, in a sentence; and the settings with
/// which a command judges by it.
std::string judgement_text(const StudyData& study);
std::string judgement_settings(const StudyPlan& plan);

/// Yield of each candidate (without any: of the runs as sampled) over the value of each side of
/// each limit, all other limits as they are.
Json limit_curves_json(const StudyData& study);

/// Name, reason and command of candidates that were passed over.
Json passed_over_json(const ReportBasis& basis, const std::vector<PassedOver>& candidates);

/// Attempts to confirm and the capability at the last one; the verdict becomes theirs. Null without
/// any.
Json confirmation_json(const ReportBasis& basis, const std::vector<StudyData>& confirmations,
                       TolerancePart& tolerance);

/// Adds to the tolerances of `tolerance` their limits of size, the Pp of the parts they hold for
/// and what is to fit, from the bearing's dimensions; to those whose nominal value is known.
void add_limits_of_size(const Json& bearing, Json& tolerance);

/// The verdict under alternatives of assumptions, one sentence of which is added to `verdict`; null
/// where there are none.
Json assumption_verdicts_json(const ReportBasis& basis, const std::vector<StudyData>& confirmations,
                              const std::optional<AssumptionRuns>& runs, Json& verdict);

/// Yield against the centres of tolerances of these widths.
/// How the peak force follows the centres in question, by dimension.
Json centre_responses_json(const ReportBasis& basis);

Json centres_json(const ReportBasis& basis, const MixtureWeights& mixture,
                  const Tolerance& tolerance);

}  // namespace cagetol
