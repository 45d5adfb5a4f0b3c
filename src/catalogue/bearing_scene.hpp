// A scene of a catalogue bearing, as a file: raceways, ratings and speeds from the catalogue,
// rollers derived from the ratings, clearance by its class, a cage by design rules. Every number
// in the file says where it is from; what nobody published is an [[assumption]].
#pragma once

#include <optional>
#include <string>

#include "src/catalogue/cage_design.hpp"
#include "src/catalogue/clearance_class.hpp"

namespace cagetol {

inline constexpr const char* kUsualLubricant = "iso-vg-68";

/// What is asked for beside the designation.
struct SceneRequest {
  std::string designation;
  std::optional<CageMake> make = {};  ///< none: the one that the suffix of the designation names
  std::optional<Guidance> guidance = {};  ///< none: that of cage_rule()
  ClearanceClass clearance = ClearanceClass::CN;
  std::optional<std::string> lubricant = {};  ///< none: kUsualLubricant
  std::optional<double> temperature = {};     ///< of the oil; none: found [degC]
  std::optional<double> load = {};            ///< radial; none: 0.1 C [N]
  std::optional<double> axial = {};           ///< on the inner ring, towards the left; none: 0 [N]
  std::optional<double> speed = {};  ///< of the inner ring; none: half the limiting speed [rad/s]
  CageKind model = CageKind::flexible;
};

/// A bearing with its cage and rollers, all dimensions in SI.
struct DesignedBearing {
  const CatalogueRow* row = nullptr;
  RollerDiameter roller;
  RatedSet set;
  CageSection section;
  CageLengths lengths;
};
/// Throws InputError where rollers or cage do not come out.
DesignedBearing designed_bearing(const CatalogueRow& row, CageMake make, Guidance guidance);

/// The file. It is held to the reader and check_scene(); throws InputError like these,
/// designed_bearing() and catalogue_row().
std::string bearing_scene(const SceneRequest& request);

}  // namespace cagetol
