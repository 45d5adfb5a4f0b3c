// Whether each sample meets the limits. Failed, jammed and censored samples are outcomes and never
// dropped.
#pragma once

#include <vector>

#include "analysis/study/study_data.hpp"

namespace cagetol {

/// A jammed cage does not meet the limits. A run that failed, was censored or poisoned, or whose
/// quantity is undefined, is unknown: every yield is then given twice, as if all of them failed and
/// as if all of them passed.
enum class Judgement { meets, misses, unknown };

/// Judgement of every sample by one limit.
std::vector<Judgement> judge(const StudyData& study, const Limit& limit);

/// Judgement by all limits together: one miss decides; otherwise one unknown makes it unknown.
std::vector<Judgement> judge_all(const StudyData& study);

}  // namespace cagetol
