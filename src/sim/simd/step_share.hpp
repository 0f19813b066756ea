#pragma once

#include "sim/simd/slice_layout.hpp"

#include <algorithm>

namespace drape {

/// The slices that one thread works on in a step, and which of them have to wait for other threads.
///
/// Within its share a thread lets every sweep trail the one before it by `lag` slices. At an end where another share
/// begins, the first sweep cannot do the last `lag` slices before the other thread has evaluated its own, the second
/// sweep not the last 2 lag slices, and so on: these are left for later phases, one a sweep, between which all meet.
struct StepShare {
  int member = 0;     ///< of the team
  int begin = 0;      ///< slices
  int end = 0;        ///< slices
  int lag = 0;        ///< the reach of the springs [slices]
  int sweeps = 1;     ///< of the step
  bool first = true;  ///< no share before this one
  bool last = true;   ///< none after it

  /// The slices of a sweep that need nothing of other shares.
  [[nodiscard]] int innerBegin(int sweep) const { return first ? begin : std::min(end, begin + sweep * lag); }
  [[nodiscard]] int innerEnd(int sweep) const { return last ? end : std::max(innerBegin(sweep), end - sweep * lag); }

  [[nodiscard]] bool holds(int place) const { return place >= begin * sliceLanes && place < end * sliceLanes; }

  /// Where a slice's springs are kept from their evaluation to the last sweep: at the ends of the share each slice has
  /// a place of its own, since it waits; in between a ring is enough.
  [[nodiscard]] int shelf(int slice) const {
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
  [[nodiscard]] int shelves() const { return innerBegin(sweeps) - begin + end - innerEnd(sweeps) + ring(); }
};

/// The share of one of `members` threads.
[[nodiscard]] StepShare shareOf(const SliceLayout& layout, int sweeps, int member, int members);

/// How many of `threads` are worth having for that many parts of work, when each should have `fewest` of them at least:
/// a small cloth is done before threads have found together. Never more than there are cores.
[[nodiscard]] int usefulThreads(int parts, int fewest, int threads);

/// The same for the slices of a cloth.
[[nodiscard]] int usefulThreads(const SliceLayout& layout, int threads);

}  // namespace drape
