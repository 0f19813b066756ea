#include "sim/adaptive/coarse_motion.hpp"

#include "sim/adaptive/lane_sum.hpp"
#include "sim/adaptive/slot_stiffness.hpp"
#include "sim/stability.hpp"

#include <algorithm>
#include <cmath>

namespace drape {
template <typename T>
CoarseMotion<T>::CoarseMotion(const std::vector<CoarseLevel>& levels, const ClothModel& model,
                              const SlicedCloth<T>& fine) {
  levels_.reserve(levels.size());
  const ClothModel* below = &model;
  const SliceLayout* layout = &fine.layout;
  for (const CoarseLevel& level : levels) {
    addLevel(level, *below, *layout);
    below = level.cloth.get();
    layout = &levels_.back().cloth.layout;
  }
}

template <typename T>
void CoarseMotion<T>::addLevel(const CoarseLevel& source, const ClothModel& below, const SliceLayout& belowLayout) {
  Level& level = levels_.emplace_back(Level{.cloth = SlicedCloth<T>(*source.cloth)});
  const SliceLayout& own = level.cloth.layout;
  const auto groups = static_cast<std::size_t>(own.vertices);
  level.groupAt.assign(static_cast<std::size_t>(belowLayout.slices()) * sliceLanes, 0);
  std::vector<std::vector<int>> members(groups);
  for (std::size_t place = 0; place < belowLayout.order.size(); ++place) {
    const auto vertex = static_cast<std::size_t>(belowLayout.order[place]);
    const int group = own.place[static_cast<std::size_t>(source.groupOf[vertex])];
    level.groupAt[place] = group;
    members[static_cast<std::size_t>(group)].push_back(static_cast<int>(place));
  }
  const auto weightOf = [&](std::size_t group, int place) {
    const auto vertex = static_cast<std::size_t>(belowLayout.order[static_cast<std::size_t>(place)]);
    return below.vertexMass[vertex] / source.cloth->vertexMass[static_cast<std::size_t>(own.order[group])];
  };
  level.members.fill(members, weightOf, level.groupAt.size());
  for (std::size_t group = 0; group < groups; ++group) {
    level.rates.push_back(source.cloth->pinned[group] ? 0.0 : unitFrequencySquared(*source.cloth, group));
  }
  level.energy.assign(static_cast<std::size_t>(own.slices()) * sliceLanes, T(0));
}

template <typename T>
int CoarseMotion<T>::setStiffness(double stiffness, double missing, double carried, double timeStep) {
  constexpr double nothing = 1e-6;  // of the stiffness: not worth a level
  // All levels move the same vertices, so that the squares of what they carry add up (docs/theory/auto.md).
  constexpr double mostPart = 0.85;
  constexpr double allParts = 2.9;
  active_ = 0;
  carried *= std::min(mostPart, std::sqrt(allParts / static_cast<double>(levels_.size())));
  for (Level& level : levels_) {
    if (missing <= nothing * stiffness) {
      break;
    }
    missing -= fillSlots(
        level.cloth, level.rates,
        [&](double rate) { return std::min(missing, carried * carried / (timeStep * timeStep * rate)); },
        level.stiffness);
    ++active_;
  }
  return active_;
}

template <typename T>
void CoarseMotion<T>::accelerate(const SlicedCloth<T>& fine, bool measure) {
  const LaneVectors<T>* from = &fine.position;
  for (int l = 0; l < active_; ++l) {
    Level& level = levels_[static_cast<std::size_t>(l)];
    gatherMeans(*from, level.members, level.cloth.position);
    from = &level.cloth.position;
  }
  for (int l = active_ - 1; l >= 0; --l) {
    Level& level = levels_[static_cast<std::size_t>(l)];
    TensionStep<T> step{.stiffness = level.stiffness.data(), .energy = measure ? level.energy.data() : nullptr};
    if (l + 1 < active_) {
      const Level& above = levels_[static_cast<std::size_t>(l) + 1];
      step.groups = above.groupAt.data();
      step.pushes = &above.cloth.start;
    }
    accelerateByTension(level.cloth, step);
  }
}

template <typename T>
double CoarseMotion<T>::energy() const {
  double sum = 0.0;
  for (int l = 0; l < active_; ++l) {
    const Level& level = levels_[static_cast<std::size_t>(l)];
    sum += sumOfLanes(level.energy);
  }
  return sum;
}

template class CoarseMotion<float>;
template class CoarseMotion<double>;

}  // namespace drape
