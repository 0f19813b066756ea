#pragma once

#include "scene/cloth_part.hpp"
#include "settings/settings.hpp"
#include "sim/model/cloth_model.hpp"
#include "text/sentence.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace drape::scene {

/// Whether warp runs along V of the texture coordinates, by fabric.warp_from and fabric.rest_shape. Otherwise it is
/// vertical.
[[nodiscard]] bool warpsAlongUvs(const PatternUvs& uvs, const settings::Settings& settings);

/// Where warp comes from, in words: "along V of the UVs, turned by 30 degrees".
[[nodiscard]] text::Sentence warpInWords(const PatternUvs& uvs, const settings::Settings& settings);

/// Why fabric.warp_from = auto does not take the texture coordinates that a mesh has, in one sentence. Empty if it
/// does, if there are none, or if they are sound but no pattern.
[[nodiscard]] text::Sentence warpNote(const PatternUvs& uvs, const settings::Settings& settings);

/// The fabric of each cloth: "Denim", or "shirt: Jersey; jacket: Denim". @param settings of the scene
[[nodiscard]] text::Sentence fabricsInWords(std::span<const ClothPart> cloths, const settings::Settings& settings);

/// The name of a material of the model: the fabric of the first cloth that consists of it. Empty for springs.
/// @param material index into sim::fabric::TriangleMaterials::list  @param settings of the scene
[[nodiscard]] text::Sentence materialInWords(std::span<const ClothPart> cloths, const settings::Settings& settings,
                                             int material);

/// warpInWords of each cloth, in the same form.
[[nodiscard]] text::Sentence warpInWords(std::span<const ClothPart> cloths, const settings::Settings& settings);

/// warpNote of the first cloth that has one.
[[nodiscard]] text::Sentence warpNote(std::span<const ClothPart> cloths, const settings::Settings& settings);

/// The direction of warp in each triangle of the model, a unit vector in its plane, without fabric.warp_angle. Zero for
/// a degenerate triangle. Vertical, projected onto each triangle, where the texture coordinates cannot give it.
/// @param cloths of the model
[[nodiscard]] std::vector<Vec3> warpDirections(const sim::ClothModel& model, std::span<const ClothPart> cloths,
                                               const settings::Settings& settings);

/// The same model, elastic as the settings say: springs or fabrics, whose rest shape is the mesh or the pattern. Warp
/// has the direction of warpDirections, turned by fabric.warp_angle about the normal of each triangle. Throws
/// InputError when fabric.warp_from = uv and the texture coordinates cannot give the warp, InputError as patternOf
/// does, and ClothModelError as fabric::withFabric does.
/// @param cloths of the model  @param settings of the scene
[[nodiscard]] std::shared_ptr<const sim::ClothModel> withElasticity(const sim::ClothModel& model,
                                                                    std::span<const ClothPart> cloths,
                                                                    const settings::Settings& settings);

/// The same with the masses of the settings, for the area of the rest shape. Cloths of springs that stay springs do not
/// change.
[[nodiscard]] std::shared_ptr<const sim::ClothModel> withMaterial(const sim::ClothModel& model,
                                                                  std::span<const ClothPart> cloths,
                                                                  const settings::Settings& settings);

}  // namespace drape::scene
