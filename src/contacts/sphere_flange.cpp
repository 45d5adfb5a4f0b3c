#include "src/contacts/sphere_flange.hpp"

#include <algorithm>
#include <numbers>

#include "src/contacts/flange_contacts.hpp"
#include "src/contacts/turned_frame.hpp"

namespace cagetol {
namespace {

/// Gap beyond which no film bears a load; within it even one thinner than the layer of oil may [m].
constexpr double kFar = 20e-6;
constexpr int kMotions = kLocalPositions + kLocalVelocities;
using Slopes = Dual<Pack, kMotions>;

template <class T>
struct Vector {  // along the bearing's axis, and a roller's e_r and e_t
  T x, r, t;
};
template <class T>
Vector<T> operator+(const Vector<T>& a, const Vector<T>& b) {
  return {a.x + b.x, a.r + b.r, a.t + b.t};
}
template <class T>
Vector<T> operator-(const Vector<T>& a, const Vector<T>& b) {
  return {a.x - b.x, a.r - b.r, a.t - b.t};
}
template <class T, class S>
Vector<T> operator*(const S& s, const Vector<T>& a) {
  return {s * a.x, s * a.r, s * a.t};
}
template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
  return a.x * b.x + a.r * b.r + a.t * b.t;
}
template <class T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {a.r * b.t - a.t * b.r, a.t * b.x - a.x * b.t, a.x * b.r - a.r * b.x};
}

/// Number `i` of a roller's motions: position, then velocity.
template <class T>
T motion(Pack value, int i) {
  if constexpr (std::is_same_v<T, Pack>)
    return value;
  else
    return variable<T>(value, i);
}
inline Pack plain(Pack x) {
  return x;
}
inline Pack plain(const Slopes& x) {
  return x.value;
}

/// A pack of rollers against the ring of the flange, in directions that stand still.
template <class T>
struct Relative {
  T a_r, a_t, b_r, b_t, spin;
  Vector<T> place, rate;  ///< of the roller's centre
};
template <class T>
Relative<T> relative_motion(const RollerPack& q, const FlangeRing& ring) {
  const auto speed = [](Pack value, int i) { return motion<T>(value, kLocalPositions + i); };
  return {
      motion<T>(q.a_r, kLar),
      motion<T>(q.a_t, kLat),
      speed(q.b_r, kLar),
      speed(q.b_t, kLat),
      speed(q.spin, kLs),
      {motion<T>(q.x, kLx) - ring.x, motion<T>(q.r, kLr) - ring.u_r,
       motion<T>(Pack{}, kLt) - ring.u_t},
      {speed(q.vx, kLx) - ring.x_rate, speed(q.vr, kLr) - ring.du_r, speed(q.vt, kLt) - ring.du_t}};
}

