// Cage tables take long to make and depend on the scene alone: they are kept between runs.
#pragma once

#include <filesystem>
#include <memory>

#include "src/cage/scene_cage.hpp"

namespace cagetol {

/// Where cage tables are kept: $CAGETOL_CACHE, else $XDG_CACHE_HOME/cagetol, else
/// $HOME/.cache/cagetol, else a folder of this user's where the system keeps scratch files.
std::filesystem::path cage_cache_folder();

/// The table of the scene's cage, from that folder or made now and kept there. While it is made
/// stderr says how far it is; a folder that cannot be written costs a warning. Throws InputError
/// where the undeviated cage is impossible.
std::shared_ptr<const CageTable> kept_cage_table(const Scene& scene);

}  // namespace cagetol
