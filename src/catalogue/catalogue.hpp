// The bearings that ship with the program by their designations: what a catalogue prints of them.
//
// inputs/catalogue.csv says where each number is from. A catalogue gives neither number nor
// length of the rollers: rated_rollers.hpp derives them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/input/choice.hpp"

namespace cagetol {

/// Flanges of the rings; NU: outer ring, NJ: outer ring and one side of the inner, NUP: both rings,
/// N: inner ring.
enum class BearingType { NU, NJ, NUP, N };
constexpr auto spellings(BearingType) {
  using enum BearingType;
  return std::array{Spelling{NU, "NU"}, Spelling{NJ, "NJ"}, Spelling{NUP, "NUP"}, Spelling{N, "N"}};
}

inline bool has_outer_flanges(BearingType type) {
  return type != BearingType::N;
}
inline bool has_inner_flanges(BearingType type) {
  return type != BearingType::NU;
}

/// One bearing. NaN: not published.
struct CatalogueRow {
  std::string designation;  ///< "NU 208 ECP"
  BearingType type = BearingType::NU;
  double bore = 0, outside = 0, width = 0;         ///< d, D, B [m]
  double inner_raceway = 0;                        ///< F [m]
  double outer_raceway = 0;                        ///< E [m]
  double inner_shoulder = 0, outer_shoulder = 0;   ///< d_1 and D_1 [m]
  double dynamic_rating = 0, static_rating = 0;    ///< C, C_0 [N]
  double reference_speed = 0, limiting_speed = 0;  ///< [rad/s]
  double minimum_load_factor = 0;                  ///< k_r
  bool uprated = false;            ///< C is 1.15 times that of ISO 281 with b_m = 1.1
  std::string outer_raceway_from;  ///< bearing whose row has E; "own row"; empty without E
};

/// All bearings, in the order of the table.
const std::vector<CatalogueRow>& catalogue();

/// Reads a table as text. Throws InputError, with `name` and the line, for a row that does not fit
/// the heading.
std::vector<CatalogueRow> read_catalogue(std::string_view text, const std::string& name);

/// The bearing of a designation. Case, blanks, hyphens and dots do not count, and the suffix may
/// be left out: "nu208" is NU 208 ECP. Throws InputError that lists the nearest designations.
const CatalogueRow& catalogue_row(std::string_view designation);

/// Bearings whose designations are nearest, at most `count`, nearest first.
std::vector<std::string> nearest_designations(std::string_view designation, std::size_t count);

/// Bearings whose designations hold `part`; all for an empty part.
std::vector<const CatalogueRow*> matching_rows(std::string_view part);

}  // namespace cagetol
