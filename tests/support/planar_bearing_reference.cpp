// One file on purpose, though long: the whole reference is to be read from top to bottom beside the
// equations, and shares nothing with the program.
#include "tests/support/planar_bearing_reference.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace cagetol {
namespace {

using std::numbers::pi;

constexpr double kSlowest = 0.01;  // u0 [m/s]

/// Factors of the oil in a gap.
struct OilShare {
  double wedge = 1, squeeze = 1, rolling = 1, couette = 1;
};
OilShare oil_share(double x) {
  if (x >= 1) return {0, 0, 0, 0};
  const double z = std::min(1.0, (1 - x) / 0.2);
  const double more = std::pow(x, 1.5), across = 1 - std::sqrt(x);
  return {(1 - x) * (1 - x) * (1 - 0.3 * x), std::pow(1 - more, 1.5) * (1 - 0.1 * more),
          across * across * (1 - 0.8 * more), std::sqrt(across) * z * z * (3 - 2 * z)};
}

/// Film thickness of a load per length q = e^y, and what belongs to it.
struct Film {
  double elastic, rigid, h, delta, slope;  // slope: dg/dy
};
struct FilmLaw {
  double elastic, rigid, approach;
  FilmLaw(const PlanarContact& c, double u)
      : elastic(2.65 * std::pow(c.pressure_viscosity, 0.54) * std::pow(c.viscosity * u, 0.70) *
                std::pow(c.radius, 0.43) * std::pow(c.modulus, -0.03)),
        rigid(4.895 * c.viscosity * u * c.radius),
        approach(c.approach) {}
  Film at(double y) const {
    Film f;
    f.elastic = elastic * std::exp(-0.13 * y);
    f.rigid = rigid * std::exp(-y);
    const double e2 = f.elastic * f.elastic, r2 = f.rigid * f.rigid;
    f.h = std::sqrt(std::sqrt(e2 * e2 + r2 * r2));
    f.delta = approach * std::exp(0.9 * y);
    f.slope = -(0.13 * e2 * e2 + r2 * r2) / (f.h * f.h * f.h) - 0.9 * f.delta;
    return f;
  }
};

/// ln q at which h - delta = gap.
double solve_load(const FilmLaw& law, double gap, const double* start) {
  if (start) {
    double y = *start;
    for (int i = 0; i < 12; ++i) {
      const Film f = law.at(y);
      const double change = (f.h - f.delta - gap) / f.slope;
      if (!(std::abs(change) < 2)) break;  // far off: by bisection
      y -= change;
      if (std::abs(change) < 1e-7) return y;  // the error left is its square
    }
  }
  double low = -40, high = 40;
  while (high - low > 1e-13 * (1 + std::abs(low))) {
    const double y = 0.5 * (low + high);
    if (y == low || y == high) break;
    const Film f = law.at(y);
    (f.h - f.delta > gap ? low : high) = y;
  }
  return 0.5 * (low + high);
}

double boundary_friction(const PlanarFriction& law, double v) {
  const double s = v / law.static_speed;
  if (std::abs(s) < 1) return law.static_coefficient * s * (3 - s * s) / 2;
  const double way = v > 0 ? 1 : -1;
  const double z = std::clamp(
      (std::abs(v) - law.static_speed) / (law.dynamic_speed - law.static_speed), 0.0, 1.0);
  return way * (law.static_coefficient +
                (law.dynamic_coefficient - law.static_coefficient) * z * z * (3 - 2 * z));
}

/// Traction of `q` N/m at film thickness h, and its slope over the sliding speed; per length.
struct Traction2 {
  double force, slope;
};
Traction2 sliding_traction(const PlanarContact& c, double q, double h, double sliding,
                           double couette) {
  const double b = std::sqrt(8 * q * c.radius / (pi * c.modulus)), p = q / (2 * b);
  const double barus = c.pressure_viscosity * p;
  const double a = barus / std::pow(1 + std::pow(barus / 15, 8), 1.0 / 8);
  const double newtonian = c.viscosity * std::exp(a) / h;
  const double x = newtonian * sliding / c.eyring, tau = c.eyring * std::asinh(x);
  const double limit = c.limiting * p, root = std::sqrt(1 + tau / limit * (tau / limit));
  const double inlet = 2.849 * c.viscosity * std::sqrt(c.radius / h) * couette;
  const double carried = 1 - std::exp(-1.8 * std::pow(h / c.roughness, 1.2));
  const double slope = newtonian / std::sqrt(1 + x * x) / (root * root * root);
  const double dry = boundary_friction(c.friction, sliding);
  return {carried * (2 * b * tau / root + inlet * sliding) + (1 - carried) * dry * q,
          carried * (2 * b * slope + inlet) +
              (1 - carried) * 1.5 * c.friction.static_coefficient / c.friction.static_speed * q};
}

double rolling_force(const PlanarContact& c, double q, double u) {
  const double W = q / (c.modulus * c.radius);
  const double elastic = 4.317 *
                         std::pow(c.pressure_viscosity * c.viscosity * u / c.radius, 0.658228) *
                         std::pow(W, 0.012658) * c.radius / c.pressure_viscosity;
  const double rigid = 2.0796 * std::sqrt(c.viscosity * u * q);
  return 1 / std::cbrt(1 / (elastic * elastic * elastic) + 1 / (rigid * rigid * rigid));
}

PlanarContact make_contact(const PlanarBearing& b, double radius, double modulus, double roughness,
                           double layer) {
  PlanarContact c;
  c.viscosity = b.oil.viscosity;
  c.pressure_viscosity = b.oil.pressure_viscosity;
  c.eyring = b.oil.eyring;
  c.limiting = b.oil.limiting;
  c.roughness = roughness;
  c.radius = radius;
  c.length = b.roller_length;
  c.modulus = modulus;
  // Q = 77652 L^(8/9) delta^(10/9), lengths in mm, of steel; as stiff as the pair's E' against it.
  const double mm = 1e3, steel = 208e9 / (1 - 0.3 * 0.3);
  c.approach = std::pow(b.roller_length * steel /
                            (77652 * std::pow(mm * b.roller_length, 8.0 / 9) * modulus),
                        0.9) /
               mm;
  c.layer = layer;
  c.chi = b.chi;
  c.friction = b.friction;
  return c;
}

/// A force couple of contact and axis along one direction, as roller_forces adds it up.
struct Tangential {
  double surface;  ///< on the roller's surface
  double axis;     ///< on the roller's axis
};

}  // namespace

