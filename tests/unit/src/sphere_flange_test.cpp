// Spherical-ended rollers against inclined flanges.
#include "src/contacts/sphere_flange.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "src/input/input_error.hpp"
#include "src/integration/system.hpp"
#include "src/reading/scene_keys.hpp"
#include "src/scene/materials.hpp"
#include "src/simulate.hpp"
#include "tests/support/dense_jacobian.hpp"
#include "tests/support/random_bearing.hpp"
#include "tests/support/reference_scene.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

constexpr double kEnd = 0.4, kOuterHeight = 2.85e-3, kInnerHeight = 2.7e-3;

/// An NJ 205 with spherical roller ends, dry, without gravity, its rollers off the races and the
/// cage.
Scene round_ended() {
  Scene s;
  s.bearing.inner_flanges = FlangeSides::left;
  s.bearing.inner_flange_diameter = 34.7e-3;
  s.roller.end_radius = kEnd;
  s.bearing.outer_flange_angle = std::asin(kOuterHeight / kEnd);
  s.bearing.inner_flange_angle = std::asin(kInnerHeight / kEnd);
  s.operation.gravity = 0;
  s.operation.radial_load = 0;
  s.operation.axial_load = 300;
  return s;
}

void take_apart(BearingModel& m) {
  m.inner_radius -= 1e-3;
  m.outer_radius += 1e-3;
  for (CageGuide& guide : m.guides) guide.touching_at = 1, guide.film = {};
  for (RollerGroup& group : m.groups) {
    group.half_width += 1e-2;
    group.half_length += 1e-2;
  }
}

/// Rollers at the bearing's middle, standing still, of which the first may be moved.
struct Alone {
  Scene scene;
  BearingModel model;
  PackVector y;
  explicit Alone(const Scene& s) : scene(s), model(make_bearing_model(s)) {
    take_apart(model);
    y.assign(static_cast<std::size_t>(model.layout.size()), 0.0);
    for (int j = 0; j < model.layout.padded(); ++j)
      at(model.layout.position(kRadius, j)) = model.pitch_radius;
    for (int j = 0; j < model.layout.rollers; ++j)
      at(model.layout.position(kAngle, j)) = 2 * std::numbers::pi * j / model.layout.rollers;
  }
  double& at(int slot) { return y[static_cast<std::size_t>(slot)]; }
  double& position(RollerPosition slot) { return at(model.layout.position(slot, 0)); }
  double& velocity(RollerVelocity slot) { return at(model.layout.velocity(slot, 0)); }
  const Flange& flange(bool inner) const {
    for (const Flange& f : model.flanges)
      if (f.inner == inner && f.side == (inner ? -1 : 1)) return f;
    throw std::logic_error("no such flange");
  }
  /// Forces on the first roller by its accelerations: radial, tangential, axial, spin.
  struct Loads {
    double r, t, x, spin, normal;
  };
  Loads loads() {
    System system(model);
    EXPECT_TRUE(system.linearise_at(0, y.data()));
    const auto rate = [&](RollerVelocity slot) {
      return system.rate[static_cast<std::size_t>(model.layout.velocity(slot, 0))];
    };
    const RollerGroup& g = model.groups[0];
    const double r = position(kRadius), omega = velocity(kOrbitRate);
    return {g.mass[0] * (rate(kRadialSpeed) - r * omega * omega), g.mass[0] * r * rate(kOrbitRate),
            g.mass[0] * rate(kAxialSpeed), g.polar[0] * rate(kSpin), system.seen.flange_force[0]};
  }
};

double modulus(const Scene& s) {  // E*
  const Material steel = roller_material(s);
  return steel.young / (2 * (1 - steel.poisson * steel.poisson));
}
/// Mean of both curvatures of end and flange.
double mean_curvature(const BearingModel& m, bool inner) {
  const double way = inner ? -1 : 1, height = inner ? kInnerHeight : kOuterHeight;
  return 1 / kEnd - way * height / kEnd / (m.pitch_radius + way * height) / 2;
}

