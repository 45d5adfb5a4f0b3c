// The outline of a bar in the radial plane, piece by piece, as a roller's axis meets it: the flat
// face between its edges, and arcs - a curved face, rounded edges, lips. In the pocket's directions
// with s = +1 at the leading bar and -1 at the trailing one, at a station of the roller:
//
//   w = D_R - A_R X - height of the arc's centre      along e_R
//   u = s (D_T - kappa X) - its offset                along s e_T, from the pocket's middle
//   d = |(w, u)|
//   flat      p = s (D_T - kappa X) + R - S_j/2
//   edge, lip p = R + radius - d      the force on the roller points from the centre to the axis
//   curved    p = R - radius + d      the force points the other way
//
// A flat or curved face answers while the roller's axis stands between the normals at its ends, a
// rounded edge beyond, so that p goes smoothly from one to the other. A lip stands before the face
// and answers by itself. Bending of the bar shifts the centres.
#pragma once

#include "src/contacts/pocket_touch.hpp"

namespace cagetol {

/// Distance of the farthest station from the roller's middle [m].
inline double farthest_station(const BearingModel& model) {
  return std::max(-model.bar_stations.front(), model.bar_stations.back());
}

/// How a piece of a bar meets a pack of rollers at one station.
struct FaceMeeting {
  Pack p;          ///< penetration [m]
  Mask here;       ///< lanes whose axis stands before this piece
  Pack m_R, m_T;   ///< arcs: direction of the force on the roller
  Pack curvature;  ///< arcs: of the way on which the normal turns, > 0 over edges [1/m]
};

/// Whether the axis of a roller of the pack stands beyond an edge of its bars' flat faces.
inline bool beyond_edges(const BearingModel& model, const RollerGroup& group,
                         const PocketFrame& f) {
  const Pack spread = farthest_station(model) * abs(f.a_R - f.A_R);
  const Pack height = f.D_R - f.A_R * f.X;
  return any(((height - spread < group.face_low) | (height + spread > group.face_high)) &
             (group.exists > 0.0));
}

/// The flat face of bars.
struct FlatFace {
  static constexpr bool kTurns = false;  ///< the normal turns as the roller moves along
  static constexpr double kMargin = 1;   ///< of a displacement along each direction
  const RollerGroup& roller;
  const PocketFrame& f;
  const LubricatedLine& line;
  Pack kappa, minimum;
  bool bounded;         ///< an axis of the pack stands beyond an edge
  double travel = 1.0;  ///< speed of the contact along the bar over that of the roller's axis

  FlatFace(const BearingModel& model, const RollerGroup& group, const PocketFrame& frame,
           bool beyond)
      : roller(group),
        f(frame),
        line(model.bar_line),
        kappa(frame.A_T + group.squareness),
        minimum(group.radius - group.half_width),
        bounded(beyond) {}
  FaceMeeting meet(const AxisPlace& at, double s) const {
    FaceMeeting meeting;
    meeting.p = s * (at.D_T - kappa * at.X) + minimum;
    meeting.here = roller.exists > 0.0;
    if (bounded) {
      const Pack height = at.D_R - f.A_R * at.X;
      meeting.here &= (height > roller.face_low) & (height < roller.face_high);
    }
    return meeting;
  }
  void bend(FaceMeeting& meeting, const AxisPlace&, double s, const ModalState& modal, int group,
            int point) const {
    meeting.p -= s * modal.along(group, point, 1, modal.q);
  }
  FaceMeeting choose(Mask first, const FaceMeeting& a, const FaceMeeting& b) const {
    return {select(first, a.p, b.p), first, Pack{}, Pack{}, Pack{}};
  }
  PocketLevers levers(const AxisPlace& at, Pack s, const FaceMeeting&) const {
    return bar_levers(f, at, kappa, s, roller.radius);
  }
};

/// One arc of the outline: the curved face, or an edge or lip.
struct ArcFace {
  static constexpr bool kTurns = true;
  static constexpr double kMargin = 2;
  const RollerGroup& roller;
  const PocketFrame& f;
  const LubricatedLine& line;
  const OutlineArc& arc;
  Pack kappa;
  double travel;