PlanarContact inner_race_contact(const PlanarBearing& b) {
  const double R = b.roller_radius * b.inner_radius / (b.roller_radius + b.inner_radius);
  return make_contact(b, R, b.race_modulus, b.oil.race_roughness, b.oil.race_layer);
}
PlanarContact outer_race_contact(const PlanarBearing& b) {
  const double R = b.roller_radius * b.outer_radius / (b.outer_radius - b.roller_radius);
  return make_contact(b, R, b.race_modulus, b.oil.race_roughness, b.oil.outer_layer);
}
PlanarContact bar_contact(const PlanarBearing& b) {
  return make_contact(b, b.roller_radius, b.bar_modulus, b.oil.pocket_roughness,
                      b.oil.pocket_layer);
}

PlanarContactForces contact_forces(const PlanarContact& c, double gap, double rate,
                                   double entrainment, double sliding, double* log_load) {
  PlanarContactForces f;
  if (c.layer > 0 && gap >= c.layer) return f;
  const double u = std::sqrt(entrainment * entrainment + kSlowest * kSlowest);
  const FilmLaw law(c, u);
  const double y = solve_load(law, gap, log_load), q = std::exp(y);
  if (log_load) *log_load = y;
  const Film film = law.at(y);
  const double h = film.h, share = std::pow(film.rigid / h, 4);
  const double opening = 1 + 0.9 * film.delta / film.slope;  // dh/dg = 1 + d delta/dg
  OilShare oil;
  double steady = q, thin = h;
  if (c.layer > 0) {
    const double filled = (1 - share) * h / c.layer;
    thin = h * (share + (1 - share) / (1 + filled * std::sqrt(filled / (filled + 0.045))));
    const double z = std::clamp(2 - 2 * gap / c.layer, 0.0, 1.0), near = z * z * (3 - 2 * z);
    oil = oil_share(1 - (1 - thin / c.layer) * near);
    steady = q * (share * oil.wedge + (1 - share) * near);
  }
  const double drag =
      oil.squeeze * 3 * std::sqrt(2.0) * pi * c.viscosity * std::pow(c.radius / h, 1.5) * opening;
  const double s = -drag * rate, root = std::sqrt(s * s + 4 * steady * steady);
  const double pressed = (s + root) / 2;
  const double body = steady * c.chi * (1 - opening);
  const double acting = std::max(0.0, pressed - body * rate), L = c.length;
  f.normal = L * acting;
  f.steady = L * steady;
  f.film = L * pressed;
  f.thickness = thin;
  if (acting > 0) {
    const Traction2 t = sliding_traction(c, acting, thin, sliding, oil.couette);
    f.traction = L * t.force;
    f.slope = L * t.slope;
  }
  f.rolling = L * oil.rolling * rolling_force(c, q, u) * entrainment / u;
  f.stiffness = -L * steady / film.slope;
  f.damping = L * (root > 0 ? drag * (1 + s / root) / 2 : 0) + L * body;
  return f;
}

