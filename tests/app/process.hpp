#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace drape {

/// How to start a program.
struct ProcessOptions {
  std::vector<std::string> command{};                ///< program and arguments
  std::map<std::string, std::string> environment{};  ///< added to this process's; an empty value removes the variable
  std::filesystem::path folder{};                    ///< to run in; empty: this process's
  std::filesystem::path output{};                    ///< file for standard output and error; empty: nowhere
  int inheritedPipe = -1;                            ///< a file descriptor that the program keeps; -1: none
};

/// A program that runs beside the test. Ended and waited for by the destructor.
class Process {
 public:
  explicit Process(const ProcessOptions& options);
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process();

  /// The exit status once it has ended by itself within that time; nothing when it still runs. 128 and more: a signal.
  [[nodiscard]] std::optional<int> waitFor(double seconds);

  /// Stops the program where it is, and lets it go on. What happens to it in between arrives all at once.
  void suspend() const;
  void resume() const;

  [[nodiscard]] bool running() { return !waitFor(0.0).has_value(); }

 private:
  pid_t pid_ = -1;
  std::optional<int> status_;
};

/// Runs a program to its end and gives its exit status.
[[nodiscard]] int runToEnd(const ProcessOptions& options);

}  // namespace drape