  ArcFace(const BearingModel& model, const RollerGroup& group, const PocketFrame& frame,
          const OutlineArc& outline)
      : roller(group),
        f(frame),
        line(outline.hollow ? model.bar_line : model.edge_line),
        arc(outline),
        kappa(frame.A_T + group.squareness),
        travel(outline.travel) {}

  /// False where no lane can touch, were the arc `margin` [m] nearer.
  static bool in_reach(const BearingModel& model, const RollerGroup& group,
                       const PocketFrame& frame, const OutlineArc& arc, Pack margin) {
    const double farthest = farthest_station(model);
    const Pack kappa = frame.A_T + group.squareness;
    const Pack w = frame.D_R - frame.A_R * frame.X - arc.height,
               u = abs(frame.D_T - kappa * frame.X);
    const Pack lean = farthest * (abs(frame.a_R - frame.A_R) + abs(frame.a_T - kappa));
    // Of both bars the nearer one.
    const Pack nearest = u - (arc.hollow ? -1.0 : 1.0) * arc.offset;
    if (arc.hollow) {
      const Pack far = u + abs(arc.offset);
      return any((sqrt(w * w + far * far) + lean + group.radius - arc.radius > -margin) &
                 (group.exists > 0.0));
    }
    const Pack d = sqrt(w * w + nearest * nearest);
    return any((group.radius + arc.radius - d + lean > -margin) & (group.exists > 0.0));
  }
  FaceMeeting meet(const AxisPlace& at, double s) const {
    return meet_at(at.D_R - f.A_R * at.X - arc.height, s * (at.D_T - kappa * at.X) - arc.offset, s);
  }
  void bend(FaceMeeting& meeting, const AxisPlace& at, double s, const ModalState& modal, int group,
            int point) const {
    meeting = meet_at(
        at.D_R - f.A_R * at.X - arc.height - modal.along(group, point, 0, modal.q),
        s * (at.D_T - kappa * at.X - modal.along(group, point, 1, modal.q)) - arc.offset, s);
  }
  FaceMeeting choose(Mask first, const FaceMeeting& a, const FaceMeeting& b) const {
    return {select(first, a.p, b.p), first, select(first, a.m_R, b.m_R),
            select(first, a.m_T, b.m_T), select(first, a.curvature, b.curvature)};
  }
  PocketLevers levers(const AxisPlace& at, Pack, const FaceMeeting& meeting) const {
    return arc_levers(f, at, kappa, meeting.m_R, meeting.m_T, roller.radius);
  }

 private:
  FaceMeeting meet_at(Pack w, Pack u, double s) const {
    FaceMeeting meeting;
    const double sign = arc.hollow ? -1.0 : 1.0;
    const Pack d = sqrt(max(w * w + u * u, splat(1e-18)));
    const Pack along = sign / d;
    meeting.p = roller.radius + sign * (arc.radius - d);
    meeting.m_R = along * w;
    meeting.m_T = s * (along * u);
    meeting.curvature = along;
    meeting.here = roller.exists > 0.0;
    // Before the curved face: between the normals at its ends. Beyond the face: past that normal.
    const Pack past_low = arc.low_u * w - arc.low_w * u,
               past_high = arc.high_u * w - arc.high_w * u;
    if (arc.hollow)
      meeting.here &= (u > 0.0) & (past_low > 0.0) & (past_high < 0.0);
    else if (arc.edge < 0)
      meeting.here &= past_low < 0.0;
    else if (arc.edge > 0)
      meeting.here &= past_high > 0.0;
    return meeting;
  }
};

/// Calls `touch` with each arc of the bars that a roller of the pack may touch, were it `margin`
/// [m] nearer.
template <class Touch>
void touch_arcs(const BearingModel& model, const RollerGroup& group, const PocketFrame& f,
                Pack margin, const Touch& touch) {
  const auto meet = [&](const OutlineArc& arc) {
    if (ArcFace::in_reach(model, group, f, arc, margin)) touch(ArcFace(model, group, f, arc));
  };
  if (model.curved_faces) meet(group.face);
  for (const OutlineArc& arc : group.ends) meet(arc);
}

}  // namespace cagetol
