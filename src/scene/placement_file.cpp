#include "scene/placement_file.hpp"

#include "text/number_text.hpp"

namespace drape::scene {

Placement readPlacement(const TomlReader& table) {
  constexpr double manyDegrees = 1e6;
  Placement placement;
  if (const auto written = table.table("placement")) {
    written->allowOnly({"position", "rotation", "scale"});
    placement.position = written->vector("position").value_or(Vec3::Zero());
    placement.rotation = written->vector("rotation", manyDegrees).value_or(Vec3::Zero());
    placement.scale = written->number("scale", minPlacementScale, maxPlacementScale).value_or(1.0);
  }
  return placement;
}

void writePlacement(const Placement& placement, TomlText& toml) {
  if (!placement.isNone()) {
    toml.value("placement", "{ position = " + vectorText(placement.position) +
                                ", rotation = " + vectorText(placement.rotation) +
                                ", scale = " + text::exactNumber(placement.scale) + " }");
  }
}

}  // namespace drape::scene
