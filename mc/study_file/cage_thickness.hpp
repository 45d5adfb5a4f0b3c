// What scattering diameters of a flexible cage leave wrong. Contacts, clearances, mass and inertia
// follow each sample; its elasticity is that of the cage with nominal diameters. Errors are
// relative and grow with the deviations of both surfaces together, as a share of the thickness:
//   share = (|D_o - D_o nominal| + |D_i - D_i nominal|) / (D_o nominal - D_i nominal)
// Largest of three cages against tables of their own
// (tests/validation/cage/cage_thickness_test.cpp).
#pragma once

namespace cagetol {

/// Error per share: 1.3 says that a share of 1 % leaves 1.3 %.
inline constexpr double kFrequencyErrorPerShare = 1.3;   ///< of the first twelve modes
inline constexpr double kComplianceErrorPerShare = 2.9;  ///< of bars under a force
inline constexpr double kStressErrorPerShare = 3.2;      ///< largest, under a force on a bar

}  // namespace cagetol
