// One file on purpose, though long: the whole reference is to be read from top to bottom beside
// src/NOTATION.md, and shares nothing with the program's kernels.
#include "tests/support/reference_forces.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "src/cage/mesh/cage_mass.hpp"
#include "src/contact_laws/normal_force.hpp"
#include "src/scene/materials.hpp"

namespace cagetol {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

const Vector3d kX = Vector3d::UnitX();

double auto_or(double given, double computed) {
  return std::isnan(given) ? computed : given;
}

/// The part of a vector in the radial plane.
Vector3d radial(const Vector3d& v) {
  return {0, v.y(), v.z()};
}

/// Velocities of the bodies that meet at a contact. Every speed below is linear in them.
struct Motion {
  Vector3d roller = Vector3d::Zero();     ///< of the roller's centre
  Vector3d lean = Vector3d::Zero();       ///< a' of its axis
  double spin = 0;                        ///< w_s
  Vector3d ring = Vector3d::Zero();       ///< of the inner ring's centre
  Vector3d ring_tilt = Vector3d::Zero();  ///< B' of its centre line
  Vector3d cage = Vector3d::Zero();       ///< of the cage's mass centre
  double cage_spin = 0;                   ///< phi'
  Vector3d cage_lean = Vector3d::Zero();  ///< A'
  double inner_spin = 0, outer_spin = 0;  ///< w_i, w_o
};

/// Rate of penetration and two sliding speeds.
struct Speeds {
  double approach, v1, v2;
};
using Kinematics = std::function<Speeds(const Motion&)>;

struct Roller {
  double radius, mass, polar, transverse;
  Vector3d centre, axis, e_r, e_t;  ///< axis: (1, a_y, a_z)
  double r, theta_rate, r_rate;
  Motion own;
};

/// A generalised force and the sum of its contributions' sizes.
struct Sum {
  double net = 0, gross = 0;
  void operator+=(double force) {
    net += force;
    gross += std::abs(force);
  }
};
using Sum3 = std::array<Sum, 3>;
Vector3d net(const Sum3& s) {
  return {s[0].net, s[1].net, s[2].net};
}
double gross(const Sum3& s) {
  return std::max({s[0].gross, s[1].gross, s[2].gross});
}

struct Forces {  // generalised, conjugate to Motion
  Sum3 centre, lean;
  Sum spin;
};

struct Borders {
  Sum3 ring, ring_tilt, cage, cage_lean;
  Sum cage_spin;
};

double elastic_force(const ContactParameters& law, double length, double p) {
  if (law.law == ForceLaw::hertz)
    return 77652 * std::pow(length * 1e3, 8.0 / 9.0) * std::pow(p * 1e3, 10.0 / 9.0);
  return law.stiffness * std::pow(p * 1e3, law.exponent);
}

double exponent(const ContactParameters& law) {
  return law.law == ForceLaw::hertz ? 10.0 / 9.0 : law.exponent;
}

class Bearing {
 public:
  Bearing(const Scene& scene, double t, const std::vector<double>& y)
      : scene_(scene), t_(t), y_(y), layout_(reference_layout(scene)) {
    unpack_cage();
  }

  Reference run() {
    result_.rates.assign(y_.size(), 0.0);
    result_.gross.assign(y_.size(), 0.0);
    for (int j = 0; j < layout_.rollers; ++j) roller(j);
    lands();
    border();
    result_.load_power = force().dot(moving_.ring) + moment().dot(moving_.ring_tilt);
    return result_;
  }

 private:
  double state(int slot) const { return y_[static_cast<std::size_t>(slot)]; }
  double& size(int slot) { return result_.gross[static_cast<std::size_t>(slot)]; }
  double& rate(int slot) { return result_.rates[static_cast<std::size_t>(slot)]; }

  double ramped() const {
    const auto& o = scene_.operation;
    return o.load_ramp > 0 ? reference_step(t_, 0, 0, o.load_ramp, 1) : 1;
  }
  static Vector3d downwards(double angle) {
    return Eigen::AngleAxisd(angle, kX) * -Vector3d::UnitZ();
  }
  /// Angle of a ring, by Simpson's rule, which a ramp fits exactly.
  double turned_by(double last, double first) const {
    const auto at = [&](double t) { return speed(last, first, t); };
    const double ramp = std::min(t_, scene_.operation.speed_ramp);
    return ramp / 6 * (at(0) + 4 * at(ramp / 2) + at(ramp)) + (t_ - ramp) * at(t_);
  }
  /// On the inner ring.
  Vector3d force() const {
    const auto& o = scene_.operation;
    const double turned = turned_by(o.inner_speed, o.speed_ramp_from);
    const double with = std::isnan(o.rotating_speed) ? turned : o.rotating_speed * t_;
    const double now = speed(o.inner_speed, o.speed_ramp_from, t_);
    return ramped() * (o.radial_load * downwards(o.load_direction) +
                       o.rotating_load * downwards(o.rotating_phase + with)) +
           o.unbalance * now * now * downwards(o.rotating_phase + turned) +
           ramped() * o.axial_load * kX;
  }
  double speed(double last, double first, double t) const {
    const auto& o = scene_.operation;
    if (!(o.speed_ramp > 0)) return last;
    return reference_step(t, 0, auto_or(first, last), o.speed_ramp, last);
  }
  Vector3d gravity() const {
    const auto& o = scene_.operation;
    const Vector3d down = -o.gravity * Vector3d::UnitZ();
    return Eigen::AngleAxisd(o.shaft_inclination, Vector3d::UnitY()) * down;
  }
  /// Conjugate to the ring's tilt, where that is free.
  Vector3d moment() const {
    const auto& o = scene_.operation;
    return ramped() * Vector3d(0, o.tilting_moment_y, o.tilting_moment_z);
  }
  Vector3d misalignment() const {
    return {0, scene_.bearing.misalignment_y, scene_.bearing.misalignment_z};
  }

