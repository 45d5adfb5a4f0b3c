// Number, diameter and length of a catalogue bearing's rollers from its load ratings.
//
//   D_we = (E - F)/2                     where the catalogue has both raceways
//   L_we = sqrt(L_C L_0)                 C(Z, D_we, L_C) = C,  C_0(Z, D_we, L_0) = C_0
//
// C by ISO 281 with b_m = 1.1, or 1.1 x 1.15 for bearings that the catalogue marks as uprated, C_0
// by ISO 76 (src/quantities/load_rating.hpp). Ratings hardly tell Z: C_0 fixes Z L_we, and then C
// goes by Z^(-1/36). Z is therefore the largest number that leaves the cage its bars, less what
// would make rollers shorter than 0.86 of their diameter: standard ones are as long as thick at
// least, and their chamfers do not carry.
//
// Without E, D_we is the multiple of half a millimetre at which both ratings agree best, among
// those that make the outer ring's flanges (E - D_1)/2 from 0.1 to 0.3 D_we high.
#pragma once

#include "src/catalogue/catalogue.hpp"
#include "src/quantities/load_rating.hpp"

namespace cagetol {

/// Both ratings are met within this share.
inline constexpr double kRatingError = 0.03;

struct RollerDiameter {
  double diameter = 0;        ///< D_we [m]
  double outer_raceway = 0;   ///< E [m]
  double pitch_diameter = 0;  ///< D_pw = (E + F)/2 [m]
  bool from_ratings = false;  ///< the catalogue has no E
};

struct RatedSet {
  RatedRollers rollers;
  double dynamic_error = 0, static_error = 0;  ///< of C and C_0, relative to the catalogue's
};

/// b_m of the catalogue's ratings.
double rating_factor(const CatalogueRow& row);

/// Throws InputError where E is not known and no diameter meets both ratings.
RollerDiameter roller_diameter(const CatalogueRow& row);

/// Rollers that take up at most 82 % of their pitch circle, as those of NU 205 do.
long most_rollers(const RollerDiameter& roller);

/// Up to `most` rollers that meet both ratings. Throws InputError, with the figure, where none do
/// within kRatingError, or where they would be longer than 0.78 B.
RatedSet rated_set(const CatalogueRow& row, const RollerDiameter& roller, long most);

}  // namespace cagetol
