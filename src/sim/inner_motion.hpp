#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"

#include <vector>

namespace drape {

/// The part of a cloth's motion that can be slowed down without touching momentum: a piece that nothing holds moves
/// against its own rigid motion (drift and spin), a piece with pins against these.
class InnerMotion {
 public:
  /// @param pieces of the cloth that nothing holds (freePieces)
  InnerMotion(const ClothModel& model, const std::vector<std::vector<std::size_t>>& pieces, const ClothState& state);

  /// Its kinetic energy [J]. That of the rigid motion is the rest: the two are orthogonal.
  [[nodiscard]] double energy() const { return energy_; }

  /// Multiplies it by `factor` [-]. Linear and angular momentum of free pieces stay what they are.
  void scale(double factor, ClothState& state) const;

 private:
  std::vector<Vec3> rigid_;  // velocity of each vertex in its piece's rigid motion [m/s]
  double energy_ = 0.0;
};

}  // namespace drape