  void unpack_cage() {
    const auto q = [&](int slot) { return state(layout_.border_position(slot)); };
    const auto v = [&](int slot) { return state(layout_.border_velocity(slot)); };
    const CageMass mass = cage_mass(scene_.cage, scene_.bearing.roller_count);
    phi_ = q(kCagePhi);
    unbalance_ = Eigen::AngleAxisd(phi_, kX) * Vector3d(0, mass.centre_y, mass.centre_z);
    cage_centre_ = Vector3d(q(kCageX), q(kCageY), q(kCageZ)) - unbalance_;
    cage_axis_ = Vector3d(1, q(kCageAxisY), q(kCageAxisZ));
    const int axial = layout_.ring_axial_slot();
    const bool floats = layout_.ring_axial > 0;
    ring_ = Vector3d(floats ? q(axial) : 0, q(kRingY), q(kRingZ));
    moving_.ring = Vector3d(floats ? v(axial) : 0, v(kRingY), v(kRingZ));
    const int tilt = layout_.ring_tilt_slot();
    const bool tilting = layout_.ring_tilt > 0;
    ring_slope_ = tilting ? Vector3d(0, q(tilt), q(tilt + 1)) : misalignment();
    if (tilting) moving_.ring_tilt = Vector3d(0, v(tilt), v(tilt + 1));
    moving_.cage = Vector3d(v(kCageX), v(kCageY), v(kCageZ));
    moving_.cage_spin = v(kCagePhi);
    moving_.cage_lean = Vector3d(0, v(kCageAxisY), v(kCageAxisZ));
    const auto& o = scene_.operation;
    moving_.inner_spin = speed(o.inner_speed, o.speed_ramp_from, t_);
    moving_.outer_spin = speed(o.outer_speed, o.outer_ramp_from, t_);
    cage_mass_ = auto_or(scene_.cage.mass, mass.mass);
    cage_polar_ = auto_or(scene_.cage.polar_inertia, mass.polar_inertia);
    cage_transverse_ = auto_or(scene_.cage.transverse_inertia, mass.transverse_inertia);
  }

  /// Velocity of the roller's point at rho from its axis at xi.
  static Vector3d roller_point(const Roller& roller, const Motion& m, double xi,
                               const Vector3d& rho) {
    const Vector3d w = m.spin * roller.axis + kX.cross(m.lean);
    return m.roller + xi * m.lean + w.cross(rho);
  }
  /// Velocity of the cage's geometric centre.
  Vector3d cage_centre_rate(const Motion& m) const {
    return m.cage - m.cage_spin * kX.cross(unbalance_);
  }
  /// Velocity of the cage's point at `arm` from its geometric centre.
  Vector3d cage_point(const Motion& m, const Vector3d& arm) const {
    return cage_centre_rate(m) + (m.cage_spin * cage_axis_ + kX.cross(m.cage_lean)).cross(arm);
  }

  /// How much stiffer the kind's pair of materials is than steel on steel.
  double against_steel(ContactKind kind) const {
    const auto softness = [](const Material& m) { return (1 - m.poisson * m.poisson) / m.young; };
    const Material other = kind == kBar ? cage_material(scene_) : ring_material(scene_);
    return 2 * softness({208e9, 0.3, 0}) / (softness(roller_material(scene_)) + softness(other));
  }

  /// One contact: its law, its forces, its account.
  void contact(ContactKind kind, const ContactParameters& law, double shares, double penetration,
               const Motion& now, const Kinematics& speeds, Forces* on_roller) {
    if (penetration <= 0) return;
    const Speeds s = speeds(now);
    const double share = (law.law == ForceLaw::hertz ? against_steel(kind) : 1) / shares;
    const double Q =
        reference_normal_force(law, scene_.roller.length, penetration, s.approach) * share;
    const double elastic = elastic_force(law, scene_.roller.length, penetration) * share;
    ++result_.touching[kind];
    if (Q == 0) ++result_.pulling[kind];
    const double speed = std::hypot(s.v1, s.v2);
    const double traction = reference_friction_coefficient(scene_.contact, speed) * Q;
    const double F1 = speed > 0 ? -traction * s.v1 / speed : 0,
                 F2 = speed > 0 ? -traction * s.v2 / speed : 0;
    const auto power = [&](const Motion& unit) {
      const Speeds u = speeds(unit);
      return -Q * u.approach + F1 * u.v1 + F2 * u.v2;
    };
    for (int k = 0; k < 3; ++k) {
      const auto at = static_cast<std::size_t>(k);
      const Vector3d direction = Vector3d::Unit(k);
      Motion unit;
      if (on_roller) {
        unit.roller = direction;
        on_roller->centre[at] += power(unit);
      }
      unit = {};
      unit.cage = direction;
      border_.cage[at] += power(unit);
      unit = {};
      unit.ring = direction;
      border_.ring[at] += power(unit);
      if (k == 0) continue;
      if (on_roller) {
        unit = {};
        unit.lean = direction;
        on_roller->lean[at] += power(unit);
      }
      unit = {};
      unit.ring_tilt = direction;
      border_.ring_tilt[at] += power(unit);
      unit = {};
      unit.cage_lean = direction;
      border_.cage_lean[at] += power(unit);
    }
    Motion unit;
    unit.spin = 1;
    if (on_roller) on_roller->spin += power(unit);
    unit = {};
    unit.cage_spin = 1;
    border_.cage_spin += power(unit);
    // What shaft and housing must supply against the contact.
    unit = {};
    unit.inner_spin = now.inner_spin;
    unit.outer_spin = now.outer_spin;
    result_.drive_power -= power(unit);
    result_.elastic_energy += elastic * penetration / (exponent(law) + 1);
    result_.friction_power += traction * speed;
    result_.damping_power += (Q - elastic) * s.approach;
  }

