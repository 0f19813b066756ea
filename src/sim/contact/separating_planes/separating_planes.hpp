#pragma once

#include "sim/contact/constraints/cloth_frames.hpp"
#include "sim/contact/constraints/contact_pass.hpp"
#include "sim/contact/recovery/body_overlaps.hpp"
#include "sim/contact/separating_planes/separating_plane_filter.hpp"

#include <span>
#include <vector>

namespace drape::sim::contact {

/// The separating planes of a pass: `begin`, `find` and `apply` are called in this order.
class SeparatingPlanes {
 public:
  void clear() { planes_.clear(); }

  /// Starts with the separating planes of primitive bodies (planes, spheres, capsules), which the search for contacts
  /// found.
  void begin(std::vector<SeparatingPlane> planes);

  /// Adds the separating planes of meshes for the motion from the start of the pass to the solved positions. This
  /// motion is shorter than the predicted one, so fewer triangles need planes.
  /// @return true if the cloth pierces a mesh where the search for contacts did not know of it
  bool find(const ContactPass& pass, const ClothFrames& frames, const BodyOverlaps& overlaps);

  /// Adds the planes of the triangles that `find` leaves out, because known distances show that they do not reach the
  /// mesh. Which distances are known depends on earlier steps; the complete planes depend on this pass only.
  void complete(const ContactPass& pass, const ClothFrames& frames, const BodyOverlaps& overlaps);

  /// Moves the solved positions to the permitted side of the planes (SeparatingPlaneFilter). If this moves vertices of
  /// triangles without planes, finds the planes of these triangles and starts again.
  /// @return number of infeasible vertices
  int apply(const ContactPass& pass, const ClothFrames& frames, const BodyOverlaps& overlaps,
            std::vector<Vec3>& positions);

  /// The maximum displacement of a vertex by the last `apply` [m].
  [[nodiscard]] double maxCorrection() const { return filter_.maxCorrection(); }
  /// The positions that the last `apply` was given [m].
  [[nodiscard]] const std::vector<Vec3>& unprojected() const { return solved_; }
  [[nodiscard]] std::span<const SeparatingPlane> all() const { return planes_; }

 private:
  bool requestAroundMoved(const ContactPass& pass, bool all, const std::vector<Vec3>& positions);

  std::vector<SeparatingPlane> planes_;
  std::size_t firstOfMeshes_ = 0;  // first of the planes that belong to meshes
  SeparatingPlaneFilter filter_;
  std::vector<Vec3> solved_;  // positions after the impulses [m]
  std::vector<bool> moved_;   // whether planes moved the vertex from there
};

}  // namespace drape::sim::contact