// delta = (9 F^2/(16 E*^2 R))^(1/3) for equal curvatures, which these nearly are.
TEST(SphereFlange, PushesByHertzAlongTheFlangesNormal) {
  for (const bool inner : {false, true}) {
    Alone a(round_ended());
    const double depth = 1e-6, sine = (inner ? kInnerHeight : kOuterHeight) / kEnd,
                 cosine = std::sqrt(1 - sine * sine), side = inner ? -1 : 1;
    a.position(kAxial) = side * (a.flange(inner).clearance + depth / cosine);
    if (inner) a.model.flanges[0].clearance = 1;
    const Alone::Loads on = a.loads();
    const double force = std::hypot(on.r, on.x), E = modulus(a.scene);
    const double approach =
        std::cbrt(9 * force * force * mean_curvature(a.model, inner) / (16 * E * E));
    EXPECT_NEAR(approach, depth, 0.01 * depth) << inner;
    EXPECT_NEAR(on.normal, force, 1e-9 * force);
    EXPECT_NEAR(on.x, -side * cosine * force, 1e-9 * force);
    EXPECT_NEAR(on.r, (inner ? 1 : -1) * sine * force, 1e-9 * force);
  }
}

// Friction takes hold R_e sin(angle) from the axis, and where a roller tilts R_e times the tilt
// away.
TEST(SphereFlange, TouchesAtItsHeight) {
  for (const bool inner : {false, true})
    for (const double tilt : {0.0, 1e-3}) {
      Alone a(round_ended());
      const double side = inner ? -1 : 1, height = inner ? -kInnerHeight : kOuterHeight;
      a.position(kAxial) = side * (a.flange(inner).clearance + 30e-6);
      if (inner) a.model.flanges[0].clearance = 1;
      a.position(kAxisY) = tilt;
      a.velocity(kSpin) = -900;
      a.model.duty.speed = a.model.duty.speed_from = {0, 0};
      const Alone::Loads on = a.loads();
      ASSERT_GT(on.normal, 10);
      EXPECT_NEAR(on.spin / on.t, height - side * kEnd * tilt * std::cos(height / kEnd), 2e-8)
          << inner << ' ' << tilt;
    }
}

/// Distance of a point from a cone about `axis` through the origin, from the generator that comes
/// nearest; these begin at the apex.
double cone_distance(const Vector3d& point, const Vector3d& axis, double apex,
                     const Vector3d& slope) {
  const Vector3d x = axis.normalized(), y = x.unitOrthogonal(), z = x.cross(y);
  const auto from = [&](double angle) {
    const Vector3d out = std::cos(angle) * y + std::sin(angle) * z,
                   along = slope.x() * x + slope.y() * out;
    const Vector3d d = point - apex * x;
    return (d - std::max(0.0, d.dot(along)) * along).norm();
  };
  double low = 0, high = 0, best = 1e9;
  for (int i = 0; i < 720; ++i) {
    const double angle = i * std::numbers::pi / 360;
    if (from(angle) < best) best = from(angle), low = angle - 0.02, high = angle + 0.02;
  }
  for (int i = 0; i < 200; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (from(a) < from(b) ? high : low) = from(a) < from(b) ? b : a;
  }
  return from((low + high) / 2);
}

