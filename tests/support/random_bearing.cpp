#include "tests/support/random_bearing.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace cagetol {
namespace {

using std::numbers::pi;

class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  /// Uniform in [-size, size].
  double about(double size) { return size * (2 * unit() - 1); }
  double between(double low, double high) { return low + (high - low) * unit(); }
  bool coin() { return unit() < 0.5; }

 private:
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  std::mt19937_64 engine_;
};

}  // namespace

Scene random_scene(unsigned seed, double lean) {
  Draw draw(seed);
  Scene s;
  const bool sixteen = seed % 2 == 1;
  s.bearing.roller_count = sixteen ? 16 : 13;
  if (sixteen) {
    s.bearing.inner_raceway_diameter = 56.49e-3;
    s.bearing.outer_raceway_diameter = 74.51e-3;
    s.bearing.shoulder_diameter = 70.3e-3;
    s.bearing.bore_diameter = 45e-3;
    s.bearing.internal_clearance = 0;
    s.roller.length = 10e-3;
    s.cage.inner_diameter = 62e-3;
    s.cage.outer_diameter = 70e-3;
    s.cage.width = 16e-3;
  }
  const double diameter = sixteen ? 9e-3 : 7.5e-3;
  s.bearing.misalignment_y = lean * draw.about(2e-3);
  s.bearing.misalignment_z = lean * draw.about(2e-3);
  const auto n = static_cast<std::size_t>(s.bearing.roller_count);
  for (auto* list : {&s.roller.diameter, &s.roller.taper, &s.cage.pocket_width,
                     &s.cage.pocket_length, &s.cage.pocket_pitch, &s.cage.pocket_squareness})
    list->assign(n, 0.0);
  for (std::size_t j = 0; j < n; ++j) {
    s.roller.diameter[j] = diameter + draw.about(5e-6);
    s.roller.taper[j] = draw.about(8e-6);
    s.cage.pocket_width[j] = diameter + draw.between(0.1e-3, 0.3e-3);
    s.cage.pocket_length[j] = s.roller.length + draw.between(0.1e-3, 0.3e-3);
    s.cage.pocket_pitch[j] = draw.about(2e-3);
    s.cage.pocket_squareness[j] = lean * draw.about(3e-3);
  }
  s.roller.profile = draw.coin() ? RollerProfile::logarithmic : RollerProfile::none;
  const Guidance guidances[] = {Guidance::outer, Guidance::inner, Guidance::roller};
  s.cage.guidance = guidances[seed / 2 % 3];
  s.cage.guide_clearance = 0.15e-3;
  s.contact.race.law = draw.coin() ? ForceLaw::hertz : ForceLaw::impact;
  s.contact.bar.law = draw.coin() ? ForceLaw::hertz : ForceLaw::impact;
  s.discretisation.race_slices = seed / 6 % 2 == 0 ? 5 : 1;
  s.discretisation.bar_stations = seed / 12 % 2 == 0 ? 3 : 2;
  s.operation.radial_load = 1000;
  s.operation.load_ramp = 1e-3;
  s.operation.speed_ramp = draw.coin() ? 2e-3 : 0;
  s.operation.speed_ramp_from = 500;
  s.operation.gravity = draw.coin() ? 9.81 : 0;
  if (seed % 3 == 2) {  // both rings turn, loads turn, the shaft leans
    Draw more(seed + 3000017);
    s.operation.outer_speed = more.about(400);
    s.operation.outer_ramp_from = more.about(400);
    s.operation.load_direction = more.about(3);
    s.operation.rotating_load = more.between(100, 500);
    if (more.coin()) s.operation.rotating_speed = more.about(900);
    s.operation.rotating_phase = more.about(3);
    s.operation.unbalance = more.between(1e-4, 1e-3);
    s.operation.shaft_inclination = more.about(1.5);
  }
  return s;
}

