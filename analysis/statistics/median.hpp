// Small statistics of repeated measurements.
#pragma once

#include <vector>

namespace cagetol {

/// Middle value, the mean of the two middle ones of an even count; NaN of none.
double median(std::vector<double> values);

/// Likewise, NaN where one of the values is.
double median_of_whole(std::vector<double> values);

}  // namespace cagetol
