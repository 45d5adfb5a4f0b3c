#include "analysis/compare/matched_runs.hpp"

#include <map>
#include <set>

#include "analysis/study/estimate.hpp"

namespace cagetol {

std::vector<MatchedRuns> matched_runs(const StudyData& reference, const StudyData& runs) {
  std::map<std::int64_t, std::size_t> run_of_row;
  for (const std::size_t i : first_runs(runs)) run_of_row[runs.row[i]] = i;
  std::vector<MatchedRuns> all;
  for (const Column& column : reference.quantities) {
    const Column* other = find_quantity(runs, column.name);
    if (other == nullptr) continue;
    MatchedRuns& pairs = all.emplace_back(MatchedRuns{column.name, column.unit, {}, {}});
    for (const std::size_t i : first_runs(reference)) {
      const auto partner = run_of_row.find(reference.row[i]);
      pairs.reference.push_back(column.values[i]);
      pairs.values.push_back(partner == run_of_row.end() ? kUndefined
                                                         : other->values[partner->second]);
    }
  }
  return all;
}

bool share_lots(const StudyData& study) {
  const auto first = first_runs(study);
  std::set<std::int64_t> lots;
  for (const std::size_t i : first) lots.insert(study.lot[i]);
  return lots.size() < first.size();
}

}  // namespace cagetol
