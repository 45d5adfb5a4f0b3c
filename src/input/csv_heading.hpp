// The heading of a column of measurements: its name, and the unit where it gives one.
//
//   width [mm]   width (mm)   Width / mm   Width, mm   Breite in mm   width_mm
//
// What stands in square brackets is a unit; elsewhere only what is one. After an underscore that is
// the suffix of a key, or cm, inch, thou, micron and the like ("in" alone is a word).
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cagetol {

struct CsvHeading {
  std::string name;  ///< without the unit
  std::string unit;  ///< as written; empty: none is given
};
CsvHeading csv_heading(std::string_view text);

/// The headings that `column` names, as positions from 0: those that read exactly so; else those
/// whose name is the same, and whose unit too where `column` gives one; else the same regardless of
/// capitals. More than one: the name is ambiguous.
std::vector<std::size_t> named_columns(const std::vector<std::string>& headings,
                                       std::string_view column);

}  // namespace cagetol
