#include "mc/commands/judgeable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/tolerance/campaign_plan.hpp"
#include "mc/study/operating_points.hpp"
#include "src/input/unit.hpp"
#include "src/quantities/quantity_labels.hpp"
#include "src/quantities/quantity_rows.hpp"

namespace cagetol {
namespace {

/// Whether some run of the study gives the limited quantity a value.
bool is_defined(const Study& study, const Limit& limit) {
  const Quantity& quantity = quantity_named(limit.quantity);
  if (study.points.empty()) return quantity.need.met(study.scene);
  const auto label = labelled_key(limit.quantity).label;
  return std::any_of(study.points.begin(), study.points.end(), [&](const auto& point) {
    const bool of_point = label.empty() || label.substr(0, label.find('.')) == point.name;
    return of_point && quantity.need.met(at_operating_point(study.scene, point));
  });
}

bool may_be_negative(const Quantity& quantity) {
  const Bound* own = &quantity.bound;
  return own == &bound::finite || own == &bound::slip || own == &bound::ring_place ||
         own == &bound::loss;
}

}  // namespace

void require_limits_and_candidates(const Study& study) {
  if (study.limits.empty())
    throw InputError(
        {}, "limit", "", "the study has no limits: there is nothing to judge a tolerance by",
        "add [[limit]] with quantity, max, source and cage_revolutions; where this is a "
        "scene, name it in a study: [scene] with file = \"...\"");
  if (study.candidates.empty())
    throw InputError({}, "tolerance.dimension", "", "the study has no candidate tolerances",
                     "add [[tolerance.dimension]] with key, tolerance_width_mm and candidates");
}

std::size_t first_runs_of(const Study& study) {
  return static_cast<std::size_t>(study.screen.budget_samples) +
         static_cast<std::size_t>(std::ceil(static_cast<double>(study.recommend.pilot_samples) *
                                            (1 + study.extra_replicates)));
}

std::vector<InputError> judgement_faults(const Study& study) {
  std::vector<InputError> faults;
  for (const Limit& limit : study.limits) {
    if (!may_be_negative(quantity_named(limit.quantity)) && limit.maximum < 0)
      faults.emplace_back(SourcePlace{}, "limit.max", number_text(*limit.maximum),
                          limit.quantity + " is never negative: no run meets this limit",
                          "give 0 or more");
    if (!is_defined(study, limit))
      faults.emplace_back(SourcePlace{}, "limit.quantity", limit.quantity,
                          "runs of this scene give it no value: it needs " +
                              std::string(quantity_named(limit.quantity).need.text),
                          "change the scene, or leave the limit out");
  }
  if (study.candidates.empty()) return faults;
  if (study.tolerance.target_yield >= 1) {
    faults.emplace_back(
        SourcePlace{}, "tolerance.target_yield", number_text(study.tolerance.target_yield),
        "a yield of 1 cannot be confirmed by any number of runs", "give less, such as 0.999");
    return faults;
  }
  const std::size_t minimum =
      minimum_budget({study.tolerance.target_yield, study.tolerance.confidence,
                      static_cast<std::size_t>(study.recommend.attempts)},
                     study.extra_replicates, first_runs_of(study));
  if (study.recommend.budget_samples > 0 &&
      static_cast<std::size_t>(study.recommend.budget_samples) < minimum)
    faults.emplace_back(SourcePlace{}, "recommend.budget_samples",
                        std::to_string(study.recommend.budget_samples),
                        "so few runs cannot confirm any tolerance, even if none of them fails",
                        fmt::format("give {} or more", minimum));
  return faults;
}

}  // namespace cagetol
