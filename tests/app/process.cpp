#include "process.hpp"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace drape::app {
namespace {

constexpr int cannotStart = 127;

/// Runs in the child; never returns.
[[noreturn]] void become(const ProcessOptions& options, std::vector<char*>& arguments) {
  for (const auto& [name, value] : options.environment) {
    if (value.empty()) {
      unsetenv(name.c_str());
    } else {
      setenv(name.c_str(), value.c_str(), 1);
    }
  }
  if (!options.folder.empty() && chdir(options.folder.c_str()) != 0) {
    _exit(cannotStart);
  }
  const char* output = options.output.empty() ? "/dev/null" : options.output.c_str();
  const int file = open(output, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  dup2(file, STDOUT_FILENO);
  dup2(file, STDERR_FILENO);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  if (options.inheritedPipe >= 0) {
    fcntl(options.inheritedPipe, F_SETFD, 0);
  }
  execvp(arguments.front(), arguments.data());
  _exit(cannotStart);
}

}  // namespace

Process::Process(const ProcessOptions& options) {
  std::vector<char*> arguments;
  for (const std::string& argument : options.command) {
    arguments.push_back(const_cast<char*>(argument.c_str()));
  }
  arguments.push_back(nullptr);
  pid_ = fork();
  if (pid_ < 0) {
    throw std::runtime_error("fork failed");
  }
  if (pid_ == 0) {
    become(options, arguments);
  }
}

Process::~Process() {
  if (!running()) {
    return;
  }
  kill(pid_, SIGTERM);
  if (!waitFor(5.0)) {
    kill(pid_, SIGKILL);
    static_cast<void>(waitFor(5.0));
  }
}

std::optional<int> Process::waitFor(double seconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (!status_) {
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) == pid_) {
      status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    } else if (std::chrono::steady_clock::now() >= end) {
      break;
    } else {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
  return status_;
}

void Process::suspend() const {
  kill(pid_, SIGSTOP);
}

void Process::resume() const {
  kill(pid_, SIGCONT);
}

int runToEnd(const ProcessOptions& options) {
  Process process(options);
  return process.waitFor(60.0).value_or(-1);
}

}  // namespace drape::app
