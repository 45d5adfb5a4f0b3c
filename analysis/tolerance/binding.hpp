// Does a dimension's tolerance change the yield at all?
//
// For each dimension the yield at its narrowest candidate is compared with the yield at each wider
// one, run by run on the same samples (yield_difference), the other dimensions averaged over the
// combinations among which the decision lies: those that meet the target with at least one
// tolerance of the dimension tested (hopelessly wide ones would only add noise). Three answers:
//   binding      some difference is significant. Two-sided Student t test over lots, family error
//                1 - confidence over all comparisons of all dimensions (Bonferroni).
//   not binding  no difference is significant, AND the loss of yield from the narrowest to any
//                wider candidate is, with that confidence, below the margin of the narrowest over
//                the target, AND the widest combination that meets the target (the cheapest, where
//                costs are stated) has the dimension at its widest. Such a dimension is left at its
//                widest, which must withhold no tolerance that passes. Absence of evidence alone is
//                not taken for an answer. With fewer than five effective failures at the wider
//                candidate the loss is bounded by these failures (Clopper-Pearson at the effective
//                sample size).
//   undecided    neither. Such a dimension is treated as binding.
// Runs without a judgement count both ways, each as passing or failing so that the difference is
// least or largest. Comparisons with fewer than kFewestEffectiveRuns effective runs or kFewestLots
// effective lots decide nothing.
#pragma once

#include <string>
#include <vector>

#include "analysis/tolerance/yield_curve.hpp"

namespace cagetol {

enum class Binding { binding, not_binding, undecided };
const char* binding_name(Binding binding);

struct BindingTest {
  std::string key;
  Binding answer = Binding::undecided;
  double largest_loss = 0;        ///< largest estimated loss of yield from the narrowest to a wider
                                  ///< candidate, unknown runs counted so that it is largest
  double largest_loss_bound = 1;  ///< its upper bound
  double allowed_loss = 0;        ///< yield of the narrowest candidate less the target, at least 0
  std::string narrowest, widest;  ///< names of the candidates compared
};

std::vector<BindingTest> test_binding(const StudyData& runs, const MixtureWeights& mixture,
                                      const YieldCurves& curves,
                                      const std::vector<Judgement>& joint,
                                      const Resampling& resampling);

/// The candidate's tolerances without that of dimension d, and its centres.
std::vector<double> rest_of(const Candidate& candidate, std::size_t d);

/// "IT9", or "0.05 mm" where the tolerance is no grade.
std::string tolerance_name(const std::string& grade, double tolerance_width_mm);

}  // namespace cagetol
