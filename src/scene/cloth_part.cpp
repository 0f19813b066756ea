#include "scene/cloth_part.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace drape::scene {

ClothPart wholeCloth(const sim::ClothModel& model, PatternUvs uvs) {
  ClothPart cloth;
  cloth.vertexCount = model.vertexCount();
  cloth.triangleCount = static_cast<int>(model.triangles.size());
  cloth.uvs = std::move(uvs);
  return cloth;
}

const ClothPart& clothWith(int vertex, std::span<const ClothPart> cloths) {
  std::size_t index = 0;
  while (index + 1 < cloths.size() && vertex >= cloths[index + 1].firstVertex) {
    ++index;
  }
  return cloths[index];
}

settings::Settings settingsOf(std::span<const OwnSetting> own, settings::Settings scene) {
  for (const OwnSetting& setting : own) {
    settings::assignSetting(scene, *setting.info, setting.value);
  }
  return scene;
}

bool mayDifferByCloth(const settings::SettingInfo& info) {
  constexpr std::array<std::string_view, 3> shared{"material.model", "fabric.rest_shape", "fabric.uv_scale"};
  const bool ofModel = info.effect == settings::SettingEffect::Mass || info.effect == settings::SettingEffect::Fabric ||
                       info.effect == settings::SettingEffect::Scene || info.key == "stiffness";
  return ofModel && std::find(shared.begin(), shared.end(), info.key) == shared.end();
}

}  // namespace drape::scene
