// Load ratings, rating life and minimum load of a radial cylindrical roller bearing with one row.
//
//   C    = b_m f_c L^(7/9) Z^(3/4) D^(29/27)                        basic dynamic rating [N]
//   f_c  = 172.6 g^(2/9) (1 - g)^(29/27) / (1 + g)^(1/4)
//          / (1 + (1.04 ((1 - g)/(1 + g))^(143/108))^(9/2))^(2/9)
//   C_0  = 44 (1 - g) Z L D                                         basic static rating [N]
//   L_10 = 10^6 (C/P)^(10/3)                                        rating life [revolutions]
//   F_S  = k_r (6 + 4 n/n_r) (d_m/100)^2 1000                       minimum load, SKF [N]
//   F_C  = C_0/60                                                   minimum load, Schaeffler [N]
//
// Z number of rollers, L and D their length and diameter [mm], g = D/D_pw, D_pw pitch diameter
// [mm], b_m = 1.1 for machined rings, P equivalent load: the radial load [N], k_r factor of the
// series, n speed, n_r thermal reference speed, d_m = (d + D_outside)/2 [mm]. The functions take
// SI. L_10 is the life that 90 % of bearings reach, for P <= C/2, without the influence of
// lubricant, dirt and misalignment.
//
// Sources: ISO 281:2007, 7.1 and 7.3 (f_c: its table 7 from the formula of ISO/TR 1281-1:2008,
// 0.83 x 207.9 = 172.6); ISO 76:2006, 6.1; minimum loads: SKF General Catalogue (cylindrical roller
// bearings, "minimum load"), Schaeffler HR 1 (likewise, C_0r/P_0 < 60).
#pragma once

namespace cagetol {

/// Rollers of one row, as ratings see them.
struct RatedRollers {
  long count = 0;             ///< Z
  double diameter = 0;        ///< D [m]
  double length = 0;          ///< L [m]
  double pitch_diameter = 0;  ///< D_pw [m]
};

/// f_c of g = D/D_pw in (0, 1), for lengths in mm and forces in N.
double geometry_factor(double ratio);

double dynamic_rating(const RatedRollers& rollers);  ///< C [N]
double static_rating(const RatedRollers& rollers);   ///< C_0 [N]

/// Infinite without a load [revolutions].
double rating_life(double dynamic_rating, double load);

/// F_S; `speed_ratio` = n/n_r, `mean_diameter` = d_m [m] -> [N].
double minimum_load_skf(double factor, double speed_ratio, double mean_diameter);

double minimum_load_schaeffler(double static_rating);  ///< F_C [N]

}  // namespace cagetol
