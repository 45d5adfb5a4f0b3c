// The bearing's right-hand side once more, written from the equations alone: one roller and one
// contact point at a time, three- vectors in inertial Cartesian directions (x, y, z), std::pow, no
// packs. Kinematics is stated once per contact as the speeds of its three channels; generalised
// forces come from that map's transpose, column by column, never from algebra of their own.
// Equations: src/NOTATION.md. Slow and plain on purpose: a reference for tests.
#pragma once

#include <array>
#include <vector>

#include "src/model/state.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

enum ContactKind { kInnerRace, kOuterRace, kBar, kWall, kFlange, kLand, kContactKinds };

struct Reference {
  std::vector<double> rates;  ///< dy/dt in the order of the state vector; padding zero
  std::vector<double>
      gross;  ///< sum of the sizes of all contacts' contributions to each acceleration
  std::array<int, kContactKinds> touching{};  ///< contact points with penetration
  std::array<int, kContactKinds> pulling{};   ///< of these, clamped at zero force
  double elastic_energy = 0;                  ///< [J]
  double friction_power = 0, damping_power = 0, drive_power = 0, load_power = 0;  ///< [W]
};

StateLayout reference_layout(const Scene& scene);

Reference reference_rates(const Scene& scene, double t, const std::vector<double>& y);

/// Adams STEP, IMPACT and friction as physics.md prints them: N, mm inside.
double reference_step(double x, double x0, double h0, double x1, double h1);
double reference_normal_force(const ContactParameters& law, double length, double penetration,
                              double rate);
double reference_friction_coefficient(const Contacts& contact, double speed);

}  // namespace cagetol
