#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace drape::io {

/// How a child process ended.
struct ProcessOutcome {
  enum class End {
    Exited,     ///< with the exit status `code`
    Killed,     ///< by signal number `code`
    TimedOut,   ///< stopped: it took too long
    TooMuch,    ///< stopped: it wrote too much
    Cancelled,  ///< stopped on request
  } end = End::Exited;
  int code = 0;
  std::string output;  ///< its standard output
};

/// The limits of a child process.
struct ProcessLimits {
  std::chrono::milliseconds wallClock{10'000};
  std::size_t outputBytes = 0;  ///< maximum output
  std::stop_token stop = {};    ///< a request stops the child within 1/20 s
};

/// Receives each piece of a child's output as it arrives.
using OutputListener = std::function<void(std::string_view piece)>;

/// Runs a program, writes `input` to its standard input, closes it, and collects its standard output. Its standard
/// error is discarded. Full pipes cannot cause a deadlock, and a child that dies early raises no signal here. Throws
/// InputError when the program cannot be started.
[[nodiscard]] ProcessOutcome runProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                                        std::string_view input, const ProcessLimits& limits,
                                        const OutputListener& listener = {});

}  // namespace drape::io
