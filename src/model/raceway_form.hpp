// Radial form of a raceway: how far it lies outside its circle, over the angle in the frame of its
// ring, which turns with the ring,
//   form(theta) = sum of a_k cos(k theta - phi_k)
// k waves each; theta as the angle of rollers, from y towards z.
#pragma once

#include <array>

#include "src/numerics/pack.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

inline bool is_round(const std::array<Waviness, kHarmonics>& form) {
  for (const Waviness& waves : form)
    if (waves.amplitude != 0) return false;
  return true;
}

/// Of the raceways of both rings.
struct RacewayForms {
  std::array<Waviness, kHarmonics> inner, outer;
  bool round = true;  ///< both are circles

  RacewayForms() = default;
  explicit RacewayForms(const BearingGeometry& b)
      : inner(b.inner_waviness),
        outer(b.outer_waviness),
        round(is_round(inner) && is_round(outer)) {}
};

/// Form and its first two derivatives by the angle [m].
struct FormAt {
  Pack height{}, slope{}, bend{};
};
inline FormAt form_at(const std::array<Waviness, kHarmonics>& form, Pack angle) {
  FormAt at;
  for (const Waviness& waves : form) {
    const double k = static_cast<double>(waves.count);
    Pack sine, cosine;
    sine_cosine(k * angle - waves.phase, sine, cosine);
    at.height += waves.amplitude * cosine;
    at.slope -= k * waves.amplitude * sine;
    at.bend -= k * k * waves.amplitude * cosine;
  }
  return at;
}

}  // namespace cagetol
