#pragma once

#include "sim/adaptive/coarse_levels.hpp"
#include "sim/simd/aggregate_means.hpp"
#include "sim/simd/sliced_cloth.hpp"

#include <cstdint>
#include <vector>

namespace drape::sim::adaptive {

/// Computes the accelerations from the coarse levels of a cloth. An aggregate's position is the mass-weighted mean of
/// its members. Springs between aggregates resist stretching. All members get the aggregate's acceleration: the force
/// is distributed by mass, the transpose of the mean, so linear and angular momentum are conserved.
template <typename T>
class CoarseMotion {
 public:
  /// @param fine the layout of the cloth that the levels belong to
  CoarseMotion(const std::vector<CoarseLevel>& levels, const ClothModel& model, const simd::SlicedCloth<T>& fine);

  /// Gives the springs of each level the stiffness that the finer levels lack, up to what is stable in a substep.
  /// @param stiffness of the cloth [N/m]  @param missing stiffness that clamping removed [N/m]
  /// @param hOmegaLimit to which the cloth's springs are clamped [-]; each level is clamped to a fraction of it
  /// @param timeStep the substep h [s]
  /// @return the number of levels in use
  int setStiffness(double stiffness, double missing, double hOmegaLimit, double timeStep);

  /// Computes the accelerations of the aggregates for the cloth's present positions.
  /// @param measure whether to measure the energy too
  void accelerate(const simd::SlicedCloth<T>& fine, bool measure);

  /// The aggregate of each vertex of the cloth on the finest level, by permuted index.
  [[nodiscard]] const std::int32_t* aggregates() const { return levels_.front().aggregateAt.data(); }
  /// The accelerations of the aggregates of the finest level, coarser levels included [m/s^2].
  [[nodiscard]] const simd::LaneVectors<T>& accelerations() const { return levels_.front().cloth.start; }

  /// The energy of the springs of all levels when it was last measured [J].
  [[nodiscard]] double energy() const;

 private:
  struct Level {
    simd::SlicedCloth<T> cloth;
    std::vector<std::int32_t> aggregateAt = {};  // of each lane of the finer level
    simd::AggregateMembers<T> members = {};      // permuted indices of the finer level
    std::vector<double> rates = {};              // omega^2 / k of each aggregate [1/kg]
    std::vector<simd::SliceNumbers<T>> stiffness = {};
    std::vector<T> energy = {};
  };

  void addLevel(const CoarseLevel& source, const ClothModel& finer, const simd::SliceLayout& finerLayout);

  std::vector<Level> levels_;
  int active_ = 0;
};

}  // namespace drape::sim::adaptive
