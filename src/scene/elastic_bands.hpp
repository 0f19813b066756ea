#pragma once

#include "scene/cloth_part.hpp"
#include "sim/fabric/rest_shape.hpp"

#include <memory>
#include <span>
#include <vector>

namespace drape::scene {

/// Whether a cloth has an elastic band.
[[nodiscard]] bool haveBands(std::span<const ClothPart> cloths);

/// Shortens or lengthens the triangles along elastic bands, in the direction of the band and by its factor.
/// @param rest the triangles of all cloths
void applyBands(std::span<const ClothPart> cloths, const sim::ClothModel& model,
                std::vector<sim::fabric::RestTriangle>& rest);

/// The same cloth with the rest lengths of the springs along elastic bands. Masses do not change.
[[nodiscard]] std::shared_ptr<const sim::ClothModel> withBandSprings(const sim::ClothModel& model,
                                                                     std::span<const ClothPart> cloths);

}  // namespace drape::scene
