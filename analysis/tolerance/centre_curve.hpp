// Yield against the centre of a tolerance: what a setting beside the nominal value costs or gains.
//
// The dimension's lot (its pockets, where it has no lot) is moved as a whole and every run weighted
// by its density there (tolerance_density.hpp). No run is made for it, so the effective number of
// runs falls with the distance; below kFewestEffectiveRuns nothing is shown.
#pragma once

#include <vector>

#include "analysis/tolerance/recommendation.hpp"

namespace cagetol {

struct CentreYield {
  std::vector<double> shifts_mm;  ///< from the centre, one for each dimension
  double ess = 0;
  Yield yield;  ///< only where ess suffices
};

struct CentreCurves {
  std::vector<std::vector<CentreYield>> dimensions;  ///< one dimension moved, the others centred
  std::vector<CentreYield> map;                      ///< the first two moved together
};

/// About the centres of this tolerance, in steps of 1/32 of each tolerance, up to an eighth. Throws
/// Refused where a law has no density.
CentreCurves centre_curves(const StudyData& runs, const MixtureWeights& mixture,
                           const Tolerance& tolerance, const std::vector<Judgement>& joint,
                           const Resampling& resampling, double confidence);

}  // namespace cagetol
