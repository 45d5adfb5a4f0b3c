// Cage lands against the rings, one at each side ring of the cage (x = +-land_offset): against the
// ring that guides the cage, and against the other one, which holds it if all else deflects. A
// land touches at its two edges, x +- land_edge: a tilted one at one of them. delta is the land's
// offset from the ring's axis, n = delta/|delta|, p = |delta| - clearance. Under a guide film
// (guide_film.hpp, around the land's middle) the clearance ends at the height of roughness. The
// force on the cage is -Q n. Sliding: v1 along t = e_x x n, v2 along e_x, of the cage's surface
// at land_radius n relative to the ring's. Inner guidance rubs on the inner ring, which answers.
// A flexible cage's guiding surface bends: its displacement, interpolated around between the
// corners of FlexibleCage, adds to p and to the sliding speeds; the surface's slope turns the
// normal a little.
#pragma once

#include <numbers>

#include "src/contacts/guide_film.hpp"
#include "src/contacts/touch.hpp"

namespace cagetol {

/// The bent guiding surface at an angle in the cage: displacement and speed along e_r, e_t, e_x,
/// their rows, and how the radial displacement changes with the angle [m/rad].
struct BentLand {
  double moved = 0, slope = 0, rate[3] = {0, 0, 0};
  double row[3][kMostModes];
};
inline void bend_land(const ModalState& modal, int land, double angle, BentLand& bent) {
  const FlexibleCage& cage = *modal.cage;
  const double per_radian = cage.corners / (2 * std::numbers::pi);
  const double place = angle * per_radian, below = __builtin_floor(place), share = place - below;
  const int from = ((static_cast<int>(below) % cage.corners) + cage.corners) % cage.corners;
  const int to = (from + 1) % cage.corners;
  with_packs(packs_for(cage.modes), [&]<int packs>() {
    Pack q[packs], rate[packs];
    load_padded(modal.q, cage.modes, q);
    load_padded(modal.rate, cage.modes, rate);
    for (int d = 0; d < 3; ++d) {
      Pack first[packs], change[packs], moved{}, slope{}, speed{};
      load_padded(cage.land_row(land, from, d), cage.modes, first);
      load_padded(cage.land_row(land, to, d), cage.modes, change);
      for (int p = 0; p < packs; ++p) {
        change[p] -= first[p];
        const Pack row = first[p] + share * change[p];
        store_first(bent.row[d] + p * kLanes, row, cage.modes - p * kLanes);
        speed += row * rate[p];
        if (d > 0) continue;
        moved += row * q[p];
        slope += change[p] * q[p];
      }
      bent.rate[d] = sum(speed);
      if (d > 0) continue;
      bent.moved = sum(moved);
      bent.slope = per_radian * sum(slope);
    }
  });
}

/// One land: where it is relative to its ring, and how it touches.
struct LandPlace {
  bool inner;                  ///< guided by the inner ring
  double side;                 ///< +1 where the cage's outside meets the outer ring, else -1
  double R, X;                 ///< signed radius and axial place of the surface [m]
  double offset[2], speed[2];  ///< of the land's centre relative to the ring's [m], [m/s]
  double distance, inverse;
  double n[2];   ///< direction of the offset
  double along;  ///< speed across it [m/s]
};
inline LandPlace land_place(const BearingModel& model, const CageGuide& guide, const BorderState& b,
                            double X) {
  LandPlace at;
  at.inner = guide.inner;
  // The cage's outside surface meets the outer ring where the offset points; its bore meets the
  // inner ring on the opposite side.
  at.side = at.inner ? -1.0 : 1.0;
  at.R = at.side * guide.land_radius;
  at.X = X;
  const double tilt[2] = {model.misalignment_y, model.misalignment_z};
  for (int k = 0; k < 2; ++k) {
    at.offset[k] = b.cage[k] + at.X * b.axis[k];
    at.speed[k] = b.cage_rate[k] + at.X * b.axis_rate[k];
    if (!at.inner) continue;
    at.offset[k] -= b.ring[k] + tilt[k] * at.X;
    at.speed[k] -= b.ring_rate[k];
  }
  return at;
}
inline void set_normal(LandPlace& at) {
  at.distance = __builtin_sqrt(at.offset[0] * at.offset[0] + at.offset[1] * at.offset[1]);
  at.inverse = at.distance > 0 ? 1 / at.distance : 0;
  for (int k = 0; k < 2; ++k) at.n[k] = at.offset[k] * at.inverse;
  at.along = at.n[0] * at.speed[1] - at.n[1] * at.speed[0];
}

/// A touch of a land with what its forces depend on.
struct LandTouch {
  Touch<double> touch;
  BentLand bent;
  double ring_surface, drift;  ///< speed of the ring's surface along t, and axially as it is tilted
  double n_A;                  ///< (A x n)_x
  double py, pz;  ///< dp/d(place of the land): the normal, turned by the surface's slope
};
/// False where the land is apart.
inline bool land_touch(const BearingModel& model, const CageGuide& guide, const BorderState& b,
                       const ModalState& modal, const LandPlace& at, int land, LandTouch& on) {
  const double ny = at.n[0], nz = at.n[1];
  Touch<double>& touch = on.touch;
  touch.p = at.distance - guide.touching_at;
  if (!(touch.p > -modal.farthest)) return false;
  touch.rate = ny * at.speed[0] + nz * at.speed[1];
  if (modal.flexible()) {
    bend_land(modal, land, std::atan2(at.side * nz, at.side * ny) - b.phi, on.bent);
    touch.p += at.side * on.bent.moved;
    touch.rate +=
        at.side * (on.bent.rate[0] + on.bent.slope * (at.along * at.inverse - b.phi_rate));
  }
  if (!(touch.p > 0)) return false;
  on.ring_surface = (at.inner ? b.speed.inner : b.speed.outer) * at.side * guide.ring_radius;
  on.drift =
      at.inner ? on.ring_surface * (model.misalignment_y * nz - model.misalignment_z * ny) : 0;
  on.n_A = b.axis[0] * nz - b.axis[1] * ny;
  touch.v1 = at.along + b.phi_rate * at.R - on.ring_surface + at.side * on.bent.rate[1];
  touch.v2 = b.cage_rate[2] - (at.inner ? b.ring_axial_rate : 0) + on.bent.rate[2] +
             at.R * (b.phi_rate * on.n_A - (b.axis_rate[0] * ny + b.axis_rate[1] * nz)) - on.drift;
  const double lean = at.side * on.bent.slope * at.inverse;
  on.py = ny - lean * nz, on.pz = nz + lean * ny;
  return true;
}

/// What the ring's drive changes by: its surface is dragged along t.
inline void add_land_drive(const LandTouch& on, const Answer<double>& contact,
                           const ContactRows& rows, Linearisation& jac) {
  if (on.ring_surface == 0) return;
  const auto& [p, rate, v1, v2] = on.touch;
  const NormalForce<double>& normal = contact.normal;
  const Friction<double>& fr = contact.friction;
  const double bend = normal.force * fr.bend, along = fr.ratio * v1;
  for (std::size_t j = 0; j < rows.border[0].size(); ++j) {
    const double gn = rows.border[0][j], g1 = rows.border[1][j], g2 = rows.border[2][j];
    const auto at = static_cast<Eigen::Index>(j);
    jac.power_velocity[at] += on.ring_surface * (along * normal.damping * gn - contact.drag * g1 -
                                                 bend * v1 * (v1 * g1 + v2 * g2));
    jac.power_position[at] += on.ring_surface * along * normal.stiffness * gn;
  }
}

/// Derivatives of the forces of a touch.
inline void add_land_slopes(const BorderState& b, const ModalState& modal, const LandPlace& at,
                            const LandTouch& on, const Answer<double>& contact, ContactRows& rows,
                            Linearisation& jac) {
  const double ny = at.n[0], nz = at.n[1], X = at.X, R = at.R, side = at.side;
  const auto& [p, rate, v1, v2] = on.touch;
  const double channels[3][kCageRigid] = {
      {-on.py, -on.pz, 0, side * on.bent.slope, -X * on.py, -X * on.pz},
      {-nz, ny, 0, R, -X * nz, X * ny},
      {0, 0, 1, R * on.n_A, -R * ny, -R * nz}};
  const double modal_sign[3] = {-side, side, 1};
  for (int c = 0; c < 3; ++c) {
    fill_cage_row(channels[c], b, rows.border[c]);
    for (int m = 0; m < modal.cage->modes; ++m)
      rows.border[c][static_cast<std::size_t>(kModes + m)] = modal_sign[c] * on.bent.row[c][m];
    if (!at.inner) continue;
    rows.border[c][kRingY] = -channels[c][0];
    rows.border[c][kRingZ] = -channels[c][1];
  }
  add_contact(rows, slopes_of(on.touch, contact), -1, jac);
  add_land_drive(on, contact, rows, jac);
  // n and t turn as the cage moves along t: with them the force, and p'.
  const NormalForce<double>& normal = contact.normal;
  const std::vector<double>&gn = rows.border[0], &g1 = rows.border[1], &g2 = rows.border[2];
  const double turn[kRigidBorder] = {
      at.inner ? nz : 0, at.inner ? -ny : 0, -nz, ny, 0, 0, -X * nz, X * ny};
  for (int i = 0; i < kRigidBorder; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double e = gn[k] - contact.friction.ratio * (v1 * g1[k] + v2 * g2[k]);
    const double row =
        (-contact.drag * v1 * gn[k] - normal.force * turn[i] + e * normal.damping * at.along) *
        at.inverse;
    for (int j = 0; j < kRigidBorder; ++j) jac.border_position(i, j) += row * turn[j];
  }
  for (auto& row : rows.border) row[kRingY] = row[kRingZ] = 0;
}

/// What presses on one land of the cage: sum of film and touches, and of the touches' sizes [N].
struct LandForce {
  double sum[2] = {0, 0}, touches = 0;
};

/// Forces of a touch on cage, modes and ring, its account and derivatives.
template <bool linear>
void apply_land_touch(const BearingModel& model, const BorderState& b, const ModalState& modal,
                      const LandPlace& at, const LandTouch& on, int land, LandForce& pressed,
                      BorderLoads& border, double* modal_force, ContactRows* rows,
                      Linearisation* jac, Observation* seen) {
  const double ny = at.n[0], nz = at.n[1], X = at.X, R = at.R;
  const Answer<double> contact = answer_to(on.touch, model.land, model.friction[kLandPair]);
  const double push = contact.normal.force, f1 = -contact.drag * on.touch.v1,
               f2 = -contact.drag * on.touch.v2;
  const double fy = -push * on.py - f1 * nz, fz = -push * on.pz + f1 * ny;
  for (int k = 0; k < modal.cage->modes; ++k)
    modal_force[k] +=
        at.side * (f1 * on.bent.row[1][k] - push * on.bent.row[0][k]) + f2 * on.bent.row[2][k];
  border.cage[0] += fy;
  border.cage[1] += fz;
  border.cage[2] += f2;
  border.cage[3] += R * (f1 + f2 * on.n_A) + push * at.side * on.bent.slope;
  border.cage[4] += X * fy - R * ny * f2;
  border.cage[5] += X * fz - R * nz * f2;
  if (at.inner) {
    border.ring[0] -= fy;
    border.ring[1] -= fz;
    border.ring_axial -= f2;
  }
  if constexpr (linear) {
    pressed.sum[0] -= push * on.py;
    pressed.sum[1] -= push * on.pz;
    pressed.touches += push;
    seen->land_touching[land] = seen->land_touching[land] || push > 0;
    account(on.touch, contact, model.land, kLandFriction, *seen);
    seen->drive_power += f1 * on.ring_surface + f2 * on.drift;
    add_land_slopes(b, modal, at, on, contact, *rows, *jac);
  }
}

/// One land on one ring.
template <bool linear>
void land_on_guide(const BearingModel& model, const CageGuide& guide, int land,
                   const BorderState& b, const ModalState& modal, BorderLoads& border,
                   double* modal_force, ContactRows* rows, Linearisation* jac, Observation* seen) {
  const double middle = land == 0 ? -model.land_offset : model.land_offset;
  LandPlace at = land_place(model, guide, b, middle);
  // Most lands are apart: a root and a division less.
  const double tilt = std::abs(b.axis[0]) + std::abs(b.axis[1]) + std::abs(model.misalignment_y) +
                      std::abs(model.misalignment_z);
  const double reach = guide.touching_at - modal.farthest - model.land_edge * tilt;
  const double squared = at.offset[0] * at.offset[0] + at.offset[1] * at.offset[1];
  if (!guide.film.on && reach > 0 && squared < reach * reach) return;
  LandForce pressed;
  if (guide.film.on) {
    set_normal(at);
    guide_film<linear>(guide, b, at.X, at.offset, at.speed, border, pressed.sum, rows, jac, seen);
  }
  const bool edges = model.land_edge > 0;
  for (int edge = 0; edge < (edges ? 2 : 1); ++edge) {
    if (edges)
      at = land_place(model, guide, b, middle + (edge == 0 ? -model.land_edge : model.land_edge));
    set_normal(at);
    LandTouch on;
    if (land_touch(model, guide, b, modal, at, land, on))
      apply_land_touch<linear>(model, b, modal, at, on, land, pressed, border, modal_force, rows,
                               jac, seen);
  }
  if constexpr (linear)
    seen->land_force[land] +=
        guide.film.on ? std::hypot(pressed.sum[0], pressed.sum[1]) : pressed.touches;
}

template <bool linear>
void land_contacts(const BearingModel& model, const BorderState& b, const ModalState& modal,
                   BorderLoads& border, double* modal_force, ContactRows* rows, Linearisation* jac,
                   Observation* seen) {
  for (const CageGuide& guide : model.guides)
    for (int land = 0; land < 2; ++land)
      land_on_guide<linear>(model, guide, land, b, modal, border, modal_force, rows, jac, seen);
}

}  // namespace cagetol
