// Stress at the faces and fillets of the bars, from a fine submodel (bar_strip.hpp).
//
// The sector mesh has sharp pocket corners, where its stress grows with mesh density without limit.
// Its forces and moments in a section are right all the same. For each column of the basis:
//
//   1. A whole bar of the undeviated cage with half of both side rings is solved on the fine mesh.
//      It is loaded by the column's inertia and bar forces. Its four cuts, at the middles of the
//      pockets, have the displacement of the sector mesh plus the rigid motion of each section that
//      gives the section the force and moment of the sector mesh. The bar is symmetric about its
//      middle plane: half of it is solved, once for the symmetric and once for the antisymmetric
//      part.
//   2. This gives displacements on the bar's middle plane and at the cuts, and what they differ by
//      from those of the sector mesh.
//   3. For a deviating pocket, half the bar is solved with the middle plane held at that
//      displacement, as the sector's fields are (sector_carry.hpp), and the cuts at that of the
//      deviated sector mesh plus the difference of step 2.
//
// Correction fields (cage_basis.hpp), whose loads act on the middle planes, skip steps 1 and 2.
// A bar force acts along the line of its station, spread radially over a quarter of the thickness
// to both sides, and is kept off the fillets: roller ends have chamfers.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "src/cage/mesh/bar_strip.hpp"
#include "src/cage/solve/cage_basis.hpp"

namespace cagetol {

class BarStress {
 public:
  BarStress(const CageDimensions& cage, const CageStations& stations, const Material& material,
            const SectorGrid& grid, const BarStrip& strip, const SectorFields& fields);
  ~BarStress();
  BarStress(const BarStress&) = delete;
  BarStress& operator=(const BarStress&) = delete;

  /// Prepares the half bar of a leading face for a deviation.
  void deviate(const PocketDeviation& deviation);

  /// Stress at the strip's stations on a face (-1 trailing, 1 leading) for the columns `all` of the
  /// basis, from their fields and accelerations on the sector mesh of the deviated pocket.
  /// deviate() was called with the pocket's deviation, mirrored for a trailing face. Rows 6 i +
  /// component, axes of the sector's frame.
  Eigen::MatrixXd stress(int face, const std::vector<Eigen::Index>& all,
                         const Eigen::MatrixXd& fields, const Eigen::MatrixXd& accelerations) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The deviation whose leading face is the mirror image of the trailing face.
PocketDeviation mirrored(const PocketDeviation& deviation);

}  // namespace cagetol
