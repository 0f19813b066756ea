#include "sim/simd/step_share.hpp"

#include <algorithm>
#include <thread>

namespace drape::sim::simd {
namespace {

/// Minimum number of slices for a thread: about 5 microseconds of work in the cheapest step of springs.
constexpr int minSlicesPerThread = 96;
constexpr int minFabricSlicesPerThread = 48;  // the forces of a fabric cost more

}  // namespace

StepShare shareOf(const SliceLayout& layout, int sweeps, int member, int members) {
  const auto boundary = [&](int m) { return static_cast<int>(static_cast<long long>(layout.slices()) * m / members); };
  return {.member = member,
          .begin = boundary(member),
          .end = boundary(member + 1),
          .lag = layout.sliceBandwidth,
          .sweeps = sweeps,
          .first = member == 0,
          .last = member + 1 == members};
}

int usefulThreads(int parts, int minParts, int threads) {
  // Static, since the system call takes as long as a step of a small cloth.
  static const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  return std::clamp(parts / minParts, 1, std::min(threads, cores));
}

int usefulThreads(const SliceLayout& layout, bool hasFabric, int threads) {
  return usefulThreads(layout.slices(), hasFabric ? minFabricSlicesPerThread : minSlicesPerThread, threads);
}

}  // namespace drape::sim::simd