/// Elastic modes of random shape, of the size and frequency that a steel cage's have; no stress.
std::shared_ptr<const CageModel> random_cage(const Scene& s, int modes, Draw& draw) {
  CageModel cage;
  cage.bar_stations = s.discretisation.bar_stations;
  cage.points = 2 * cage.bar_stations + 8;
  const auto fill = [&](auto& matrix, long rows, long columns, double size) {
    matrix.resize(rows, columns);
    for (double& x : matrix.reshaped()) x = draw.about(size);
  };
  fill(cage.contact, 3 * cage.points * s.bearing.roller_count, modes, 8);
  fill(cage.frequency, modes, 1, 5e3);
  cage.frequency.array() += 10e3;
  fill(cage.centrifugal, modes, 1, 2e-3);
  fill(cage.gyroscopic, modes, modes, 0.5);
  cage.gyroscopic = (cage.gyroscopic - cage.gyroscopic.transpose()).eval();
  return std::make_shared<const CageModel>(std::move(cage));
}

const char* freedom_name(Freedom freedom) {
  return freedom == Freedom::spatial ? "spatial" : "tilting";
}

const char* outline_name(Outline outline) {
  return outline == Outline::flat    ? "flat"
         : outline == Outline::edges ? "edges"
         : outline == Outline::lips  ? "lips"
                                     : "curved";
}

void shape_pockets(Outline outline, Scene& scene) {
  if (outline == Outline::flat) return;
  auto& cage = scene.cage;
  const double diameter = scene.roller.diameter[0];
  cage.edge_radius = 0.3e-3;
  if (outline == Outline::curved) cage.face_radius = diameter / 2 + 0.2e-3;
  if (outline == Outline::lips) {
    cage.retention_outer.clear();
    cage.retention_inner.clear();
    for (long j = 0; j < scene.bearing.roller_count; ++j) {  // of each pocket its own
      cage.retention_outer.push_back((0.92 - 0.002 * static_cast<double>(j % 3)) * diameter);
      cage.retention_inner.push_back((0.9 - 0.002 * static_cast<double>(j % 4)) * diameter);
    }
  }
}

/// A place of the roller's axis in its pocket, `depth` at most from a part of the bar on side s:
/// heights and ways along the tangent from the cage's centre.
struct PocketPlace {
  double height, along;
};
PocketPlace beside_bar(const RollerGroup& g, int lane, Outline outline, double depth, double s,
                       Draw& draw) {
  const double R = g.radius[lane], play = g.half_width[lane] - R;
  const bool inner = draw.coin();
  const OutlineArc& end = g.ends[inner ? 0 : 1];
  const double outwards = inner ? -1 : 1;
  const auto from = [&](const OutlineArc& arc, double w, double u) {
    return PocketPlace{arc.height[lane] + w, s * (arc.offset[lane] + u)};
  };
  const double apart = R + end.radius + draw.about(depth);
  if (outline == Outline::lips) {
    const double u = s * 0.8 * draw.about(play) - end.offset[lane];
    return from(end, -outwards * std::sqrt(apart * apart - u * u), u);
  }
  const double low = std::atan2(g.ends[0].low_w[lane], g.ends[0].low_u[lane]),
               high = std::atan2(g.ends[1].high_w[lane], g.ends[1].high_u[lane]);
  if (outline == Outline::curved && draw.coin()) {
    const double along = draw.between(0.9 * low, 0.9 * high),
                 d = g.face.radius - R + draw.about(depth);
    return from(g.face, d * std::sin(along), d * std::cos(along));
  }
  // Beyond the normal at the face's end.
  const double turned = (inner ? low : high) - outwards * draw.between(0.1, 0.9);
  return from(end, -apart * std::sin(turned), -apart * std::cos(turned));
}

/// Lets the inner ring tilt, held by a shaft, under a moment.
void free_the_ring(unsigned seed, Scene& scene) {
  Draw draw(seed + 3000017);
  scene.model.ring_tilt = TiltModel::free;
  if (scene.cage.guidance == Guidance::inner) scene.cage.guidance = Guidance::roller;
  scene.bearing.tilt_stiffness = draw.between(0, 2e4);
  scene.operation.tilting_moment_y = draw.about(10);
  scene.operation.tilting_moment_z = draw.about(10);
}

