#include "sim/adaptive/coarse_motion.hpp"

#include "sim/adaptive/slot_stiffness.hpp"
#include "sim/stability.hpp"

#include <algorithm>
#include <numeric>

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
  level.memberBegin.push_back(0);
  for (std::size_t group = 0; group < groups; ++group) {
    const double mass = source.cloth->vertexMass[static_cast<std::size_t>(own.order[group])];
    for (const int place : members[group]) {
      const auto vertex = static_cast<std::size_t>(belowLayout.order[static_cast<std::size_t>(place)]);
      level.members.push_back(place);
      level.weights.push_back(static_cast<T>(below.vertexMass[vertex] / mass));
    }
    level.memberBegin.push_back(static_cast<int>(level.members.size()));
  }
  for (std::size_t group = 0; group < groups; ++group) {
    level.rates.push_back(source.cloth->pinned[group] ? 0.0 : unitFrequencySquared(*source.cloth, group));
  }
  level.energy.assign(static_cast<std::size_t>(own.slices()) * sliceLanes, T(0));
}

template <typename T>
int CoarseMotion<T>::setStiffness(double stiffness, double missing, double carried, double timeStep) {
  constexpr double nothing = 1e-6;  // of the stiffness: not worth a level
  active_ = 0;
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
void CoarseMotion<T>::gather(const LaneVectors<T>& from, Level& level) const {
  for (std::size_t group = 0; group + 1 < level.memberBegin.size(); ++group) {
    T x = 0;
    T y = 0;
    T z = 0;
    for (int m = level.memberBegin[group]; m < level.memberBegin[group + 1]; ++m) {
      const int place = level.members[static_cast<std::size_t>(m)];
      const T weight = level.weights[static_cast<std::size_t>(m)];
      x += weight * from.x.data()[place];
      y += weight * from.y.data()[place];
      z += weight * from.z.data()[place];
    }
    level.cloth.position.set(group, x, y, z);
  }
}

template <typename T>
void CoarseMotion<T>::accelerate(const SlicedCloth<T>& fine, bool measure) {
  const LaneVectors<T>* from = &fine.position;
  for (int l = 0; l < active_; ++l) {
    Level& level = levels_[static_cast<std::size_t>(l)];
    gather(*from, level);
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
    sum = std::accumulate(level.energy.begin(), level.energy.end(), sum);
  }
  return sum;
}

template class CoarseMotion<float>;
template class CoarseMotion<double>;

}  // namespace drape
