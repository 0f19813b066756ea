#pragma once

#include "session/command.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <vector>

namespace drape::session {

/// Commands on their way to the simulation. Any thread may post; one thread drains, and can wait for the next command.
/// The lock is held only for a push or a swap, so neither side waits for the other's work.
class CommandQueue {
 public:
  void post(Command command) {
    {
      const std::scoped_lock lock(mutex_);
      commands_.push_back(std::move(command));
    }
    changed_.notify_one();
  }

  /// Waits until there is a command or another thread calls wake(), but no longer than that.
  void await(std::chrono::duration<double> longest) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, longest, [this] { return woken_ || !commands_.empty(); });
    woken_ = false;
  }

  /// Ends the present call of await(), or the next one.
  void wake() {
    {
      const std::scoped_lock lock(mutex_);
      woken_ = true;
    }
    changed_.notify_one();
  }

  /// Takes all posted commands, in order. `taken` is cleared first; its memory is reused.
  void drain(std::vector<Command>& taken) {
    taken.clear();
    const std::scoped_lock lock(mutex_);
    commands_.swap(taken);
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool woken_ = false;
  std::vector<Command> commands_;
};

}  // namespace drape::session
