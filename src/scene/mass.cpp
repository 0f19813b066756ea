#include "scene/mass.hpp"

#include <numeric>
#include <utility>
#include <vector>

namespace drape::scene {

sim::MassLumping lumpingOf(const settings::Settings& settings) {
  return settings.material.lumping == "uniform" ? sim::MassLumping::Uniform : sim::MassLumping::Area;
}

double totalMassOf(const settings::Settings& settings, double restArea) {
  if (settings::weighsAsFabric(settings)) {
    return settings.fabric.density * restArea;
  }
  return settings.material.massGivenAs == "mass" ? settings.material.mass : settings.material.density * restArea;
}

std::shared_ptr<const sim::ClothModel> withMasses(const sim::ClothModel& model, std::span<const ClothPart> cloths,
                                                  const settings::Settings& settings) {
  std::vector<double> masses;
  masses.reserve(model.vertexArea.size());
  for (const ClothPart& cloth : cloths) {
    const settings::Settings own = settingsOf(cloth.own, settings);
    const auto areas = std::span(model.vertexArea).subspan(cloth.firstVertex, cloth.vertexCount);
    const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
    const std::vector<double> part = sim::lumpedMasses(areas, totalMassOf(own, area), lumpingOf(own));
    masses.insert(masses.end(), part.begin(), part.end());
  }
  return sim::withVertexMasses(model, std::move(masses));
}

}  // namespace drape::scene
