#include "scene/cloth_material.hpp"

#include "scene/mass.hpp"
#include "sim/fabric/fabric.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace drape::scene {
namespace {

/// The direction of warp in each triangle [-]; see sim::fabric::warpAlong.
std::vector<Vec3> warpOf(const sim::ClothModel& model, const settings::Settings& settings) {
  std::vector<Vec3> warp = sim::fabric::warpAlong(Vec3::UnitY(), model.restPositions, model.triangles);
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

std::shared_ptr<const sim::ClothModel> withElasticity(const sim::ClothModel& model,
                                                      const settings::Settings& settings) {
  if (settings::usesFabric(settings)) {
    return sim::fabric::withFabric(model, settings.fabric.moduli, warpOf(model, settings));
  }
  return model.fabric ? sim::withSprings(model) : model.shared_from_this();
}

std::shared_ptr<const sim::ClothModel> withMaterial(const sim::ClothModel& model, const settings::Settings& settings) {
  if (!settings::usesFabric(settings) && !model.fabric) {
    return model.shared_from_this();
  }
  const auto weighed = sim::withMass(model, totalMassOf(settings, model.restArea()), lumpingOf(settings));
  return withElasticity(*weighed, settings);
}

}  // namespace drape::scene