PlanarRollerForces roller_forces(const PlanarBearing& b, const PlanarBody& ring,
                                 const PlanarBody& roller, double pocket, double cage_speed,
                                 double* starts) {
  PlanarRollerForces on;
  const double Rw = b.roller_radius;
  const auto race = [&](const PlanarContact& c, const PlanarBody& body, double R, double side,
                        double* start, double& rate, double& force_y, double& force_z,
                        double& moment) {
    const double dy = roller.y - body.y, dz = roller.z - body.z, apart = std::hypot(dy, dz);
    const double ry = dy / apart, rz = dz / apart, ty = -rz, tz = ry;
    const double vy = roller.vy - body.vy, vz = roller.vz - body.vz;
    const double v_r = vy * ry + vz * rz, v_t = vy * ty + vz * tz, turn = v_t / apart;
    // The contact lies at -side Rw from the roller's axis and at R from the race's.
    const double gap = side > 0 ? apart - R - Rw : R - Rw - apart;
    rate = side * v_r;
    const double of_race = (body.spin - turn) * R, of_roller = -side * (roller.spin - turn) * Rw;
    const double u = (of_race + of_roller) / 2;
    const double sliding = v_t - side * roller.spin * Rw - body.spin * R;
    const PlanarContactForces f = contact_forces(c, gap, rate, u, sliding, start);
    const double surface = -f.traction - f.rolling, axis = f.rolling * 2 * c.radius / Rw;
    const double other = f.traction - f.rolling, other_axis = side * f.rolling * 2 * c.radius / R;
    const double along = surface + axis, across = side * f.normal;
    on.y += across * ry + along * ty;
    on.z += across * rz + along * tz;
    on.moment += -side * Rw * surface;
    force_y += -across * ry + (other + other_axis) * ty;
    force_z += -across * rz + (other + other_axis) * tz;
    moment += other * R;
    on.losses.rolling += 2 * f.rolling * u;
    on.losses.sliding += f.traction * sliding;
    on.losses.squeeze -= (f.normal - f.steady) * rate;
    on.film -= f.steady * rate;
    return f;
  };
  const PlanarBody outer_ring;
  on.inner_contact =
      race(inner_race_contact(b), ring, b.inner_radius, 1, starts ? starts + 0 : nullptr,
           on.inner_rate, on.ring_y, on.ring_z, on.ring_moment);
  on.outer_contact =
      race(outer_race_contact(b), outer_ring, b.outer_radius, -1, starts ? starts + 1 : nullptr,
           on.outer_rate, on.outer_y, on.outer_z, on.outer_moment);
  on.inner = on.inner_contact.normal;
  on.outer = on.outer_contact.normal;
  // The pocket's directions: e_R outwards through its middle, e_T along the cage's turning.
  const double Ry = std::cos(pocket), Rz = std::sin(pocket), Ty = -Rz, Tz = Ry;
  const double D_R = roller.y * Ry + roller.z * Rz, D_T = roller.y * Ty + roller.z * Tz;
  const double v_R = roller.vy * Ry + roller.vz * Rz + cage_speed * D_T,
               v_T = roller.vy * Ty + roller.vz * Tz - cage_speed * D_R;
  const PlanarContact bar = bar_contact(b);
  for (int k = 0; k < 2; ++k) {
    const double side = k == 0 ? 1 : -1;
    on.bar_rate[k] = -side * v_T;
    const double sliding = v_R + side * Rw * (cage_speed - roller.spin), u = sliding / 2 - v_R;
    const PlanarContactForces f = contact_forces(bar, b.half_clearance - side * D_T, on.bar_rate[k],
                                                 u, sliding, starts ? starts + 2 + k : nullptr);
    const double surface = -f.traction - f.rolling, axis = 2 * f.rolling;
    const double along = surface + axis, across = -side * f.normal;
    on.y += across * Ty + along * Ry;
    on.z += across * Tz + along * Rz;
    on.moment += -side * Rw * surface;
    on.bar_y -= across * Ty + along * Ry;
    on.bar_z -= across * Tz + along * Rz;
    on.cage_moment += side * f.normal * D_R + surface * (D_T + side * Rw) + axis * D_T;
    on.losses.pocket += f.traction * sliding + 2 * f.rolling * u;
    on.losses.squeeze -= (f.normal - f.steady) * on.bar_rate[k];
    on.film -= f.steady * on.bar_rate[k];
    on.bar[k] = f.normal;
    on.bar_contacts[k] = f;
  }
  return on;
}

