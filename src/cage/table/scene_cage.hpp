// The flexible cage of a scene: the interface of src/cage to the rest of the program. Its
// dimensions are those in operation (src/operation/operating_clearance.hpp).
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "src/cage/table/cage_model.hpp"
#include "src/operation/operating_scene.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

/// The grid point whose table a sample of the scene uses.
GridPoint table_point(const OperatingScene& nominal, const OperatingScene& sample);

/// Makes the table of a scene's cage at a point of the grid around the mean of the scene's pockets,
/// which takes some seconds. If the scene gives cage.mass_kg, the density is scaled to it.
std::shared_ptr<const CageTable> make_scene_cage_table(const OperatingScene& nominal,
                                                       const GridPoint& point = {},
                                                       const TableProgress& progress = {});

/// Key of that table among those of all scenes (cage_table_bytes.hpp).
std::string scene_cage_table_key(const OperatingScene& nominal, const GridPoint& point);

/// Restores that table from cage_table_bytes(); nullptr if the bytes are not a table.
std::shared_ptr<const CageTable> scene_cage_table_from_bytes(const OperatingScene& nominal,
                                                             const GridPoint& point,
                                                             std::string_view bytes);

/// How far bore and outside of a sample's cage may deviate together from those of the table, as a
/// share of its thickness. Elasticity stays that of the table; contacts, clearances, mass and
/// inertia follow the sample. What that leaves wrong: mc/study_file/cage_thickness.hpp.
inline constexpr double kThicknessShare = 0.01;

/// The elastic cage of one sample: the table's cage with the sample's pockets. Returns a fault if
/// the pockets leave no valid cage, if its diameters deviate by more than kThicknessShare, or if
/// the cage differs from the table's in anything else.
std::variant<std::shared_ptr<const CageModel>, CageFault> scene_cage_model(
    const OperatingScene& sample, const CageTable& table);

}  // namespace cagetol
