#include "io/import_process.hpp"

#include "input_error.hpp"

#include <signal.h>

#include <gtest/gtest.h>
#include <stop_token>

namespace drape::io {
namespace {

using End = ProcessOutcome::End;

constexpr std::size_t manyBytes = 8U << 20;

ProcessOutcome runShell(const std::string& script, std::string_view input, ProcessLimits limits) {
  return runProcess("/bin/sh", {"-c", script}, input, limits);
}

ProcessLimits withinSeconds(int seconds) {
  return {std::chrono::seconds(seconds), 4 * manyBytes, {}};
}

TEST(ImportProcess, echoesMoreThanAPipeHoldsWithoutStalling) {
  std::string input;
  for (std::size_t i = 0; i < manyBytes; ++i) {
    input += static_cast<char>(i * 31 % 251);
  }
  const ProcessOutcome outcome = runShell("cat", input, withinSeconds(60));
  EXPECT_EQ(outcome.end, End::Exited);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(outcome.output == input);
}

TEST(ImportProcess, hearsAChildOutThatDoesNotReadItsInput) {
  const ProcessOutcome outcome = runShell("echo done", std::string(manyBytes, 'x'), withinSeconds(60));
  EXPECT_EQ(outcome.end, End::Exited);
  EXPECT_EQ(outcome.output, "done\n");
}

TEST(ImportProcess, reportsTheExitStatus) {
  EXPECT_EQ(runShell("exit 3", "", withinSeconds(60)).code, 3);
}

TEST(ImportProcess, reportsTheSignalThatKilledTheChild) {
  const ProcessOutcome outcome = runShell("kill -SEGV $$", std::string(manyBytes, 'x'), withinSeconds(60));
  EXPECT_EQ(outcome.end, End::Killed);
  EXPECT_EQ(outcome.code, SIGSEGV);
}

TEST(ImportProcess, stopsAChildThatTakesTooLong) {
  const auto start = std::chrono::steady_clock::now();
  const ProcessLimits limits{std::chrono::milliseconds(200), manyBytes, {}};
  EXPECT_EQ(runShell("exec sleep 60", "", limits).end, End::TimedOut);
  EXPECT_EQ(runShell("exec sleep 60", std::string(manyBytes, 'x'), limits).end, End::TimedOut);
  EXPECT_EQ(runShell("exec sleep 60 >&-", "", limits).end, End::TimedOut) << "even when it has closed its output";
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

TEST(ImportProcess, stopsAChildThatWritesWithoutEnd) {
  EXPECT_EQ(runShell("exec yes", "", {std::chrono::seconds(60), manyBytes, {}}).end, End::TooMuch);
}

TEST(ImportProcess, stopsAChildWhenAsked) {
  std::stop_source source;
  ProcessLimits limits = withinSeconds(60);
  limits.stop = source.get_token();
  std::string heard;
  const ProcessOutcome outcome =
      runProcess("/bin/sh", {"-c", "echo hello; exec sleep 60"}, "", limits, [&heard, &source](std::string_view piece) {
        heard += piece;
        source.request_stop();
      });
  EXPECT_EQ(outcome.end, End::Cancelled);
  EXPECT_EQ(heard, "hello\n");
}

TEST(ImportProcess, saysWhichProgramCannotBeStarted) {
  const std::string message = inputErrorOf([] { (void)runProcess("/nowhere/program", {}, "", withinSeconds(60)); });
  EXPECT_TRUE(contains(message, "/nowhere/program"));
}

}  // namespace
}  // namespace drape::io