double kinematic_speed(const PlanarBearing& b) {
  return b.inner_speed * b.inner_radius / (b.inner_radius + b.outer_radius);
}

namespace {

double roller_mass(const PlanarBearing& b) {
  return b.roller_density * pi * b.roller_radius * b.roller_radius * b.roller_length;
}

/// A roller that rolls without slip at (r, angle).
PlanarBody rolling_roller(const PlanarBearing& b, double r, double angle, double orbit) {
  const double spin = (r * orbit - b.inner_radius * b.inner_speed) / b.roller_radius;
  return {r * std::cos(angle), r * std::sin(angle), -r * orbit * std::sin(angle),
          r * orbit * std::cos(angle), spin};
}

/// Radius at which a roller without its cage is at rest in the radial direction.
double resting_radius(const PlanarBearing& b, const PlanarBody& ring, double angle,
                      double* starts) {
  const double middle = (b.inner_radius + b.outer_radius) / 2, orbit = kinematic_speed(b);
  const double mass = roller_mass(b);
  PlanarBearing open = b;
  open.half_clearance = 1;  // bars out of reach
  double low = middle - 100e-6, high = middle + 100e-6;
  while (high - low > 1e-13) {
    const double r = (low + high) / 2;
    const PlanarRollerForces f =
        roller_forces(open, ring, rolling_roller(b, r, angle, orbit), angle, orbit, starts);
    const double out = f.y * std::cos(angle) + f.z * std::sin(angle) + mass * r * orbit * orbit;
    (out > 0 ? low : high) = r;
  }
  return (low + high) / 2;
}

}  // namespace

double static_displacement(const PlanarBearing& b) {
  constexpr int places = 4;  // within one pitch of the rollers
  const int n = b.rollers * places;
  std::vector<double> starts(static_cast<std::size_t>(4 * n), 5.0);
  const double orbit = kinematic_speed(b);
  double low = 0, high = 500e-6;
  while (high - low > 1e-10) {
    const double d = (low + high) / 2;
    const PlanarBody ring{0, -d, 0, 0, b.inner_speed};
    double lift = 0;
    for (int i = 0; i < n; ++i) {
      double* start = starts.data() + 4 * i;
      const double angle = 2 * pi * i / n, r = resting_radius(b, ring, angle, start);
      lift +=
          roller_forces(b, ring, rolling_roller(b, r, angle, orbit), angle, orbit, start).ring_z /
          places;
    }
    (lift < b.load ? low : high) = d;
  }
  return (low + high) / 2;
}