/// The point where sphere and cone meet.
template <class T>
struct SpherePoint {
  T p, rate;
  Vector<T> normal, along, around;  ///< unit vectors: n, along the flange's face, around the ring
  T lean_r, lean_t;                 ///< l
  T v1, v2;                         ///< sliding speeds along both [m/s]
  T drawn;                          ///< u [m/s]
  T spin;                           ///< relative angular speed about n [rad/s]
  Vector<T> swept;                  ///< velocity by the ring's spin [m/s]
  T swept_spin;                     ///< that spin about n [rad/s]
};
template <class T>
SpherePoint<T> sphere_point(const Flange& flange, const FlangeRing& ring, const Relative<T>& at) {
  const SphereFlange& f = flange.sphere;
  const double e = flange.side, k = f.centre, way = flange.inner ? -1 : 1;
  const double ec = e * f.cosine, zs = way * f.sine;
  const Pack B_r = ring.B_r, B_t = ring.B_t;
  SpherePoint<T> to;
  const T l_r = to.lean_r = at.a_r - B_r, l_t = to.lean_t = at.a_t - B_t;
  const auto leaning = [&](const T& x, const T& r, const T& t) {
    return Vector<T>{x - (B_r * r + B_t * t), r + B_r * x, t + B_t * x};
  };
  const Vector<T>&d = at.place, &v = at.rate;
  const T X = d.x + B_r * d.r + B_t * d.t - (0.5 * k) * (l_r * l_r + l_t * l_t);
  const T Y_r = d.r - B_r * d.x + k * l_r, Y_t = d.t - B_t * d.x + k * l_t;
  const T X_rate = v.x + B_r * v.r + B_t * v.t - k * (l_r * at.b_r + l_t * at.b_t);
  const T Yr_rate = v.r - B_r * v.x + k * at.b_r, Yt_rate = v.t - B_t * v.x + k * at.b_t;
  const T off = sqrt(Y_r * Y_r + Y_t * Y_t), inverse = reciprocal(off);
  const T e_r = Y_r * inverse, e_t = Y_t * inverse;
  to.p = f.cosine * (e * X - flange.clearance) + zs * (off - f.rest);
  to.rate = ec * X_rate + zs * (e_r * Yr_rate + e_t * Yt_rate);
  to.normal = leaning(T{} + ec, zs * e_r, zs * e_t);
  to.along = leaning(T{} - zs, ec * e_r, ec * e_t);
  to.around = leaning(T{}, -e_t, e_r);
  const T turn_r = at.spin * at.a_r - at.b_t, turn_t = at.spin * at.a_t + at.b_r;
  const Vector<T> turn{at.spin, turn_r, turn_t}, axis{T{} + 1.0, T{} + B_r, T{} + B_t};
  const T second = 0.5 * (at.a_r * at.a_r + at.a_t * at.a_t);
  const Vector<T> reach = f.radius * to.normal,
                  centre{v.x - k * (at.a_r * at.b_r + at.a_t * at.b_t), v.r + k * at.b_r,
                         v.t + k * at.b_t},
                  end{d.x + k * (1.0 - second), d.r + k * at.a_r, d.t + k * at.a_t};
  to.swept = ring.speed * cross(axis, end + reach);
  const Vector<T> surface = centre + cross(turn, reach), slide = surface - to.swept;
  to.v1 = dot(to.along, slide);
  to.v2 = dot(to.around, slide);
  const T passing = (off + zs * f.radius) * inverse * (e_r * Yt_rate - e_t * Yr_rate);
  to.drawn = 0.5 * dot(to.around, surface + to.swept) - passing;
  to.swept_spin = ring.speed * dot(to.normal, axis);
  to.spin = dot(to.normal, turn) - to.swept_spin;
  return to;
}

/// What the laws make of it.
template <class T>
struct SphereForces {
  T normal, elastic, steady;  ///< [N]; elastic: dry; steady: of the film
  T drag, turning;            ///< [N s/m], [N m s]
};
template <class T>
T damping_at(const SphereFlange& f, const T& depth, const T& rate) {
  return f.damping * smooth_step(depth * f.inverse_depth) * rate;
}
template <class T>
SphereForces<T> dry_forces(const SphereFlange& f, const FrictionLaw& rubbing,
                           const SpherePoint<T>& at, Mask wet) {
  const T p = select(wet, at.p, T{} + 1e-9);
  SphereForces<T> on{};
  on.elastic = f.stiffness * p * sqrt(p);
  on.normal = max(on.elastic + damping_at(f, p, at.rate), T{});
  on.drag = friction(rubbing, at.v1 * at.v1 + at.v2 * at.v2).ratio * on.normal;
  return on;
}
/// a b/2: square of the radius of gyration of a film sheared evenly [m2].
template <class T>
T film_gyration(const PointFilm& film, T load) {
  return (0.5 * film.area / std::numbers::pi) * power(load, 2.0 / 3);
}
template <class T>
SphereForces<T> oiled_forces(const SphereFlange& f, const FrictionLaw& rubbing,
                             const SpherePoint<T>& at, Mask wet) {
  const T gap = select(wet, -at.p, T{} + 0.5 * f.film.layer);
  const PointState<T> film = point_state(f.film, film_speed(at.drawn), gap);
  const OilFactors<T> oil = oil_factors(film.thickness * (1 / f.film.layer));
  SphereForces<T> on{};
  on.steady = starved_load(film, oil.wedge);
  on.normal = max(on.steady + damping_at(f, film.approach, (1.0 - film.opening) * at.rate), T{});
  const T load = max(on.normal, T{} + 1e-6);
  const T spun = at.spin * at.spin * film_gyration(f.film, load);
  const PointFriction<T> rubs =
      point_friction(f.film, rubbing, load, film.thickness, at.v1 * at.v1 + at.v2 * at.v2 + spun);
  on.drag = rubs.drag;
  on.turning = rubs.turning;
  return on;
}

