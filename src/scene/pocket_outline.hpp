// The outline of a bar in the radial plane (src/contacts/pocket_face.hpp), from the cage's
// dimensions: a flat or curved face between the bore and the outside of the cage, rounded edges
// where it ends, or lips that narrow the pocket there to a retention width.
//
// Heights are along e_R from the cage's axis, offsets along the tangent from the pocket's middle
// towards the bar. Lips reach along the whole bar, and are tips of the edge's radius.
#pragma once

#include "src/scene/scene.hpp"

namespace cagetol {

/// One end of the outline: 0 at the bore, 1 at the outside.
struct OutlineEnd {
  bool lip = false;
  double height = 0, offset = 0;  ///< of the centre of its rounding [m]
  /// Direction of the face's normal at this end, from the middle of its curvature towards the bar:
  /// (height, offset), (0, 1) where the face is flat.
  double normal_height = 0, normal_offset = 1;
};
struct PocketOutline {
  bool curved = false;
  double face_radius = 0;                   ///< curved faces [m]
  double face_height = 0, face_offset = 0;  ///< of the middle of their curvature [m]
  double edge_radius = 0;                   ///< of edges and lips [m]
  OutlineEnd end[2];
};

/// Of a pocket whose roller runs at `pitch_radius` [m].
PocketOutline pocket_outline(const CageGeometry& cage, double pitch_radius, long pocket);

/// Whether pockets have lips or curved faces.
bool has_shaped_pockets(const CageGeometry& cage);

/// How far a roller in the middle of its pocket moves from `pitch_radius` towards the bore (end 0)
/// or the outside (end 1) until both bars touch it [m]; infinite where it passes them, negative
/// where it does not fit.
double radial_play(const PocketOutline& outline, double pitch_radius, double roller_radius,
                   int end);

/// Opening between lips at an end that leaves a roller in the middle this play [m]; NaN where none
/// does.
double retention_width(CageGeometry cage, double pitch_radius, double roller_radius, int end,
                       double play);

/// The smaller of both plays, least of all pockets: how far rollers let the cage's centre go.
double roller_guide_clearance(const Scene& scene, double pitch_radius);

}  // namespace cagetol
