#pragma once

#include "scene/scene.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace drape::scene {

/// The seams and the elastic bands of a scene, as its file has them.
struct Sewing {
  std::vector<SeamDescription> seams;
  std::vector<std::vector<BandDescription>> bands;  ///< of each cloth

  bool operator==(const Sewing&) const = default;
};

/// Those of the scene file.
[[nodiscard]] Sewing sewingOf(const SceneDescription& description);

/// The mesh of one cloth of a scene, without its placement. Its vertices count from the first one of the cloth.
[[nodiscard]] sim::ClothMesh meshOf(std::size_t cloth, const Scene& scene);

/// Builds another seam of a scene that was built. Throws InputError as seamsOf does, and when its duration is outside
/// its range.
/// @param pieces its model now, with the pieces apart  @param others its other seams
[[nodiscard]] sim::Seam seamOf(const SeamDescription& seam, const Scene& scene, const sim::ClothModel& pieces,
                               std::span<const sim::Seam> others);

/// The cloths of a scene with other elastic bands. Throws InputError as bandsOf does, when a length is outside its
/// range, and when their number does not fit the cloths.
[[nodiscard]] std::vector<ClothPart> withBands(const Scene& scene, std::span<const std::vector<BandDescription>> bands);

/// The same pieces with the elastic bands of these cloths, and without those that they had.
[[nodiscard]] std::shared_ptr<const sim::ClothModel> withBandsOf(std::span<const ClothPart> cloths,
                                                                 const sim::ClothModel& pieces,
                                                                 const settings::Settings& settings);

}  // namespace drape::scene