/// Generalised forces on the rollers, and powers.
template <class T>
struct SphereLoads {
  T force[kLocalVelocities];
  T rubbed, damped, film, drive;  ///< [W]
};
template <class T>
SphereLoads<T> sphere_loads(const SphereFlange& f, double side, bool inner, const Relative<T>& by,
                            const SpherePoint<T>& at, const SphereForces<T>& on) {
  const double k = f.centre, ec = side * f.cosine, zs = inner ? -f.sine : f.sine;
  const Vector<T> rubs = T(-on.drag * at.v1) * at.along + T(-on.drag * at.v2) * at.around;
  const T turns = -on.turning * at.spin, push = on.normal;
  const Vector<T> moment = f.radius * cross(at.normal, rubs) + turns * at.normal;
  const T e_r = at.around.t, e_t = -at.around.r;  // around the ring, but for its lean
  SphereLoads<T> to;
  to.force[kLr] = rubs.r - push * at.normal.r;
  to.force[kLt] = rubs.t - push * at.normal.t;
  to.force[kLx] = rubs.x - push * at.normal.x;
  to.force[kLar] =
      k * (rubs.r - by.a_r * rubs.x) + moment.t - push * (k * (zs * e_r - ec * at.lean_r));
  to.force[kLat] =
      k * (rubs.t - by.a_t * rubs.x) - moment.r - push * (k * (zs * e_t - ec * at.lean_t));
  to.force[kLs] = moment.x + by.a_r * moment.r + by.a_t * moment.t;
  to.rubbed = on.drag * (at.v1 * at.v1 + at.v2 * at.v2) + on.turning * at.spin * at.spin;
  to.damped = (on.normal - on.elastic - on.steady) * at.rate;
  to.film = on.steady * at.rate;
  to.drive = dot(rubs, at.swept) + turns * at.swept_spin;
  return to;
}

template <class T>
struct SphereContact {
  SpherePoint<T> at;
  SphereForces<T> on;
  SphereLoads<T> loads;
};
template <class T>
SphereContact<T> sphere_contact(const BearingModel& model, const Flange& flange,
                                const FlangeRing& ring, const RollerPack& q, Mask wet) {
  const Relative<T> by = relative_motion<T>(q, ring);
  SphereContact<T> to{sphere_point(flange, ring, by), {}, {}};
  const FrictionLaw& rubbing = model.friction[kFlangePair];
  const SphereFlange& f = flange.sphere;
  to.on = f.film.on ? oiled_forces(f, rubbing, to.at, wet) : dry_forces(f, rubbing, to.at, wet);
  const Pack one = select(wet, splat(1.0), Pack{});
  for (T* each : {&to.on.normal, &to.on.elastic, &to.on.steady, &to.on.drag, &to.on.turning})
    *each = *each * one;
  to.loads = sphere_loads(f, flange.side, flange.inner, by, to.at, to.on);
  return to;
}

