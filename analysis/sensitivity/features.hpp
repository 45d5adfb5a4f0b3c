// Scalar features of a cage that a tolerance or an inspection can control. Shares of variance refer
// to them.
#pragma once

#include <string>
#include <vector>

#include "analysis/study/study_data.hpp"

namespace cagetol {

struct Feature {
  std::string input;       ///< key of the scene, e.g. "cage.pocket_width_mm"
  std::string name;        ///< short and unique: "pocket width: from cage to cage"
  std::string definition;  ///< one sentence for the report
  std::string unit;
  std::vector<double> values;  ///< N
};

/// Every feature that varies in the study:
///   KEY: from cage to cage      deviation shared by the cage (from lot to lot: by its lot, where
///                               lots have several cages)
///   KEY: within-cage scatter    standard deviation over the cage's pockets
///   KEY: smallest pocket        smallest value of the cage (keys with nominal 0: the deviation of
///                               largest magnitude)
///   KEY: pocket in load zone    value of the pocket nearest to the load's direction when the run
///                               starts
///   KEY                         for keys drawn from the noise of the run
std::vector<Feature> cage_features(const StudyData& study);

/// Deviation of each pocket, one feature per pocket.
std::vector<Feature> pocket_features(const StudyData& study, const InputColumns& input);

/// Name of a key for people, different for every key: "pocket width" for cage.pocket_width_mm,
/// "roller diameter" for roller.diameter_mm, "cage width" for cage.width_mm.
std::string plain_name(const std::string& key);

}  // namespace cagetol
