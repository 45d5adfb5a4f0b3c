#include "src/catalogue/cage_design.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/input/input_error.hpp"
#include "src/scene/pocket_outline.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;

constexpr double kReach = 1.2;            // of faces past the axes over the guide clearance
constexpr double kMinimumBar = 0.08;      // bar at the bore over D_we
constexpr double kMinimumSideRing = 0.1;  // over D_we
constexpr double kWidestCage = 14. / 15;  // over B
constexpr double kEdge = 0.2 / 7.5;       // over D_we
constexpr double kStep = 0.01e-3;         // dimensions are multiples of this [m]

double rounded(double value) {
  return kStep * std::round(value / kStep);
}

InputError no_room(const CatalogueRow& row, const std::string& problem) {
  return InputError({}, "DESIGNATION", row.designation, problem,
                    "choose another --guidance or --cage");
}

/// Diameter on which a flat face ends that reaches past the rollers' axes, towards the outside
/// (`side` 1) or the bore (-1), by more than the guide lets the cage go. A face stands half a
/// pocket beside the axes, on a larger circle.
double end_of_face(const RollerDiameter& roller, const CageSection& cage, double side) {
  const double past = kReach * cage.guide_clearance + cage.edge_radius;
  return std::hypot(roller.pitch_diameter + 2 * side * past, cage.pocket_width);
}

/// About the rollers' axes, but no nearer to a ring than `gap`.
void place_about_axes(const RingSurfaces& rings, const RollerDiameter& roller, double thickness,
                      double gap, CageSection& cage) {
  const double middle = std::hypot(roller.pitch_diameter, cage.pocket_width);
  const double wanted = std::max(thickness, end_of_face(roller, cage, 1) - middle),
               room = std::min(rings.outer - middle, middle - rings.inner) - 2 * gap;
  cage.inner_diameter = rounded(middle - std::min(wanted, room));
  cage.outer_diameter = rounded(middle + std::min(wanted, room));
}

void place_at_outer_ring(const RollerDiameter& roller, double thickness, CageSection& cage) {
  cage.outer_diameter = rounded(cage.land_diameter - 2 * cage.guide_clearance);
  cage.inner_diameter =
      rounded(std::min(cage.outer_diameter - 2 * thickness, end_of_face(roller, cage, -1)));
}

void place_at_inner_ring(const RollerDiameter& roller, double thickness, CageSection& cage) {
  cage.inner_diameter = rounded(cage.land_diameter + 2 * cage.guide_clearance);
  cage.outer_diameter =
      rounded(std::max(cage.inner_diameter + 2 * thickness, end_of_face(roller, cage, 1)));
}

/// Lips that hold the cage as loosely as pockets are wide.
void shape_pockets(const RollerDiameter& roller, CageSection& cage) {
  const double play = (cage.pocket_width - roller.diameter) / 2;
  cage.guide_clearance = play;
  CageGeometry plain;
  plain.inner_diameter = cage.inner_diameter;
  plain.outer_diameter = cage.outer_diameter;
  plain.edge_radius = cage.edge_radius;
  for (const int end : {0, 1})
    (end == 0 ? cage.retention_inner : cage.retention_outer) =
        rounded(retention_width(plain, roller.pitch_diameter / 2, roller.diameter / 2, end, play));
}

}  // namespace

const CageRule& cage_rule(CageMake make) {
  using enum Guidance;
  // clang-format off
  //   material, guidance, thickness, clearances of pockets: width, length, side ring, guide
  //   clearance, corner
  static constexpr CageRule kSheet{"steel-sheet", outer, 0.15, 0.03, 0.04, 0.15, 0.0046, 0.067};
  static constexpr CageRule kSteel{"steel-q235", outer, 0.43, 0.02, 0.033, 0.32, 0.0046, 0.067};
  static constexpr CageRule kBrass{"brass-cuzn40pb2", outer, 0.43, 0.02, 0.033, 0.32, 0.0046, 0.067};
  static constexpr CageRule kMoulded{"pa66-gf25", outer, 0.50, 0.03, 0.04, 0.32, 0.0060, 0.1};
  static constexpr CageRule kPeek{"peek-cf30", outer, 0.43, 0.02, 0.033, 0.32, 0.0046, 0.067};
  // clang-format on
  switch (make) {
    case CageMake::steel_sheet:
      return kSheet;
    case CageMake::brass_machined:
      return kBrass;
    case CageMake::polyamide:
      return kMoulded;
    case CageMake::peek_machined:
      return kPeek;
    case CageMake::steel_machined:
      break;
  }
  return kSteel;
}

