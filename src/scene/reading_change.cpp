#include "scene/reading_change.hpp"

#include "scene/mesh_placement.hpp"
#include "scene/unit_guess.hpp"
#include "sim/contact/bodies/motion.hpp"

#include <variant>

namespace drape::scene {
namespace {

ReadingChoice readingOfCloth(const Scene& scene) {
  const MeshPlacement& placement = scene.cloths.front().placement;
  return {wordForUnit(placement.metresPerUnit), placement.up};
}

bool isOnlyClothFromFile(const SceneDescription& description) {
  const auto* file = std::get_if<MeshFileSource>(&description.cloth().source);
  return description.cloths.size() == 1 && description.cloth().own.empty() && file != nullptr && !file->builtIn;
}

/// The frame in which the cloth or the body has the coordinates of its file, scaled and turned.
sim::contact::Pose ownPose(const SceneDescription& description, const Placeable& thing) {
  if (thing.kind == Placeable::Kind::Body) {
    return {};
  }
  const ClothDescription& cloth = description.cloth();
  return sim::contact::poseOf(cloth.position, cloth.rotation);
}

}  // namespace

std::optional<ReadingChoice> changeableReading(const Scene& scene, const Placeable& thing) {
  const SceneDescription& description = scene.description;
  if (thing.kind == Placeable::Kind::Cloth) {
    return isOnlyClothFromFile(description) ? std::optional(readingOfCloth(scene)) : std::nullopt;
  }
  const BodyDescription& body = description.bodies.at(thing.index);
  if (body.readLikeCloth && !body.reading) {
    return readingOfCloth(scene);
  }
  return body.reading;
}

ReadingChange withReading(const Scene& scene, const Placeable& thing, const ReadingChoice& to, const Vec3& middle,
                          ReadingChange present) {
  const ReadingChoice from = changeableReading(scene, thing).value_or(to);
  const sim::contact::Pose own = ownPose(scene.description, thing);
  const MeshPlacement before{metresPerUnit(from.unit), from.up, own};
  const MeshPlacement after{metresPerUnit(to.unit), to.up, own};
  Placement& placement = present.placements.of(thing);
  placement = movedTo(placement, after.toScene(before.toFile(middle)), placement.applied(middle));
  if (thing.kind == Placeable::Kind::Cloth) {
    present.settings.mesh.unit = to.unit;
    present.settings.mesh.up = to.up;
  } else {
    present.placements.readings.at(thing.index) = to;
  }
  return present;
}

}  // namespace drape::scene