  void race(const Roller& roller, int j, bool inner, Forces& forces) {
    const auto& b = scene_.bearing;
    const double s = inner ? 1 : -1;
    const double catalogue = inner ? b.inner_raceway_diameter - b.internal_clearance / 2
                                   : b.outer_raceway_diameter + b.internal_clearance / 2;
    const double race_radius = catalogue / 2;
    const Vector3d m = inner ? ring_slope_ : Vector3d::Zero().eval();
    const long slices = scene_.discretisation.race_slices;
    const double length = scene_.roller.length;
    double mean_diameter = 0;
    for (long k = 0; k < b.roller_count; ++k) mean_diameter += each(scene_.roller.diameter, k);
    mean_diameter /= static_cast<double>(b.roller_count);
    // Form of the race where the middle of the roller is, and its slope.
    const auto& o = scene_.operation;
    const Vector3d to = radial(roller.centre - (inner ? ring_ : Vector3d::Zero().eval()));
    const double angle =
        std::atan2(to.z(), to.y()) - (inner ? turned_by(o.inner_speed, o.speed_ramp_from)
                                            : turned_by(o.outer_speed, o.outer_ramp_from));
    double height = 0, slope = 0;
    for (const Waviness& of : inner ? b.inner_waviness : b.outer_waviness) {
      const auto waves = static_cast<double>(of.count);
      height += of.amplitude * std::cos(waves * angle - of.phase);
      slope -= waves * of.amplitude * std::sin(waves * angle - of.phase);
    }
    for (long k = 0; k < slices; ++k) {
      const double xi =
          ((static_cast<double>(k) + 0.5) / static_cast<double>(slices) - 0.5) * length;
      double radius = roller.radius + xi / length * each(scene_.roller.taper, j) / 2;
      if (scene_.roller.profile == RollerProfile::logarithmic)
        radius -= 0.00035 * mean_diameter * std::log(1 / (1 - std::pow(2 * xi / length, 2)));
      const double place = roller.centre.x() + xi - (inner ? ring_.x() : 0);
      const Vector3d on_axis = radial(roller.centre + xi * roller.axis);
      const Vector3d d = on_axis - (inner ? radial(ring_) : Vector3d::Zero().eval()) - place * m;
      const Vector3d n = s * d.normalized(), t = kX.cross(n);
      const double p = s * (race_radius + height - d.norm()) + radius;
      const auto speeds = [=, &roller](const Motion& v) {
        // The ring's axis at the slice, and the turning of the ring.
        const Vector3d tilt = inner ? v.ring_tilt : Vector3d::Zero().eval();
        const Vector3d ring = inner ? (v.ring + place * tilt).eval() : tilt;
        const double spin = inner ? v.inner_spin : v.outer_spin;
        const Vector3d approach = v.roller + xi * v.lean - ring - (v.roller.x() - v.ring.x()) * m;
        const Vector3d surface =
            ring + (spin * (kX + m) + kX.cross(tilt)).cross(s * race_radius * n);
        const Vector3d slide = roller_point(roller, v, xi, -radius * n) - surface;
        const Vector3d past = v.roller - (inner ? v.ring : Vector3d::Zero().eval());
        const double passing = kX.cross(to).dot(past) / to.squaredNorm() - spin;
        return Speeds{-n.dot(approach) + s * slope * passing, t.dot(slide), slide.x()};
      };
      contact(inner ? kInnerRace : kOuterRace, scene_.contact.race, static_cast<double>(slices), p,
              roller.own, speeds, &forces);
    }
  }