/// Forces and powers depend on the motion against the ring alone, so that what moves the ring does
/// the opposite of what moves the roller.
void add_slopes(const BearingModel& model, bool inner, const RollerPack& q, Mask wet, int group,
                const SphereLoads<Slopes>& on, Linearisation& jac) {
  GroupLinear& g = jac.groups[static_cast<std::size_t>(group)];
  GroupLinear own;
  own.cosine = q.cosine, own.sine = q.sine;
  own.radius = q.r, own.inverse_radius = g.inverse_radius;
  const Slopes power = on.drive - on.rubbed - on.damped - on.film;
  for (int j = 0; j < kLocalVelocities; ++j) {
    for (int i = 0; i < kLocalVelocities; ++i) {
      own.velocity[i][j] = on.force[i].slope[kLocalPositions + j];
      if (j < kLocalPositions) own.position[i][j] = on.force[i].slope[j];
    }
    own.power_velocity[j] = power.slope[kLocalPositions + j];
    if (j < kLocalPositions) own.power_position[j] = power.slope[j];
  }
  if (inner) {
    finish_inner(q, own);
    add_ring_block(own, jac);
    const auto add_power = [&](const Pack* by, Eigen::VectorXd& to) {
      to[kRingY] -= sum(q.cosine * by[kLr] - q.sine * by[kLt]);
      to[kRingZ] -= sum(q.sine * by[kLr] + q.cosine * by[kLt]);
    };
    add_power(own.power_position, jac.power_position);
    add_power(own.power_velocity, jac.power_velocity);
    if (model.layout.ring_axial > 0)
      finish_axial(q, own, select(wet, splat(1.0), Pack{}), group, model.layout.ring_axial_slot(),
                   jac);
  }
  for (int i = 0; i < kLocalVelocities; ++i) {
    turn_frame(q, own.position[i], own.velocity[i]);
    for (int j = 0; j < kLocalVelocities; ++j) {
      g.velocity[i][j] += own.velocity[i][j];
      if (j < kLocalPositions) g.position[i][j] += own.position[i][j];
    }
    g.power_velocity[i] += own.power_velocity[i];
    if (i < kLocalPositions) g.power_position[i] += own.power_position[i];
    if (!inner) continue;
    for (int k = 0; k < 2; ++k) {
      g.ring.position[i][k] += own.ring.position[i][k];
      g.ring.velocity[i][k] += own.ring.velocity[i][k];
      g.ring.to_velocity[k][i] += own.ring.to_velocity[k][i];
      if (i < kLocalPositions) g.ring.to_position[k][i] += own.ring.to_position[k][i];
    }
  }
}

template <class T>
void add_loads(const Flange& flange, const RollerPack& q, const SphereLoads<T>& on,
               RollerLoads& loads, BorderLoads& border) {
  for (int i = 0; i < kLocalVelocities; ++i) loads.f[i] += plain(on.force[i]);
  if (!flange.inner) return;
  const Pack r = plain(on.force[kLr]), t = plain(on.force[kLt]);
  border.ring[0] -= sum(q.cosine * r - q.sine * t);
  border.ring[1] -= sum(q.sine * r + q.cosine * t);
  border.ring_axial -= sum(plain(on.force[kLx]));
}

void observe(const SphereContact<Slopes>& contact, int group, Observation& seen) {
  const SphereForces<Slopes>& on = contact.on;
  double* const force = seen.flange_force.data() + group * kLanes;
  store(force, load(force) + on.normal.value);
  seen.rub(kFlangeFriction, sum(contact.loads.rubbed.value));
  seen.damp(kDamping, sum(contact.loads.damped.value));
  seen.damp(kFilm, sum(contact.loads.film.value));
  seen.drive_power += sum(contact.loads.drive.value);
  seen.elastic_energy += 0.4 * sum(on.elastic.value * max(contact.at.p.value, Pack{}));
}

}  // namespace

void sphere_flange(const BearingModel& model, const Flange& flange, const RollerGroup& roller,
                   const RollerPack& q, const BorderState& b, int group, RollerLoads& loads,
                   BorderLoads& border, Linearisation* jac, Observation* seen) {
  const FlangeRing ring = flange.inner ? inner_flange_ring(q, b) : FlangeRing{b.speed.outer};
  const Pack p = sphere_point(flange, ring, relative_motion<Pack>(q, ring)).p;
  const PointFilm& film = flange.sphere.film;
  const double reach = film.on ? std::max(film.layer, kFar) : 0;
  const Mask wet = (p > -reach) & (roller.exists > 0.0);
  if (!any(wet)) return;
  if (jac == nullptr) {
    add_loads(flange, q, sphere_contact<Pack>(model, flange, ring, q, wet).loads, loads, border);
    return;
  }
  const SphereContact<Slopes> contact = sphere_contact<Slopes>(model, flange, ring, q, wet);
  add_loads(flange, q, contact.loads, loads, border);
  add_slopes(model, flange.inner, q, wet, group, contact.loads, *jac);
  observe(contact, group, *seen);
}

}  // namespace cagetol
