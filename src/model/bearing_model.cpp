// Above 400 lines: one part after another of a single model.
#include "src/model/bearing_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "src/cage/mesh/cage_mass.hpp"
#include "src/contact_laws/hertz_line.hpp"
#include "src/contact_laws/hertz_point.hpp"
#include "src/lubrication/lubricant.hpp"
#include "src/model/race_stiffness.hpp"
#include "src/operation/heat_shed.hpp"
#include "src/operation/operating_scene.hpp"
#include "src/scene/materials.hpp"
#include "src/scene/oil_supply.hpp"
#include "src/scene/pocket_outline.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;

constexpr double kWatchedShare = 0.01;  ///< of the load (of 1 N at least): a film that bears load

/// Mass of the inner ring as a plain hollow cylinder [kg].
double ring_mass(const BearingGeometry& b, double inner_race_diameter) {
  return properties_of(b.ring_material).density * b.width * pi / 4 *
         (inner_race_diameter * inner_race_diameter - b.bore_diameter * b.bore_diameter);
}

/// ISO/TS 16281 logarithmic profile drop at axial position x of a roller of diameter D and length L
/// [m].
double profile_drop(RollerProfile profile, double x, double diameter, double length) {
  if (profile == RollerProfile::none) return 0;
  const double s = 2 * x / length;
  return 0.00035 * diameter * std::log(1 / (1 - s * s));
}

/// Puts the outline of the bars of a pocket into lane `lane`.
void set_outline(const PocketOutline& outline, double roller_radius, int lane, RollerGroup& g) {
  constexpr double kBeyond = 1;  // farther than any roller [m]
  const OutlineEnd &low = outline.end[0], &high = outline.end[1];
  g.face_low[lane] = low.lip ? -kBeyond : low.height;
  g.face_high[lane] = high.lip ? kBeyond : high.height;
  const auto set_normals = [&](OutlineArc& arc) {
    arc.low_w[lane] = low.normal_height;
    arc.low_u[lane] = low.normal_offset;
    arc.high_w[lane] = high.normal_height;
    arc.high_u[lane] = high.normal_offset;
  };
  if (outline.curved) {
    g.face.hollow = true;
    g.face.radius = outline.face_radius;
    g.face.travel = outline.face_radius / (outline.face_radius - roller_radius);
    g.face.height[lane] = outline.face_height;
    g.face.offset[lane] = outline.face_offset;
    set_normals(g.face);
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const OutlineEnd& end = outline.end[k];
    OutlineArc& arc = g.ends[k];
    arc.edge = end.lip ? 0 : k == 0 ? -1 : 1;
    arc.radius = outline.edge_radius;
    arc.travel = outline.edge_radius / (outline.edge_radius + roller_radius);
    arc.height[lane] = end.height;
    arc.offset[lane] = end.offset;
    set_normals(arc);
  }
}

RollerGroup make_group(const Scene& scene, int group) {
  RollerGroup g;
  const long z = scene.bearing.roller_count;
  for (int lane = 0; lane < kLanes; ++lane) {
    const long j = group * kLanes + lane;
    g.exists[lane] = j < z;
    const long k = j < z ? j : 0;  // padding copies roller 0; `exists` keeps it out of every sum
    const double radius = each(scene.roller.diameter, k) / 2, length = scene.roller.length;
    const double mass = roller_material(scene).density * pi * radius * radius * length;
    g.mass[lane] = mass;
    g.polar[lane] = mass * radius * radius / 2;
    g.transverse[lane] = mass * (3 * radius * radius + length * length) / 12;
    g.inverse_mass[lane] = 1 / g.mass[lane];
    g.inverse_polar[lane] = 1 / g.polar[lane];
    g.inverse_transverse[lane] = 1 / g.transverse[lane];
    g.radius[lane] = radius;
    g.taper_slope[lane] = each(scene.roller.taper, k) / (2 * length);
    const double even = 2 * pi * static_cast<double>(j) / static_cast<double>(z),
                 angle = even + each(scene.cage.pocket_pitch, k);
    g.pocket_cos[lane] = std::cos(angle);
    g.pocket_sin[lane] = std::sin(angle);
    g.half_width[lane] = each(scene.cage.pocket_width, k) / 2;
    g.half_length[lane] = each(scene.cage.pocket_length, k) / 2;
    g.squareness[lane] = each(scene.cage.pocket_squareness, k);
    set_outline(pocket_outline(scene.cage, pitch_radius(scene.bearing), k), radius, lane, g);
  }
  return g;
}

