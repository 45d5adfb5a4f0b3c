#include <algorithm>

#include "analysis/report/json_parts.hpp"
#include "analysis/report/report.hpp"

namespace cagetol {
namespace {

/// About two million weights in all: the bootstrap stays within seconds and a few ten megabytes.
std::size_t resample_count(std::size_t runs) {
  return std::clamp<std::size_t>(2'000'000 / std::max<std::size_t>(runs, 1), 200, 1000);
}

}  // namespace

nlohmann::ordered_json make_report(const StudyData& study,
                                   const std::vector<StudyData>& confirmations,
                                   const std::string& directory,
                                   const nlohmann::ordered_json& cage_peak,
                                   const nlohmann::ordered_json& refining_ladder,
                                   const std::optional<AssumptionRuns>& assumptions,
                                   const nlohmann::ordered_json& bearing) {
  const StudyData runs = select_samples(study, first_runs(study));
  const auto joint = judge_all(runs);
  const Resampling resampling(runs, resample_count(runs.size()));
  const ReportBasis basis{study, runs, joint, resampling, study.plan.confidence, directory};
  TolerancePart tolerance = tolerance_json(basis, confirmations);
  Json confirmation = confirmation_json(basis, confirmations, tolerance);
  add_limits_of_size(bearing, tolerance.tolerance);
  Json assumed = assumption_verdicts_json(basis, confirmations, assumptions, tolerance.verdict);
  add_used_values(bearing, "ranges", "value", assumed);
  add_used_values(bearing, "alternatives", "nominal", assumed);
  Json wider = passed_over_json(basis, tolerance.passed_over);
  Json report;
  report["report_version"] = kReportVersion;
  report["verdict"] = std::move(tolerance.verdict);
  report["margins"] = margins_json(basis, confirmations, refining_ladder);
  report["passed_over"] = std::move(wider);
  report["bearing"] = bearing;
  report["tolerance"] = std::move(tolerance.tolerance);
  report["confirmation"] = std::move(confirmation);
  report["assumption_verdicts"] = std::move(assumed);
  report["outcomes"] = outcomes_json(basis);
  report["limits"] = limits_json(basis);
  report["contributors"] = contributors_json(basis);
  report["quantities"] = quantities_json(basis);
  report["error_budget"] = error_budget_json(basis, report["quantities"], refining_ladder);
  report["cage"] = cage_json(basis, cage_peak);
  report["capability"] = capability_json(basis);
  report["measured"] = measured_json(basis);
  report["measured_cages"] = measured_cages_json(basis, report["measured"]);
  report["convergence"] = convergence_json(basis);
  report["failures"] = failures_json(basis);
  report["worst_samples"] = worst_samples_json(basis);
  report["health"] = health_json(basis);
  report["intervals"] = {{"confidence", basis.confidence}, {"method", resampling.description()}};
  report["fidelity"] = fidelity_json(study);
  report["assumptions"] = assumptions_json(study);
  add_used_values(bearing, "ranged", "value", report["assumptions"]);
  report["provenance"] = provenance_json(study);
  report["document"] = document_json(study);
  finish_verdict(basis, report);
  return report;
}

}  // namespace cagetol
