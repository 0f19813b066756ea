#include "program.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace drape::app::testing {

std::string readFile(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::filesystem::path testFolder() {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const auto folder = std::filesystem::path(::testing::TempDir()) /
                      (std::string("drape_") + test->test_suite_name() + "_" + test->name());
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

namespace {

Outcome runProgram(const std::string& program, const std::string& arguments, const std::string& redirection = "") {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::string base = ::testing::TempDir() + "drape_" + test->test_suite_name() + "_" + test->name();
  const std::string output = redirection.empty() ? ">" + base + ".out" : redirection;
  const std::string command = program + " " + arguments + " " + output + " 2>" + base + ".err </dev/null";
  const int status = std::system(command.c_str());  // NOLINT(concurrency-mt-unsafe): the test has one thread
  Outcome outcome{WIFEXITED(status) ? WEXITSTATUS(status) : -1, readFile(base + ".out"), readFile(base + ".err")};
  std::filesystem::remove(base + ".out");
  std::filesystem::remove(base + ".err");
  return outcome;
}

}  // namespace

Outcome headless(const std::string& arguments) {
  return runProgram(DRAPE_HEADLESS, arguments);
}

Outcome headlessInto(const std::string& redirection, const std::string& arguments) {
  return runProgram(DRAPE_HEADLESS, arguments, redirection);
}

Outcome headlessOnSoftpipe(const std::string& arguments) {
  return runProgram("GALLIUM_DRIVER=softpipe " DRAPE_HEADLESS, arguments);
}

Outcome reportInto(const std::string& redirection, const std::string& arguments) {
  return runProgram(DRAPE_REPORT, arguments, redirection);
}

Outcome report(const std::string& arguments) {
  return runProgram(DRAPE_REPORT, arguments);
}

Outcome interruptedReport(int seconds, const std::string& arguments) {
  // Without --foreground the program gets the signal twice, and a second interrupt ends it at once.
  return runProgram("timeout --foreground --preserve-status -s INT " + std::to_string(seconds) + " " DRAPE_REPORT,
                    arguments);
}

}  // namespace drape::app::testing
