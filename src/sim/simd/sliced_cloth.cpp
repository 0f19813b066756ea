#include "sim/simd/sliced_cloth.hpp"

#include <algorithm>

namespace drape {
namespace {

template <typename T>
void scatter(const SliceLayout& layout, const std::vector<Vec3>& from, LaneVectors<T>& to) {
  for (std::size_t k = 0; k < layout.order.size(); ++k) {
    const Vec3& value = from[static_cast<std::size_t>(layout.order[k])];
    to.set(k, static_cast<T>(value.x()), static_cast<T>(value.y()), static_cast<T>(value.z()));
  }
}

template <typename T>
Vec3 vectorAt(const LaneVectors<T>& vectors, std::size_t place) {
  return {static_cast<double>(vectors.x.data()[place]), static_cast<double>(vectors.y.data()[place]),
          static_cast<double>(vectors.z.data()[place])};
}

}  // namespace

template <typename T>
SlicedCloth<T>::SlicedCloth(const ClothModel& model) : layout(buildSliceLayout(model)) {
  const int slices = layout.slices();
  restLength.resize(layout.slots.size());
  for (std::size_t slot = 0; slot < restLength.size(); ++slot) {
    for (std::size_t lane = 0; lane < sliceLanes; ++lane) {
      const int spring = layout.springs[slot][lane];
      restLength[slot][lane] =
          spring < 0 ? T(-1) : static_cast<T>(model.springs[static_cast<std::size_t>(spring)].restLength);
    }
  }
  for (LaneArray<T>* array : {&mass, &area, &free}) {
    array->resize(slices);
  }
  for (LaneVectors<T>* vectors : {&position, &velocity, &start}) {
    vectors->resize(slices, layout.irregular());
  }
  for (LaneArray<T>& array : inverse) {
    array.resize(slices);
  }
  for (int k = 0; k < slices * sliceLanes; ++k) {
    mass.data()[k] = T(1);
  }
  setMassesAndPins(model);
}

template <typename T>
void SlicedCloth<T>::setMassesAndPins(const ClothModel& model) {
  for (std::size_t k = 0; k < layout.order.size(); ++k) {
    const auto v = static_cast<std::size_t>(layout.order[k]);
    mass.data()[k] = static_cast<T>(model.vertexMass[v]);
    area.data()[k] = static_cast<T>(model.vertexArea[v]);
    free.data()[k] = model.pinned[v] ? T(0) : T(1);
  }
}

template <typename T>
void SlicedCloth<T>::load(const ClothState& state) {
  scatter(layout, state.positions, position);
  scatter(layout, state.velocities, velocity);
  // What is pinned has no velocity, and gains none; whatever it had before it was pinned would carry it on.
  for (std::size_t k = 0; k < layout.order.size(); ++k) {
    if (free.data()[k] == T(0)) {
      velocity.set(k, T(0), T(0), T(0));
    }
  }
}

template <typename T>
void SlicedCloth<T>::store(ClothState& state) const {
  for (std::size_t k = 0; k < layout.order.size(); ++k) {
    const auto v = static_cast<std::size_t>(layout.order[k]);
    if (free.data()[k] == T(0)) {
      state.velocities[v].setZero();  // and it stays where it was, unrounded
    } else {
      state.positions[v] = vectorAt(position, k);
      state.velocities[v] = vectorAt(velocity, k);
    }
  }
}

template <typename T>
void SlicedCloth<T>::prepare(int threads, int sweeps) {
  const auto members = static_cast<std::size_t>(threads);
  terms.resize(std::max(terms.size(), members));
  done.resize(std::max(done.size(), members));
  for (int member = 0; member < threads; ++member) {
    const StepShare share = shareOf(layout, sweeps, member, threads);
    auto& own = terms[static_cast<std::size_t>(member)];
    const auto needed = static_cast<std::size_t>(share.shelves()) * static_cast<std::size_t>(layout.mostSlots);
    own.resize(std::max(own.size(), needed));
  }
  if (sweeps > 1 && !change[0].sized()) {
    change[0].resize(layout.slices(), layout.irregular());
    change[1].resize(layout.slices(), layout.irregular());
  }
}

template <typename T>
void driftSlices(SlicedCloth<T>& cloth, T time, const StepShare& share) {
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

}  // namespace drape
