// Exact bounds for a probability from independent trials.
//
// Clopper & Pearson 1934, doi:10.1093/biomet/26.4.404. With k successes in n trials the one-sided
// bounds at confidence c are
//   lower = BetaInv(1 - c; k, n - k + 1),  upper = BetaInv(c; k + 1, n - k).
// k and n need not be integers. For weighted and clustered samples Korn & Graubard 1998 use an
// effective number of trials:
//   n* = y (1 - y) / Var(y),   k = y n*
#pragma once

namespace cagetol {

/// One-sided lower bound of the probability of success; 0 without successes or without trials.
double clopper_pearson_lower(double successes, double trials, double confidence);

/// One-sided upper bound; 1 without failures or without trials.
double clopper_pearson_upper(double successes, double trials, double confidence);

}  // namespace cagetol
