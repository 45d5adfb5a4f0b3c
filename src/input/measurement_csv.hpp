// Measured parts in a CSV file (csv_records.hpp): one header line with the names of the columns,
// then one line a part.
//
// A heading may give a unit (csv_heading.hpp): values are converted into the unit wanted, or
// refused where that cannot be; without one they are in the unit wanted. Numbers have a decimal
// point, or a decimal comma where that is asked for, and may have a leading plus sign.
#pragma once

#include <string>
#include <vector>

#include "src/input/input_error.hpp"

namespace cagetol {

struct WantedColumn {
  std::string name;  ///< the heading, or its name without the unit; capitals do not matter
  std::string unit;  ///< of the values wanted, as the suffix of a key: "mm"; empty: a pure number
  bool decimal_comma = false;
  bool gaps = false;       ///< an empty field is a value that is missing, not an error
  std::string group = {};  ///< heading of the column that says which parts belong together
};

/// One column of measured parts, by line.
struct MeasuredColumn {
  std::vector<double> values;       ///< NaN where missing
  std::vector<int> lines;           ///< of the file
  std::vector<std::string> labels;  ///< of the group; empty where none is asked for
  /// Headings of other columns that number or name parts: integers or text in every line, no unit.
  std::vector<std::string> label_columns;
};

/// From the bytes of a file; `file` names it in messages. Throws InputError with line and column.
/// What such a message quotes comes from files that hold numbers: other files may be nobody's
/// business.
MeasuredColumn measured_column(const std::string& bytes, const std::string& file,
                               const WantedColumn& wanted);

/// Its numbers alone.
std::vector<double> csv_column(const std::string& bytes, const std::string& file,
                               const WantedColumn& wanted);

}  // namespace cagetol
