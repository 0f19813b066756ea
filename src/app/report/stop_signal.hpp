#pragma once

#include <csignal>

namespace drape {

/// Lets Ctrl-C (SIGINT) and SIGTERM wait until the program asks for them. To be made before any thread is. After the
/// first one the next ends the program as usual.
class StopSignal {
 public:
  StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  ~StopSignal();

  /// Whether one has come.
  [[nodiscard]] bool came();

 private:
  sigset_t signals_ = {};
  sigset_t before_ = {};
  bool came_ = false;
};

}  // namespace drape
