#include "src/cage/cage_report.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

#include "src/cage/cage_check.hpp"

namespace cagetol {
namespace {

constexpr int kTimedSamples = 10;

double seconds_of_a_sample(const CageTable& table, const std::vector<PocketDeviation>& deviations,
                           const CageModelOptions& options) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kTimedSamples; ++i) {
    const auto start = std::chrono::steady_clock::now();
    make_cage_model(table, deviations, options);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    best = std::min(best, spent.count());
  }
  return best;
}

}  // namespace

std::variant<CageReport, CageFault> cage_report(const CageTable& table,
                                                const std::vector<PocketDeviation>& deviations,
                                                long modes) {
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
  report.largest_error = check.largest_error;
  report.seconds_table = table.seconds_table;
  report.seconds_full = check.seconds;
  report.seconds_sample = seconds_of_a_sample(table, deviations, options);
  for (Eigen::Index i = 0; i < model.frequency.size(); ++i) {
    report.modes.push_back({table.frequency[i], model.frequency[i], check.frequency[i],
                            family_name(table.family[static_cast<std::size_t>(i)])});
  }
  return report;
}

}  // namespace cagetol