/// Two points of the roller's end face at +-0.8 R tangentially, kept inside the face at radial
/// offset `radial`.
std::array<EndPoint, 2> end_points(double radius, double radial) {
  const double inside = std::sqrt(std::max(0.0, radius * radius - radial * radial));
  const double t = std::min(0.8 * radius, inside);
  return {EndPoint{radial, -t}, EndPoint{radial, t}};
}

std::array<FrictionLaw, kFrictionPairs> friction_laws(const Contacts& c) {
  const auto law = [&](const ContactParameters& of) {
    return FrictionLaw{
        given_or(of.friction_static, c.friction_static),
        given_or(of.friction_dynamic, c.friction_dynamic),
        given_or(of.static_speed, c.static_speed),
        given_or(of.dynamic_speed, c.dynamic_speed),
    };
  };
  return {law(c.race), law(c.bar), law(c.end), law(c.flange), law(c.land)};
}

/// Of a disc, what lies within `height` of its rim [m2].
double segment_area(double radius, double height) {
  const double h = std::clamp(height, 0.0, 2 * radius), inside = radius - h;
  return radius * radius * std::acos(inside / radius) - inside * std::sqrt(h * (2 * radius - h));
}

/// Oil of a scene at its operating temperature.
struct OperatingOil {
  double viscosity, pressure_viscosity, fall, density;  ///< [Pa s], [1/Pa], beta [1/K], [kg/m3]
  double limiting_shear;                                ///< Lambda
};
OperatingOil operating_oil(const Lubrication& l) {
  const Oil& named = lubricant_named(l.lubricant).oil;
  const ViscosityCurve curve = viscosity_curve(given_or(l.viscosity_40, named.viscosity_40),
                                               given_or(l.viscosity_100, named.viscosity_100));
  const double density = oil_density(given_or(l.density, named.density_15), l.temperature),
               nu = kinematic_viscosity(curve, l.temperature);
  return {given_or(l.viscosity, 1e-6 * nu * density),
          given_or(l.pressure_viscosity, pressure_viscosity(named, nu)),
          viscosity_fall(curve, l.temperature), density,
          given_or(l.limiting_shear, named.limiting_shear())};
}

/// Film of one of `slices` slices or stations of a roller of `length`; `radius` reduced,
/// `stiffness_modulus` for the elastic approach.
LubricatedLine line_of(const Scene& scene, const ContactParameters& contact,
                       const OperatingOil& oil, const FrictionLaw& boundary, double modulus,
                       double stiffness_modulus, double radius, double roughness, double length,
                       long slices) {
  const Lubrication& l = scene.lubrication;
  LubricatedLine line;
  line.squeeze = l.squeeze;
  line.rolls = l.rolling_resistance;
  line.shears = l.film_traction;
  line.length = length / static_cast<double>(slices);
  // Of the whole contact: its share of the length bears the same load per length.
  const NormalLaw whole = make_normal_law(contact, length, 1, stiffness_modulus);
  line.chi = whole.chi;
  const double approach = elastic_penetration(whole, length);  // at 1 N/m
  line.film = make_line_film(oil.viscosity, oil.pressure_viscosity, radius, modulus, approach);
  line.rolling = make_rolling_resistance(oil.viscosity, oil.pressure_viscosity, radius, modulus,
                                         l.inlet_heating, oil.fall, l.conductivity);
  line.traction = make_traction(oil.viscosity, oil.pressure_viscosity, radius, modulus,
                                l.eyring_stress, oil.limiting_shear, roughness);
  line.boundary = boundary;
  return line;
}

/// Of all pockets.
double mean_pocket_length(const Scene& scene) {
  double mean = 0;
  for (long j = 0; j < scene.bearing.roller_count; ++j) mean += each(scene.cage.pocket_length, j);
  return mean / static_cast<double>(scene.bearing.roller_count);
}

