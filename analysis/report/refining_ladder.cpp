#include "analysis/report/refining_ladder.hpp"

#include <cmath>
#include <fstream>

namespace cagetol {

Json read_refining_ladder(const std::filesystem::path& sweep_directory) {
  std::ifstream file(sweep_directory / kRefiningLadderFolder / "ladder.json");
  const Json ladder = file ? Json::parse(file, nullptr, false) : Json();
  return ladder.is_object() ? ladder : Json();
}

double known(const Json& value) {
  return value.is_number() ? value.get<double>() : kUndefined;
}

Estimate estimate_of(const Json& entry, const char* value) {
  return {known(entry.at(value)), known(entry.at("lower")), known(entry.at("upper"))};
}

std::vector<RefinedShift> refined_shifts(const Json& ladder, const std::string& quantity) {
  std::vector<RefinedShift> shifts;
  for (const Json& entry : ladder.at("quantities"))
    if (entry.at("quantity") == quantity)
      for (const Json& rung : entry.at("rungs"))
        if (rung.at("rung") != ladder.at("reference"))
          shifts.push_back({.setting = rung.at("rung"),
                            .shift = estimate_of(rung, "shift"),
                            .pairs = rung.at("pairs"),
                            .lost = rung.at("lost"),
                            .usable = rung.at("verdict") != "unusable"});
  return shifts;
}

double known_bias(const Json& ladder, const StudyData& study, const std::string& quantity) {
  if (ladder.is_null() || !ladder.value("refining", false) ||
      ladder.value("resolved_study", Json::object()) != study.plan.whole)
    return kUndefined;
  const auto shifts = refined_shifts(ladder, quantity);
  if (shifts.empty()) return kUndefined;
  double bias = 0;
  for (const ErrorSource& source : error_budget({}, shifts, known(ladder.at("confidence"))).sources)
    if (source.state == ErrorState::resolved && source.pairs > 0)
      bias += std::abs(source.error.value);
  return bias;
}

}  // namespace cagetol
