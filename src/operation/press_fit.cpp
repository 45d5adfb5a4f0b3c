#include "src/operation/press_fit.hpp"

namespace cagetol {
namespace {

/// Which causes act.
struct Causes {
  bool heat, spin;
};

double free_growth(const FitBody& body, Causes causes, double radius) {
  double growth = 0;
  if (causes.heat) growth += body.heat * radius;
  if (causes.spin) growth += spinning_growth(body.ring, body.speed, radius);
  return growth;
}

FitState state_under(const PressFit& fit, Causes causes) {
  const double at = fit.radius;
  const double left = fit.interference / 2 + free_growth(fit.inside, causes, at) -
                      free_growth(fit.outside, causes, at);
  const double give =
      pressed_growth(fit.outside.ring, 1, 0, at) - pressed_growth(fit.inside.ring, 0, 1, at);
  return {2 * left, left > 0 ? left / give : 0};
}

double growth_under(const PressFit& fit, bool outside, double radius, Causes causes) {
  const FitBody& body = outside ? fit.outside : fit.inside;
  const double pressure = state_under(fit, causes).pressure;
  return free_growth(body, causes, radius) +
         pressed_growth(body.ring, outside ? pressure : 0, outside ? 0 : pressure, radius);
}

}  // namespace

FitState fit_state(const PressFit& fit) {
  return state_under(fit, {true, true});
}

Growth fit_growth(const PressFit& fit, bool outside, double radius) {
  const double pressed = growth_under(fit, outside, radius, {false, false}),
               hot = growth_under(fit, outside, radius, {true, false}),
               spinning = growth_under(fit, outside, radius, {true, true});
  return {2 * pressed, 2 * (hot - pressed), 2 * (spinning - hot)};
}

}  // namespace cagetol
