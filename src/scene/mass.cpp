#include "scene/mass.hpp"

namespace drape {

MassLumping lumpingOf(const Settings& settings) {
  return settings.material.lumping == "uniform" ? MassLumping::Uniform : MassLumping::Area;
}

double totalMassOf(const Settings& settings, double restArea) {
  return settings.material.massGivenAs == "mass" ? settings.material.mass : settings.material.density * restArea;
}

}  // namespace drape
