#pragma once

#include "scene/pattern_uvs.hpp"
#include "settings/settings.hpp"
#include "sim/fabric/pattern.hpp"
#include "sim/model/cloth_model.hpp"
#include "text/sentence.hpp"

#include <string>
#include <vector>

namespace drape::scene {

/// The size of a unit of the texture coordinates [m]: fabric.uv_scale, or where that is 0 the scale with which the
/// pattern has the area of the mesh.
[[nodiscard]] double patternScale(const PatternUvs& uvs, const settings::Settings& settings);

/// The triangles of the pattern at rest. Warp runs along V, turned by fabric.warp_angle.
/// Throws InputError if the texture coordinates cannot be a pattern, if fabric.warp_from is vertical, or if
/// fabric.uv_scale makes the pattern implausibly large or small.
[[nodiscard]] std::vector<sim::fabric::RestTriangle> patternOf(const PatternUvs& uvs,
                                                               const settings::Settings& settings);

/// The rest shape in words: "the mesh", "the mesh, with elastic bands", or the pattern with its scale and the strain of
/// the mesh against it.
[[nodiscard]] text::Sentence restShapeInWords(const sim::ClothModel& model, const PatternUvs& uvs,
                                              const settings::Settings& settings);

/// Why the pattern is unlikely to belong to the mesh, in one sentence: their areas differ by more than a factor of 4,
/// or the texture coordinates do not look like a pattern (PatternUvs::isPattern). Empty if neither is so.
[[nodiscard]] text::Sentence restShapeNote(const sim::ClothModel& model, const PatternUvs& uvs,
                                           const settings::Settings& settings);

}  // namespace drape::scene