  /// A part of a bar that is an arc in the radial plane: middle and radius, in the pocket's
  /// directions, of one side; `counts`: whether it answers an axis at v from its middle.
  struct Arc {
    double height, along, radius;
    bool hollow;
    std::function<bool(double v_R, double v_T)> counts;
  };
  /// The parts of the bar on side s of pocket j, from src/contacts/pocket_face.hpp.
  std::vector<Arc> arcs(int j, double s) const {
    const auto& c = scene_.cage;
    const double half = each(c.pocket_width, j) / 2, r = c.edge_radius;
    const double pitch =
        (scene_.bearing.inner_raceway_diameter + scene_.bearing.outer_raceway_diameter) / 4;
    const bool curved = !std::isnan(c.face_radius);
    std::vector<Arc> all;
    double rays[2] = {0, 0};  // of a curved face's normals at its ends, from e_T towards e_R
    for (const int end : {0, 1}) {
      const double out = end == 0 ? -1 : 1,
                   surface = (end == 0 ? c.inner_diameter : c.outer_diameter) / 2,
                   lips = each(end == 0 ? c.retention_inner : c.retention_outer, j);
      if (!curved) {
        const double opening = std::isnan(lips) ? half : lips / 2;
        const double height = std::sqrt(surface * surface - opening * opening) - out * r;
        if (std::isnan(lips))
          all.push_back(
              {height, opening + r, r, false, [out](double v_R, double) { return out * v_R > 0; }});
        else
          all.push_back({height, opening + r, r, false, [](double, double) { return true; }});
        continue;
      }
      // The rounding's middle lies R_f + r from that of the face and, measured on the surface
      // above it, r below the cage's surface: by halving along the circle of the first.
      const double middle = half - c.face_radius, reach = c.face_radius + r;
      double low = 0, high = out * pi / 2;
      for (int k = 0; k < 200; ++k) {
        rays[end] = (low + high) / 2;
        const double x = middle + reach * std::cos(rays[end]),
                     miss = pitch + reach * std::sin(rays[end]) + out * r -
                            std::sqrt(surface * surface - x * x);
        (out * miss < 0 ? low : high) = rays[end];
      }
      const double ray = rays[end];
      all.push_back({pitch + reach * std::sin(ray), middle + reach * std::cos(ray), r, false,
                     [out, ray](double v_R, double v_T) {
                       return out * (std::cos(ray) * v_R - std::sin(ray) * v_T) > 0;
                     }});
    }
    if (curved)
      all.push_back({pitch, half - c.face_radius, c.face_radius, true,
                     [low = rays[0], high = rays[1]](double v_R, double v_T) {
                       const double angle = std::atan2(v_R, v_T);
                       return angle > low && angle < high;
                     }});
    for (Arc& arc : all) arc.along *= s;
    return all;
  }

  void bars(const Roller& roller, int j, Forces& forces) {
    const double angle = phi_ + 2 * pi * j / layout_.rollers + each(scene_.cage.pocket_pitch, j);
    const Vector3d e_R(0, std::cos(angle), std::sin(angle)), e_T = kX.cross(e_R);
    const double squareness = each(scene_.cage.pocket_squareness, j);
    const long stations = scene_.discretisation.bar_stations;
    for (long k = 0; k < stations; ++k) {
      const double share =
          stations == 1 ? 0 : static_cast<double>(k) / static_cast<double>(stations - 1) - 0.5;
      const double xi = 0.8 * share * scene_.roller.length;
      const double X = roller.centre.x() + xi - cage_centre_.x();
      const Vector3d D = radial(roller.centre + xi * roller.axis - cage_centre_);
      const auto rub = [&](double p, const Vector3d& rho, const Vector3d& along,
                           const std::function<double(const Motion&, const Vector3d&)>& p_rate) {
        const Vector3d arm = X * kX + D + rho;
        const auto speeds = [=, this, &roller](const Motion& v) {
          const Vector3d D_rate = v.roller + xi * v.lean - cage_centre_rate(v);
          const Vector3d slide = roller_point(roller, v, xi, rho) - cage_point(v, arm);
          return Speeds{p_rate(v, D_rate), slide.dot(along), slide.x()};
        };
        contact(kBar, scene_.contact.bar, static_cast<double>(stations), p, roller.own, speeds,
                &forces);
      };
      for (const double s : {1.0, -1.0}) {
        face(roller, j, s, D, X, e_R, e_T, squareness, rub);
        for (const Arc& arc : arcs(j, s)) {
          // From the arc's middle, which the cage carries along and leans, to the roller's axis.
          const Vector3d middle = arc.height * e_R + (arc.along + squareness * X) * e_T;
          const Vector3d lean = radial(cage_axis_), v = D - X * lean - middle;
          if (!arc.counts(v.dot(e_R), s * v.dot(e_T))) continue;
          const double sign = arc.hollow ? -1 : 1, d = v.norm();
          const Vector3d m = sign * v / d;
          rub(roller.radius + sign * (arc.radius - d), -roller.radius * m, kX.cross(m),
              [=](const Motion& now, const Vector3d& D_rate) {
                const Vector3d v_rate = radial(D_rate) - X * now.cage_lean - D_rate.x() * lean -
                                        now.cage_spin * kX.cross(middle) -
                                        squareness * D_rate.x() * e_T;
                return -m.dot(v_rate);
              });
        }
      }
    }
  }