PlanarOutcome planar_bearing_run(const PlanarBearing& b, const PlanarRun& run) {
  struct Roller {
    double r, angle, v_r, orbit, spin;
    double start[4] = {5, 5, 5, 5};  // ln q of its contacts
  };
  PlanarOutcome out;
  PlanarBody ring{0, -static_displacement(b), 0, 0, b.inner_speed};
  const double mass = roller_mass(b), Rw = b.roller_radius, inertia = mass * Rw * Rw / 2;
  const double kinematic = kinematic_speed(b), dt = run.step;
  double cage = kinematic * run.start, turned = 0;
  std::vector<Roller> rollers;
  for (int j = 0; j < b.rollers; ++j) {
    Roller w{0, 2 * pi * j / b.rollers, 0, cage, 0};
    w.r = resting_radius(b, ring, w.angle, w.start);
    w.spin = rolling_roller(b, w.r, w.angle, cage).spin;
    if (run.start != 1) w.spin = -cage * b.outer_radius / Rw + cage;  // rolls on the outer race
    rollers.push_back(w);
  }
  const long settle = std::lround(run.settle / dt), steps = settle + std::lround(run.measure / dt);
  double mean = 0, first = 0, depth = 0, drive = 0, square = 0;
  PlanarLosses sum;
  for (long k = 0; k < steps; ++k) {
    const bool seen = k >= settle;
    double on_cage = -b.land_moment * cage, on_ring_y = 0, on_ring_z = -b.load;
    sum.lands += seen ? b.land_moment * cage * cage : 0;
    for (int j = 0; j < b.rollers; ++j) {
      Roller& w = rollers[static_cast<std::size_t>(j)];
      const double c = std::cos(w.angle), s = std::sin(w.angle), v_t = w.r * w.orbit;
      const PlanarBody body{w.r * c, w.r * s, w.v_r * c - v_t * s, w.v_r * s + v_t * c, w.spin};
      const PlanarRollerForces f =
          roller_forces(b, ring, body, turned + 2 * pi * j / b.rollers, cage, w.start);
      const double through = w.r * (w.orbit - b.drag_carried * cage);
      const double drag =
          b.drag_density * Rw * b.roller_length * through * std::abs(through);  // C_d = 1
      double F_r = f.y * c + f.z * s + mass * v_t * w.orbit;
      double F_t = f.z * c - f.y * s - drag - 2 * mass * w.v_r * w.orbit;
      const double M = f.moment;
      // Linearly implicit Euler: normal forces at the step's end, tractions by their slopes.
      const PlanarContactForces &in = f.inner_contact, &ou = f.outer_contact;
      const double k_in = in.stiffness * dt, k_ou = ou.stiffness * dt;
      F_r += -k_in * f.inner_rate + k_ou * f.outer_rate;
      const double stiff_r = k_in + in.damping + k_ou + ou.damping;
      double stiff_t = 0, hold[2];
      for (int i = 0; i < 2; ++i) {
        const double side = i == 0 ? 1 : -1, k_bar = f.bar_contacts[i].stiffness * dt;
        F_t += side * k_bar * f.bar_rate[i];
        on_cage += -side * k_bar * f.bar_rate[i] * w.r;
        hold[i] = k_bar + f.bar_contacts[i].damping;
        stiff_t += hold[i];
      }
      const double change_r = dt * F_r / (mass + dt * stiff_r);
      // Along the orbit and in spin: [m + dt (a + b + bars), dt Rw (b - a)] etc.
      const double a = in.slope, o = ou.slope;
      const double A = mass + dt * (a + o + stiff_t), B = dt * Rw * (o - a),
                   C = inertia + dt * Rw * Rw * (a + o);
      const double det = A * C - B * B;
      const double change_t = dt * (F_t * C - M * B) / det, change_s = dt * (M * A - F_t * B) / det;
      on_ring_y += f.ring_y;
      on_ring_z += f.ring_z;
      on_cage += f.cage_moment + (hold[0] + hold[1]) * change_t * w.r;
      if (seen) {
        const double bars = f.bar[0] + f.bar[1];
        square += bars * bars;
        out.bar_peak = std::max(out.bar_peak, bars);
        drive -= f.ring_moment;
        sum.rolling += f.losses.rolling;
        sum.sliding += f.losses.sliding;
        sum.pocket += f.losses.pocket;
        sum.squeeze += f.losses.squeeze;
        sum.drag += drag * v_t;
      }
      w.v_r += change_r;
      const double fresh = (v_t + change_t) / w.r;
      w.r += dt * w.v_r;
      w.orbit = fresh;
      w.angle += dt * fresh;
      w.spin += change_s;
    }
    cage += dt * on_cage / b.cage_inertia;
    turned += dt * cage;
    if (run.ring_dashpot > 0) {
      // Its speed is left out of the contacts': tractions would drive it from step to step.
      ring.y += dt * on_ring_y / run.ring_dashpot;
      ring.z += dt * on_ring_z / run.ring_dashpot;
    }
    if (!seen) continue;
    mean += cage;
    depth -= ring.z;
    if (2 * (k - settle) < steps - settle) first += cage;
  }
  const double n = static_cast<double>(steps - settle);
  const auto per_step = [&](double total) { return total / n; };
  out.losses = {per_step(sum.rolling), per_step(sum.sliding), per_step(sum.pocket),
                per_step(sum.squeeze), per_step(sum.drag),    per_step(sum.lands)};
  out.displacement = depth / n;
  out.cage_slip = 1 - mean / n / kinematic;
  out.torque = out.losses.total() / b.inner_speed;
  out.drive = drive / n;
  out.bar_rms = std::sqrt(square / n / b.rollers);
  out.cage_drift = 1 - 2 * first / mean;
  return out;
}

}  // namespace cagetol
