#pragma once

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace drape {

/// Threads that go through a step together and wait for each other between its phases: a step of a small cloth takes
/// some microseconds, less than it takes to wake a thread. So they spin for a while before they sleep.
class ThreadTeam {
 public:
  ThreadTeam() = default;
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;
  ~ThreadTeam();

  /// Calls body(member) for the members 0 .. count - 1 at the same time, member 0 on the calling thread.
  void run(int count, const std::function<void(int member)>& body);

  /// For the members of the running team: nobody passes before all have come.
  void meet();

 private:
  void work(int member);
  void resize(int count);
  void dismiss();

  std::vector<std::thread> others_;
  const std::function<void(int)>* body_ = nullptr;
  int count_ = 1;
  bool leaving_ = false;
  // Each on a cache line of its own: who waits on one must not slow down who writes another.
  alignas(64) std::atomic<unsigned> round_ = 0;     // grows when there is work
  alignas(64) std::atomic<int> busy_ = 0;           // others that are still at it
  alignas(64) std::atomic<int> arrived_ = 0;        // at the meeting
  alignas(64) std::atomic<unsigned> meetings_ = 0;  // grows when all have come
};

}  // namespace drape