  /// The flat face of a bar, where the axis stands between its edges.
  template <class Rub>
  void face(const Roller& roller, int j, double s, const Vector3d& D, double X, const Vector3d& e_R,
            const Vector3d& e_T, double squareness, const Rub& rub) {
    const auto& c = scene_.cage;
    if (!std::isnan(c.face_radius)) return;
    const double half = each(c.pocket_width, j) / 2, height = (D - X * radial(cage_axis_)).dot(e_R);
    const auto surface = [&](double diameter) {
      return std::sqrt(diameter * diameter / 4 - half * half);
    };
    if (std::isnan(c.retention_inner[0]) && height <= surface(c.inner_diameter) + c.edge_radius)
      return;
    if (std::isnan(c.retention_outer[0]) && height >= surface(c.outer_diameter) - c.edge_radius)
      return;
    const double lean = cage_axis_.dot(e_T) + squareness;
    rub(s * (D.dot(e_T) - lean * X) + roller.radius - half, s * roller.radius * e_T, e_R,
        [=, this](const Motion& v, const Vector3d& D_rate) {
          const Vector3d e_T_rate = -v.cage_spin * e_R;  // e_T turns with the cage
          return s * (radial(D_rate).dot(e_T) + D.dot(e_T_rate) -
                      (v.cage_lean.dot(e_T) + cage_axis_.dot(e_T_rate)) * X - lean * D_rate.x());
        });
  }

  /// Hertz's contact of a spherical roller end and a cone of opposite or like curvature around the
  /// ring, as an impact law of that exponent.
  ContactParameters sphere_law(double angle, bool inner, double pitch) const {
    const double way = inner ? -1 : 1, R_e = scene_.roller.end_radius;
    const double around =
        1 / (1 / R_e - way * std::sin(angle) / (pitch + way * R_e * std::sin(angle)));
    const double larger = std::max(around, R_e), smaller = std::min(around, R_e);
    const auto softness = [](const Material& m) { return (1 - m.poisson * m.poisson) / m.young; };
    const double modulus =
        2 / (softness(roller_material(scene_)) + softness(ring_material(scene_)));
    const double second = 1 + (pi / 2 - 1) * smaller / larger,
                 first = pi / 2 + (pi / 2 - 1) * std::log(larger / smaller),
                 axes = std::pow(larger / smaller, 2 / pi),
                 radius = larger * smaller / (larger + smaller);
    ContactParameters law = scene_.contact.flange;
    law.exponent = 1.5;
    // delta = first (9/(2 second radius) (F/(pi axes modulus))^2)^(1/3), here for mm
    law.stiffness =
        pi * axes * modulus * std::sqrt(2 * second * radius / 9) * std::pow(1e-3 / first, 1.5);
    return law;
  }

  /// A spherical roller end against an inclined flange, by src/contacts/sphere_flange.hpp.
  void sphere_end(const Roller& roller, double e, bool inner, Forces& forces) {
    const auto& b = scene_.bearing;
    const double way = inner ? -1 : 1, R_e = scene_.roller.end_radius;
    const double angle = inner ? b.inner_flange_angle : b.outer_flange_angle;
    const double pitch = (b.inner_raceway_diameter + b.outer_raceway_diameter) / 4;
    const double clearance =
        inner ? auto_or(b.inner_flange_clearance, b.flange_clearance) : b.flange_clearance;
    const double k = e * (scene_.roller.length / 2 - R_e);
    const double along_n = e * std::cos(angle), across_n = way * std::sin(angle);
    const Vector3d m = inner ? misalignment() : Vector3d::Zero().eval(),
                   centre = inner ? ring_ : Vector3d::Zero().eval();
    const Vector3d place = roller.centre - centre, a = radial(roller.axis), lean = a - m;
    const double X = place.x() + m.dot(place) - k * lean.squaredNorm() / 2;
    const Vector3d Y = radial(place) - place.x() * m + k * lean, out = Y.normalized();
    const auto tilted = [&](const Vector3d& v) { return Vector3d(v - m.dot(v) * kX + v.x() * m); };
    const Vector3d n = tilted(along_n * kX + across_n * out),
                   face = tilted(-across_n * kX + along_n * out), around = tilted(kX.cross(out));
    const Vector3d arm = place + k * (kX + a - a.squaredNorm() / 2 * kX) + R_e * n;
    const double p = std::cos(angle) * (e * X - clearance / 2) + across_n * (Y.norm() - pitch);
    const auto speeds = [=, &roller](const Motion& v) {
      const Vector3d moved = v.roller - (inner ? v.ring : Vector3d::Zero().eval());
      const double spin = inner ? v.inner_spin : v.outer_spin;
      const double X_rate = moved.x() + m.dot(moved) - k * lean.dot(v.lean);
      const Vector3d Y_rate = radial(moved) - moved.x() * m + k * v.lean;
      const Vector3d w = v.spin * roller.axis + kX.cross(v.lean);
      const Vector3d slide =
          moved + k * (v.lean - a.dot(v.lean) * kX) + w.cross(R_e * n) - spin * (kX + m).cross(arm);
      return Speeds{along_n * X_rate + across_n * out.dot(Y_rate), face.dot(slide),
                    around.dot(slide)};
    };
    contact(kFlange, sphere_law(angle, inner, pitch), 1, p, roller.own, speeds, &forces);
  }