/// Axial width of a land over which it touches [m]; 0: at its middle.
double land_width(const Scene& scene) {
  const auto& contact = scene.contact;
  const bool points = contact.race.law == ForceLaw::impact && contact.bar.law == ForceLaw::impact;
  return given_or(scene.cage.land_width,
                  points ? 0 : (scene.cage.width - mean_pocket_length(scene)) / 2);
}

CageGuide ring_guide(const Scene& scene, bool inner) {
  CageGuide guide;
  guide.inner = inner;
  guide.land_radius = (inner ? scene.cage.inner_diameter : scene.cage.outer_diameter) / 2;
  guide.ring_radius =
      (inner ? inner_land_diameter(scene.bearing) : outer_land_diameter(scene.bearing)) / 2;
  guide.clearance = std::abs(guide.ring_radius - guide.land_radius);
  guide.touching_at = guide.clearance;
  return guide;
}

/// Contact of a spherical-ended roller with a flange, curved by 1/R_e along it and by that and the
/// cone's curvature around it.
HertzPoint sphere_contact(const Scene& scene, const BearingModel& m, bool inner) {
  const double radius = scene.roller.end_radius, sine = std::sin(sphere_flange_angle(scene, inner)),
               way = inner ? -1 : 1, place = m.pitch_radius + way * radius * sine;
  return hertz_point(1 / (1 / radius - way * sine / place), radius,
                     effective_modulus(roller_material(scene), ring_material(scene)));
}

SphereFlange sphere_flange(const Scene& scene, const BearingModel& m, const Flange& flange) {
  const ContactParameters& law = scene.contact.flange;
  const double angle = sphere_flange_angle(scene, flange.inner);
  SphereFlange to;
  to.on = true;
  to.radius = scene.roller.end_radius;
  to.centre = flange.side * (scene.roller.length / 2 - to.radius);
  to.sine = std::sin(angle);
  to.cosine = std::cos(angle);
  to.rest = m.pitch_radius;
  to.stiffness = sphere_contact(scene, m, flange.inner).stiffness;
  to.damping = law.damping;
  to.inverse_depth = 1 / law.damping_depth;
  return to;
}

void set_flanges(const Scene& scene, BearingModel& m) {
  const BearingGeometry& b = scene.bearing;
  for (const bool inner : {false, true})
    for (const bool right : {false, true}) {
      if (!has_flange(inner ? b.inner_flanges : b.outer_flanges, right)) continue;
      const double clearance =
          inner ? given_or(b.inner_flange_clearance, b.flange_clearance) : b.flange_clearance;
      const double rim = (inner ? b.inner_flange_diameter : b.shoulder_diameter) / 2,
                   half_pad = has_end_film(scene) ? flange_pad(scene, inner) / 2 : 0,
                   middle = rim + (inner ? -half_pad : half_pad) - m.pitch_radius;
      m.flanges.push_back({inner, right ? 1.0 : -1.0, clearance / 2,
                           end_points(m.nominal_diameter / 2, middle), FlatFilm{}, SphereFlange{}});
      if (sphere_flange_angle(scene, inner) > 0)
        m.flanges.back().sphere = sphere_flange(scene, m, m.flanges.back());
    }
}

/// What guides the cage, and what holds it else.
void set_guides(const Scene& scene, BearingModel& m) {
  const auto& c = scene.cage;
  const double mean_length = mean_pocket_length(scene);
  m.guidance = c.guidance;
  m.land_offset = given_or(c.land_offset, (c.width + mean_length) / 4);
  const bool inner = m.guidance == Guidance::inner;
  m.guides = {ring_guide(scene, inner), ring_guide(scene, !inner)};
  CageGuide& guide = m.guides[0];
  if (m.guidance == Guidance::roller) {
    m.guide_clearance = std::min({roller_guide_clearance(scene, m.pitch_radius),
                                  m.guides[0].clearance, m.guides[1].clearance});
    return;
  }
  guide.touching_at = guide.clearance = m.guide_clearance =
      given_or(c.guide_clearance, guide.clearance);
  if (!has_land_film(scene)) return;
  const Lubrication& l = scene.lubrication;
  const double radius = (guide.land_radius + guide.ring_radius) / 2,
               width = given_or(l.land_film_width, (c.width - mean_length) / 2);
  const double viscosity = operating_oil(l).viscosity;
  const double turned = 2 * pi * viscosity * radius * width;
  guide.film = {true,
                viscosity * radius * width * width * width,
                turned * radius * radius,
                turned,
                m.guide_clearance,
                l.land_film_minimum,
                oil_layers(l).land};
  guide.touching_at -= l.land_film_minimum;
}

