#pragma once

#include "bench/results.hpp"

#include <chrono>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace drape::bench {

/// Work that is measured in batches.
struct Batch {
  double items = 1.0;               ///< number of steps, springs, ... in a batch; a row has the time of one of them
  std::function<double()> seconds;  ///< runs a batch and returns its time [s]
};

/// The benchmarks with their ratios and targets. A batch is created when it is first needed, so that filtered
/// benchmarks cost nothing.
class Suite {
 public:
  /// @param cores number of cores that the benchmark is bound to
  void add(const Row& row, std::function<Batch()> make, int cores = 1);

  /// A figure that is not a time and is determined once, in the unit of the row.
  void addFigure(const Row& row, std::function<double()> find);

  void addRatio(Ratio ratio) { ratios_.push_back(std::move(ratio)); }

  /// Runs all benchmarks whose "group/name" matches the regular expression, `repetitions` times in a random order, so
  /// that a temporary disturbance of the machine affects all alike.
  [[nodiscard]] Results run(const std::string& filter, int repetitions, double seconds);

 private:
  struct Entry {
    Row row;
    std::shared_ptr<const Batch> batch;
  };
  struct Figure {
    Row row;
    std::function<double()> find;
  };

  std::vector<Entry> entries_;
  std::vector<Figure> figures_;
  std::vector<Ratio> ratios_;
};

/// CPU time of this thread [s]; other programs do not count.
template <typename Work>
double threadSeconds(Work&& work) {
  const auto now = [] {
    std::timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double start = now();
  work();
  return now() - start;
}

/// Wall-clock time [s].
template <typename Work>
double wallSeconds(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The groups, one in each file.
void addStepGroup(Suite& suite);
void addIrregularGroup(Suite& suite);
void addSizeGroup(Suite& suite);
void addFloorGroup(Suite& suite);
void addThreadsGroup(Suite& suite);
void addMemoryGroup(Suite& suite);
void addInstructionsGroup(Suite& suite);
void addBulletGroup(Suite& suite);
void addViewerGroup(Suite& suite);
void addSelfCollisionGroup(Suite& suite);
void addBodyContactGroup(Suite& suite);
void addContactGroup(Suite& suite);
void addAutoGroup(Suite& suite);

}  // namespace drape::bench
