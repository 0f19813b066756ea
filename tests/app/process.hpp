#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace drape::app {

/// Options for starting a program.
struct ProcessOptions {
  std::vector<std::string> command{};                ///< program and arguments
  std::map<std::string, std::string> environment{};  ///< added to this process's; an empty value removes the variable
  std::filesystem::path folder{};                    ///< working directory; empty: this process's
  std::filesystem::path output{};                    ///< file for standard output and error; empty: discarded
  int inheritedPipe = -1;                            ///< a file descriptor that the program keeps; -1: none
};

/// A program that runs during the test. The destructor ends it and waits for it.
class Process {
 public:
  explicit Process(const ProcessOptions& options);
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process();

  /// The exit status if the program ends within that time, otherwise empty. 128 and more: a signal.
  [[nodiscard]] std::optional<int> waitFor(double seconds);

  /// Stops and continues the program. Events in between arrive at once.
  void suspend() const;
  void resume() const;

  [[nodiscard]] bool running() { return !waitFor(0.0).has_value(); }

 private:
  pid_t pid_ = -1;
  std::optional<int> status_;
};

/// Runs a program to its end and returns its exit status.
[[nodiscard]] int runToEnd(const ProcessOptions& options);

}  // namespace drape::app