/// E' of rollers and bars [Pa].
double bar_modulus(const Scene& scene) {
  return effective_modulus(roller_material(scene), cage_material(scene));
}

HeatAccount heat_account(const Scene& scene) {
  const Temperatures& t = scene.temperature;
  if (!t.balance || std::isnan(t.found)) return {};
  return {true, t.found, t.found_power, t.found_slope, heat_shed(scene).slope};
}

/// Fills the model with oil. To be called when its geometry is there.
void lubricate(const Scene& scene, BearingModel& m) {
  const Lubrication& l = scene.lubrication;
  const auto& b = scene.bearing;
  const auto& cage = scene.cage;
  const Contacts& contact = scene.contact;
  const OperatingOil oil = operating_oil(l);
  const double roller = m.nominal_diameter / 2, length = scene.roller.length;
  const OilLayers layers = oil_layers(l);
  const auto race = [&](double curvature, double layer) {
    LubricatedLine line = line_of(scene, contact.race, oil, m.friction[kRacePair],
                                  effective_modulus(roller_material(scene), ring_material(scene)),
                                  race_stiffness_modulus(scene), 1 / (1 / roller + curvature),
                                  given_or(contact.race.roughness, l.race_roughness), length,
                                  static_cast<long>(m.race_slices.size()));
    line.starved = std::isfinite(layer);
    line.layer = layer;
    return line;
  };
  m.lubricated = true;
  m.inner_line = race(1 / m.inner_radius, layers.inner);
  m.outer_line = race(-1 / m.outer_radius, layers.outer);
  m.film_watch = kWatchedShare * std::max(largest_load(m.duty), 1.0) /
                 static_cast<double>(m.race_slices.size());
  m.oiled_bars = l.pocket_film;
  const auto pocket = [&](double curvature) {
    const double modulus = bar_modulus(scene);
    LubricatedLine line = line_of(scene, contact.bar, oil, m.friction[kBarPair], modulus, modulus,
                                  curvature == 0 ? roller : 1 / (1 / roller + curvature),
                                  given_or(contact.bar.roughness, l.pocket_roughness), length,
                                  static_cast<long>(m.bar_stations.size()));
    line.starved = true;
    line.layer = layers.pocket;
    return line;
  };
  m.bar_line = pocket(m.curved_faces ? -1 / cage.face_radius : 0);
  m.edge_line = pocket(1 / cage.edge_radius);
  if (l.end_film) {
    const auto flat = [&](const ContactParameters& of, double area, bool squeeze) {
      return make_flat_film(oil.viscosity, area, layers.pocket,
                            given_or(of.roughness, l.pocket_roughness), 2, squeeze);
    };
    const double face = pi * roller * roller,
                 wall = m.nominal_diameter * (cage.outer_diameter - cage.inner_diameter) / 2;
    m.wall_film = flat(contact.end, std::min(face, wall), l.squeeze);
    // Rollers that an axial load presses against flanges squeeze out next to nothing there, in many
    // steps.
    const bool squeezed = l.squeeze && m.layout.ring_axial == 0;
    for (Flange& flange : m.flanges) {
      const double pad = flange_pad(scene, flange.inner), reach = flange.points[0].radial;
      if (flange.sphere.on) {
        // Oil ends where its layer does, or the roller's end.
        const double end = roller - corner_radius(scene),
                     height = flange.sphere.radius * flange.sphere.sine,
                     gap = (end * end - height * height) / (2 * flange.sphere.radius),
                     minimum = 0.1e-6;  // growth may take the point to the end of a face
        const Traction traction =
            make_traction(oil.viscosity, oil.pressure_viscosity, flange.sphere.radius,
                          m.race_modulus, l.eyring_stress, oil.limiting_shear,
                          given_or(contact.flange.roughness, l.pocket_roughness));
        flange.sphere.film = make_point_film(
            sphere_contact(scene, m, flange.inner), traction, std::max(pad, minimum),
            std::min(layers.pocket, std::max(gap, minimum)), l.film_traction);
        continue;
      }
      flange.film =
          with_wedge(flat(contact.flange, segment_area(std::abs(reach) + pad / 2, pad), squeezed),
                     oil.viscosity, pad, 2);
    }
  }
  if (!l.churning) return;
  Churning& c = m.churning;
  c.on = true;
  c.fluid = free_space_fluid(layers.share, oil.density, oil.viscosity);
  c.roller = 0.5 * c.fluid.density * l.roller_drag * m.nominal_diameter * length;
  c.carried_along = l.carried_along;
  c.inner_radius = cage.inner_diameter / 2;
  c.outer_radius = cage.outer_diameter / 2;
  c.width = cage.width;
  if (m.guidance != Guidance::inner) c.bore_gap = std::max(0.0, c.inner_radius - m.inner_radius);
  if (m.guidance != Guidance::outer)
    c.outer_gap = std::max(0.0, outer_land_diameter(b) / 2 - c.outer_radius);
}

