#include "scene/sewing.hpp"

#include "messages/error.hpp"
#include "scene/cloth_material.hpp"
#include "scene/elastic_bands.hpp"
#include "scene/seam_builder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace drape::scene {
namespace {

void requireDuration(const SeamDescription& seam) {
  if (!(seam.duration >= minSeamDuration && seam.duration <= maxSeamDuration)) {
    throw messages::InputError(fmt::format("the duration of a seam must be from {} to {} s, not {}", minSeamDuration,
                                           maxSeamDuration, seam.duration));
  }
}

void requireLength(const BandDescription& band) {
  if (!(band.length >= minBandLength && band.length <= maxBandLength)) {
    throw messages::InputError(fmt::format("the length of an elastic band must be from {} to {}, not {}", minBandLength,
                                           maxBandLength, band.length));
  }
}

}  // namespace

sim::ClothMesh meshOf(std::size_t index, const Scene& scene) {
  const ClothPart& cloth = scene.cloths.at(index);
  sim::ClothMesh mesh;
  const auto positions = std::span(scene.restPositions).subspan(cloth.firstVertex, cloth.vertexCount);
  mesh.positions.assign(positions.begin(), positions.end());
  for (const auto& [a, b, c] : std::span(scene.model->triangles).subspan(cloth.firstTriangle, cloth.triangleCount)) {
    mesh.triangles.push_back({a - cloth.firstVertex, b - cloth.firstVertex, c - cloth.firstVertex});
  }
  return mesh;
}

Sewing sewingOf(const SceneDescription& description) {
  Sewing sewing{.seams = description.seams, .bands = {}};
  std::ranges::transform(description.cloths, std::back_inserter(sewing.bands), &ClothDescription::bands);
  return sewing;
}

sim::Seam seamOf(const SeamDescription& seam, const Scene& scene, const sim::ClothModel& pieces,
                 std::span<const sim::Seam> others) {
  requireDuration(seam);
  const sim::ClothMesh mesh{scene.restPositions, scene.model->triangles};
  return seamsOf(std::array{seam}, mesh, scene.cloths, pieces, {others.begin(), others.end()}).back();
}

std::vector<ClothPart> withBands(const Scene& scene, std::span<const std::vector<BandDescription>> bands) {
  if (bands.size() != scene.cloths.size()) {
    throw messages::InputError("each cloth needs a list of elastic bands, which may be empty");
  }
  std::vector<ClothPart> cloths = scene.cloths;
  for (std::size_t i = 0; i < cloths.size(); ++i) {
    std::ranges::for_each(bands[i], requireLength);
    cloths[i].bands = bandsOf(bands[i], meshOf(i, scene));
  }
  return cloths;
}

std::shared_ptr<const sim::ClothModel> withBandsOf(std::span<const ClothPart> cloths, const sim::ClothModel& pieces,
                                                   const settings::Settings& settings) {
  return withMaterial(*sim::withMeshSizes(pieces), cloths, settings);
}

}  // namespace drape::scene
