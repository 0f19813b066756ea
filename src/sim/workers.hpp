#pragma once

#include <functional>
#include <memory>

namespace drape {

/// Threads for loops over vertices or springs. A loop body writes only what belongs to its own indices, so the result
/// does not depend on how many threads there are.
class Workers {
 public:
  Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  ~Workers();

  /// Calls body(begin, end) on pieces that together cover 0 .. count - 1, on at most `threads` threads; short loops
  /// stay on the calling one.
  void forRange(int threads, int count, const std::function<void(int begin, int end)>& body);

 private:
  struct Arena;
  std::unique_ptr<Arena> arena_;
};

}  // namespace drape
