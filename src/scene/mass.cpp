#include "scene/mass.hpp"

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

}  // namespace drape::scene
