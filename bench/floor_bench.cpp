// Lower bound of a step's cost by its arithmetic: the same number of operations, in registers, without dependencies.
// The header below includes this file once for each instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bench/floor_bench.cpp"
#include "sim/simd/targets.hpp"

#include <hwy/foreach_target.h>
// Highway's own includes have to come first.
#include "bench/cloths.hpp"
#include "bench/suite.hpp"
#include "sim/simd/lanes-inl.hpp"

#include <benchmark/benchmark.h>
#include <hwy/highway.h>
#include <string>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace drape::bench::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using D = drape::sim::simd::HWY_NAMESPACE::LanesOf<float>;

/// Eight sums that are independent of each other, so that no operation waits for the one before.
struct Sums {
  hn::Vec<D> a, b, c, d, e, f, g, h;

  HWY_INLINE void multiplyAdd(hn::Vec<D> factor) {
    a = hn::MulAdd(a, factor, factor);
    b = hn::MulAdd(b, factor, factor);
    c = hn::MulAdd(c, factor, factor);
    d = hn::MulAdd(d, factor, factor);
    e = hn::MulAdd(e, factor, factor);
    f = hn::MulAdd(f, factor, factor);
    g = hn::MulAdd(g, factor, factor);
    h = hn::MulAdd(h, factor, factor);
  }
};

/// Computes this number of groups of eight multiply-adds, and of roots with a division for each.
HWY_INLINE void work(Sums& sums, hn::Vec<D> factor, int eights, int roots, const float* numbers) {
  for (int i = 0; i < eights; ++i) {
    sums.multiplyAdd(factor);
  }
  for (int i = 0; i < roots; ++i) {
    const auto root = hn::Sqrt(hn::LoadU(D(), numbers + 16 * i));
    sums.a = hn::Add(sums.a, hn::Div(factor, root));
  }
}

/// As `assembleLanes` and `relaxLanes` have them: 57 operations, a root and a division a slot; 55 and a division a
/// slice, 120, two roots and two divisions with air.
float arithmetic(int slots, int slices, bool air, const float* numbers) {
  const D d;
  const auto factor = hn::Set(d, 0.5F);
  const auto one = hn::LoadU(d, numbers);
  Sums sums{one, one, one, one, one, one, one, one};
  for (int lane = 0; lane < sim::simd::sliceLanes; lane += static_cast<int>(hn::Lanes(d))) {
    for (int slot = 0; slot < slots; ++slot) {
      work(sums, factor, 7, 1, numbers);
    }
    for (int slice = 0; slice < slices; ++slice) {
      work(sums, factor, air ? 15 : 7, air ? 2 : 1, numbers);
    }
  }
  const auto left = hn::Add(hn::Add(sums.a, sums.b), hn::Add(sums.c, sums.d));
  const auto right = hn::Add(hn::Add(sums.e, sums.f), hn::Add(sums.g, sums.h));
  return hn::GetLane(hn::Add(left, right));
}

}  // namespace drape::bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace drape::bench {
namespace {

HWY_EXPORT(arithmetic);

Batch arithmeticOf(int n, bool air) {
  constexpr int steps = 50;
  const sim::simd::SliceLayout layout = sim::simd::buildSliceLayout(*grid(n));
  const auto slots = static_cast<int>(layout.slots.size());
  return {steps, [slots, slices = layout.slices(), air, numbers = std::vector<float>(64, 1.5F)] {
            return threadSeconds([&] {
              for (int i = 0; i < steps; ++i) {
                benchmark::DoNotOptimize(HWY_DYNAMIC_DISPATCH(arithmetic)(slots, slices, air, numbers.data()));
              }
            });
          }};
}

}  // namespace

void addFloorGroup(Suite& suite) {
  const auto add = [&](const std::string& name, const std::string& step, bool air) {
    suite.add({"floor", name, "us/step"}, [air] { return arithmeticOf(33, air); });
    suite.addRatio({"floor", step + " / its arithmetic", "step/" + step, "floor/" + name});
  };
  add("arithmetic of a full step, 33x33", "full step, float", true);
  add("the same without air and damping", "without air and damping, float", false);
}

}  // namespace drape::bench
#endif
