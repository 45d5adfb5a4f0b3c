#include "src/cage/table/cage_report.hpp"

#include <algorithm>
#include <ctime>

#include "src/cage/table/cage_check.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kTimedSamples = 101;

/// Median of the processor time of repetitions: other programs on the machine disturb some.
double seconds_of_a_sample(const CageTable& table, const std::vector<PocketDeviation>& deviations,
                           const CageModelOptions& options) {
  std::vector<double> seconds(kTimedSamples);
  for (double& each : seconds) {
    const std::clock_t start = std::clock();
    make_cage_model(table, deviations, options);
    each = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[kTimedSamples / 2];
}

}  // namespace

std::variant<CageReport, CageFault> cage_report(const CageTable& table,
                                                const std::vector<PocketDeviation>& deviations,
                                                long modes, long pocket) {
  CageModelOptions options;
  options.modes = modes;
  const auto made = make_cage_model(table, deviations, options);
  if (const auto* fault = std::get_if<CageFault>(&made)) return *fault;
  const CageModel& model = std::get<CageModel>(made);
  const CageCheck check = check_cage_model(table, deviations, model);
  CageReport report;
  report.nodes = check.nodes;
  report.elements = check.elements;
  report.dofs = table.dofs;
  report.body = model.body;
  report.bar_loads = unit_bar_loads(table, model, pocket);
  report.largest_error = check.largest_error;
  report.seconds_table = table.seconds_table;
  report.seconds_full = check.seconds;
  report.seconds_sample = seconds_of_a_sample(table, deviations, options);
  for (Eigen::Index i = 0; i < model.elastic_modes(); ++i) {
    report.modes.push_back({table.frequency[i], model.frequency[i], check.frequency[i],
                            family_name(table.family[static_cast<std::size_t>(i)])});
  }
  return report;
}

}  // namespace cagetol
