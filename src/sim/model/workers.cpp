#include "sim/model/workers.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>
#include <algorithm>

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace drape::sim {
namespace {

/// Shorter loops cost less than waking another thread.
constexpr int minParallelLoop = 2048;
constexpr int minParallelUnevenLoop = 64;
constexpr int rangesPerThread = 8;  // of uneven loops

/// Tells ThreadSanitizer about the synchronisation of TBB, which is not built with it: the parts of a loop happen after
/// the code before the loop and before the code after it. There is no order among the parts.
class Order {
 public:
#ifdef __SANITIZE_THREAD__
  Order() {
    __tsan_release(&begin_);
  }
  void pieceBegins() {
    __tsan_acquire(&begin_);
  }
  void pieceEnds() {
    __tsan_release(&end_);
  }
  void loopEnds() {
    __tsan_acquire(&end_);
  }

 private:
  char begin_ = 0;
  char end_ = 0;
#else
  void pieceBegins() {}
  void pieceEnds() {}
  void loopEnds() {}
#endif
};

/// @param size of a part; the parts of the simple partitioner are at most this long
template <typename Partitioner>
void forParts(oneapi::tbb::task_arena& arena, int count, int size, const Partitioner& partitioner,
              const std::function<void(int begin, int end)>& body) {
  Order order;
  arena.execute([&] {
    oneapi::tbb::parallel_for(
        oneapi::tbb::blocked_range<int>(0, count, size),
        [&](const oneapi::tbb::blocked_range<int>& range) {
          order.pieceBegins();
          body(range.begin(), range.end());
          order.pieceEnds();
        },
        partitioner);
  });
  order.loopEnds();
}

}  // namespace

struct Workers::Arena {
  explicit Arena(int threadCount) : threads(threadCount), arena(threadCount) {}
  int threads;
  oneapi::tbb::task_arena arena;
};

Workers::Workers() = default;
Workers::~Workers() = default;

Workers::Arena& Workers::arenaOf(int threads) {
  // More threads than cores would only wait for each other.
  const int useful = std::min(threads, oneapi::tbb::info::default_concurrency());
  if (!arena_ || arena_->threads != useful) {
    arena_ = std::make_unique<Arena>(useful);
  }
  return *arena_;
}

void Workers::forRange(int threads, int count, const std::function<void(int begin, int end)>& body) {
  if (threads <= 1 || count < minParallelLoop) {
    body(0, count);
    return;
  }
  forParts(arenaOf(threads).arena, count, count / threads, oneapi::tbb::static_partitioner(), body);
}

void Workers::forUnevenRange(int threads, int count, const std::function<void(int begin, int end)>& body) {
  if (threads <= 1 || count < minParallelUnevenLoop) {
    body(0, count);
    return;
  }
  const int size = (count + rangesPerThread * threads - 1) / (rangesPerThread * threads);
  forParts(arenaOf(threads).arena, count, size, oneapi::tbb::simple_partitioner(), body);
}

}  // namespace drape::sim
