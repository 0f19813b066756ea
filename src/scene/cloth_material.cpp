#include "scene/cloth_material.hpp"

#include "messages/error.hpp"
#include "scene/elastic_bands.hpp"
#include "scene/mass.hpp"
#include "scene/rest_pattern.hpp"
#include "sim/fabric/fabric.hpp"
#include "text/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace drape::scene {
namespace {

/// Turns the directions of warp by fabric.warp_angle, each in the plane of its triangle.
void turnWarp(std::span<const Vec3> rest, std::span<const Triangle> triangles, double degrees, std::span<Vec3> warp) {
  const double angle = degrees * std::numbers::pi / 180.0;
  if (angle == 0.0) {
    return;
  }
  for (std::size_t t = 0; t < warp.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const Vec3& origin = rest[a];
    const Vec3 normal = (rest[b] - origin).cross(rest[c] - origin).normalized();
    warp[t] = std::cos(angle) * warp[t] + std::sin(angle) * normal.cross(warp[t]);
  }
}

std::span<const Triangle> trianglesOf(const ClothPart& cloth, const sim::ClothModel& model) {
  return std::span(model.triangles).subspan(cloth.firstTriangle, cloth.triangleCount);
}

std::vector<Vec3> warpOf(const ClothPart& cloth, const sim::ClothModel& model, const settings::Settings& settings) {
  const std::span<const Triangle> triangles = trianglesOf(cloth, model);
  return warpsAlongUvs(cloth.uvs, settings) && cloth.uvs.usable()
             ? warpAlongV(cloth.uvs, model.restPositions, triangles)
             : sim::fabric::warpAlong(Vec3::UnitY(), model.restPositions, triangles);
}

void requireWarp(const PatternUvs& uvs, const settings::Settings& settings) {
  if (warpsAlongUvs(uvs, settings) && !uvs.usable()) {
    throw messages::InputError(refusalOf(uvs, "fabric.warp_from", "vertical"));
  }
}

/// The direction of warp in each triangle with fabric.warp_angle.
std::vector<Vec3> turnedWarp(const sim::ClothModel& model, std::span<const ClothPart> cloths,
                             const settings::Settings& settings) {
  std::vector<Vec3> all;
  all.reserve(model.triangles.size());
  for (const ClothPart& cloth : cloths) {
    const settings::Settings own = settingsOf(cloth.own, settings);
    requireWarp(cloth.uvs, own);
    std::vector<Vec3> warp = warpOf(cloth, model, own);
    turnWarp(model.restPositions, trianglesOf(cloth, model), own.fabric.warpAngle, warp);
    all.insert(all.end(), warp.begin(), warp.end());
  }
  return all;
}

/// The triangles of the patterns of all cloths.
std::vector<sim::fabric::RestTriangle> patternsOf(std::span<const ClothPart> cloths,
                                                  const settings::Settings& settings) {
  std::vector<sim::fabric::RestTriangle> all;
  for (const ClothPart& cloth : cloths) {
    const auto pattern = patternOf(cloth.uvs, settingsOf(cloth.own, settings));
    all.insert(all.end(), pattern.begin(), pattern.end());
  }
  return all;
}

struct ClothMaterials {
  std::vector<sim::fabric::Material> list;
  std::vector<int> indices;  // of each cloth, into `list`
};

/// The materials of the cloths. Cloths with equal moduli share one.
ClothMaterials materialsOfCloths(std::span<const ClothPart> cloths, const settings::Settings& settings) {
  ClothMaterials materials;
  for (const ClothPart& cloth : cloths) {
    const sim::fabric::Material moduli = settingsOf(cloth.own, settings).fabric.moduli;
    const auto found = std::ranges::find(materials.list, moduli);
    materials.indices.push_back(static_cast<int>(found - materials.list.begin()));
    if (found == materials.list.end()) {
      materials.list.push_back(moduli);
    }
  }
  return materials;
}

/// The material of each triangle.
sim::fabric::TriangleMaterials materialsOf(const sim::ClothModel& model, std::span<const ClothPart> cloths,
                                           const settings::Settings& settings) {
  ClothMaterials materials = materialsOfCloths(cloths, settings);
  std::vector<int> indices(model.triangles.size(), 0);
  for (std::size_t i = 0; i < cloths.size(); ++i) {
    std::fill_n(indices.begin() + cloths[i].firstTriangle, cloths[i].triangleCount, materials.indices[i]);
  }
  return materials.list.size() == 1 ? sim::fabric::TriangleMaterials(materials.list.front())
                                    : sim::fabric::TriangleMaterials(std::move(materials.list), std::move(indices));
}

/// The text for each cloth, after its name if there are several.
template <typename TextOf>
text::Sentence ofEachCloth(std::span<const ClothPart> cloths, const TextOf& textOf) {
  text::Sentence all;
  for (const ClothPart& cloth : cloths) {
    all.append("; ", text::Sentence::verbatim(cloth.name).append(": ", textOf(cloth)));
  }
  return all;
}

}  // namespace

