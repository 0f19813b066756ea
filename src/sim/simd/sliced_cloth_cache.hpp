#pragma once

#include "sim/simd/sliced_cloth.hpp"

#include <cstdint>
#include <memory>

namespace drape::sim::simd {

/// The sliced cloth of the last model. The layout is reused for a model that differs only in masses and pins.
template <typename T>
class SlicedClothCache {
 public:
  [[nodiscard]] SlicedCloth<T>& get(const ClothModel& model);

 private:
  std::weak_ptr<const ClothModel> model_;         // distinguishes the model from a later one at the same address
  std::shared_ptr<const fabric::Fabric> fabric_;  // of that model; null for springs
  std::uint64_t topology_ = 0;
  std::unique_ptr<SlicedCloth<T>> cloth_;
};

}  // namespace drape::sim::simd
