#pragma once

#include "scene/scene.hpp"

#include <memory>

namespace drape::report {

/// The scene with another start: each free vertex is moved along each axis by a random distance of at most 1 % of the
/// mean edge. @param start seed; 0: the scene itself
[[nodiscard]] std::shared_ptr<const scene::Scene> withJitteredStart(const std::shared_ptr<const scene::Scene>& scene,
                                                                    int start);

}  // namespace drape::report