/// Mass, strength and guide of the cage.
void set_cage(const Scene& scene, BearingModel& m) {
  const CageMass cage = cage_mass(scene.cage, scene.bearing.roller_count);
  m.cage_mass = given_or(scene.cage.mass, cage.mass);
  m.cage_polar = given_or(scene.cage.polar_inertia, cage.polar_inertia);
  m.cage_transverse = given_or(scene.cage.transverse_inertia, cage.transverse_inertia);
  m.cage_strength = cage_strength(scene);
  const double off_centre = scene.cage.unbalance / m.cage_mass;
  m.unbalance_y = cage.centre_y + off_centre * std::cos(scene.cage.unbalance_phase);
  m.unbalance_z = cage.centre_z + off_centre * std::sin(scene.cage.unbalance_phase);
  set_guides(scene, m);
}

}  // namespace

BearingModel make_bearing_model(const OperatingScene& scene,
                                std::shared_ptr<const CageModel> flexible) {
  BearingModel m;
  const auto& b = scene.bearing;
  m.layout.rollers = static_cast<int>(b.roller_count);
  m.layout.groups = (m.layout.rollers + kLanes - 1) / kLanes;
  m.curved_faces = !std::isnan(scene.cage.face_radius);
  m.shaped_pockets = has_shaped_pockets(scene.cage);
  m.layout.ring_tilt = has_free_ring_tilt(scene) ? 2 : 0;
  m.layout.ring_axial = has_free_axial_place(scene) ? 1 : 0;
  for (int g = 0; g < m.layout.groups; ++g) m.groups.push_back(make_group(scene, g));
  if (flexible) m.flexible = make_flexible_cage(flexible, scene.cage, m.layout.groups);
  m.layout.modes = m.flexible.modes;

  for (long j = 0; j < b.roller_count; ++j) m.nominal_diameter += each(scene.roller.diameter, j);
  m.nominal_diameter /= static_cast<double>(b.roller_count);
  const double length = scene.roller.length;
  const long slices = scene.discretisation.race_slices,
             stations = scene.discretisation.bar_stations;
  if (slices > kMostSlices) throw std::domain_error("bearing model: too many race slices");
  for (long k = 0; k < slices; ++k) {
    const double x = ((static_cast<double>(k) + 0.5) / static_cast<double>(slices) - 0.5) * length;
    m.race_slices.push_back({x, profile_drop(scene.roller.profile, x, m.nominal_diameter, length)});
  }
  for (long k = 0; k < stations; ++k)  // from -0.4 L to 0.4 L
    m.bar_stations.push_back(
        stations == 1
            ? 0.0
            : (-0.4 + 0.8 * static_cast<double>(k) / static_cast<double>(stations - 1)) * length);
  m.roller_half_length = length / 2;

  m.race_modulus = effective_modulus(roller_material(scene), ring_material(scene));
  m.race = make_normal_law(scene.contact.race, length, slices, race_stiffness_modulus(scene));
  m.bar = make_normal_law(scene.contact.bar, length, stations, bar_modulus(scene));
  m.wall = make_normal_law(scene.contact.end, length, 2);
  m.flange = make_normal_law(scene.contact.flange, length, 2);
  m.land_edge = land_width(scene) / 2;
  m.land = make_normal_law(scene.contact.land, length, m.land_edge > 0 ? 4 : 2);
  m.friction = friction_laws(scene.contact);

  m.inner_radius = b.inner_raceway_diameter / 2 - b.internal_clearance / 4;
  m.outer_radius = b.outer_raceway_diameter / 2 + b.internal_clearance / 4;
  m.pitch_radius = (m.inner_radius + m.outer_radius) / 2;
  m.forms = RacewayForms(b);
  m.wall_points = end_points(m.nominal_diameter / 2, 0);
  set_flanges(scene, m);
  m.misalignment_y = b.misalignment_y;
  m.misalignment_z = b.misalignment_z;
  m.ring_mass = given_or(b.inner_ring_mass, ring_mass(b, 2 * m.inner_radius));
  // Of a hollow cylinder of that mass.
  const double bore = b.bore_diameter / 2;
  const double radii = m.inner_radius * m.inner_radius + bore * bore;
  m.ring_polar = given_or(b.inner_ring_polar_inertia, m.ring_mass * radii / 2);
  m.ring_transverse =
      given_or(b.inner_ring_transverse_inertia, m.ring_mass * (3 * radii + b.width * b.width) / 12);
  m.tilt_stiffness = b.tilt_stiffness;

  set_cage(scene, m);

  const auto& o = scene.operation;
  m.duty = make_duty(o);
  m.first_axial_load = first_axial_load(o);
  m.heat = heat_account(scene);
  if (is_lubricated(scene)) lubricate(scene, m);
  m.gravity = o.gravity * std::cos(o.shaft_inclination);
  m.gravity_axial = o.gravity * std::sin(o.shaft_inclination);
  return m;
}

