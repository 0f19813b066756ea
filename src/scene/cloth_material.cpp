#include "scene/cloth_material.hpp"

#include "messages/error.hpp"
#include "scene/mass.hpp"
#include "scene/rest_pattern.hpp"
#include "sim/fabric/fabric.hpp"
#include "text/number_text.hpp"

#include <cmath>
#include <numbers>

namespace drape::scene {
namespace {

/// The direction of warp in each triangle with fabric.warp_angle.
std::vector<Vec3> turnedWarp(const sim::ClothModel& model, const PatternUvs& uvs, const settings::Settings& settings) {
  if (warpsAlongUvs(uvs, settings) && !uvs.usable()) {
    throw messages::InputError("fabric.warp_from = uv cannot be used: " + problemOf(uvs) +
                               ". Correct the UVs in the file, or use fabric.warp_from = vertical");
  }
  std::vector<Vec3> warp = warpDirections(model, uvs, settings);
  const double angle = settings.fabric.warpAngle * std::numbers::pi / 180.0;
  if (angle == 0.0) {
    return warp;
  }
  for (std::size_t t = 0; t < warp.size(); ++t) {
    const auto& [a, b, c] = model.triangles[t];
    const Vec3 origin = model.restPositions[a];
    const Vec3 normal = (model.restPositions[b] - origin).cross(model.restPositions[c] - origin).normalized();
    warp[t] = std::cos(angle) * warp[t] + std::sin(angle) * normal.cross(warp[t]);
  }
  return warp;
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

std::string warpInWords(const PatternUvs& uvs, const settings::Settings& settings) {
  const std::string from = warpsAlongUvs(uvs, settings) ? "along V of the UVs" : "vertical";
  const double angle = settings.fabric.warpAngle;
  return angle == 0.0 ? from : from + ", turned by " + text::exactNumber(angle) + " degrees";
}

std::string warpNote(const PatternUvs& uvs, const settings::Settings& settings) {
  if (!settings::usesFabric(settings) || settings.fabric.warpFrom != "auto" || !uvs.present() || uvs.usable()) {
    return {};
  }
  return "warp is vertical, because " + problemOf(uvs);
}

std::vector<Vec3> warpDirections(const sim::ClothModel& model, const PatternUvs& uvs,
                                 const settings::Settings& settings) {
  return warpsAlongUvs(uvs, settings) && uvs.usable()
             ? warpAlongV(uvs, model.restPositions, model.triangles)
             : sim::fabric::warpAlong(Vec3::UnitY(), model.restPositions, model.triangles);
}

std::shared_ptr<const sim::ClothModel> withElasticity(const sim::ClothModel& model, const settings::Settings& settings,
                                                      const PatternUvs& uvs) {
  if (settings::restsOnPattern(settings)) {
    return sim::fabric::withPatternFabric(model, settings.fabric.moduli, patternOf(uvs, settings));
  }
  if (settings::usesFabric(settings)) {
    return sim::fabric::withFabric(model, settings.fabric.moduli, turnedWarp(model, uvs, settings));
  }
  return model.fabric ? sim::withSprings(model) : model.shared_from_this();
}

std::shared_ptr<const sim::ClothModel> withMaterial(const sim::ClothModel& model, const settings::Settings& settings,
                                                    const PatternUvs& uvs) {
  if (!settings::usesFabric(settings) && !model.fabric) {
    return model.shared_from_this();
  }
  const auto sized = settings::restsOnPattern(settings) ? sim::fabric::withPattern(model, patternOf(uvs, settings))
                                                        : sim::withMeshSizes(model);
  const auto weighed = sim::withMass(*sized, totalMassOf(settings, sized->restArea()), lumpingOf(settings));
  return withElasticity(*weighed, settings, uvs);
}

}  // namespace drape::scene
