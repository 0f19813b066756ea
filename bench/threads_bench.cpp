// One thread against two. A step on few vertices always runs on one thread.
#include "bench/slice_runner.hpp"
#include "bench/suite.hpp"

#include <algorithm>

namespace drape::bench {

void addThreadsGroup(Suite& suite) {
  constexpr int cores = 2;
  // The library determines the number of cores once. It must not do so while this thread is bound to one core.
  static_cast<void>(sim::simd::usefulThreads(sim::simd::SliceLayout{}, false, cores));
  for (const int n : {33, 65, 257, 1025}) {
    const int batch = std::clamp(4'000'000 / (n * n * 3), 4, 200);
    const std::string size = std::to_string(n) + "x" + std::to_string(n);
    for (const int threads : {1, 2}) {
      suite.add(
          {"threads", size + ", " + std::to_string(threads), "us/step"},
          [=]() -> Batch {
            sim::StepParameters parameters = fullStep();
            parameters.threads = threads;
            auto runner = std::make_shared<SliceRunner<float>>(grid(n), Method::OneIteration, parameters);
            return {static_cast<double>(batch), [runner, batch] { return batchSeconds(*runner, batch, true); }};
          },
          cores);
    }
    // For the smallest cloth two threads must only not be slower; 5 % is within the repeatability of a run.
    const double minRatio = n == 33 ? 0.95 : n == 65 ? 1.7 : n == 257 ? 1.8 : 1.0;
    suite.addRatio({"threads", size + ", 1 thread / 2", "threads/" + size + ", 1", "threads/" + size + ", 2",
                    Bound{Bound::Side::AtLeast, minRatio}});
  }
}

}  // namespace drape::bench