// A rigid roller, turned as a whole, against a cone that may lean: exact but for the third order.
TEST(SphereFlange, HasTheDistanceOfASphereToACone) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> draw(-1, 1);
  for (int n = 0; n < 40; ++n) {
    const bool inner = n % 2 == 1;
    Scene s = round_ended();
    s.bearing.misalignment_y = 1e-3 * draw(random);
    s.bearing.misalignment_z = 1e-3 * draw(random);
    Alone a(s);
    const double side = inner ? -1 : 1, way = inner ? -1 : 1;
    const Flange& flange = a.flange(inner);
    const double angle = std::asin(flange.sphere.sine);
    a.position(kAxial) = side * (flange.clearance + 60e-6);
    a.position(kRadius) += 40e-6 * draw(random);
    a.position(kAxisY) = 1.5e-3 * draw(random);
    a.position(kAxisZ) = 1.5e-3 * draw(random);
    const int axial = a.model.layout.border_position(a.model.layout.ring_axial_slot());
    a.at(a.model.layout.border_position(kRingY)) = 20e-6 * draw(random);
    a.at(axial) = 20e-6 * draw(random);
    const double half = s.roller.length / 2;
    const Vector3d tilted = Vector3d(1, a.position(kAxisY), a.position(kAxisZ)).normalized(),
                   ring(a.at(axial), a.at(a.model.layout.border_position(kRingY)), 0);
    Vector3d centre =
        Vector3d(a.position(kAxial), a.position(kRadius), 0) + side * (half - kEnd) * tilted;
    Vector3d cone(1, 0, 0);
    if (inner) {
      centre -= ring;
      cone = Vector3d(1, s.bearing.misalignment_y, s.bearing.misalignment_z);
    }
    // The cone through the point that an upright roller at the clearance touches.
    const double r = a.model.pitch_radius + way * kEnd * std::sin(angle),
                 x = side * (half - kEnd + flange.clearance + kEnd * std::cos(angle));
    const Vector3d slope(-side * way * std::sin(angle), std::cos(angle), 0);
    const double apex = x - slope.x() / slope.y() * r;
    const double depth = kEnd - cone_distance(centre, cone, apex, slope);
    for (Flange& other : a.model.flanges)
      if (&other != &flange) other.clearance = 1;
    const double force = a.loads().normal,
                 found = std::pow(force / flange.sphere.stiffness, 2.0 / 3);
    ASSERT_GT(depth, 1e-6);
    EXPECT_NEAR(found, depth, 3e-10) << n;
  }
}

// An axial load presses rollers between a flange of each ring: both carry it, at Hertz's
// approaches.
TEST(SphereFlange, BalancesAnAxialLoad) {
  Alone a(round_ended());
  const Flange &outer = a.flange(false), &inner = a.flange(true);
  const int rollers = a.model.layout.rollers,
            slot = a.model.layout.border_position(a.model.layout.ring_axial_slot());
  const auto depth = [&](bool at_inner) {
    const Flange& f = at_inner ? inner : outer;
    const double force = 300 / (rollers * f.sphere.cosine), E = modulus(a.scene);
    return std::cbrt(9 * force * force * mean_curvature(a.model, at_inner) / (16 * E * E)) /
           f.sphere.cosine;
  };
  for (int j = 0; j < rollers; ++j)
    a.at(a.model.layout.position(kAxial, j)) = outer.clearance + depth(false);
  a.at(slot) = outer.clearance + depth(false) + inner.clearance + depth(true);
  a.model.duty.speed = a.model.duty.speed_from = {0, 0};
  System system(a.model);
  ASSERT_TRUE(system.linearise_at(0, a.y.data()));
  const auto rate = [&](int at) { return system.rate[static_cast<std::size_t>(at)]; };
  const double left =
      a.model.ring_mass * rate(a.model.layout.border_velocity(a.model.layout.ring_axial_slot()));
  EXPECT_NEAR(left, 0, 0.02 * 300);
  for (int j = 0; j < rollers; ++j) {
    EXPECT_NEAR(a.model.groups[0].mass[0] * rate(a.model.layout.velocity(kAxialSpeed, j)), 0,
                0.02 * 300 / rollers);
    EXPECT_NEAR(system.seen.flange_force[static_cast<std::size_t>(j)], 2 * 300.0 / rollers,
                0.02 * 300 / rollers);
  }
}

