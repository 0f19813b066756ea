#pragma once

#include "sim/adaptive/coarse_levels.hpp"
#include "sim/simd/group_means.hpp"
#include "sim/simd/sliced_cloth.hpp"

#include <cstdint>
#include <vector>

namespace drape {

/// The coarse levels of a cloth at work: groups stand where their members' mean is, springs between them resist
/// stretching, and what a group is accelerated by all its members are. The members' share of a group's force is their
/// share of its mass, the transpose of the mean: linear and angular momentum stay what they are.
template <typename T>
class CoarseMotion {
 public:
  /// @param fine the cloth that the levels are of, as it is laid out
  CoarseMotion(const std::vector<CoarseLevel>& levels, const ClothModel& model, const SlicedCloth<T>& fine);

  /// Gives each level's springs the stiffness that is still missing, as far as a substep carries it.
  /// @param missing of the springs below [N/m]  @param carried what h omega the springs are held to [-]: each level to
  /// a part of that
  /// @param timeStep the substep h [s]
  /// @return how many levels have any
  int setStiffness(double stiffness, double missing, double carried, double timeStep);

  /// Works out the groups' accelerations for the cloth as it stands.
  void accelerate(const SlicedCloth<T>& fine, bool measure);

  /// Of the finest level: one group a place of the cloth, and the groups' accelerations.
  [[nodiscard]] const std::int32_t* groups() const { return levels_.front().groupAt.data(); }
  [[nodiscard]] const LaneVectors<T>& pushes() const { return levels_.front().cloth.start; }

  /// Of all levels' springs, when it was measured last [J].
  [[nodiscard]] double energy() const;

 private:
  struct Level {
    SlicedCloth<T> cloth;
    std::vector<std::int32_t> groupAt = {};  // one a place of the level below, and as many more as fill its last slice
    GroupMembers<T> members = {};            // places of the level below
    std::vector<double> rates = {};          // omega^2 / k of each group [1/kg]
    std::vector<SliceNumbers<T>> stiffness = {};
    std::vector<T> energy = {};
  };

  void addLevel(const CoarseLevel& source, const ClothModel& below, const SliceLayout& belowLayout);

  std::vector<Level> levels_;
  int active_ = 0;
};

}  // namespace drape
