// The flexible cage of a scene: the door through which the rest of the program asks for it.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "src/cage/cage_model.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

inline bool is_flexible(const Scene& scene) {
  return scene.cage.model == CageKind::flexible;
}

/// Of the tables of a scene's cage, the one that serves a sample of the scene.
GridPoint table_point(const Scene& nominal, const Scene& sample);

/// The table of a scene's cage at a point of the grid around the mean of the scene's pockets: made,
/// which takes some seconds. A cage.mass_kg given in the scene scales the density.
std::shared_ptr<const CageTable> make_scene_cage_table(const Scene& nominal,
                                                       const GridPoint& point = {},
                                                       const TableProgress& progress = {});

/// Identifies that table among those of all scenes (cage_table_bytes.hpp).
std::string scene_cage_table_key(const Scene& nominal, const GridPoint& point);

/// That table from what cage_table_bytes() wrote of it; nullptr where the bytes are no table.
std::shared_ptr<const CageTable> scene_cage_table_from_bytes(const Scene& nominal,
                                                             const GridPoint& point,
                                                             std::string_view bytes);

/// The elastic cage of one sample: its pockets on the table's cage. A fault where these leave no
/// cage, or where the cage differs from the table's in more than pockets.
std::variant<std::shared_ptr<const CageModel>, CageFault> scene_cage_model(const Scene& sample,
                                                                           const CageTable& table);

}  // namespace cagetol
