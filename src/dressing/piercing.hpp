#pragma once

#include "dressing/wearing.hpp"
#include "scene/scene.hpp"

#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <vector>

namespace drape::dressing {

/// A body that passes through the cloth.
struct Piercing {
  std::size_t body = 0;        ///< index into the bodies of the scene
  std::size_t pairs = 0;       ///< of triangles that intersect
  std::vector<Fault> faults;   ///< the same pairs, one entry a part of the body; BodyPart::Whole unless it is a person
  Vec3 centre = Vec3::Zero();  ///< the mean of the triangles of the cloth [m]
};

/// The surface of a body of a scene at one time.
struct PlacedBody {
  std::size_t body = 0;  ///< index into the bodies of the scene
  sim::ClothMesh mesh;   ///< in the scene [m]
};

/// The surface of a body in the scene. @param vertices of a deforming mesh, in its own frame [m]; otherwise empty
[[nodiscard]] sim::ClothMesh placedBody(const sim::contact::Body& body, const sim::contact::Pose& pose,
                                        std::span<const Vec3> vertices = {});

/// All bodies with an inside where they are at the start of the scene. The ground and other planes have none.
[[nodiscard]] std::vector<PlacedBody> bodiesAtStart(const scene::Scene& scene);

/// Finds the bodies that pass through the cloth, by the exact intersection test, and names their parts.
class PiercingSearch {
 public:
  /// @param scene its start tells the parts of its bodies and the openings of its cloth; never null
  explicit PiercingSearch(std::shared_ptr<const scene::Scene> scene);
  ~PiercingSearch();
  PiercingSearch(const PiercingSearch&) = delete;
  PiercingSearch& operator=(const PiercingSearch&) = delete;

  /// @param positions of the cloth [m]  @return the body with the most pairs first; empty if none passes through
  [[nodiscard]] std::vector<Piercing> find(std::span<const Vec3> positions, std::span<const PlacedBody> bodies);

 private:
  struct Anatomy;
  [[nodiscard]] const Anatomy* anatomyOf(std::size_t body);

  std::shared_ptr<const scene::Scene> scene_;
  std::map<std::size_t, std::unique_ptr<Anatomy>> anatomies_;  // by body, once one was needed; null: it has no parts
};

}  // namespace drape::dressing
