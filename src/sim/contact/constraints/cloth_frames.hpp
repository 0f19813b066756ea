#pragma once

#include "sim/contact/constraints/cloth_in_body.hpp"
#include "sim/contact/constraints/contact_pass.hpp"

#include <span>
#include <vector>

namespace drape::sim::contact {

/// The cloth in the frames of the near bodies, in which a rigid body stands still. Also the displacement bounds of its
/// vertices: contacts and planes are searched within these distances from the start of the pass.
class ClothFrames {
 public:
  /// Transforms the start and the predicted positions of a pass into the frames. The displacement bound of a vertex is
  /// its predicted displacement, plus two contact offsets for the corrections, plus the motion of deforming meshes near
  /// it.
  void prepare(const ContactPass& pass);

  /// Transforms the solved positions into the frames, and measures the displacements from start to solved.
  /// @param positions in the world frame [m]
  void setSolved(const ContactPass& pass, const std::vector<Vec3>& positions);
  /// Reduces the displacement bounds to the displacements from start to solved, plus one contact offset for the
  /// correction by planes.
  void tightenBounds(const NearBodies& bodies);

  /// Increases the displacement bounds [m].
  void extendBounds(double by);
  void extendBounds(std::span<const int> vertices, double by);

  [[nodiscard]] std::span<const Vec3> startIn(const NearBody& body) const { return frames_[body.index].start; }
  [[nodiscard]] std::span<const double> displacementBounds() const { return displacementBounds_; }
  /// Displacements of the vertices from start to solved, the maximum over the frames [m].
  [[nodiscard]] std::span<const double> displacements() const { return displacements_; }

  /// The cloth with its predicted or its solved positions.
  /// @param overlap the part of the cloth inside the body; null if there is none
  [[nodiscard]] ClothInBody predictedIn(const NearBody& body, const ContactPass& pass, const Overlap* overlap) const;
  [[nodiscard]] ClothInBody solvedIn(const NearBody& body, const ContactPass& pass, const Overlap* overlap) const;

 private:
  struct Frame {
    std::vector<Vec3> start;      // of the pass [m]
    std::vector<Vec3> predicted;  // [m]
    std::vector<Vec3> solved;     // after the impulses [m]
  };

  void addDeformation(const ContactPass& pass, const NearBody& body);
  [[nodiscard]] ClothInBody clothIn(const NearBody& body, const ContactPass& pass, std::span<const Vec3> predicted,
                                    const Overlap* overlap) const;

  std::vector<Frame> frames_;               // per near body, and unused ones
  std::vector<double> displacementBounds_;  // of each vertex from the start of the pass [m]
  std::vector<double> displacements_;       // of each vertex from start to solved [m]
  std::vector<double> deformations_;        // maximum displacement of deforming meshes near each vertex [m]
};

}  // namespace drape::sim::contact
