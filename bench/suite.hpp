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
  double items = 1.0;               ///< how many steps, springs ... a batch handles; a row's times are for one of them
  std::function<double()> seconds;  ///< takes a batch and says how long it took [s]
};

/// What is measured, and the ratios and bounds that come out of it. A batch is made when it is first needed, so that
/// what a filter leaves out costs nothing.
class Suite {
 public:
  /// @param cores the benchmark may run on so many, and is kept on them.
  void add(const Row& row, std::function<Batch()> make, int cores = 1);

  /// Something that is no time and is found once, in the row's own unit.
  void addFigure(const Row& row, std::function<double()> find);

  void addRatio(Ratio ratio) { ratios_.push_back(std::move(ratio)); }

  /// Runs everything whose "group/name" matches the regular expression, `repetitions` times in a random order, so that
  /// what disturbs the machine for a while disturbs all alike.
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

/// The time that this thread alone was at work [s]: what other programs take does not count.
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

/// The time that passed [s].
template <typename Work>
double wallSeconds(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The groups, one file each.
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
void addAutoGroup(Suite& suite);

}  // namespace drape::bench
