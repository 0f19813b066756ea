#include "app/report/stop_signal.hpp"

#include <pthread.h>
#include <ctime>

namespace drape::app {

StopSignal::StopSignal() {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals_, &before_);
}

StopSignal::~StopSignal() {
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

bool StopSignal::came() {
  constexpr timespec atOnce{};
  if (!came_ && sigtimedwait(&signals_, nullptr, &atOnce) > 0) {
    came_ = true;
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  return came_;
}

}  // namespace drape::app
