#pragma once

#include "sim/cloth_model.hpp"

#include <memory>
#include <utility>

namespace drape {

/// Something that is worked out once for each model: a colouring, a sparsity pattern, a factorisation. It is made again
/// only when another model comes along.
template <typename T>
class ModelCache {
 public:
  /// The value for that model; `make(model)` makes it when it is not there yet.
  template <typename Make>
  T& get(const ClothModel& model, Make&& make) {
    const std::shared_ptr<const ClothModel> known = model_.lock();
    if (!value_ || known == nullptr || known.get() != &model) {
      value_ = std::make_unique<T>(std::forward<Make>(make)(model));
      model_ = model.weak_from_this();
    }
    return *value_;
  }

 private:
  std::weak_ptr<const ClothModel> model_;  // tells the model apart from a later one at the same address
  std::unique_ptr<T> value_;
};

}  // namespace drape
