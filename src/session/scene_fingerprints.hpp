#pragma once

#include "scene/scene.hpp"

#include <cstdint>
#include <string_view>
#include <vector>

namespace drape::session {

/// A part of a scene on which the motion depends, and a hash of it.
struct PartFingerprint {
  std::string_view part;    ///< "the bodies"
  std::uint64_t value = 0;  ///< the same in another process of this program
};

/// The parts of a built scene, always the same ones in the same order: bodies with their motion, surfaces and pins;
/// pins that move; seams and elastic bands; the cloths with their rest shape, texture coordinates and own settings. The
/// settings of the scene have no part in it, except where they change what is built.
[[nodiscard]] std::vector<PartFingerprint> fingerprintsOf(const scene::Scene& scene);

}  // namespace drape::session
