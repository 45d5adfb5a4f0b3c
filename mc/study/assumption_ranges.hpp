// Ranges of assumptions as alternatives to a study: other values of one key that nobody can rule
// out. Scatter and noise stay what they are: an alternative is a state of knowledge, no draw.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <vector>

#include "mc/study/study.hpp"

namespace cagetol {

/// One end of the range of an assumption.
struct Alternative {
  std::string key, unit, note;
  double low = 0, high = 0;     ///< the range
  double value = 0;             ///< its end that this is
  std::vector<double> nominal;  ///< of the study: one value, or one for each pocket; NaN: "auto"
};

/// Both ends of every range, in the order of the assumptions; without ends that are the study's own
/// nominal value and without keys that do nothing in its scene.
std::vector<Alternative> alternatives_of(const Study& study);

/// Sets the nominal value, of every pocket where there is one for each; laws stay as they are.
/// `study` has to be resolved anew (changed_study).
void apply_alternative(const Alternative& alternative, Study& study);

/// Throws InputError where an alternative makes no scene, or laws leave the range of the key.
void check_assumption_ranges(const Study& study, const toml::table& scene, const std::string& file);

/// Ranges of keys that do nothing in the scene of a study with candidate tolerances, one sentence
/// for each reason.
std::vector<std::string> idle_range_notes(const Study& study);

}  // namespace cagetol
