#include "analysis/tolerance/assumption_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/tolerance/campaign_plan.hpp"

namespace cagetol {

std::size_t automatic_runs(const AssumptionPlan& plan) {
  const bool settles = plan.settling > 0 && plan.settling <= kMostOfAuto * plan.confirming;
  return settles ? std::max(plan.settling, plan.confirming) : plan.confirming;
}

std::string alternative_directory(const AssumptionPlan& plan, const AssumedValue& alternative) {
  return fmt::format("assume-{}-{}/{}-{}", plan.attempt, plan.runs, alternative.key,
                     alternative.value);
}

std::string assumption_plan_text(const AssumptionPlan& plan) {
  const std::size_t count = plan.alternatives.size();
  if (count == 0) return "";
  if (plan.attempt == 0)
    return fmt::format("assumptions: {} alternatives are not judged: no tolerance was tried",
                       count);
  const auto cost = [&](std::size_t runs) {
    return fmt::format("{} runs under each of {} alternatives, {} in all, about {}", runs, count,
                       runs * count,
                       duration_text(plan.seconds_per_run * static_cast<double>(runs * count)));
  };
  const std::size_t automatic = automatic_runs(plan);
  std::string settling =
      plan.settling > 0
          ? fmt::format(". One whose yield is that of confirm-{} is settled by about {} runs",
                        plan.attempt, plan.settling)
          : "";
  if (plan.runs > 0)
    return fmt::format("assumptions: {}, on the cages of confirm-{}{}", cost(plan.runs),
                       plan.attempt, settling);
  if (automatic > plan.confirming)
    settling += fmt::format(". assumption_samples={} settles those that never fail, by {}",
                            plan.confirming, cost(plan.confirming));
  return "assumptions: their ranges are not judged. The same command with --set "
         "recommend.assumption_samples=auto does it, " +
         cost(automatic) + settling;
}

nlohmann::ordered_json to_json(const AssumptionPlan& plan) {
  auto alternatives = nlohmann::ordered_json::array();
  for (const AssumedValue& each : plan.alternatives)
    alternatives.push_back(
        {{"key", each.key},
         {"unit", each.unit},
         {"note", each.note},
         {"low", each.low},
         {"high", each.high},
         {"value", each.value},
         {"nominal", std::isnan(each.nominal) ? nlohmann::ordered_json()
                                              : nlohmann::ordered_json(each.nominal)}});
  return {{"attempt", plan.attempt},
          {"runs", plan.runs},
          {"confirming", plan.confirming},
          {"settling", plan.settling},
          {"seconds_per_run", plan.seconds_per_run},
          {"alternatives", alternatives}};
}

AssumptionPlan assumption_plan_of(const nlohmann::ordered_json& json) {
  AssumptionPlan plan;
  json.at("attempt").get_to(plan.attempt);
  json.at("runs").get_to(plan.runs);
  json.at("confirming").get_to(plan.confirming);
  json.at("settling").get_to(plan.settling);
  json.at("seconds_per_run").get_to(plan.seconds_per_run);
  for (const auto& each : json.at("alternatives")) {
    AssumedValue& value = plan.alternatives.emplace_back();
    each.at("key").get_to(value.key);
    each.at("unit").get_to(value.unit);
    each.at("note").get_to(value.note);
    each.at("low").get_to(value.low);
    each.at("high").get_to(value.high);
    each.at("value").get_to(value.value);
    if (!each.at("nominal").is_null()) each.at("nominal").get_to(value.nominal);
  }
  return plan;
}

}  // namespace cagetol
