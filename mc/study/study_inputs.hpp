// The uncertain inputs of a study: which keys of its scene are distributions, and how they depend
// on each other.
#pragma once

#include <toml++/toml.h>
#include <string>
#include <vector>

#include "mc/study/law_reader.hpp"
#include "mc/study/study.hpp"
#include "src/input/key_table.hpp"

namespace cagetol {

/// Every distribution below `scene`, in the order of scene_keys(). `nominal` is the scene as read
/// from the same table. Throws InputError for laws that describe absolute values instead of
/// deviations, and for scopes that a key does not have.
std::vector<UncertainInput> read_inputs(const toml::table& scene, const std::string& file,
                                        const Scene& nominal, MeasurementFiles& measurements);

/// Throws InputError for laws that would draw values outside the range of their key, with the
/// largest candidate.
void check_drawn_range(const Study& study, const toml::table& scene, const std::string& file);

/// Farthest deviation of the cage's bore and outside together, as a share of its thickness.
double thickness_scatter(const Study& study);

/// Throws InputError for laws on what the table of a flexible cage (src/cage/table/cage_table.hpp)
/// holds fixed, all of the cage but its pockets and diameters, and for diameters that scatter
/// farther than it covers.
void check_flexible_cage(const Study& study, const toml::table& scene, const std::string& file);

/// The [[correlation]] entries of a study. `inputs` must be read already.
std::vector<Correlation> read_correlations(const toml::table& root, const std::string& file,
                                           const std::vector<UncertainInput>& inputs);

/// "cage.pocket_width_mm:lot" as position in `inputs` and scope; position -1 where there is no such
/// input.
struct InputScope {
  long input = -1;
  bool pocket = false;
};
InputScope find_input_scope(const std::vector<UncertainInput>& inputs, const std::string& name);

/// Elements of an array of tables `name` ("limit", "tolerance.dimension") in `root`; every key of
/// an element must be among `known`, whose names start with `name`. Throws InputError.
std::vector<const toml::table*> table_entries(const toml::table& root, const std::string& name,
                                              const std::vector<KeyInfo>& known,
                                              const std::string& file);

/// The key called `name` among `known`.
const KeyInfo& info_of(const std::vector<KeyInfo>& known, const std::string& name);

}  // namespace cagetol
