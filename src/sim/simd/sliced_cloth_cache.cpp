#include "sim/simd/sliced_cloth_cache.hpp"

#include "sim/model/fingerprint.hpp"

namespace drape::sim::simd {
namespace {

/// The fingerprint of everything that the layout depends on.
std::uint64_t topologyOf(const ClothModel& model) {
  Fingerprint fingerprint;
  fingerprint.add(std::uint64_t{model.restPositions.size()});
  for (const Spring& spring : model.springs) {
    fingerprint.add((static_cast<std::uint64_t>(static_cast<std::uint32_t>(spring.a)) << 32U) |
                    static_cast<std::uint32_t>(spring.b));
    fingerprint.add(spring.restLength);
    fingerprint.add(spring.relativeStiffness);
  }
  for (const Triangle& triangle : model.triangles) {
    for (const int vertex : triangle) {
      fingerprint.add(static_cast<std::uint64_t>(vertex));
    }
  }
  return fingerprint.value();
}

}  // namespace

template <typename T>
SlicedCloth<T>& SlicedClothCache<T>::get(const ClothModel& model) {
  const std::shared_ptr<const ClothModel> known = model_.lock();
  if (cloth_ && known && known.get() == &model) {
    return *cloth_;
  }
  const std::uint64_t topology = topologyOf(model);
  if (cloth_ && topology == topology_ && fabric_ == model.fabric) {
    cloth_->setMassesAndPins(model);
  } else {
    cloth_ = std::make_unique<SlicedCloth<T>>(model);
    topology_ = topology;
    fabric_ = model.fabric;
  }
  model_ = model.weak_from_this();
  return *cloth_;
}

template class SlicedClothCache<float>;
template class SlicedClothCache<double>;

}  // namespace drape::sim::simd
