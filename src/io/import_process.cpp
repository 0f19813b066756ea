#include "io/import_process.hpp"

#include "messages/error.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the user

namespace drape::io {
namespace {

using Clock = std::chrono::steady_clock;

/// A file descriptor, closed at the end of its scope.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }

  [[nodiscard]] int number() const { return number_; }

  void close() {
    if (number_ >= 0) {
      ::close(number_);
    }
    number_ = -1;
  }

 private:
  int number_;
};

/// The settings of posix_spawn besides program and arguments.
class SpawnSetup {
 public:
  /// The child's standard input and output are `channel`, its standard error is discarded, and signals have their
  /// default actions.
  explicit SpawnSetup(int channel) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, channel, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, channel, STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawnattr_init(&attributes_);
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&attributes_, &signals);
    sigaddset(&signals, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes_, &signals);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  SpawnSetup(const SpawnSetup&) = delete;
  SpawnSetup& operator=(const SpawnSetup&) = delete;
  ~SpawnSetup() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }

  /// Starts the program and returns its process id.
  pid_t spawn(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) {
      pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    pid_t child = 0;
    const int problem = posix_spawn(&child, program.c_str(), &actions_, &attributes_, pointers.data(), environ);
    if (problem != 0) {
      throw messages::InputError("cannot start " + program.string() + ": " + std::strerror(problem));
    }
    return child;
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

/// A child process that ends with this object at the latest.
class Child {
 public:
  explicit Child(pid_t number) : number_(number) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    kill();
    wait();
  }

  void kill() const {
    if (number_ > 0) {
      ::kill(number_, SIGKILL);
    }
  }

  /// Waits for its end and returns the status of waitpid.
  int wait() {
    int status = 0;
    while (number_ > 0 && waitpid(number_, &status, 0) < 0 && errno == EINTR) {
    }
    number_ = -1;
    return status;
  }

  /// The same, but kills the child at the deadline. True when it ended before.
  bool waitUntil(Clock::time_point deadline, int& status) {
    while (true) {
      const pid_t ended = waitpid(number_, &status, WNOHANG);
      if (ended != 0 && !(ended < 0 && errno == EINTR)) {
        number_ = -1;
        return true;
      }
      if (Clock::now() >= deadline) {
        kill();
        status = wait();
        return false;
      }
      poll(nullptr, 0, 2);
    }
  }

 private:
  pid_t number_;
};

bool isPassing(int error) {
  return error == EAGAIN || error == EWOULDBLOCK || error == EINTR;
}

/// The exchange of data with a child over a socket, its standard input and output.
class Conversation {
 public:
  Conversation(int channel, std::string_view input, std::size_t outputLimit, const OutputListener& listener)
      : channel_(channel), input_(input), outputLimit_(outputLimit), listener_(listener) {}

  enum class State { Talking, Ended, TooMuch };

  /// Sends and receives as much as possible without waiting.
  State exchange() {
    send();
    return receive();
  }

  /// Waits until data can be sent or received, at most until the deadline.
  void waitForTurn(Clock::time_point deadline, bool canBeStopped) const {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count() + 1;
    const long long longest = canBeStopped ? 50 : 1000;
    pollfd entry{channel_, static_cast<short>(closed_ ? POLLIN : POLLIN | POLLOUT), 0};
    poll(&entry, 1, static_cast<int>(std::clamp<long long>(left, 0, longest)));
  }

  std::string takeOutput() { return std::move(output_); }

 private:
  void send() {
    while (!input_.empty()) {
      const ssize_t sent = ::send(channel_, input_.data(), input_.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (sent < 0) {
        if (!isPassing(errno)) {
          input_ = {};  // The child reads no more, but may still write.
        }
        break;
      }
      input_.remove_prefix(static_cast<std::size_t>(sent));
    }
    if (input_.empty() && !closed_) {
      shutdown(channel_, SHUT_WR);
      closed_ = true;
    }
  }

  State receive() {
    std::array<char, 65536> buffer{};
    // The deadline must be checked even when a child never stops writing.
    for (int turn = 0; turn < 64; ++turn) {
      const ssize_t got = recv(channel_, buffer.data(), buffer.size(), MSG_DONTWAIT);
      if (got < 0) {
        return isPassing(errno) ? State::Talking : State::Ended;
      }
      if (got == 0) {
        return State::Ended;
      }
      output_.append(buffer.data(), static_cast<std::size_t>(got));
      if (listener_) {
        listener_(std::string_view(buffer.data(), static_cast<std::size_t>(got)));
      }
      if (output_.size() > outputLimit_) {
        return State::TooMuch;
      }
    }
    return State::Talking;
  }

  int channel_;
  std::string_view input_;
  std::size_t outputLimit_;
  const OutputListener& listener_;
  std::string output_;
  bool closed_ = false;
};

ProcessOutcome converse(Child& child, Conversation& conversation, Clock::time_point deadline,
                        const std::stop_token& stop) {
  ProcessOutcome outcome;
  auto state = Conversation::State::Talking;
  while ((state = conversation.exchange()) == Conversation::State::Talking && Clock::now() < deadline &&
         !stop.stop_requested()) {
    conversation.waitForTurn(deadline, stop.stop_possible());
  }
  int status = 0;
  if (stop.stop_requested()) {
    outcome.end = ProcessOutcome::End::Cancelled;
  } else if (state == Conversation::State::TooMuch) {
    outcome.end = ProcessOutcome::End::TooMuch;
  } else if (state == Conversation::State::Talking || !child.waitUntil(deadline, status)) {
    outcome.end = ProcessOutcome::End::TimedOut;
  } else if (WIFSIGNALED(status)) {
    outcome.end = ProcessOutcome::End::Killed;
    outcome.code = WTERMSIG(status);
  } else {
    outcome.code = WEXITSTATUS(status);
    outcome.output = conversation.takeOutput();
  }
  return outcome;
}

}  // namespace

ProcessOutcome runProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                          std::string_view input, const ProcessLimits& limits, const OutputListener& listener) {
  const Clock::time_point deadline = Clock::now() + limits.wallClock;
  // A socket instead of two pipes: writing to a dead child can then avoid SIGPIPE.
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    throw messages::InputError(std::string("cannot talk to the import program: ") + std::strerror(errno));
  }
  Descriptor ours(ends[0]);
  Descriptor theirs(ends[1]);
  Child child(SpawnSetup(theirs.number()).spawn(program, arguments));
  theirs.close();
  Conversation conversation(ours.number(), input, limits.outputBytes, listener);
  return converse(child, conversation, deadline, limits.stop);
}

}  // namespace drape::io
