#pragma once

#include "session/command.hpp"

#include <mutex>
#include <vector>

namespace drape::session {

/// Commands on their way to the simulation. Any thread may post; one thread drains. The lock is held only for a push or
/// a swap, so neither side waits for the other's work.
class CommandQueue {
 public:
  void post(Command command) {
    const std::scoped_lock lock(mutex_);
    commands_.push_back(std::move(command));
  }

  /// Takes all posted commands, in order. `taken` is cleared first; its memory is reused.
  void drain(std::vector<Command>& taken) {
    taken.clear();
    const std::scoped_lock lock(mutex_);
    commands_.swap(taken);
  }

 private:
  std::mutex mutex_;
  std::vector<Command> commands_;
};

}  // namespace drape::session