/// Makes an NUP or an N, whose inner ring has flanges; under an axial load or without one.
void flange_the_inner_ring(unsigned seed, Scene& scene) {
  Draw draw(seed + 4000037);
  auto& b = scene.bearing;
  b.inner_flanges = FlangeSides::both;
  b.inner_flange_diameter = b.inner_raceway_diameter + draw.between(2e-3, 4e-3);
  b.inner_flange_clearance = draw.between(0.05e-3, 0.1e-3);
  if (draw.coin())
    scene.operation.axial_load = draw.about(500);
  else
    b.outer_flanges = FlangeSides::none;
}

/// Spherical roller ends, which meet every flange in the middle of its face.
void round_the_ends(unsigned seed, Scene& scene) {
  Draw draw(seed + 6000011);
  auto& b = scene.bearing;
  scene.roller.end_radius = draw.between(0.2, 0.6);
  const double pitch = pitch_radius(b), edge = 0.44 * scene.roller.diameter[0];
  const auto angle = [&](double rim) {
    return std::asin((std::abs(rim / 2 - pitch) + edge) / 2 / scene.roller.end_radius);
  };
  b.outer_flange_angle = angle(b.shoulder_diameter);
  if (b.inner_flanges != FlangeSides::none) b.inner_flange_angle = angle(b.inner_flange_diameter);
}

/// Waviness on both raceways.
void wave_the_raceways(unsigned seed, Scene& scene) {
  Draw draw(seed + 5000011);
  for (auto* form : {&scene.bearing.inner_waviness, &scene.bearing.outer_waviness})
    for (Waviness& waves : *form)
      waves = {draw.about(15e-6), static_cast<long>(draw.between(1, 9)), draw.about(3)};
}

void oil_the_lands(const Scene& scene, BearingModel& model) {
  Scene oiled = scene;
  oiled.lubrication.model = LubricationModel::film;
  oiled.lubrication.viscosity = 0.02;
  oiled.contact.race.law = oiled.contact.bar.law = ForceLaw::hertz;
  model.guides[0] = make_bearing_model(oiled).guides[0];
}

