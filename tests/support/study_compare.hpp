// Compares study files to the bit: every group, dataset and attribute except what lies below
// /timing.
#pragma once

#include <string>
#include <vector>

namespace cagetol {

/// What differs, in words; empty when the files say the same.
std::vector<std::string> study_file_differences(const std::string& first,
                                                const std::string& second);

}  // namespace cagetol