  void ends(const Roller& roller, int j, Forces& forces) {
    const auto& b = scene_.bearing;
    double mean_radius = 0;
    for (long k = 0; k < b.roller_count; ++k) mean_radius += each(scene_.roller.diameter, k) / 2;
    mean_radius /= static_cast<double>(b.roller_count);
    const double pitch = (b.inner_raceway_diameter + b.outer_raceway_diameter) / 4;
    for (const double e : {-1.0, 1.0}) {
      const double xi = e * scene_.roller.length / 2;
      enum Against { kPocket, kOuterFlange, kInnerFlange };
      for (const Against against : {kPocket, kOuterFlange, kInnerFlange}) {
        const bool flange = against != kPocket, inner = against == kInnerFlange;
        if (flange && !has_flange(inner ? b.inner_flanges : b.outer_flanges, e > 0)) continue;
        if (flange && scene_.roller.end_radius > 0) {
          sphere_end(roller, e, inner, forces);
          continue;
        }
        const double rim = inner ? b.inner_flange_diameter : b.shoulder_diameter;
        const double h = flange ? rim / 2 - pitch : 0;
        const double tau = std::min(0.8 * mean_radius,
                                    std::sqrt(std::max(0.0, mean_radius * mean_radius - h * h)));
        // A wall's points keep their place beside the pocket and turn with the cage, a flange's
        // beside the roller's orbit.
        const double angle =
            phi_ + 2 * pi * j / layout_.rollers + each(scene_.cage.pocket_pitch, j);
        const Vector3d one = flange ? roller.e_r : Vector3d(0, std::cos(angle), std::sin(angle));
        const Vector3d two = kX.cross(one);
        for (const double side : {-1.0, 1.0}) {
          const Vector3d q = h * one + side * tau * two;  // the point's place on the end face
          const Vector3d a = radial(roller.axis);
          const auto q_rate = [=, &roller](const Motion& v) {
            const double turning = flange ? v.roller.dot(roller.e_t) / roller.r : v.cage_spin;
            return Vector3d(turning * kX.cross(q));
          };
          if (flange) {
            // The flange's plane is normal to its ring's axis, through the ring's centre but for
            // the clearance.
            const Vector3d m = inner ? misalignment() : Vector3d::Zero().eval(),
                           centre = inner ? ring_ : Vector3d::Zero().eval();
            const double clearance =
                inner ? auto_or(b.inner_flange_clearance, b.flange_clearance) : b.flange_clearance;
            const Vector3d place = roller.centre - q.dot(a) * kX + q - centre;
            const double p = e * (kX + m).dot(place) - clearance / 2;
            const auto speeds = [=, &roller](const Motion& v) {
              const Vector3d ring = inner ? v.ring : Vector3d::Zero().eval();
              const double spin = inner ? v.inner_spin : v.outer_spin;
              const Vector3d slide =
                  roller_point(roller, v, xi, q) - ring - spin * kX.cross(radial(place));
              const Vector3d moved =
                  v.roller - (q.dot(v.lean) + q_rate(v).dot(a)) * kX + q_rate(v) - ring;
              return Speeds{e * (kX + m).dot(moved), slide.dot(one), slide.dot(two)};
            };
            contact(kFlange, scene_.contact.flange, 2, p, roller.own, speeds, &forces);
          } else {
            const Vector3d A = radial(cage_axis_);
            const Vector3d D = radial(roller.centre + xi * roller.axis - cage_centre_) + q;
            const double X = roller.centre.x() + xi - q.dot(a) - cage_centre_.x();
            const double p = e * (X + A.dot(D)) - each(scene_.cage.pocket_length, j) / 2;
            const auto speeds = [=, this, &roller](const Motion& v) {
              const Vector3d centre = v.roller - cage_centre_rate(v), turn = q_rate(v);
              const double approach = centre.x() - q.dot(v.lean) - turn.dot(a) +
                                      v.cage_lean.dot(D) + A.dot(centre + xi * v.lean + turn);
              const Vector3d slide = roller_point(roller, v, xi, q) - cage_point(v, X * kX + D);
              return Speeds{e * approach, slide.dot(one), slide.dot(two)};
            };
            contact(kWall, scene_.contact.end, 2, p, roller.own, speeds, &forces);
          }
        }
      }
    }
  }

  Roller unpack_roller(int j) const {
    const auto q = [&](RollerPosition slot) { return state(layout_.position(slot, j)); };
    const auto v = [&](RollerVelocity slot) { return state(layout_.velocity(slot, j)); };
    Roller roller;
    roller.radius = each(scene_.roller.diameter, j) / 2;
    const double length = scene_.roller.length;
    roller.mass =
        properties_of(scene_.roller.material).density * pi * std::pow(roller.radius, 2) * length;
    roller.polar = roller.mass * std::pow(roller.radius, 2) / 2;
    roller.transverse = roller.mass * (std::pow(roller.radius, 2) / 4 + length * length / 12);
    const double theta = q(kAngle);
    roller.r = q(kRadius);
    roller.r_rate = v(kRadialSpeed);
    roller.theta_rate = v(kOrbitRate);
    roller.e_r = Vector3d(0, std::cos(theta), std::sin(theta));
    roller.e_t = kX.cross(roller.e_r);
    roller.centre = q(kAxial) * kX + roller.r * roller.e_r;
    roller.axis = Vector3d(1, q(kAxisY), q(kAxisZ));
    roller.own = moving_;
    roller.own.roller = v(kAxialSpeed) * kX + roller.r_rate * roller.e_r +
                        roller.r * roller.theta_rate * roller.e_t;
    roller.own.lean = Vector3d(0, v(kAxisRateY), v(kAxisRateZ));
    roller.own.spin = v(kSpin);
    return roller;
  }

