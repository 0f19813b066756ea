#include "sim/simd/sliced_cloth_cache.hpp"

#include <bit>

namespace drape {
namespace {

class Fingerprint {
 public:
  void add(std::uint64_t value) { hash_ = (hash_ ^ value) * 0x100000001b3ULL; }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

/// Of all that the layout depends on.
std::uint64_t topologyOf(const ClothModel& model) {
  Fingerprint fingerprint;
  fingerprint.add(model.restPositions.size());
  for (const Spring& spring : model.springs) {
    fingerprint.add((static_cast<std::uint64_t>(static_cast<std::uint32_t>(spring.a)) << 32U) |
                    static_cast<std::uint32_t>(spring.b));
    fingerprint.add(std::bit_cast<std::uint64_t>(spring.restLength));
    fingerprint.add(std::bit_cast<std::uint64_t>(spring.relativeStiffness));
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
  if (cloth_ && topology == topology_) {
    cloth_->setMassesAndPins(model);
  } else {
    cloth_ = std::make_unique<SlicedCloth<T>>(model);
    topology_ = topology;
  }
  model_ = model.weak_from_this();
  return *cloth_;
}

template class SlicedClothCache<float>;
template class SlicedClothCache<double>;

}  // namespace drape
