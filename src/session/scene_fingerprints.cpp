#include "session/scene_fingerprints.hpp"

#include "settings/settings_table.hpp"
#include "sim/model/fingerprint.hpp"

#include <array>
#include <memory>
#include <string>
#include <variant>

namespace drape::session {
namespace {

using sim::Fingerprint;

template <typename Integer>
void addCount(Fingerprint& print, Integer value) {
  print.add(static_cast<std::uint64_t>(value));
}

void addText(Fingerprint& print, std::string_view text) {
  addCount(print, text.size());
  for (const char c : text) {
    addCount(print, static_cast<unsigned char>(c));
  }
}

void addPositions(Fingerprint& print, const std::vector<Vec3>& positions) {
  addCount(print, positions.size());
  for (const Vec3& position : positions) {
    print.add(position);
  }
}

void addIndices(Fingerprint& print, const std::vector<int>& indices) {
  addCount(print, indices.size());
  for (const int index : indices) {
    addCount(print, index);
  }
}

void add(Fingerprint& print, const sim::contact::PlaneShape& shape) {
  print.add(shape.halfSize);
}

void add(Fingerprint& print, const sim::contact::SphereShape& shape) {
  print.add(shape.radius);
}

void add(Fingerprint& print, const sim::contact::CapsuleShape& shape) {
  print.add(shape.radius);
  print.add(shape.halfLength);
}

void add(Fingerprint& print, const sim::contact::BoxShape& shape) {
  print.add(shape.half);
}

/// A deformation is a function, of which a hash can contain only some values: these are off the times at which motions
/// usually repeat.
void add(Fingerprint& print, const sim::contact::Deformation& deformation) {
  constexpr std::array<double, 7> times{0.0, 0.37, 1.09, 2.23, 4.57, 9.71, 19.3};  // [s]
  std::vector<Vec3> positions;
  for (const double time : times) {
    deformation.positionsAt(time, positions);
    addPositions(print, positions);
  }
}

void add(Fingerprint& print, const std::shared_ptr<const sim::contact::MeshShape>& shape) {
  addPositions(print, shape->positions);
  for (const Triangle& triangle : shape->triangles) {
    for (const int vertex : triangle) {
      addCount(print, vertex);
    }
  }
  addCount(print, shape->frames.size());
  for (const std::vector<Vec3>& frame : shape->frames) {
    addPositions(print, frame);
  }
  print.add(shape->frameTime);
  addCount(print, shape->loop);
  addCount(print, shape->loopStart);
  if (shape->deformation) {
    add(print, *shape->deformation);
  }
}

void add(Fingerprint& print, const sim::contact::BodyMotion& motion) {
  addCount(print, motion.keyframes.size());
  for (const sim::contact::Keyframe& key : motion.keyframes) {
    print.add(key.time);
    print.add(key.position);
    print.add(key.rotation);
  }
  addCount(print, motion.loop);
  print.add(motion.spin);
  if (motion.placement) {
    print.add(motion.placement->position);
    print.add(motion.placement->rotation.w());
    print.add(Vec3(motion.placement->rotation.vec()));
  }
}

std::uint64_t hashOf(const std::vector<sim::contact::Body>& bodies) {
  Fingerprint print;
  for (const sim::contact::Body& body : bodies) {
    addCount(print, body.shape.index());
    std::visit([&print](const auto& shape) { add(print, shape); }, body.shape);
    add(print, body.motion);
    print.add(body.surface.staticFriction);
    print.add(body.surface.kineticFriction);
    print.add(body.surface.thickness);
    addCount(print, body.pins.size());
    for (const sim::contact::CarriedPin& pin : body.pins) {
      addCount(print, pin.vertex);
      addCount(print, pin.anchor);
    }
  }
  return print.value();
}

std::uint64_t hashOf(const std::vector<scene::PinPath>& paths) {
  Fingerprint print;
  for (const scene::PinPath& path : paths) {
    addIndices(print, path.vertices);
    print.add(path.centre);
    add(print, path.motion);
  }
  return print.value();
}

std::uint64_t hashOfSewing(const scene::Scene& scene) {
  Fingerprint print;
  for (const sim::Seam& seam : *scene.seams) {
    addCount(print, seam.pairs.size());
    for (const sim::SeamPair& pair : seam.pairs) {
      addCount(print, pair.a);
      addCount(print, pair.b);
    }
    print.add(seam.duration);
    print.add(seam.start);
  }
  for (const scene::ClothPart& cloth : scene.cloths) {
    for (const scene::ElasticBand& band : cloth.bands) {
      addIndices(print, band.vertices);
      print.add(band.length);
      addCount(print, band.isClosed);
    }
  }
  return print.value();
}

std::uint64_t hashOfCloths(const scene::Scene& scene) {
  Fingerprint print;
  addPositions(print, scene.model->restPositions);
  for (const scene::ClothPart& cloth : scene.cloths) {
    addCount(print, cloth.firstVertex);
    for (const scene::OwnSetting& own : cloth.own) {
      addText(print, own.info->key);
      addText(print, settings::formatValue(own.value));
    }
    for (const std::array<Vec2, 3>& corners : cloth.uvs.corners) {
      for (const Vec2& corner : corners) {
        print.add(corner.x());
        print.add(corner.y());
      }
    }
  }
  return print.value();
}

}  // namespace

std::vector<PartFingerprint> fingerprintsOf(const scene::Scene& scene) {
  return {{"the bodies", hashOf(*scene.bodies)},
          {"the motion of the pins", hashOf(scene.pinPaths)},
          {"the seams or elastic bands", hashOfSewing(scene)},
          {"the cloth", hashOfCloths(scene)}};
}

}  // namespace drape::session
