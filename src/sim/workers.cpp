#include "sim/workers.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>
#include <algorithm>

namespace drape {
namespace {

/// Below this a loop costs less than waking another thread.
constexpr int shortestParallelLoop = 2048;

}  // namespace

struct Workers::Arena {
  explicit Arena(int threadCount) : threads(threadCount), arena(threadCount) {}
  int threads;
  oneapi::tbb::task_arena arena;
};

Workers::Workers() = default;
Workers::~Workers() = default;

void Workers::forRange(int threads, int count, const std::function<void(int begin, int end)>& body) {
  if (threads <= 1 || count < shortestParallelLoop) {
    body(0, count);
    return;
  }
  // More threads than the machine has would only wait for each other.
  const int useful = std::min(threads, oneapi::tbb::info::default_concurrency());
  if (!arena_ || arena_->threads != useful) {
    arena_ = std::make_unique<Arena>(useful);
  }
  arena_->arena.execute([&] {
    oneapi::tbb::parallel_for(
        oneapi::tbb::blocked_range<int>(0, count, count / threads),
        [&](const oneapi::tbb::blocked_range<int>& range) { body(range.begin(), range.end()); },
        oneapi::tbb::static_partitioner());
  });
}

}  // namespace drape