double kinematic_cage_speed(const BearingModel& m, const RingSpeeds& speeds) {
  return (speeds.inner * m.inner_radius + speeds.outer * m.outer_radius) /
         (m.inner_radius + m.outer_radius);
}

double roller_interval(const BearingModel& m) {
  const double orbit = kinematic_cage_speed(m, fastest_speeds(m.duty));
  return 2 * std::numbers::pi / (orbit * m.layout.rollers);
}

RingLoad ring_force_at(const BearingModel& m, double t) {
  RingLoad force = load_at(m.duty, t);
  force.z -= m.ring_mass * m.gravity;
  return force;
}

double slice_length(const BearingModel& m) {
  return 2 * m.roller_half_length / static_cast<double>(m.race_slices.size());
}

double race_pressure(const BearingModel& m, double inner_slice, double outer_slice) {
  const double roller = m.nominal_diameter / 2, length = slice_length(m);
  const auto pressure = [&](double force, double curvature) {
    return hertz_line(force, 1 / (1 / roller + curvature), length, m.race_modulus).peak_pressure;
  };
  return std::max(pressure(inner_slice, 1 / m.inner_radius),
                  pressure(outer_slice, -1 / m.outer_radius));
}

double minimum_static_speed(const BearingModel& m) {
  double minimum = m.friction.front().static_speed;
  for (const FrictionLaw& law : m.friction) minimum = std::min(minimum, law.static_speed);
  return minimum;
}

Jam find_jam(const OperatingScene& scene) {
  Jam worst;
  const auto see = [&worst](long pocket, const char* where, double larger) {
    if (larger >= 0 && (worst.pocket < 0 || larger > worst.interference))
      worst = {static_cast<int>(pocket), where, larger};
  };
  const double pitch = pitch_radius(scene.bearing);
  for (long j = 0; j < scene.bearing.roller_count; ++j) {
    const double diameter = each(scene.roller.diameter, j);
    see(j, "width", diameter - each(scene.cage.pocket_width, j));
    see(j, "length", scene.roller.length - each(scene.cage.pocket_length, j));
    const PocketOutline outline = pocket_outline(scene.cage, pitch, j);
    for (const int end : {0, 1})
      if (outline.end[end].lip)
        see(j, end == 0 ? "lips at the bore" : "lips at the outside",
            -radial_play(outline, pitch, diameter / 2, end));
  }
  return worst;
}

}  // namespace cagetol
