#pragma once

#include "sim/contact/constraints/cloth_frames.hpp"
#include "sim/contact/constraints/contact_pass.hpp"
#include "sim/contact/recovery/overlap.hpp"
#include "sim/model/cloth_state.hpp"

#include <span>
#include <vector>

namespace drape::sim::contact {

/// The cloth that is inside the near bodies at the start of a pass, and its exits: the surface points through which it
/// leaves. Vertices inside get contacts at their exits, with which they move out at the recovery speed.
class BodyOverlaps {
 public:
  void clear();

  /// Finds the cloth inside closed meshes. The first search of a pass tests one vertex of each connected piece. If one
  /// is inside, or in the second search if triangles pierce the mesh, all vertices are classified.
  /// @param first whether this is the first search of the pass
  void find(const ContactPass& pass, const ClothFrames& frames, bool first);

  /// Finds the cloth inside spheres and capsules.
  /// @param bodies indices of near bodies that the search for contacts found cloth in
  /// @return true if an overlap was found that was not known, so that the search must be repeated
  bool findInPrimitives(const ContactPass& pass, const ClothFrames& frames, std::span<const int> bodies);

  [[nodiscard]] bool any() const;
  /// The cloth inside a body; null if there is none.
  [[nodiscard]] const Overlap* in(const NearBody& body) const;

  /// Increases the displacement bounds of the vertices inside by the largest step of recovery.
  void extendBounds(const ContactPass& pass, ClothFrames& frames) const;

  /// Limits the speed of cloth at an overlap, relative to the body. Cloth that has left a body pulls at cloth that is
  /// still inside; without a limit stretched springs would accelerate it.
  /// @param predicted positions at the end of the step, changed [m]
  void limitDisplacements(const ContactPass& pass, const ClothFrames& frames, std::vector<Vec3>& predicted);
  /// Limits the velocities of the same cloth.
  void limitVelocities(double timeStep, ClothState& state) const;

 private:
  struct InBody {
    Overlap overlap;
    bool known = false;  // `overlap` is valid: some of the cloth is inside the body or pierces it
  };
  /// A vertex inside a body or next to such cloth.
  struct SlowedVertex {
    std::size_t vertex = 0;
    Vec3 displacement = Vec3::Zero();  // of the body there over the step [m]
  };

  [[nodiscard]] std::vector<bool> verticesAtOverlap(const ContactPass& pass, const NearBody& body) const;

  std::vector<InBody> inBodies_;  // per near body, and unused ones
  std::vector<SlowedVertex> slowed_;
};

}  // namespace drape::sim::contact
