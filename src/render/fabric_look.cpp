#include "render/fabric_look.hpp"

#include <algorithm>
#include <cmath>

namespace drape::render {
namespace {

/// How many times larger one value is than the other, as a logarithm [-].
double logRatio(double a, double b) {
  constexpr double tiny = 1e-9;  // smaller moduli and densities do not occur
  return std::abs(std::log((std::abs(a) + tiny) / (std::abs(b) + tiny)));
}

double differenceOf(const fabrics::Preset& preset, const settings::Settings::Fabric& fabric) {
  const sim::fabric::Material& a = preset.material;
  const sim::fabric::Material& b = fabric.moduli;
  return logRatio(preset.density, fabric.density) + logRatio(a.stretchWarp, b.stretchWarp) +
         logRatio(a.stretchWeft, b.stretchWeft) + logRatio(a.shear, b.shear) + logRatio(a.bendWarp, b.bendWarp) +
         logRatio(a.bendWeft, b.bendWeft) + logRatio(a.bendBias, b.bendBias);
}

const fabrics::Preset& nearestPreset(const settings::Settings::Fabric& fabric) {
  const auto presets = fabrics::presetTable();
  return *std::min_element(presets.begin(), presets.end(), [&](const auto& a, const auto& b) {
    return differenceOf(a, fabric) < differenceOf(b, fabric);
  });
}

}  // namespace

Surface surfaceOf(const settings::Settings& settings) {
  const std::string& chosen = settings.view.surface;
  if (chosen == "fabric" || (chosen == "auto" && settings::usesFabric(settings))) {
    return Surface::Fabric;
  }
  return chosen == "plain" ? Surface::Plain : Surface::Checker;
}

const fabrics::Preset& lookedLike(const settings::Settings& settings) {
  const settings::Settings::Fabric& fabric = settings.fabric;
  const settings::OwnFabric* own = settings::findOwnFabric(fabric.own, fabric.preset);
  const fabrics::Preset* preset = fabrics::findPreset(own != nullptr ? own->basedOn : fabric.preset);
  return preset != nullptr ? *preset : nearestPreset(fabric);
}

const fabrics::Look& lookOf(const settings::Settings& settings) {
  return lookedLike(settings).look;
}

}  // namespace drape::render
