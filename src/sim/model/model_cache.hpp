#pragma once

#include "sim/model/cloth_model.hpp"

#include <memory>
#include <utility>

namespace drape::sim {

/// A value that is computed once for each model: a colouring, a sparsity pattern, a factorisation. It is computed again
/// when the model changes.
template <typename T>
class ModelCache {
 public:
  /// The value for that model; `make(model)` computes it if necessary.
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
  std::weak_ptr<const ClothModel> model_;  // distinguishes the model from a later one at the same address
  std::unique_ptr<T> value_;
};

}  // namespace drape::sim
