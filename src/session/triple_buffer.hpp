#pragma once

#include <array>
#include <atomic>

namespace drape {

/// Hands the newest value from one writing thread to one reading thread without either ever waiting. Values that the
/// reader is too slow for are dropped. Three slots: one is the writer's, one the reader's, and the third changes hands.
template <typename T>
class TripleBuffer {
 public:
  /// The writer's slot, to be filled before publish(). It holds an older value whose memory can be reused.
  [[nodiscard]] T& writeSlot() { return slots_[writer_]; }

  /// Makes the write slot the newest value and takes another slot for the next one.
  void publish() { writer_ = middle_.exchange(writer_ | fresh, std::memory_order_acq_rel) & index; }

  /// The newest published value; the same object as before when nothing new came. The reader may keep it until its
  /// next call.
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

}  // namespace drape
