// Utilisation of a flexible cage's fatigue strength at its stress stations.
//
// Von Mises stress has no sign, so the amplitude is taken of the components. Over one revolution of
// the cage, at each station:
//
//   s_a,c    = +-(max s_c - min s_c) / 2    of each of the six components c
//   s_m,c    = (max s_c + min s_c) / 2
//   sigma_a  = von Mises stress of s_a,c
//
// with the sign of the covariance with the component of the largest range: components that swing
// against each other, as in shear, add up, and stress that swings in proportion has the same
// sigma_a in all axes.
//
// and over the window, by the modified Goodman line:
//
//   utilisation = Q(sigma_a) / sigma_w + max(0, sigma_1(mean of s_m,c)) / R_m
//
// sigma_w: fully reversed fatigue strength, R_m: tensile strength [Pa]; Q: smallest value that at
// least 99 % of the revolutions do not exceed, of fewer than 100 revolutions the largest; sigma_1:
// largest principal stress, which is at least the mean stress along any direction of the surface.
// Where components do not swing in proportion, s_a,c combines extremes of different instants.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "src/scene/scene.hpp"

namespace cagetol {

class CageFatigue {
 public:
  /// `stations` per sector.
  CageFatigue(long stations, long sectors);

  /// Stress at an instant [Pa]: row stations (6 sector + component) + station, components xx, yy,
  /// zz, xy, yz, zx.
  void add(const Eigen::VectorXf& stress);
  /// Ends a revolution of the cage.
  void end_revolution();

  struct Place {
    double utilisation = 0;
    double amplitude = 0, mean = 0;  ///< Q(sigma_a), and the mean stress of the other term [Pa]
    long sector = 0, station = 0;
  };
  /// Of the station with the largest utilisation, over the complete revolutions; of a window
  /// without one over what there is.
  Place worst(const Strength& strength) const;

 private:
  /// sigma_a of this revolution so far, at each station of each sector [Pa].
  Eigen::VectorXf amplitudes() const;

  long stations_, sectors_;
  long instants_ = 0;  ///< in this revolution
  Eigen::VectorXf first_, lowest_, highest_;
  Eigen::VectorXf sums_;      ///< of stress less `first_`
  Eigen::VectorXf products_;  ///< sums of products: row stations (15 sector + pair) + station
  Eigen::VectorXd means_;     ///< sum over revolutions of s_m,c
  std::vector<Eigen::VectorXf> amplitude_;  ///< sigma_a of each revolution
};

}  // namespace cagetol
