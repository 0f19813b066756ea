#include "sim/simd/sliced_cloth.hpp"

#include "sim/simd/convert.hpp"
#include "sim/simd/step_origin.hpp"

#include <algorithm>
#include <utility>

namespace drape::sim::simd {
namespace {

/// The permuted indices of a thread's share.
struct IndexRange {
  std::size_t begin;
  std::size_t end;

  IndexRange(const SliceLayout& layout, const StepShare& share)
      : begin(static_cast<std::size_t>(share.begin) * sliceLanes),
        end(std::min(layout.order.size(), static_cast<std::size_t>(share.end) * sliceLanes)) {}
};

template <typename T>
Coordinates<T> coordinatesOf(LaneVectors<T>& vectors) {
  return {vectors.x.data(), vectors.y.data(), vectors.z.data()};
}

template <typename T>
void scatter(const SliceLayout& layout, IndexRange range, const std::vector<Vec3>& from, const Vec3& origin,
             LaneVectors<T>& to) {
  const Coordinates<T> out = coordinatesOf(to);
  const double* const values = from.data()->data();
  if (layout.isModelOrder) {
    splitCoordinates(values + 3 * range.begin, range.end - range.begin, origin,
                     {out.x + range.begin, out.y + range.begin, out.z + range.begin});
  } else {
    for (std::size_t k = range.begin; k < range.end; ++k) {
      const double* const value = values + 3 * static_cast<std::size_t>(layout.order[k]);
      out.x[k] = static_cast<T>(value[0] - origin.x());
      out.y[k] = static_cast<T>(value[1] - origin.y());
      out.z[k] = static_cast<T>(value[2] - origin.z());
    }
  }
  for (std::size_t k = range.begin; !to.interleaved.empty() && k < range.end; ++k) {
    to.interleaved[4 * k] = out.x[k];
    to.interleaved[4 * k + 1] = out.y[k];
    to.interleaved[4 * k + 2] = out.z[k];
  }
}

template <typename T>
void gather(const SliceLayout& layout, IndexRange range, LaneVectors<T>& from, const Vec3& origin,
            std::vector<Vec3>& to) {
  const Coordinates<T> in = coordinatesOf(from);
  double* const values = to.data()->data();
  if (layout.isModelOrder) {
    joinCoordinates({in.x + range.begin, in.y + range.begin, in.z + range.begin}, range.end - range.begin, origin,
                    values + 3 * range.begin);
    return;
  }
  for (std::size_t k = range.begin; k < range.end; ++k) {
    double* const value = values + 3 * static_cast<std::size_t>(layout.order[k]);
    value[0] = static_cast<double>(in.x[k]) + origin.x();
    value[1] = static_cast<double>(in.y[k]) + origin.y();
    value[2] = static_cast<double>(in.z[k]) + origin.z();
  }
}

}  // namespace

template <typename T>
SlicedCloth<T>::SlicedCloth(const ClothModel& model) : layout(buildSliceLayout(model)) {
  const int slices = layout.slices();
  restLength.resize(layout.slots.size());
  for (std::size_t slot = 0; slot < restLength.size(); ++slot) {
    for (std::size_t lane = 0; lane < sliceLanes; ++lane) {
      const int spring = layout.springs[slot][lane];
      restLength[slot][lane] = spring < 0 ? T(-1) : static_cast<T>(model.springs[spring].restLength);
    }
  }
  if (!model.evenlyStiff()) {
    relativeStiffness.resize(layout.slots.size());
    for (std::size_t slot = 0; slot < restLength.size(); ++slot) {
      std::transform(
          layout.springs[slot].begin(), layout.springs[slot].end(), relativeStiffness[slot].begin(),
          [&](int spring) { return spring < 0 ? T(1) : static_cast<T>(model.springs[spring].relativeStiffness); });
    }
  }
  if (model.fabric) {
    fabric = buildSlicedFabric<T>(model, layout);
  }
  // Empty lists would keep the memory.
  layout.springs = std::vector<std::array<std::int32_t, sliceLanes>>();
  layout.cornerUses = std::vector<SliceLayout::CornerUse>();
  for (LaneArray<T>* array : {&mass, &area, &free}) {
    array->resize(slices);
  }
  for (LaneVectors<T>* vectors : {&position, &velocity, &start}) {
    vectors->resize(slices, layout.irregular());
  }
  for (int k = 0; k < slices * sliceLanes; ++k) {
    mass.data()[k] = T(1);
  }
  setMassesAndPins(model);
}

template <typename T>
void SlicedCloth<T>::setMassesAndPins(const ClothModel& model) {
  pinned.clear();
  for (std::size_t k = 0; k < layout.order.size(); ++k) {
    const auto v = static_cast<std::size_t>(layout.order[k]);
    mass.data()[k] = static_cast<T>(model.vertexMass[v]);
    area.data()[k] = static_cast<T>(model.vertexArea[v]);
    free.data()[k] = model.pinned[v] ? T(0) : T(1);
    if (model.pinned[v]) {
      pinned.push_back(static_cast<int>(k));
    }
  }
}

template <typename T>
void SlicedCloth<T>::load(const ClothState& state, const StepShare& share) {
  const IndexRange range(layout, share);
  scatter(layout, range, state.positions, origin, position);
  scatter(layout, range, state.velocities, Vec3::Zero(), velocity);
  // A step that became unstable may have left NaN in the lanes beyond the last vertex, where 0 times NaN spreads it.
  for (int index = std::max(layout.vertices, share.begin * sliceLanes); index < share.end * sliceLanes; ++index) {
    for (LaneVectors<T>* vectors : {&position, &velocity, &start}) {
      vectors->set(static_cast<std::size_t>(index), T(0), T(0), T(0));
    }
  }
  // Pinned vertices need zero velocity: a velocity from before they were pinned would move them.
  for (const int index : pinned) {
    if (share.contains(index)) {
      velocity.set(static_cast<std::size_t>(index), T(0), T(0), T(0));
    }
  }
}

template <typename T>
void SlicedCloth<T>::store(ClothState& state, const StepShare& share) {
  const IndexRange range(layout, share);
  // Pinned vertices keep their unrounded positions.
  std::vector<Vec3>& unrounded = pinnedPositions[share.member];
  unrounded.clear();
  for (const int index : pinned) {
    if (share.contains(index)) {
      unrounded.push_back(state.positions[layout.order[index]]);
    }
  }
  gather(layout, range, position, origin, state.positions);
  gather(layout, range, velocity, Vec3::Zero(), state.velocities);
  std::size_t next = 0;
  for (const int index : pinned) {
    if (share.contains(index)) {
      const auto vertex = static_cast<std::size_t>(layout.order[index]);
      state.positions[vertex] = unrounded[next++];
      state.velocities[vertex].setZero();
    }
  }
}

template <typename T>
void SlicedCloth<T>::prepare(int threads, int sweeps) {
  const auto members = static_cast<std::size_t>(threads);
  terms.resize(std::max(terms.size(), members));
  inverses.resize(std::max(inverses.size(), members));
  done.resize(std::max(done.size(), members));
  pinnedPositions.resize(std::max(pinnedPositions.size(), members));
  for (int member = 0; member < threads; ++member) {
    const StepShare share = shareOf(layout, sweeps, member, threads);
    auto& own = terms[member];
    const auto needed = static_cast<std::size_t>(share.ringSlots()) * static_cast<std::size_t>(layout.maxSlots);
    own.resize(std::max(own.size(), needed));
    auto& matrices = inverses[member];
    matrices.resize(std::max(matrices.size(), static_cast<std::size_t>(share.ringSlots())));
  }
  if (sweeps > 1 && !change[0].sized()) {
    change[0].resize(layout.slices(), layout.irregular());
    change[1].resize(layout.slices(), layout.irregular());
  }
}

template <typename T>
void SlicedCloth<T>::chooseOrigin(const ClothState& state) {
  origin = stepOrigin<T>(state.positions);
}

template <typename T>
std::size_t SlicedCloth<T>::bytes() const {
  std::size_t sum = layout.bytes() + pinned.capacity() * sizeof(int) +
                    (restLength.capacity() + relativeStiffness.capacity()) * sizeof(SliceNumbers<T>);
  for (const LaneArray<T>* array : {&mass, &area, &free}) {
    sum += array->bytes();
  }
  for (const LaneVectors<T>* vectors : {&position, &velocity, &start, &change[0], &change[1]}) {
    sum += vectors->bytes();
  }
  sum += fabric ? fabric->bytes() : 0;
  for (const auto& own : terms) {
    sum += own.capacity() * sizeof(SpringTerms<T>);
  }
  for (const auto& own : inverses) {
    sum += own.capacity() * sizeof(SliceMatrices<T>);
  }
  return sum;
}

template <typename T>
void driftSlices(SlicedCloth<T>& cloth, T time, const StepShare& share) {
  if (cloth.position.interleaved.empty()) {
    const Coordinates<T> x = coordinatesOf(cloth.position);
    const Coordinates<T> v = coordinatesOf(cloth.velocity);
    for (const auto& [coordinate, speed] : {std::pair(x.x, v.x), std::pair(x.y, v.y), std::pair(x.z, v.z)}) {
      for (int i = share.begin * sliceLanes; i < share.end * sliceLanes; ++i) {
        coordinate[i] += time * speed[i];
      }
    }
    return;
  }
  for (int i = share.begin * sliceLanes; i < share.end * sliceLanes; ++i) {
    cloth.position.set(static_cast<std::size_t>(i), cloth.position.x.data()[i] + time * cloth.velocity.x.data()[i],
                       cloth.position.y.data()[i] + time * cloth.velocity.y.data()[i],
                       cloth.position.z.data()[i] + time * cloth.velocity.z.data()[i]);
  }
}

template void driftSlices(SlicedCloth<float>& cloth, float time, const StepShare& share);
template void driftSlices(SlicedCloth<double>& cloth, double time, const StepShare& share);

template struct SlicedCloth<float>;
template struct SlicedCloth<double>;

}  // namespace drape::sim::simd
