#pragma once

#include "scene/scene.hpp"
#include "sim/fabric/rest_shape.hpp"

#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace drape::scene {

/// The bands of a cloth. Throws InputError for a cloth without an open border, for vertices that are not on one, and
/// for two bands along the same edge. @param mesh of this cloth alone, without its placement
[[nodiscard]] std::vector<ElasticBand> bandsOf(std::span<const BandDescription> bands, const sim::ClothMesh& mesh);

/// The vertices of an edge, in ascending order.
using BandEdge = std::pair<int, int>;

/// The edges of a band. @param firstVertex of its cloth
[[nodiscard]] std::vector<BandEdge> edgesOf(const ElasticBand& band, int firstVertex);

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
