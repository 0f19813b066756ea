#include "render/fabric_look.hpp"

#include "sim/fabric/presets.hpp"

#include <algorithm>
#include <cmath>

namespace drape::render {
namespace {

constexpr Weave plainWeave{.repeat = 2, .step = 1, .weftOnTop = 1.0F};
constexpr Weave threeOneTwill{.repeat = 4, .step = 1, .weftOnTop = 0.75F};
constexpr Weave twoTwoTwill{.repeat = 4, .step = 1, .weftOnTop = 2.0F};
constexpr Weave satin{.repeat = 5, .step = 2, .weftOnTop = 0.8F};

// clang-format off
constexpr std::array looks{
    FabricLook{.preset = "silk", .structure = Structure::Woven, .weave = satin, .columns = 8000.0F, .rows = 4500.0F,
               .warp = {0.50F, 0.05F, 0.11F}, .weft = {0.42F, 0.06F, 0.11F}, .relief = 0.25F, .roughness = 0.20F,
               .anisotropy = 1.0F, .shine = 2.6F, .sheen = 0.10F, .unevenness = 0.06F, .translucency = 0.9F},
    FabricLook{.preset = "cotton", .structure = Structure::Woven, .weave = plainWeave, .columns = 3200.0F, .rows = 2800.0F,
               .warp = {0.40F, 0.53F, 0.72F}, .weft = {0.82F, 0.87F, 0.92F}, .relief = 0.55F, .roughness = 0.70F,
               .shine = 0.6F, .sheen = 0.12F, .unevenness = 0.10F},
    FabricLook{.preset = "denim", .structure = Structure::Woven, .weave = threeOneTwill, .columns = 2500.0F, .rows = 1700.0F,
               .warp = {0.11F, 0.20F, 0.35F}, .weft = {0.76F, 0.78F, 0.78F}, .relief = 0.75F, .roughness = 0.75F,
               .shine = 0.5F, .sheen = 0.06F, .unevenness = 0.15F, .translucency = 0.3F},
    FabricLook{.preset = "canvas", .structure = Structure::Woven, .weave = plainWeave, .columns = 1100.0F, .rows = 1000.0F,
               .warp = {0.62F, 0.58F, 0.46F}, .weft = {0.66F, 0.62F, 0.50F}, .relief = 0.75F, .roughness = 0.80F,
               .shine = 0.4F, .sheen = 0.08F, .unevenness = 0.08F, .translucency = 0.4F},
    FabricLook{.preset = "wool", .structure = Structure::Woven, .weave = twoTwoTwill, .columns = 2300.0F, .rows = 2000.0F,
               .warp = {0.27F, 0.28F, 0.31F}, .weft = {0.38F, 0.38F, 0.40F}, .relief = 0.50F, .roughness = 0.85F,
               .shine = 0.3F, .sheen = 0.20F, .unevenness = 0.22F, .translucency = 0.3F},
    FabricLook{.preset = "linen", .structure = Structure::Woven, .weave = plainWeave, .columns = 1600.0F, .rows = 1500.0F,
               .warp = {0.70F, 0.67F, 0.60F}, .weft = {0.77F, 0.74F, 0.67F}, .relief = 0.65F, .roughness = 0.55F,
               .shine = 0.7F, .sheen = 0.08F, .unevenness = 0.24F},
    FabricLook{.preset = "jersey", .structure = Structure::Knit, .columns = 700.0F, .rows = 900.0F,
               .warp = {0.70F, 0.50F, 0.23F}, .weft = {0.66F, 0.48F, 0.24F}, .relief = 0.70F, .roughness = 0.80F,
               .shine = 0.4F, .sheen = 0.18F, .unevenness = 0.05F, .translucency = 0.7F},
    FabricLook{.preset = "nylon", .structure = Structure::Knit, .columns = 1400.0F, .rows = 2200.0F,
               .warp = {0.06F, 0.33F, 0.40F}, .weft = {0.07F, 0.29F, 0.35F}, .relief = 0.40F, .roughness = 0.32F,
               .shine = 2.0F, .sheen = 0.12F, .unevenness = 0.03F, .translucency = 0.4F},
    FabricLook{.preset = "polyester", .structure = Structure::Woven, .weave = plainWeave, .columns = 2400.0F, .rows = 2200.0F,
               .warp = {0.87F, 0.86F, 0.83F}, .weft = {0.85F, 0.84F, 0.82F}, .relief = 0.45F, .roughness = 0.38F,
               .shine = 1.2F, .sheen = 0.06F, .unevenness = 0.04F},
    FabricLook{.preset = "felt", .structure = Structure::Fibres, .columns = 2500.0F, .rows = 2500.0F,
               .warp = {0.22F, 0.37F, 0.28F}, .weft = {0.23F, 0.36F, 0.28F}, .relief = 0.60F, .roughness = 0.95F,
               .shine = 0.1F, .sheen = 0.40F, .unevenness = 0.30F, .translucency = 0.1F},
    FabricLook{.preset = "leather", .structure = Structure::Grain, .columns = 750.0F, .rows = 750.0F,
               .warp = {0.43F, 0.25F, 0.15F}, .weft = {0.58F, 0.44F, 0.33F}, .relief = 0.45F, .roughness = 0.36F,
               .shine = 1.3F, .sheen = 0.03F, .unevenness = 0.20F, .translucency = 0.0F},
    FabricLook{.preset = "rubber", .structure = Structure::Smooth, .columns = 1000.0F, .rows = 1000.0F,
               .warp = {0.17F, 0.17F, 0.18F}, .weft = {0.20F, 0.20F, 0.21F}, .relief = 0.0F, .roughness = 0.30F,
               .shine = 1.2F, .sheen = 0.04F, .unevenness = 0.02F, .translucency = 0.0F},
};
// clang-format on

/// How many times larger one value is than the other, as a logarithm [-].
double logRatio(double a, double b) {
  constexpr double tiny = 1e-9;  // smaller moduli and densities do not occur
  return std::abs(std::log((std::abs(a) + tiny) / (std::abs(b) + tiny)));
}

double differenceOf(const sim::fabric::MaterialPreset& preset, const settings::Settings::Fabric& fabric) {
  const sim::fabric::Material& a = preset.material;
  const sim::fabric::Material& b = fabric.moduli;
  return logRatio(preset.density, fabric.density) + logRatio(a.stretchWarp, b.stretchWarp) +
         logRatio(a.stretchWeft, b.stretchWeft) + logRatio(a.shear, b.shear) + logRatio(a.bendWarp, b.bendWarp) +
         logRatio(a.bendWeft, b.bendWeft) + logRatio(a.bendBias, b.bendBias);
}

std::string_view nearestPreset(const settings::Settings::Fabric& fabric) {
  const auto presets = sim::fabric::presetTable();
  const auto nearest = std::min_element(presets.begin(), presets.end(), [&](const auto& a, const auto& b) {
    return differenceOf(a, fabric) < differenceOf(b, fabric);
  });
  return nearest->name;
}

/// The preset whose look a fabric has. A changed preset keeps its look.
std::string_view lookedLike(const settings::Settings::Fabric& fabric) {
  const settings::OwnFabric* own = settings::findOwnFabric(fabric.own, fabric.preset);
  const std::string& name = own != nullptr ? own->basedOn : fabric.preset;
  return sim::fabric::findPreset(name) != nullptr ? std::string_view(name) : nearestPreset(fabric);
}

}  // namespace

Surface surfaceOf(const settings::Settings& settings) {
  const std::string& chosen = settings.view.surface;
  if (chosen == "fabric" || (chosen == "auto" && settings::usesFabric(settings))) {
    return Surface::Fabric;
  }
  return chosen == "plain" ? Surface::Plain : Surface::Checker;
}

std::span<const FabricLook> fabricLooks() {
  return looks;
}

const FabricLook& lookOf(const settings::Settings& settings) {
  const std::string_view preset = lookedLike(settings.fabric);
  const auto found = std::find_if(looks.begin(), looks.end(), [&](const auto& look) { return look.preset == preset; });
  return found == looks.end() ? looks.front() : *found;
}

}  // namespace drape::render
