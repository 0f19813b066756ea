#include "app/standard_streams.hpp"

#include "messages/error.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <cerrno>
#include <cstring>
#include <iostream>
#include <string>

namespace drape::app {
namespace {

bool isClosed(int descriptor) {
  return fcntl(descriptor, F_GETFD) < 0 && errno == EBADF;
}

}  // namespace

void occupyStandardStreams() {
  // `open` takes the lowest free descriptor. A read-only descriptor makes later writes fail.
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (isClosed(descriptor)) {
      static_cast<void>(::open("/dev/null", descriptor == STDERR_FILENO ? O_WRONLY : O_RDONLY));
    }
  }
}

void flushStandardOutput() {
  errno = 0;
  std::cout.flush();
  if (std::cout) {
    return;
  }
  if (errno == 0) {
    static_cast<void>(::write(STDOUT_FILENO, "", 0));  // an earlier write failed: try again to get the reason
  }
  const std::string reason = errno == EBADF ? "it is closed" : errno != 0 ? std::strerror(errno) : "a write failed";
  throw messages::InputError("standard output could not be written completely: " + reason);
}

}  // namespace drape::app
