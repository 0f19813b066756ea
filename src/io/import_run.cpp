#include "io/import_run.hpp"

#include "io/import_process.hpp"
#include "messages/error.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace drape::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mebibyte = std::size_t{1} << 20;

/// The path of the import program: beside this program, or in DRAPE_MESH_IMPORT.
fs::path importProgram() {
  if (const char* chosen = std::getenv("DRAPE_MESH_IMPORT"); chosen != nullptr && *chosen != '\0') {
    return chosen;
  }
  std::error_code problem;
  const fs::path self = fs::read_symlink("/proc/self/exe", problem);
  fs::path program = self.parent_path() / "drape-mesh-import";
  if (problem || !fs::exists(program, problem)) {
    throw messages::InputError("the program drape-mesh-import, which reads meshes, is not at " + program.string() +
                               ". Install it there or set DRAPE_MESH_IMPORT to its path.");
  }
  return program;
}

/// Why the import program failed, as the rest of a sentence.
std::string describeFailure(const ProcessOutcome& outcome, double timeLimit) {
  if (outcome.end == ProcessOutcome::End::TimedOut ||
      (outcome.end == ProcessOutcome::End::Killed && outcome.code == SIGXCPU)) {
    return fmt::format("reading it took longer than {:.1f} s and was stopped", std::round(timeLimit * 10.0) / 10.0);
  }
  if (outcome.end == ProcessOutcome::End::TooMuch) {
    return "it expands to more data than a mesh may have";
  }
  if (outcome.end == ProcessOutcome::End::Killed) {
    return std::string("the mesh reader crashed on it (") + strsignal(outcome.code) + ")";
  }
  return "the mesh reader failed on it (exit status " + std::to_string(outcome.code) + ")";
}

}  // namespace

double defaultTimeLimit(std::size_t bytes) {
  return 10.0 + static_cast<double>(bytes) / static_cast<double>(2 * mebibyte);
}

std::string readWholeFile(const fs::path& file, const std::function<void(const std::string& name)>& check) {
  const std::string name = file.string();
  std::error_code problem;
  const fs::file_status status = fs::status(file, problem);
  if (!fs::exists(status)) {
    throw messages::InputError(name + ": " +
                               (status.type() == fs::file_type::not_found ? "no such file" : problem.message()) +
                               ". Check the path.");
  }
  if (fs::is_directory(status)) {
    throw messages::InputError(name + ": is a directory. Give a mesh file inside it.");
  }
  if (!fs::is_regular_file(status)) {
    throw messages::InputError(name + ": is not a regular file. Copy it to a regular file.");
  }
  check(name);
  const std::uintmax_t size = fs::file_size(file, problem);
  if (!problem && size > largestFile) {
    throw messages::InputError(name + ": is " + std::to_string(size / mebibyte) + " MiB large, and the limit is " +
                               std::to_string(largestFile / mebibyte) + " MiB. Reduce the mesh first.");
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(problem ? 0 : static_cast<std::size_t>(size), '\0');
  if (!stream || !stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
    throw messages::InputError(name + ": cannot be read (" + std::strerror(errno != 0 ? errno : EIO) +
                               "). Check the file's permissions.");
  }
  return bytes;
}

ImportReply replyOf(std::vector<std::string> arguments, std::string_view bytes, double timeLimit,
                    const std::string& otherFormats, const ImportWatch& watch) {
  ProcessLimits limits;
  limits.wallClock = std::chrono::milliseconds(static_cast<long long>(std::ceil(timeLimit * 1000.0)));
  limits.outputBytes = std::min(64 * mebibyte + 64 * bytes.size(), 4096 * mebibyte);
  limits.stop = watch.stop;
  const auto cpuSeconds = static_cast<long long>(std::ceil(timeLimit)) + 1;
  arguments.insert(arguments.begin() + 1, std::to_string(cpuSeconds));
  bool replying = false;
  const auto listen = [&](std::string_view piece) {
    for (std::size_t i = 0; i < piece.size() && !replying; ++i) {
      const auto share = progressOf(piece[i]);
      replying = !share;
      if (share && watch.progress) {
        watch.progress(*share, "Reading");
      }
    }
  };
  const ProcessOutcome outcome = runProcess(importProgram(), arguments, bytes, limits, listen);
  if (outcome.end == ProcessOutcome::End::Cancelled) {
    throw Cancelled();
  }
  if (outcome.end != ProcessOutcome::End::Exited || outcome.code != 0) {
    throw messages::InputError(describeFailure(outcome, timeLimit) +
                               ". The file is probably damaged: export it again, or in " + otherFormats + ".");
  }
  ImportReply reply = decodeReply(withoutProgress(outcome.output));
  if (!reply.error.empty()) {
    throw messages::InputError(reply.error);
  }
  return reply;
}

}  // namespace drape::io
