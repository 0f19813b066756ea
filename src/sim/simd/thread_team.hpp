#pragma once

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace drape::sim::simd {

/// Threads that run a step together and wait for each other between its phases. A step of a small cloth takes some
/// microseconds, less than waking a thread. So they spin for a while before they sleep.
class ThreadTeam {
 public:
  ThreadTeam() = default;
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;
  ~ThreadTeam();

  /// Calls body(member) for the members 0 .. count - 1 at the same time, member 0 on the calling thread.
  void run(int count, const std::function<void(int member)>& body);

  /// A barrier for the members of the running team.
  void arriveAndWait();

 private:
  void work(int member);
  void resize(int count);
  void dismiss();

  std::vector<std::thread> others_;
  const std::function<void(int)>* body_ = nullptr;
  int count_ = 1;
  bool leaving_ = false;
  // Separate cache lines: waiting on one must not slow down writes to another.
  alignas(64) std::atomic<unsigned> generation_ = 0;         // incremented when there is work
  alignas(64) std::atomic<int> busy_ = 0;                    // other threads that are still working
  alignas(64) std::atomic<int> arrived_ = 0;                 // at the barrier
  alignas(64) std::atomic<unsigned> barrierGeneration_ = 0;  // incremented when all have arrived
};

}  // namespace drape::sim::simd
