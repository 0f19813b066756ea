#pragma once

#include "sim/forces/common_parameters.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"

#include <span>

namespace drape::sim {

/// Mechanical energy of a cloth [J].
struct Energy {
  double kinetic = 0.0;    ///< sum of m |v|^2 / 2
  double elastic = 0.0;    ///< of springs, the sum of k (L - l0)^2 / 2; or of the membrane and bending of a fabric
  double potential = 0.0;  ///< of gravity, zero at the rest positions

  [[nodiscard]] double total() const { return kinetic + elastic + potential; }
};

/// The kinetic energy [J].
[[nodiscard]] double kineticEnergy(const ClothModel& model, const ClothState& state);

[[nodiscard]] Energy energyOf(const ClothModel& model, const CommonParameters& parameters, const ClothState& state);

/// The largest strain of an edge, (L - l0) / l0 [-]; 0 if no edge is stretched.
[[nodiscard]] double maxStretch(const ClothModel& model, const ClothState& state);

/// The strain that a twentieth of the edges exceeds [-]; 0 without edges. A tight garment has 0.1.
[[nodiscard]] double strainOfTightest(const ClothModel& model, std::span<const Vec3> positions);

/// The strain of tightest edges above which a garment is too small [-].
inline constexpr double tooTight = 0.25;

/// The mean rest length of the edges [m]; 0 without edges.
[[nodiscard]] double meanEdge(const ClothModel& model);

}  // namespace drape::sim