  void roller(int j) {
    const Roller roller = unpack_roller(j);
    Forces forces;
    race(roller, j, true, forces);
    race(roller, j, false, forces);
    bars(roller, j, forces);
    ends(roller, j, forces);

    const Vector3d acceleration = net(forces.centre) / roller.mass + gravity();
    const Vector3d lean =
        (net(forces.lean) + roller.polar * roller.own.spin * kX.cross(roller.own.lean)) /
        roller.transverse;
    rate(layout_.position(kRadius, j)) = roller.r_rate;
    rate(layout_.position(kAngle, j)) = roller.theta_rate;
    rate(layout_.position(kAxial, j)) = roller.own.roller.x();
    rate(layout_.position(kAxisY, j)) = roller.own.lean.y();
    rate(layout_.position(kAxisZ, j)) = roller.own.lean.z();
    rate(layout_.velocity(kRadialSpeed, j)) =
        acceleration.dot(roller.e_r) + roller.r * std::pow(roller.theta_rate, 2);
    rate(layout_.velocity(kOrbitRate, j)) =
        (acceleration.dot(roller.e_t) - 2 * roller.r_rate * roller.theta_rate) / roller.r;
    rate(layout_.velocity(kAxialSpeed, j)) = acceleration.x();
    rate(layout_.velocity(kAxisRateY, j)) = lean.y();
    rate(layout_.velocity(kAxisRateZ, j)) = lean.z();
    rate(layout_.velocity(kSpin, j)) = forces.spin.net / roller.polar;
    size(layout_.velocity(kRadialSpeed, j)) = gross(forces.centre) / roller.mass;
    size(layout_.velocity(kOrbitRate, j)) = gross(forces.centre) / roller.mass / roller.r;
    size(layout_.velocity(kAxialSpeed, j)) = forces.centre[0].gross / roller.mass;
    size(layout_.velocity(kAxisRateY, j)) = gross(forces.lean) / roller.transverse;
    size(layout_.velocity(kAxisRateZ, j)) = gross(forces.lean) / roller.transverse;
    size(layout_.velocity(kSpin, j)) = forces.spin.gross / roller.polar;
  }

  void lands() {
    const auto& c = scene_.cage;
    double mean_length = 0;
    for (long j = 0; j < layout_.rollers; ++j) mean_length += each(c.pocket_length, j);
    mean_length /= static_cast<double>(layout_.rollers);
    const double offset = auto_or(c.land_offset, (c.width + mean_length) / 4);
    const bool points =
        scene_.contact.race.law == ForceLaw::impact && scene_.contact.bar.law == ForceLaw::impact;
    const double edge = auto_or(c.land_width, points ? 0 : (c.width - mean_length) / 2) / 2;
    for (const bool inner : {false, true})
      for (const double land : {-offset, offset})
        if (edge == 0)
          land_at(inner, land, 2);
        else
          for (const double side : {-edge, edge}) land_at(inner, land + side, 4);
  }

  void land_at(bool inner, double X, double shares) {
    const auto& c = scene_.cage;
    const auto& b = scene_.bearing;
    const double land_radius = (inner ? c.inner_diameter : c.outer_diameter) / 2;
    const double ring_radius =
        (inner ? auto_or(b.inner_land_diameter,
                         b.inner_flanges == FlangeSides::both
                             ? b.inner_flange_diameter
                             : b.inner_raceway_diameter - b.internal_clearance / 2)
         : b.outer_flanges == FlangeSides::both
             ? b.shoulder_diameter
             : b.outer_raceway_diameter + b.internal_clearance / 2) /
        2;
    const bool guides = c.guidance == (inner ? Guidance::inner : Guidance::outer);
    const double between = std::abs(ring_radius - land_radius),
                 clearance = guides ? auto_or(c.guide_clearance, between) : between;
    const Vector3d m = inner ? misalignment() : Vector3d::Zero().eval();
    const Vector3d delta = radial(cage_centre_ + X * cage_axis_) -
                           (inner ? radial(ring_) : Vector3d::Zero().eval()) - X * m;
    const Vector3d n = delta.normalized(), t = kX.cross(n);
    // The cage's outside meets the ring on the side it is displaced to, its bore on the other
    // side.
    const double side = inner ? -1 : 1;
    const auto speeds = [=, this](const Motion& v) {
      const Vector3d ring = inner ? v.ring : Vector3d::Zero().eval();
      const Vector3d centre = cage_centre_rate(v) + X * v.cage_lean;
      const double spin = inner ? v.inner_spin : v.outer_spin;
      const Vector3d on_cage =
          centre + (v.cage_spin * cage_axis_ + kX.cross(v.cage_lean)).cross(side * land_radius * n);
      const Vector3d on_ring = ring + spin * (kX + m).cross(side * ring_radius * n);
      return Speeds{n.dot(radial(centre - ring)), t.dot(on_cage - on_ring),
                    (on_cage - on_ring).x()};
    };
    contact(kLand, scene_.contact.land, shares, delta.norm() - clearance, moving_, speeds, nullptr);
  }

