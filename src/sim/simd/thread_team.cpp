#include "sim/simd/thread_team.hpp"

#if defined(__x86_64__) || defined(__i386__)
#include <immintrin.h>
#endif

namespace drape {
namespace {

/// About 50 microseconds; whoever waits longer lets others have the processor.
constexpr int patience = 2000;

void pauseBriefly() {
#if defined(__x86_64__) || defined(__i386__)
  _mm_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

template <typename Condition>
bool spinUntil(Condition&& condition) {
  for (int i = 0; i < patience; ++i) {
    if (condition()) {
      return true;
    }
    pauseBriefly();
  }
  return condition();
}

}  // namespace

ThreadTeam::~ThreadTeam() {
  dismiss();
}

void ThreadTeam::dismiss() {
  leaving_ = true;
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  for (std::thread& other : others_) {
    other.join();
  }
  others_.clear();
  leaving_ = false;
}

void ThreadTeam::resize(int count) {
  if (static_cast<int>(others_.size()) + 1 == count) {
    return;
  }
  dismiss();
  count_ = count;
  for (int member = 1; member < count; ++member) {
    others_.emplace_back([this, member, seen = round_.load(std::memory_order_relaxed)]() mutable {
      for (;;) {
        if (!spinUntil([&] { return round_.load(std::memory_order_acquire) != seen; })) {
          round_.wait(seen, std::memory_order_acquire);
        }
        if (round_.load(std::memory_order_acquire) == seen) {
          continue;
        }
        ++seen;
        if (leaving_) {
          return;
        }
        work(member);
      }
    });
  }
}

void ThreadTeam::work(int member) {
  (*body_)(member);
  busy_.fetch_sub(1, std::memory_order_release);
}

void ThreadTeam::run(int count, const std::function<void(int member)>& body) {
  if (count <= 1) {
    count_ = 1;
    body(0);
    return;
  }
  resize(count);
  count_ = count;
  body_ = &body;
  busy_.store(count - 1, std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  body(0);
  while (!spinUntil([&] { return busy_.load(std::memory_order_acquire) == 0; })) {
    std::this_thread::yield();
  }
}

void ThreadTeam::meet() {
  if (count_ <= 1) {
    return;
  }
  const unsigned meeting = meetings_.load(std::memory_order_acquire);
  if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == count_) {
    arrived_.store(0, std::memory_order_relaxed);
    meetings_.store(meeting + 1, std::memory_order_release);
    return;
  }
  while (!spinUntil([&] { return meetings_.load(std::memory_order_acquire) != meeting; })) {
    std::this_thread::yield();
  }
}

}  // namespace drape