CageMake usual_make(const std::string& designation) {
  const std::string suffix = designation.substr(designation.find_last_of(' ') + 1);
  if (suffix.find('P') != std::string::npos) return CageMake::polyamide;
  if (suffix.find('J') != std::string::npos && suffix.front() == 'E') return CageMake::steel_sheet;
  if (suffix.find('M') != std::string::npos) return CageMake::brass_machined;
  return CageMake::steel_machined;
}

RingSurfaces ring_surfaces(const CatalogueRow& row, const RollerDiameter& roller) {
  return {has_inner_flanges(row.type) ? row.inner_shoulder : row.inner_raceway,
          has_outer_flanges(row.type) ? row.outer_shoulder : roller.outer_raceway};
}

CageSection cage_section(const CatalogueRow& row, const RollerDiameter& roller, CageMake make,
                         Guidance guidance) {
  if (make == CageMake::steel_sheet && guidance == Guidance::roller)
    throw no_room(row, "lips of a sheet so thin do not hold a cage: rollers wedge between them");
  const CageRule& rule = cage_rule(make);
  const RingSurfaces rings = ring_surfaces(row, roller);
  CageSection cage;
  cage.make = make;
  cage.guidance = guidance;
  const double d = roller.diameter, thickness = rule.thickness * d;
  cage.pocket_width = rounded(d * (1 + rule.pocket_width));
  cage.corner_radius = rounded(rule.corner * d);
  cage.edge_radius = rounded(kEdge * d);
  if (guidance != Guidance::roller) {
    cage.land_diameter = guidance == Guidance::outer ? rings.outer : rings.inner;
    cage.guide_clearance = rounded(rule.guide_clearance * cage.land_diameter);
  }
  cage.flanged = make == CageMake::steel_sheet && guidance != Guidance::roller;
  if (guidance == Guidance::roller || cage.flanged)
    place_about_axes(rings, roller, thickness, rule.guide_clearance * rings.outer, cage);
  else if (guidance == Guidance::outer)
    place_at_outer_ring(roller, thickness, cage);
  else
    place_at_inner_ring(roller, thickness, cage);
  if (guidance == Guidance::roller) shape_pockets(roller, cage);
  if (cage.inner_diameter <= rings.inner || cage.outer_diameter >= rings.outer)
    throw no_room(row, std::string("a ") + spelled(make) +
                           " cage with this guidance does not fit between the rings");
  return cage;
}

double bar_width(const CageSection& cage, long count) {
  const double half_pocket = std::asin(cage.pocket_width / cage.inner_diameter);
  return cage.inner_diameter * (pi / static_cast<double>(count) - half_pocket);
}

long most_rollers(const CageSection& cage, const RollerDiameter& roller) {
  long count = most_rollers(roller);
  while (count > 3 && bar_width(cage, count) < kMinimumBar * roller.diameter) --count;
  return count;
}

CageLengths cage_lengths(const CatalogueRow& row, const CageSection& cage,
                         const RatedRollers& rollers) {
  const CageRule& rule = cage_rule(cage.make);
  CageLengths lengths;
  lengths.pocket_length = rounded(rollers.length + rule.pocket_length * rollers.diameter);
  lengths.width = rounded(std::min(lengths.pocket_length + 2 * rule.side_ring * rollers.diameter,
                                   kWidestCage * row.width));
  if (lengths.width - lengths.pocket_length < 2 * kMinimumSideRing * rollers.diameter)
    throw no_room(row, "the bearing's width leaves the cage no side rings");
  return lengths;
}

}  // namespace cagetol