// Sliding by hand: the roller's end at r w_c + h w_s, h outwards; a flange at its own speed. The
// torque of the ring is friction times the point's distance from the bearing's axis.
TEST(SphereFlange, RubsByCoulombAtItsSliding) {
  for (const bool inner : {false, true}) {
    Alone a(round_ended());
    const double side = inner ? -1 : 1, height = inner ? -kInnerHeight : kOuterHeight;
    const double r = a.model.pitch_radius, orbit = 240, spin = -2600, turns = inner ? 600 : 0;
    a.position(kAxial) = side * (a.flange(inner).clearance + 1e-6);
    if (inner) a.model.flanges[0].clearance = 1;
    a.velocity(kOrbitRate) = orbit;
    a.velocity(kSpin) = spin;
    a.model.duty.speed = a.model.duty.speed_from = {600, 0};
    System system(a.model);
    ASSERT_TRUE(system.linearise_at(0, a.y.data()));
    const double v = r * orbit + height * spin - turns * (r + height),
                 Q = system.seen.flange_force[0];
    const double coefficient = a.scene.contact.friction_dynamic;
    ASSERT_GT(std::abs(v), a.scene.contact.dynamic_speed);
    EXPECT_NEAR(system.seen.lost[kFlangeFriction], coefficient * Q * std::abs(v), 1e-5 * Q * 0.6);
    const double torque = coefficient * Q * (r + height);
    EXPECT_NEAR(std::abs(system.seen.drive_power), torque * turns, 1e-4 * torque * 600);
  }
}

// Oil holds the bodies apart: the load is that of the film at the gap and the mean of both
// surfaces' speeds as seen from the point, the friction that of the film with the bodies' spin.
TEST(SphereFlange, RidesOnItsFilm) {
  for (const bool inner : {false, true}) {
    Scene s = round_ended();
    s.lubrication.model = LubricationModel::film;
    s.lubrication.churning = false;
    Alone a(s);
    const double side = inner ? -1 : 1, height = inner ? -kInnerHeight : kOuterHeight, gap = 0.6e-6;
    const Flange& flange = a.flange(inner);
    const SphereFlange& f = flange.sphere;
    const double r = a.model.pitch_radius, orbit = 240, spin = -1500, turns = inner ? 600 : 0;
    a.position(kAxial) = side * (flange.clearance - gap / f.cosine);
    if (inner) a.model.flanges[0].clearance = 1;
    a.velocity(kOrbitRate) = orbit;
    a.velocity(kSpin) = spin;
    a.model.duty.speed = a.model.duty.speed_from = {600, 0};
    System system(a.model);
    ASSERT_TRUE(system.linearise_at(0, a.y.data()));
    const double on_roller = r * orbit + height * spin, on_ring = turns * (r + height),
                 drawn = (on_roller + on_ring) / 2 - orbit * (r + height);
    const PointState<double> film = point_state(f.film, film_speed(drawn), gap);
    const double load = starved_load(film, oil_factors(film.thickness * (1 / f.film.layer)).wedge);
    EXPECT_GT(load, 1);
    EXPECT_NEAR(system.seen.flange_force[0], load, 1e-4 * load);
    const double v = on_roller - on_ring, w = f.cosine * (spin - turns);
    // All points of the ellipse slide by the spin as well.
    const double gyration = f.film.area * std::pow(load, 2.0 / 3) / (2 * std::numbers::pi);
    const PointFriction<double> rubs = point_friction(f.film, a.model.friction[kFlangePair], load,
                                                      film.thickness, v * v + gyration * w * w);
    EXPECT_GT(rubs.turning, 0);
    const double power = rubs.drag * v * v + rubs.turning * w * w;
    EXPECT_NEAR(system.seen.lost[kFlangeFriction], power, 1e-3 * power);
  }
}

/// Random bearings whose only contacts are those of spherical roller ends.
RandomBearing only_spheres(unsigned seed, bool lubricated) {
  RandomBearing b = random_bearing(seed, {.lubricated = lubricated, .sphere_ends = true});
  take_apart(b.model);
  b.model.churning.on = false;
  b.model.outer_line.starved = true;  // oil does not reach so far
  b.model.outer_line.layer = b.model.inner_line.layer;
  return b;
}

