#pragma once

#include <filesystem>
#include <string>

namespace drape::app::testing {

/// The result of a program.
struct Outcome {
  int status = -1;     ///< exit status
  std::string output;  ///< standard output
  std::string errors;  ///< standard error
};

/// Runs drape-headless with arguments as a shell splits them.
[[nodiscard]] Outcome headless(const std::string& arguments);

/// The same with redirected standard output, in shell syntax: ">/dev/full", ">&-". `output` stays empty.
[[nodiscard]] Outcome headlessInto(const std::string& redirection, const std::string& arguments);

/// The same for drape-report.
[[nodiscard]] Outcome reportInto(const std::string& redirection, const std::string& arguments);

/// Runs drape-headless with Mesa's softpipe, a graphics driver without multisampling.
[[nodiscard]] Outcome headlessOnSoftpipe(const std::string& arguments);

/// Runs drape-report, as above.
[[nodiscard]] Outcome report(const std::string& arguments);

/// The same, interrupted by SIGINT (Ctrl-C) after this number of seconds.
[[nodiscard]] Outcome interruptedReport(int seconds, const std::string& arguments);

/// A new folder for the running test.
[[nodiscard]] std::filesystem::path testFolder();

[[nodiscard]] std::string readFile(const std::filesystem::path& file);

}  // namespace drape::app::testing
