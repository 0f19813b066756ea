#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace drape::sim {

/// Threads for loops over vertices or springs. A loop body writes only the data of its own indices, so the result does
/// not depend on the number of threads.
class Workers {
 public:
  Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers();

  /// Calls body(begin, end) on ranges that together cover 0 .. count - 1, on at most `threads` threads. Short loops run
  /// on the calling thread.
  void forRange(int threads, int count, const std::function<void(int begin, int end)>& body);

  /// The same for loops whose indices take microseconds, and not all the same time: from fewer indices on, and in more
  /// ranges than threads.
  void forUnevenRange(int threads, int count, const std::function<void(int begin, int end)>& body);

  /// Calls visit(i) for every index i from 0 to count - 1.
  template <typename Visit>
  void forEach(int threads, std::size_t count, Visit&& visit) {
    forRange(threads, static_cast<int>(count), [&](int begin, int end) {
      for (int i = begin; i < end; ++i) {
        visit(static_cast<std::size_t>(i));
      }
    });
  }

 private:
  struct Arena;
  Arena& arenaOf(int threads);

  std::unique_ptr<Arena> arena_;
};

}  // namespace drape::sim
