#pragma once

#include <csignal>

namespace drape::app {

/// Defers Ctrl-C (SIGINT) and SIGTERM until the program checks for them. Create it before any thread. After the first
/// signal the next one ends the program as usual.
class StopSignal {
 public:
  StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  ~StopSignal();

  /// Whether a signal has arrived.
  [[nodiscard]] bool came();

 private:
  sigset_t signals_ = {};
  sigset_t before_ = {};
  bool came_ = false;
};

}  // namespace drape::app
