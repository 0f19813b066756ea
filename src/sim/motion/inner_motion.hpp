#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"

#include <vector>

namespace drape::sim {

/// The part of a cloth's motion that can be slowed down without a change of momentum: the motion of a free piece
/// relative to its rigid motion (translation and rotation), and all motion of a piece with pins.
class InnerMotion {
 public:
  /// @param pieces the free pieces of the cloth (freePieces)
  InnerMotion(const ClothModel& model, const std::vector<std::vector<std::size_t>>& pieces, const ClothState& state);

  /// Its kinetic energy [J]. The rest is that of the rigid motion, since the two are orthogonal.
  [[nodiscard]] double energy() const { return energy_; }

  /// Multiplies the inner motion by `factor` [-]. Linear and angular momentum of free pieces do not change.
  void scale(double factor, ClothState& state) const;

 private:
  std::vector<Vec3> rigid_;  // velocity of each vertex in its piece's rigid motion, zero in pieces with pins [m/s]
  double energy_ = 0.0;
};

}  // namespace drape::sim
