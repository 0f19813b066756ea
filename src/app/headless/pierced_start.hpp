#pragma once

#include "scene/scene.hpp"

#include <memory>

namespace drape::app {

/// Prints a warning to standard error when bodies pass through the cloth at the start of a scene. It names them and
/// says what to do. Prints nothing when contact with bodies is off.
void printPiercedStart(const std::shared_ptr<const scene::Scene>& scene);

}  // namespace drape::app
