// The closed sets of a scene and their spellings in input files (src/input/choice.hpp). scene.hpp
// has the defaults.
#pragma once

#include "src/contact_laws/contact_parameters.hpp"
#include "src/input/choice.hpp"

namespace cagetol {

/// Equations of motion, or equilibria without integration.
enum class MotionModel { dynamic, quasi_static };
constexpr auto spellings(MotionModel) {
  using enum MotionModel;
  return std::array{Spelling{dynamic, "dynamic"}, Spelling{quasi_static, "quasi-static"}};
}

/// Tilt of the inner ring.
enum class TiltModel { prescribed, free };
constexpr auto spellings(TiltModel) {
  using enum TiltModel;
  return std::array{Spelling{prescribed, "prescribed"}, Spelling{free, "free"}};
}

/// Axial profile of the rollers; logarithmic: ISO/TS 16281.
enum class RollerProfile { none, logarithmic };
constexpr auto spellings(RollerProfile) {
  using enum RollerProfile;
  return std::array{Spelling{none, "none"}, Spelling{logarithmic, "logarithmic"}};
}

/// Sides of a ring that have a flange; left: at -x.
enum class FlangeSides { both, none, left, right };
constexpr auto spellings(FlangeSides) {
  using enum FlangeSides;
  return std::array{Spelling{both, "both"}, Spelling{none, "none"}, Spelling{left, "left"},
                    Spelling{right, "right"}};
}
constexpr bool has_flange(FlangeSides sides, bool right) {
  return sides == FlangeSides::both || sides == (right ? FlangeSides::right : FlangeSides::left);
}

/// Cage without or with elastic modes.
enum class CageKind { rigid, flexible };
constexpr auto spellings(CageKind) {
  using enum CageKind;
  return std::array{Spelling{rigid, "rigid"}, Spelling{flexible, "flexible"}};
}

/// What guides the cage: shoulders of the outer ring, inner ring, or rollers.
enum class Guidance { outer, inner, roller };
constexpr auto spellings(Guidance) {
  using enum Guidance;
  return std::array{Spelling{outer, "outer"}, Spelling{inner, "inner"}, Spelling{roller, "roller"}};
}

constexpr auto spellings(ForceLaw) {
  using enum ForceLaw;
  return std::array{Spelling{impact, "impact"}, Spelling{hertz, "hertz"}};
}

/// Elastic approach of roller and race by `hertz`; palmgren: a bearing maker's formula, line: the
/// two-dimensional theory (src/contact_laws/line_approach.hpp).
enum class RaceApproach { palmgren, line };
constexpr auto spellings(RaceApproach) {
  using enum RaceApproach;
  return std::array{Spelling{palmgren, "palmgren"}, Spelling{line, "line"}};
}

/// Oil in the whole bearing (src/lubrication).
enum class LubricationModel { none, film };
constexpr auto spellings(LubricationModel) {
  using enum LubricationModel;
  return std::array{Spelling{none, "none"}, Spelling{film, "film"}};
}

/// How oil comes to a bearing, for layers and oil share that a scene leaves open
/// (src/lubrication/oil_supply.hpp).
enum class OilSupply { automatic, bath, circulation, oil_air, grease };
constexpr auto spellings(OilSupply) {
  using enum OilSupply;
  return std::array{Spelling{automatic, "auto"}, Spelling{bath, "bath"},
                    Spelling{circulation, "circulation"}, Spelling{oil_air, "oil-air"},
                    Spelling{grease, "grease"}};
}

/// State from which a run starts (src/statics/start_state.hpp).
enum class StartState { automatic, steady, equilibrium, centred };
constexpr auto spellings(StartState) {
  using enum StartState;
  return std::array{Spelling{automatic, "auto"}, Spelling{steady, "steady"},
                    Spelling{equilibrium, "equilibrium"}, Spelling{centred, "centred"}};
}

/// Time integration methods (src/integration/integrator.hpp).
enum class IntegrationMethod {
  rodas3,         ///< linearly implicit (Rosenbrock), 4 stages, order 3(2), L-stable
  rodasp,         ///< the same with 6 stages, order 4(3): the least error for its time
  cvode_bdf,      ///< CVODE, BDF with its order capped by integration.max_order
  arkode_esdirk,  ///< ARKODE, diagonally implicit, order 3, L-stable
  arkode_erk      ///< ARKODE, explicit, order 3: limited by stability
};
constexpr auto spellings(IntegrationMethod) {
  using enum IntegrationMethod;
  return std::array{Spelling{rodas3, "rodas3"}, Spelling{rodasp, "rodasp"},
                    Spelling{cvode_bdf, "cvode-bdf"}, Spelling{arkode_esdirk, "arkode-esdirk"},
                    Spelling{arkode_erk, "arkode-erk"}};
}

}  // namespace cagetol
