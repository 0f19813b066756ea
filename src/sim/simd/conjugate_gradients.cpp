#include "sim/simd/conjugate_gradients.hpp"

#include <algorithm>

namespace drape::sim::simd {

template <typename T>
ConjugateGradients<T>::ConjugateGradients(const SliceLayout& layout)
    : terms(layout.slots.size()), preconditioner(static_cast<std::size_t>(layout.slices())) {
  diagonal.resize(layout.slices());
  for (LaneVectors<T>* vectors : {&change, &residual, &scaled, &product}) {
    vectors->resize(layout.slices(), false);
  }
  direction.resize(layout.slices(), layout.irregular());
  const auto blocks = static_cast<std::size_t>((layout.slices() + blockSlices - 1) / blockSlices);
  for (auto* sums : {&curvatures, &descents, &norms}) {
    sums->resize(blocks);
  }
}

template <typename T>
double ConjugateGradients<T>::sumOf(const std::vector<SliceNumbers<T>>& blocks) {
  double sum = 0.0;
  for (const SliceNumbers<T>& block : blocks) {
    for (const T value : block) {
      sum += static_cast<double>(value);
    }
  }
  return sum;
}

StepShare blockShareOf(const SliceLayout& layout, int member, int members) {
  const long long blocks = (layout.slices() + blockSlices - 1) / blockSlices;
  const auto boundary = [&](int m) {
    return std::min(layout.slices(), static_cast<int>(blocks * m / members) * blockSlices);
  };
  return {.member = member,
          .begin = boundary(member),
          .end = boundary(member + 1),
          .lag = layout.sliceBandwidth,
          .sweeps = 0,
          .first = member == 0,
          .last = member + 1 == members};
}

template struct ConjugateGradients<float>;
template struct ConjugateGradients<double>;

}  // namespace drape::sim::simd
