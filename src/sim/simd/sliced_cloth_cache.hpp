#pragma once

#include "sim/simd/sliced_cloth.hpp"

#include <cstdint>
#include <memory>

namespace drape {

/// A cloth laid out for vector instructions, for the model that was asked for last. The layout is kept when a model
/// follows that differs in masses and pins alone.
template <typename T>
class SlicedClothCache {
 public:
  [[nodiscard]] SlicedCloth<T>& get(const ClothModel& model);

 private:
  std::weak_ptr<const ClothModel> model_;  // tells the model apart from a later one at the same address
  std::uint64_t topology_ = 0;
  std::unique_ptr<SlicedCloth<T>> cloth_;
};

}  // namespace drape
