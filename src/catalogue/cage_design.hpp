// Dimensions of a window cage by its make and guidance: design rules, relative to roller and
// bearing. No maker publishes cage drawings; the proportions of the machined cages are those of the
// cage in inputs/scenes/nu205.toml, the others are assumptions too.
//
//   thickness t, side rings, clearances in pockets, corners and edges: shares of D_we
//   radial guide clearance: share of the diameter of the guiding surface
//
// A cage that a ring guides lies at that ring. One that rollers guide lies about their axes, and
// lips at both ends of its pockets hold it. One pressed from sheet lies there too, and its side
// rings are flanged out to the land: cage.guide_clearance_mm is given, the mass of these flanges
// left out. Faces reach past the axes by more than the guide clearance, if need be by a thicker
// cage: where they do not, rollers wedge under the bars' edges.
#pragma once

#include "src/catalogue/rated_rollers.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

enum class CageMake { steel_sheet, steel_machined, brass_machined, polyamide, peek_machined };
constexpr auto spellings(CageMake) {
  using enum CageMake;
  return std::array{Spelling{steel_sheet, "steel-sheet"},
                    Spelling{steel_machined, "steel-machined"},
                    Spelling{brass_machined, "brass-machined"}, Spelling{polyamide, "polyamide"},
                    Spelling{peek_machined, "peek-machined"}};
}

/// Proportions of a make.
struct CageRule {
  const char* material;    ///< a name of material_presets()
  Guidance guidance;       ///< where none is asked for
  double thickness;        ///< over D_we
  double pocket_width;     ///< clearance over D_we
  double pocket_length;    ///< clearance over D_we
  double side_ring;        ///< axial width over D_we
  double guide_clearance;  ///< radial, over the diameter of the guiding surface
  double corner;           ///< radius over D_we
};
const CageRule& cage_rule(CageMake make);

/// The make that a designation's suffix names: P polyamide, J steel sheet, M brass; else machined
/// steel.
CageMake usual_make(const std::string& designation);

/// Diameters of the rings' surfaces that meet a cage: flanges where a ring has them, else its
/// raceway [m].
struct RingSurfaces {
  double inner = 0, outer = 0;
};
RingSurfaces ring_surfaces(const CatalogueRow& row, const RollerDiameter& roller);

/// Cross-section of a cage, which its rollers' number and length do not change.
struct CageSection {
  CageMake make = CageMake::steel_machined;
  Guidance guidance = Guidance::outer;
  double inner_diameter = 0, outer_diameter = 0;  ///< [m]
  double land_diameter = 0;                       ///< of the guiding surface; 0: rollers guide [m]
  double guide_clearance = 0;                     ///< radial [m]
  bool flanged = false;                           ///< side rings reach out to the land
  double pocket_width = 0;                        ///< [m]
  double retention_inner = kAuto, retention_outer = kAuto;  ///< [m]
  double corner_radius = 0, edge_radius = 0;                ///< [m]
};

/// Throws InputError where no such cage fits between the rings.
CageSection cage_section(const CatalogueRow& row, const RollerDiameter& roller, CageMake make,
                         Guidance guidance);

/// Most rollers between which this cage still has bars, at its bore.
long most_rollers(const CageSection& cage, const RollerDiameter& roller);

/// Width of a bar at the cage's bore [m].
double bar_width(const CageSection& cage, long count);

struct CageLengths {
  double pocket_length = 0, width = 0;  ///< axial [m]
};
/// Throws InputError where the bearing's width leaves no side rings.
CageLengths cage_lengths(const CatalogueRow& row, const CageSection& cage,
                         const RatedRollers& rollers);

}  // namespace cagetol
