#include "sim/simd/thread_team.hpp"

#if defined(__x86_64__) || defined(__i386__)
#include <immintrin.h>
#endif

namespace drape::sim::simd {
namespace {

/// Spins before a waiting thread yields the processor: about 50 microseconds.
constexpr int spinLimit = 2000;

void pauseBriefly() {
#if defined(__x86_64__) || defined(__i386__)
  _mm_pause();
#elif defined(__aarch64__)
  asm volatile("yield");
#endif
}

template <typename Condition>
bool spinUntil(Condition&& condition) {
  for (int i = 0; i < spinLimit; ++i) {
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
  generation_.fetch_add(1, std::memory_order_release);
  generation_.notify_all();
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
    others_.emplace_back([this, member, seen = generation_.load(std::memory_order_relaxed)]() mutable {
      for (;;) {
        if (!spinUntil([&] { return generation_.load(std::memory_order_acquire) != seen; })) {
          generation_.wait(seen, std::memory_order_acquire);
        }
        if (generation_.load(std::memory_order_acquire) == seen) {
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
  generation_.fetch_add(1, std::memory_order_release);
  generation_.notify_all();
  body(0);
  while (!spinUntil([&] { return busy_.load(std::memory_order_acquire) == 0; })) {
    std::this_thread::yield();
  }
}

void ThreadTeam::arriveAndWait() {
  if (count_ <= 1) {
    return;
  }
  const unsigned generation = barrierGeneration_.load(std::memory_order_acquire);
  if (arrived_.fetch_add(1, std::memory_order_acq_rel) + 1 == count_) {
    arrived_.store(0, std::memory_order_relaxed);
    barrierGeneration_.store(generation + 1, std::memory_order_release);
    return;
  }
  while (!spinUntil([&] { return barrierGeneration_.load(std::memory_order_acquire) != generation; })) {
    std::this_thread::yield();
  }
}

}  // namespace drape::sim::simd
