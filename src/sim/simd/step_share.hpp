#pragma once

#include "sim/simd/slice_layout.hpp"

#include <algorithm>

namespace drape::sim::simd {

/// The slices of one thread in a step.
///
/// Within its share a thread lets every sweep lag behind the previous one by `lag` slices. At a boundary with another
/// share the first sweep cannot process the last `lag` slices until the other thread has evaluated its own, the second
/// sweep not the last 2 lag slices, and so on. These are left to later phases, one a sweep. All threads wait for each
/// other between the phases.
struct StepShare {
  int member = 0;     ///< of the team
  int begin = 0;      ///< slices
  int end = 0;        ///< slices
  int lag = 0;        ///< bandwidth of the springs [slices]
  int sweeps = 1;     ///< of the step
  bool first = true;  ///< there is no share before this one
  bool last = true;   ///< there is no share after this one

  /// The slices of a sweep that do not depend on other shares.
  [[nodiscard]] int innerBegin(int sweep) const { return first ? begin : std::min(end, begin + sweep * lag); }
  [[nodiscard]] int innerEnd(int sweep) const { return last ? end : std::max(innerBegin(sweep), end - sweep * lag); }

  [[nodiscard]] bool contains(int index) const { return index >= begin * sliceLanes && index < end * sliceLanes; }

  /// The slot that holds a slice's spring terms from their evaluation to the last sweep. Slices at the ends of the
  /// share, which wait for other threads, have their own slots. All others share a ring.
  [[nodiscard]] int ringSlot(int slice) const {
    const int front = innerBegin(sweeps);
    const int back = innerEnd(sweeps);
    if (slice < front) {
      return slice - begin;
    }
    if (slice >= back) {
      return front - begin + slice - back;
    }
    return front - begin + end - back + slice % ring();
  }
  [[nodiscard]] int ring() const { return sweeps * lag + 1; }
  [[nodiscard]] int ringSlots() const { return innerBegin(sweeps) - begin + end - innerEnd(sweeps) + ring(); }
};

/// The share of one of `members` threads.
[[nodiscard]] StepShare shareOf(const SliceLayout& layout, int sweeps, int member, int members);

/// The number of threads for this number of parts of work, if each thread should have at least `minParts` of them: for
/// a small cloth synchronisation costs more than it saves. At most `threads`, and at most the number of cores.
[[nodiscard]] int usefulThreads(int parts, int minParts, int threads);

/// The same for the slices of a cloth. A fabric has twice as many useful threads as springs, since its forces cost
/// more.
[[nodiscard]] int usefulThreads(const SliceLayout& layout, bool hasFabric, int threads);

}  // namespace drape::sim::simd
