#pragma once

#include "sim/forces/substep_contact.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"
#include "sim/model/seams.hpp"

#include <span>
#include <vector>

namespace drape::sim {

/// Draws the pairs of seams together. A pair at a distance d that is to close in the remaining time T may be at most
///
///     d (1 - h / T)
///
/// apart at the end of a part of h of the step: it closes at a constant speed. At the end T no longer falls, so that
/// the rest of the distance, and that of pairs which something was in the way of, decays exponentially. The speed is
/// limited.
///
/// An impulse J along the line between the two vertices keeps to that distance, and changes positions by h J / m as if
/// it had acted before the motion. So momentum and angular momentum do not change. A solver that resolves contacts gets
/// the pairs as contacts, which it resolves in its own substeps. There close pairs keep to their motion in all
/// directions, which changes the angular momentum a little.
class SeamClosing {
 public:
  /// Plans a part of a step from `state`. @param seams those that are not welded; may be empty
  void plan(std::span<const Seam> seams, double timeStep, const ClothState& state);

  /// Whether a pair is drawn together.
  [[nodiscard]] bool acts() const { return !pairs_.empty(); }

  /// The pairs as contacts of a step from the planned state.
  void appendContacts(std::vector<SubstepContact>& contacts) const;

  /// Corrects the state at the end of the part.
  void apply(const ClothModel& model, ClothState& state) const;

 private:
  struct Pair {
    SeamPair vertices;
    Vec3 direction = Vec3::UnitX();  // from b to a at the start
    double distance = 0.0;           // at the start [m]
    double maxDistance = 0.0;        // at the end [m]
  };

  bool draw(const Pair& pair, const ClothModel& model, ClothState& state) const;

  std::vector<Pair> pairs_;
  double timeStep_ = 0.0;  // [s]
};

}  // namespace drape::sim
