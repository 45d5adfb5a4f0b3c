#include "analysis/study/judgement.hpp"

#include <cmath>

namespace cagetol {
namespace {

Judgement judge_value(double value, const Limit& limit) {
  if (std::isnan(value)) return Judgement::unknown;
  return meets(limit, value) ? Judgement::meets : Judgement::misses;
}

/// What the outcome alone says; `meets` where the quantities decide.
Judgement judge_status(RunStatus status) {
  if (status == RunStatus::ok) return Judgement::meets;
  return status == RunStatus::jammed ? Judgement::misses : Judgement::unknown;
}

}  // namespace

std::vector<Judgement> judge(const StudyData& study, const Limit& limit) {
  const Column* column = find_quantity(study, limit.quantity);
  std::vector<Judgement> judgements(study.size());
  for (std::size_t i = 0; i < study.size(); ++i) {
    judgements[i] = judge_status(study.status[i]);
    if (judgements[i] == Judgement::meets)
      judgements[i] =
          column == nullptr ? Judgement::unknown : judge_value(column->values[i], limit);
  }
  return judgements;
}

std::vector<Judgement> judge_all(const StudyData& study) {
  std::vector<Judgement> joint(study.size());
  for (std::size_t i = 0; i < study.size(); ++i) joint[i] = judge_status(study.status[i]);
  for (const Limit& limit : study.plan.limits) {
    const auto single = judge(study, limit);
    for (std::size_t i = 0; i < study.size(); ++i) {
      if (single[i] == Judgement::misses) joint[i] = Judgement::misses;
      if (single[i] == Judgement::unknown && joint[i] == Judgement::meets)
        joint[i] = Judgement::unknown;
    }
  }
  return joint;
}

}  // namespace cagetol