TEST(SphereFlange, DerivativesAreExact) {
  for (const bool lubricated : {false, true})
    for (unsigned seed = 0; seed < 24; ++seed) {
      const RandomBearing b = only_spheres(seed, lubricated);
      System system(b.model);
      ASSERT_TRUE(system.linearise_at(b.t, b.y.data()));
      const Eigen::MatrixXd found = assembled_jacobian(b.model, b.y, system.linear),
                            due = differenced_jacobian(b.model, b.t, b.y, system.scale, 1e-4);
      double size = 0, apart = 0;
      for (int i = 0; i < found.rows(); ++i)
        for (int k = 0; k < found.cols(); ++k) {
          const double row = system.scale[static_cast<std::size_t>(i)],
                       column = system.scale[static_cast<std::size_t>(k)];
          if (row > 1e20 || column > 1e20) continue;
          size = std::max(size, std::abs(due(i, k)) * column / row);
          apart = std::max(apart, std::abs(found(i, k) - due(i, k)) * column / row);
        }
      ASSERT_GT(size, 0);
      EXPECT_LT(apart, 1e-6 * size) << (lubricated ? "oiled" : "dry") << ", seed " << seed;
    }
}

/// The NJ 308 with a rigid cage, its ends spheres of 620 mm against flanges of half a degree, which
/// meet 5.4 mm from the rollers' axes, or flat.
Outcome run_nj308(bool round, double axial) {
  Scene scene = shipped_scene("nj308-axial");
  scene.cage.model = CageKind::rigid;
  scene.operation.axial_load = -axial;
  if (round) {
    scene.roller.end_radius = 0.62;
    scene.bearing.outer_flange_angle = scene.bearing.inner_flange_angle =
        0.5 * std::numbers::pi / 180;
  }
  return simulate(scene);
}
double flange_torque(const Outcome& outcome) {  // [N mm]
  return 1e3 * quantity(outcome, "power_flange_W") / (4750 * std::numbers::pi / 30);
}

// Spherical roller ends on inclined flanges rub less than flat ones, and less than the term that a
// maker gives for these (SKF rolling bearings catalogue 17000, frictional moment, table 1c: 0.16
// d_m^0.9 F_a mu, mu = 0.02 of a full film).
TEST(SphereFlange, RubsLessThanAFlatOneInARun) {
  const double axial = 600, maker = 0.16 * std::pow(65, 0.9) * axial * 0.02;
  const Outcome flat = run_nj308(false, axial), round = run_nj308(true, axial);
  ASSERT_EQ(round.status, Status::ok) << round.reason;
  EXPECT_LT(round.run.energy_residual, 1e-3);
  RecordProperty("flat_Nmm", std::to_string(flange_torque(flat)));
  RecordProperty("sphere_Nmm", std::to_string(flange_torque(round)));
  EXPECT_GT(flange_torque(round), 0.05 * flange_torque(flat));
  EXPECT_LT(flange_torque(round), 0.5 * flange_torque(flat));
  EXPECT_LT(flange_torque(round), maker);
  EXPECT_LT(quantity(round, "friction_torque_Nmm"), quantity(flat, "friction_torque_Nmm"));
}

std::string refused(const std::string& overrides) {
  try {
    read_scene(reference_scene_table(overrides, "t.toml"), "t.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SphereFlange, IsRefusedWhereEndAndFaceDoNotMeet) {
  EXPECT_THAT(refused("[bearing]\nouter_flange_angle_deg = 0.4\n"),
              HasSubstr("at the edge of its corner only"));
  EXPECT_THAT(refused("[roller]\nend_radius_mm = 400\n"), HasSubstr("at its axis, beyond the rim"));
  // 2.85 mm is in the middle between the rim at 2.4 mm and the corner at 3.3 mm.
  EXPECT_THAT(refused("[roller]\nend_radius_mm = 400\n"), HasSubstr("give an angle, 0.408"));
  const std::string steep =
      refused("[roller]\nend_radius_mm = 400\n[bearing]\nouter_flange_angle_deg = 0.6\n");
  EXPECT_THAT(steep, HasSubstr("meet 4.189 mm from the roller's axis"));
  EXPECT_THAT(steep, HasSubstr("from 2.4 to 3.3 mm"));
  EXPECT_THAT(steep, HasSubstr("an angle from 0.344 to 0.473"));
  EXPECT_THAT(steep, HasSubstr("end_radius_mm from 229.187 to 315.133"));
  EXPECT_EQ(refused("[roller]\nend_radius_mm = 400\n[bearing]\nouter_flange_angle_deg = 0.408\n"),
            "");
}

}  // namespace
}  // namespace cagetol