// auto takes texture coordinates only if they are a cut pattern. Those of the T-shirt, the skirt and the poncho are
// their patterns, so their warp runs as a tailor lays it. Those of the cape wrap a checker around it: they stretch it
// up to fivefold across, and their V runs down every part of the back. Cloth cannot be cut so, and the vertical is as
// good a guess there as for a mesh without texture coordinates.
bool warpsAlongUvs(const PatternUvs& uvs, const settings::Settings& settings) {
  const bool isPattern = settings::restsOnPattern(settings) || uvs.isPattern();
  return settings.fabric.warpFrom == "uv" || (settings.fabric.warpFrom == "auto" && isPattern);
}

text::Sentence warpInWords(const PatternUvs& uvs, const settings::Settings& settings) {
  text::Sentence words(warpsAlongUvs(uvs, settings) ? "along V of the UVs" : "vertical");
  const double angle = settings.fabric.warpAngle;
  return angle == 0.0 ? words : words.append(", ", text::Sentence("turned by {} degrees", text::exactNumber(angle)));
}

text::Sentence warpNote(const PatternUvs& uvs, const settings::Settings& settings) {
  if (!settings::usesFabric(settings) || settings.fabric.warpFrom != "auto" || !uvs.present() || uvs.usable()) {
    return {};
  }
  return text::Sentence("warp is vertical, because {}", problemOf(uvs));
}

text::Sentence fabricsInWords(std::span<const ClothPart> cloths, const settings::Settings& settings) {
  return ofEachCloth(cloths,
                     [&](const ClothPart& cloth) { return settings::fabricTitle(settingsOf(cloth.own, settings)); });
}

text::Sentence materialInWords(std::span<const ClothPart> cloths, const settings::Settings& settings, int material) {
  if (!settings::usesFabric(settings)) {
    return {};
  }
  const std::vector<int> materials = materialsOfCloths(cloths, settings).indices;
  const auto found = std::ranges::find(materials, material);
  // A snapshot can be older than a change of the fabrics. Then its material may not exist any more.
  const ClothPart& cloth = found == materials.end() ? cloths.front() : cloths[found - materials.begin()];
  return settings::fabricTitle(settingsOf(cloth.own, settings));
}

text::Sentence warpInWords(std::span<const ClothPart> cloths, const settings::Settings& settings) {
  return ofEachCloth(cloths,
                     [&](const ClothPart& cloth) { return warpInWords(cloth.uvs, settingsOf(cloth.own, settings)); });
}

text::Sentence warpNote(std::span<const ClothPart> cloths, const settings::Settings& settings) {
  for (const ClothPart& cloth : cloths) {
    if (const text::Sentence note = warpNote(cloth.uvs, settingsOf(cloth.own, settings)); !note.empty()) {
      return text::Sentence::verbatim(cloth.name).append(": ", note);
    }
  }
  return {};
}

std::vector<Vec3> warpDirections(const sim::ClothModel& model, std::span<const ClothPart> cloths,
                                 const settings::Settings& settings) {
  std::vector<Vec3> all;
  all.reserve(model.triangles.size());
  for (const ClothPart& cloth : cloths) {
    const std::vector<Vec3> warp = warpOf(cloth, model, settingsOf(cloth.own, settings));
    all.insert(all.end(), warp.begin(), warp.end());
  }
  return all;
}

std::shared_ptr<const sim::ClothModel> withElasticity(const sim::ClothModel& model, std::span<const ClothPart> cloths,
                                                      const settings::Settings& settings) {
  const bool onPattern = settings::restsOnPattern(settings);
  const auto curvature =
      settings.fabric.restCurvature == "mesh" ? sim::fabric::RestCurvature::Mesh : sim::fabric::RestCurvature::Flat;
  if (onPattern || (settings::usesFabric(settings) && haveBands(cloths))) {
    std::vector<sim::fabric::RestTriangle> rest =
        onPattern
            ? patternsOf(cloths, settings)
            : sim::fabric::restTrianglesOf(model.restPositions, model.triangles, turnedWarp(model, cloths, settings));
    applyBands(cloths, model, rest);
    return sim::fabric::withPatternFabric(model, materialsOf(model, cloths, settings), std::move(rest), curvature);
  }
  if (settings::usesFabric(settings)) {
    return sim::fabric::withFabric(model, materialsOf(model, cloths, settings), turnedWarp(model, cloths, settings),
                                   curvature);
  }
  return withBandSprings(model.fabric ? *sim::withSprings(model) : model, cloths);
}

std::shared_ptr<const sim::ClothModel> withMaterial(const sim::ClothModel& model, std::span<const ClothPart> cloths,
                                                    const settings::Settings& settings) {
  if (!settings::usesFabric(settings) && !model.fabric) {
    return withBandSprings(model, cloths);
  }
  const auto sized = settings::restsOnPattern(settings) ? sim::fabric::withPattern(model, patternsOf(cloths, settings))
                                                        : sim::withMeshSizes(model);
  return withElasticity(*withMasses(*sized, cloths, settings), cloths, settings);
}

}  // namespace drape::scene
