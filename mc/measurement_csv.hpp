// Measured parts in a CSV file: one header line with the names of the columns, then one line a
// part. Lines that start with # are comments. Columns are separated by commas or, where the header
// has any, semicolons. Numbers use a decimal point.
#pragma once

#include <string>
#include <vector>

#include "src/input/input_error.hpp"

namespace cagetol {

/// The numbers of one column of CSV text; `file` names it in messages. Empty fields are errors, not
/// gaps. Throws InputError with the line for text in a number, and with the names of the columns
/// for a missing one.
std::vector<double> csv_column(const std::string& text, const std::string& file,
                               const std::string& column);

}  // namespace cagetol
