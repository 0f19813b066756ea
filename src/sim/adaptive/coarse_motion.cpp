#include "sim/adaptive/coarse_motion.hpp"

#include "sim/adaptive/lane_sum.hpp"
#include "sim/adaptive/slot_stiffness.hpp"
#include "sim/adaptive/tuning.hpp"
#include "sim/model/local_frequency.hpp"

#include <algorithm>
#include <cmath>

namespace drape::sim::adaptive {
template <typename T>
CoarseMotion<T>::CoarseMotion(const std::vector<CoarseLevel>& levels, const ClothModel& model,
                              const simd::SlicedCloth<T>& fine) {
  levels_.reserve(levels.size());
  const ClothModel* finer = &model;
  const simd::SliceLayout* layout = &fine.layout;
  for (const CoarseLevel& level : levels) {
    addLevel(level, *finer, *layout);
    finer = level.cloth.get();
    layout = &levels_.back().cloth.layout;
  }
}

template <typename T>
void CoarseMotion<T>::addLevel(const CoarseLevel& source, const ClothModel& finer,
                               const simd::SliceLayout& finerLayout) {
  Level& level = levels_.emplace_back(Level{.cloth = simd::SlicedCloth<T>(*source.cloth)});
  const simd::SliceLayout& own = level.cloth.layout;
  const auto aggregates = static_cast<std::size_t>(own.vertices);
  level.aggregateAt.assign(static_cast<std::size_t>(finerLayout.slices()) * simd::sliceLanes, 0);
  std::vector<std::vector<int>> members(aggregates);
  for (std::size_t index = 0; index < finerLayout.order.size(); ++index) {
    const int vertex = finerLayout.order[index];
    const int aggregate = own.indexOf[source.aggregateOf[vertex]];
    level.aggregateAt[index] = aggregate;
    members[aggregate].push_back(static_cast<int>(index));
  }
  const auto weightOf = [&](std::size_t aggregate, int index) {
    const int vertex = finerLayout.order[index];
    return finer.vertexMass[vertex] / source.cloth->vertexMass[own.order[aggregate]];
  };
  level.members.fill(members, weightOf, level.aggregateAt.size());
  for (std::size_t i = 0; i < aggregates; ++i) {
    level.rates.push_back(source.cloth->pinned[i] ? 0.0 : unitFrequencySquared(*source.cloth, i));
  }
  level.energy.assign(static_cast<std::size_t>(own.slices()) * simd::sliceLanes, T(0));
}

template <typename T>
int CoarseMotion<T>::setStiffness(double stiffness, double missing, double hOmegaLimit, double timeStep) {
  active_ = 0;
  hOmegaLimit *=
      std::min(tuning.maxLevelFraction, std::sqrt(tuning.levelFractionSquares / static_cast<double>(levels_.size())));
  for (Level& level : levels_) {
    if (missing <= tuning.negligibleStiffness * stiffness) {
      break;
    }
    missing -= fillSlots(
        level.cloth, level.rates,
        [&](double rate) { return std::min(missing, hOmegaLimit * hOmegaLimit / (timeStep * timeStep * rate)); },
        level.stiffness);
    ++active_;
  }
  return active_;
}

template <typename T>
void CoarseMotion<T>::accelerate(const simd::SlicedCloth<T>& fine, bool measure) {
  const simd::LaneVectors<T>* from = &fine.position;
  for (int l = 0; l < active_; ++l) {
    Level& level = levels_[l];
    simd::gatherMeans(*from, level.members, level.cloth.position);
    from = &level.cloth.position;
  }
  for (int l = active_ - 1; l >= 0; --l) {
    Level& level = levels_[l];
    simd::TensionStep<T> step{.stiffness = level.stiffness.data(), .energy = measure ? level.energy.data() : nullptr};
    if (l + 1 < active_) {
      const Level& coarser = levels_[l + 1];
      step.aggregates = coarser.aggregateAt.data();
      step.aggregateAccelerations = &coarser.cloth.start;
    }
    simd::accelerateByTension(level.cloth, step);
  }
}

template <typename T>
double CoarseMotion<T>::energy() const {
  double sum = 0.0;
  for (int l = 0; l < active_; ++l) {
    const Level& level = levels_[l];
    sum += sumOfLanes(level.energy);
  }
  return sum;
}

template class CoarseMotion<float>;
template class CoarseMotion<double>;

}  // namespace drape::sim::adaptive
