#pragma once

#include <array>
#include <atomic>

namespace drape::session {

/// Passes the newest value from one writing thread to one reading thread; neither ever waits. Values that the reader
/// misses are dropped. There are three slots: one of the writer, one of the reader, and one in exchange.
template <typename T>
class TripleBuffer {
 public:
  /// The writer's slot, to be filled before publish(). It holds an older value, so its memory can be reused.
  [[nodiscard]] T& writeSlot() { return slots_[writer_]; }

  /// Makes the write slot the newest value and takes another slot for the next one.
  void publish() { writer_ = middle_.exchange(writer_ | fresh, std::memory_order_acq_rel) & index; }

  /// The newest published value; the same object as before when there is no newer one. It is valid until the next call.
  [[nodiscard]] const T& latest() {
    if ((middle_.load(std::memory_order_relaxed) & fresh) != 0U) {
      reader_ = middle_.exchange(reader_, std::memory_order_acq_rel) & index;
    }
    return slots_[reader_];
  }

 private:
  static constexpr unsigned index = 3U;
  static constexpr unsigned fresh = 4U;

  std::array<T, 3> slots_{};
  std::atomic<unsigned> middle_{1U};
  unsigned writer_ = 0U;
  unsigned reader_ = 2U;
};

}  // namespace drape::session
