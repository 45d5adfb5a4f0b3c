// The scene that a bearing has when it runs: mounted, warm and turning (operating_clearance.hpp).
#pragma once

#include "src/scene/scene.hpp"

namespace cagetol {

/// A scene with its dimensions in operation, and without what would change them again: that of an
/// OperatingScene is itself. Parts keep their mass. Whatever computes forces, clearances or jams of
/// a bearing takes this type, so that a scene as made cannot reach it: the compiler converts.
struct OperatingScene : Scene {
  OperatingScene(const Scene& as_made);  // NOLINT(google-explicit-constructor): see above
};

}  // namespace cagetol
