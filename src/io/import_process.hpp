#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace drape {

/// How a child process came to its end.
struct ProcessOutcome {
  enum class End {
    Exited,     ///< by itself, with `code` as its status
    Killed,     ///< by signal number `code`
    TimedOut,   ///< it was stopped because it took too long
    TooMuch,    ///< it was stopped because it wrote more than it may
    Cancelled,  ///< it was stopped because that was asked for
  } end = End::Exited;
  int code = 0;
  std::string output;  ///< what it wrote to its standard output
};

/// What a child process may use.
struct ProcessLimits {
  std::chrono::milliseconds wallClock{10'000};
  std::size_t outputBytes = 0;  ///< it is stopped when it writes more
  std::stop_token stop = {};    ///< it is stopped when this is asked to, within a twentieth of a second
};

/// Called with each piece of a child's output as it comes.
using OutputListener = std::function<void(std::string_view piece)>;

/// Runs a program, writes `input` to its standard input, closes that, and collects its standard output. Its standard
/// error goes nowhere. Neither side waits for the other when pipes run full, and a child that dies early raises no
/// signal here. Throws InputError when the program cannot be started.
[[nodiscard]] ProcessOutcome runProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                                        std::string_view input, const ProcessLimits& limits,
                                        const OutputListener& listener = {});

}  // namespace drape