  void border() {
    const auto& b = scene_.bearing;
    const double bore = b.bore_diameter,
                 inner = b.inner_raceway_diameter - b.internal_clearance / 2;
    const double ring_mass = auto_or(b.inner_ring_mass, b.ring_material.density * b.width * pi / 4 *
                                                            (inner * inner - bore * bore));
    const Vector3d g = gravity();
    const auto q = [&](int slot) -> double& { return rate(layout_.border_position(slot)); };
    const auto v = [&](int slot) -> double& { return rate(layout_.border_velocity(slot)); };
    for (int slot = 0; slot < kRigidBorder; ++slot) q(slot) = state(layout_.border_velocity(slot));
    const Vector3d pushed = net(border_.ring) + force();
    v(kRingY) = pushed.y() / ring_mass;
    v(kRingZ) = pushed.z() / ring_mass + g.z();
    if (layout_.ring_axial > 0) {
      const int axial = layout_.ring_axial_slot();
      q(axial) = moving_.ring.x();
      v(axial) = pushed.x() / ring_mass + g.x();
      size(layout_.border_velocity(axial)) = border_.ring[0].gross / ring_mass;
    }
    if (layout_.ring_tilt > 0) {
      const int tilt = layout_.ring_tilt_slot();
      const double outer = inner / 2, hole = bore / 2, radii = outer * outer + hole * hole;
      const double polar = auto_or(b.inner_ring_polar_inertia, ring_mass * radii / 2);
      const double transverse = auto_or(b.inner_ring_transverse_inertia,
                                        ring_mass * (radii / 4 + b.width * b.width / 12));
      const Vector3d held = b.tilt_stiffness * (ring_slope_ - misalignment());
      const Vector3d acceleration = (net(border_.ring_tilt) + moment() - held +
                                     polar * moving_.inner_spin * kX.cross(moving_.ring_tilt)) /
                                    transverse;
      for (int k = 0; k < 2; ++k) {
        q(tilt + k) = moving_.ring_tilt[1 + k];
        v(tilt + k) = acceleration[1 + k];
        size(layout_.border_velocity(tilt + k)) = gross(border_.ring_tilt) / transverse;
      }
    }
    const double in_plane = std::max(border_.ring[1].gross, border_.ring[2].gross);
    v(kCageX) = border_.cage[0].net / cage_mass_ + g.x();
    v(kCageY) = border_.cage[1].net / cage_mass_;
    v(kCageZ) = border_.cage[2].net / cage_mass_ + g.z();
    v(kCagePhi) = border_.cage_spin.net / cage_polar_;
    const Vector3d lean =
        (net(border_.cage_lean) + cage_polar_ * moving_.cage_spin * kX.cross(moving_.cage_lean)) /
        cage_transverse_;
    v(kCageAxisY) = lean.y();
    v(kCageAxisZ) = lean.z();
    const double sizes[kRigidBorder] = {in_plane / ring_mass,
                                        in_plane / ring_mass,
                                        gross(border_.cage) / cage_mass_,
                                        gross(border_.cage) / cage_mass_,
                                        border_.cage[0].gross / cage_mass_,
                                        border_.cage_spin.gross / cage_polar_,
                                        gross(border_.cage_lean) / cage_transverse_,
                                        gross(border_.cage_lean) / cage_transverse_};
    for (int slot = 0; slot < kRigidBorder; ++slot)
      size(layout_.border_velocity(slot)) = sizes[slot];
  }

  const Scene& scene_;
  double t_;
  const std::vector<double>& y_;
  StateLayout layout_;
  Reference result_;
  Borders border_;
  Motion moving_;
  double phi_ = 0;
  Vector3d unbalance_, cage_centre_, cage_axis_, ring_, ring_slope_;
  double cage_mass_ = 0, cage_polar_ = 0, cage_transverse_ = 0;
};

}  // namespace

StateLayout reference_layout(const Scene& scene) {
  StateLayout layout;
  layout.rollers = static_cast<int>(scene.bearing.roller_count);
  layout.groups = (layout.rollers + kLanes - 1) / kLanes;
  if (scene.model.ring_tilt == TiltModel::free) layout.ring_tilt = 2;
  if (scene.operation.axial_load != 0) layout.ring_axial = 1;
  return layout;
}

Reference reference_rates(const Scene& scene, double t, const std::vector<double>& y) {
  return Bearing(scene, t, y).run();
}

double reference_step(double x, double x0, double h0, double x1, double h1) {
  if (x <= x0) return h0;
  if (x >= x1) return h1;
  const double z = (x - x0) / (x1 - x0);
  return h0 + (h1 - h0) * z * z * (3 - 2 * z);
}

double reference_normal_force(const ContactParameters& law, double length, double penetration,
                              double rate) {
  if (penetration <= 0) return 0;
  const double elastic = elastic_force(law, length, penetration);
  if (law.law == ForceLaw::hertz) {
    const double chi = hunt_crossley_chi(law.restitution, law.restitution_speed);
    return elastic * std::max(0.0, 1 + chi * rate);
  }
  const double damping = reference_step(penetration, 0, 0, law.damping_depth, law.damping);
  return std::max(0.0, elastic + damping * rate);
}

double reference_friction_coefficient(const Contacts& c, double speed) {
  if (speed < c.static_speed)
    return reference_step(speed, -c.static_speed, -c.friction_static, c.static_speed,
                          c.friction_static);
  return reference_step(speed, c.static_speed, c.friction_static, c.dynamic_speed,
                        c.friction_dynamic);
}

}  // namespace cagetol