RandomBearing random_bearing(unsigned seed, const RandomBearingOptions& options) {
  RandomBearing b{random_scene(seed, options.lean), {}, {}, 0};
  if (options.freedom == Freedom::tilting) free_the_ring(seed, b.scene);
  if (options.inner_flanges && options.freedom == Freedom::spatial && seed % 4 == 3)
    flange_the_inner_ring(seed, b.scene);
  if (options.sphere_ends) round_the_ends(seed, b.scene);
  if (options.wavy) wave_the_raceways(seed, b.scene);
  if (options.lubricated) {
    b.scene.lubrication.model = LubricationModel::film;
    b.scene.contact.race.law = b.scene.contact.bar.law = ForceLaw::hertz;
  }
  shape_pockets(options.outline, b.scene);
  if (options.outline != Outline::flat) b.scene.bearing.internal_clearance = 10e-3;
  Draw shapes(seed + 2000003), draw(seed + 1000003);
  b.model = make_bearing_model(
      b.scene, options.modes > 0 ? random_cage(b.scene, options.modes, shapes) : nullptr);
  if (options.oiled_lands) oil_the_lands(b.scene, b.model);
  const BearingModel& m = b.model;
  const StateLayout& l = m.layout;
  b.t = draw.between(0, 1.5e-3);
  b.y.assign(static_cast<std::size_t>(l.size()), 0.0);
  const auto at = [&](int slot) -> double& { return b.y[static_cast<std::size_t>(slot)]; };
  const double depth = options.depth, lean = options.lean;
  const RingSpeeds rings = ring_speeds_at(m.duty, b.t);
  const double orbit = kinematic_cage_speed(m, rings);
  const double sliding[] = {0.03, 0.3, 3};  // below v_s, between, above v_d

  const double phi = draw.about(0.5);
  const double turn_y = std::cos(phi) * m.unbalance_y - std::sin(phi) * m.unbalance_z;
  const double turn_z = std::sin(phi) * m.unbalance_y + std::cos(phi) * m.unbalance_z;
  const double whirl = draw.between(0, 2 * pi);
  const double ring_y = draw.about(depth), ring_z = draw.about(depth);
  double reach = m.guide_clearance + draw.about(depth);
  double cage_y = reach * std::cos(whirl), cage_z = reach * std::sin(whirl);
  if (m.guidance == Guidance::inner) cage_y += ring_y, cage_z += ring_z;
  const double cage_x = draw.about(0.1e-3);
  const double cage_axis_y = lean * draw.about(2e-3), cage_axis_z = lean * draw.about(2e-3);
  const double cage_speed = orbit * (1 + draw.about(0.02));
  for (int j = 0; j < l.rollers; ++j) {
    const RollerGroup& g = m.groups[static_cast<std::size_t>(j / kLanes)];
    const int lane = j % kLanes;
    const double pocket = phi + std::atan2(g.pocket_sin[lane], g.pocket_cos[lane]);
    const double radius = m.pitch_radius + draw.about(depth);
    const double clearance = g.half_width[lane] - g.radius[lane];
    const double side = draw.coin() ? 1 : -1;
    // Where the pocket is, seen from the bearing's centre, then near one of its bars.
    const double cage_t = -std::sin(pocket) * cage_y + std::cos(pocket) * cage_z;
    const double offset = cage_t + side * (clearance + draw.about(depth));
    const double slide = sliding[j % 3];
    at(l.position(kRadius, j)) = radius;
    at(l.position(kAngle, j)) = pocket + offset / radius;
    if (options.outline != Outline::flat) {
      const PocketPlace place = beside_bar(g, lane, options.outline, depth, side, draw);
      const double y = cage_y + place.height * std::cos(pocket) - place.along * std::sin(pocket),
                   z = cage_z + place.height * std::sin(pocket) + place.along * std::cos(pocket);
      at(l.position(kRadius, j)) = std::hypot(y, z);
      at(l.position(kAngle, j)) = pocket + std::remainder(std::atan2(z, y) - pocket, 2 * pi);
    }
    const double axial = draw.coin()
                             ? m.flanges.back().clearance
                             : std::abs(cage_x) + g.half_length[lane] - m.roller_half_length;
    at(l.position(kAxial, j)) = (draw.coin() ? 1 : -1) * (axial + draw.about(depth));
    at(l.position(kAxisY, j)) = lean * draw.about(2e-3);
    at(l.position(kAxisZ, j)) = lean * draw.about(2e-3);
    at(l.velocity(kRadialSpeed, j)) = draw.about(0.1);
    at(l.velocity(kOrbitRate, j)) = orbit + draw.about(slide) / radius;
    at(l.velocity(kAxialSpeed, j)) = draw.about(0.1);
    at(l.velocity(kAxisRateY, j)) = draw.about(10);
    at(l.velocity(kAxisRateZ, j)) = draw.about(10);
    const double rolling = (m.pitch_radius * orbit - m.inner_radius * rings.inner) / g.radius[lane];
    at(l.velocity(kSpin, j)) = rolling + draw.about(slide) / g.radius[lane];
  }
  const double positions[kRigidBorder] = {ring_y, ring_z, cage_y + turn_y, cage_z + turn_z,
                                          cage_x, phi,    cage_axis_y,     cage_axis_z};
  const double rates[kRigidBorder] = {draw.about(0.1), draw.about(0.1), draw.about(0.3),
                                      draw.about(0.3), draw.about(0.1), cage_speed,
                                      draw.about(10),  draw.about(10)};
  for (int i = 0; i < kRigidBorder; ++i) {
    at(l.border_position(i)) = positions[i];
    at(l.border_velocity(i)) = rates[i];
  }
  for (int k = 0; k < options.modes; ++k) {
    at(l.border_position(kModes + k)) = shapes.about(depth / 30);
    at(l.border_velocity(kModes + k)) = shapes.about(0.01);
  }
  if (l.ring_axial > 0) {
    at(l.border_position(l.ring_axial_slot())) = shapes.about(depth);
    at(l.border_velocity(l.ring_axial_slot())) = shapes.about(0.1);
  }
  for (int k = 0; k < l.ring_tilt; ++k) {
    at(l.border_position(l.ring_tilt_slot() + k)) = lean * shapes.about(2e-3);
    at(l.border_velocity(l.ring_tilt_slot() + k)) = shapes.about(10);
  }
  // Padding as a run has it: somewhere harmless.
  for (int j = l.rollers; j < l.padded(); ++j) at(l.position(kRadius, j)) = m.pitch_radius;
  return b;
}

}  // namespace cagetol
