#include "app/viewer/file_dialog.hpp"

#include "io/animation_import.hpp"
#include "io/mesh_import.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <csignal>
#include <set>
#include <sstream>
#include <utility>

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX declares it in no header

namespace drape::app {
namespace {

std::vector<std::string> argumentsFor(const std::string& folder, const text::Catalogue& texts) {
  std::set<std::string> formats{"toml", "pc2", "mdd"};
  for (const std::vector<std::string>& some : {io::meshFormats(), io::animationFormats()}) {
    formats.insert(some.begin(), some.end());
  }
  std::string patterns;
  for (const std::string& format : formats) {
    patterns += (patterns.empty() ? "*." : " *.") + format;
  }
  std::vector<std::string> arguments{std::string(FileDialog::program),
                                     "--file-selection",
                                     "--title=" + texts("Open a scene or meshes"),
                                     "--multiple",
                                     "--separator=\n",
                                     "--file-filter=" + texts("Scenes and meshes") + " | " + patterns,
                                     "--file-filter=" + texts("All files") + " | *"};
  if (!folder.empty()) {
    arguments.push_back("--filename=" + folder + "/");
  }
  return arguments;
}

/// Starts a program whose standard output goes to `output`. 0, or the reason as in errno.
int start(std::vector<std::string> arguments, int output, pid_t& process) {
  std::vector<char*> pointers;
  pointers.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) {
    pointers.push_back(argument.data());
  }
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  const int reason = posix_spawnp(&process, pointers.front(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return reason;
}

}  // namespace

FileDialog::~FileDialog() {
  if (isOpen()) {
    ::kill(process_, SIGTERM);
    ::waitpid(process_, nullptr, 0);
    ::close(output_);
  }
}

bool FileDialog::open(const std::string& folder, const text::Catalogue& texts) {
  if (isOpen()) {
    return true;
  }
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    return false;
  }
  text_.clear();
  const int reason = start(argumentsFor(folder, texts), ends[1], process_);
  ::close(ends[1]);
  if (reason != 0) {
    process_ = -1;
    ::close(ends[0]);
    return false;
  }
  output_ = ends[0];
  ::fcntl(output_, F_SETFL, O_NONBLOCK);
  return true;
}

/// Reads what the program wrote so far; whether it closed its output.
bool FileDialog::readAll() {
  std::array<char, 4096> buffer{};
  while (true) {
    const ssize_t count = ::read(output_, buffer.data(), buffer.size());
    if (count > 0) {
      text_.append(buffer.data(), static_cast<std::size_t>(count));
    } else if (count == 0 || (errno != EINTR && errno != EAGAIN)) {
      return true;
    } else if (errno == EAGAIN) {
      return false;
    }
  }
}

std::optional<FileDialog::Outcome> FileDialog::poll() {
  if (!isOpen() || !readAll()) {
    return std::nullopt;
  }
  int status = 0;
  if (::waitpid(process_, &status, WNOHANG) == 0) {
    return std::nullopt;  // it closed its output and ends soon
  }
  ::close(std::exchange(output_, -1));
  process_ = -1;
  Outcome outcome;
  constexpr int cancelled = 1;
  if (!WIFEXITED(status) || WEXITSTATUS(status) > cancelled) {
    outcome.error = text::Sentence("The file dialog ({}) failed", program);
  } else if (WEXITSTATUS(status) == 0) {
    std::istringstream lines(text_);
    for (std::string line; std::getline(lines, line);) {
      if (!line.empty()) {
        outcome.files.push_back(line);
      }
    }
  }
  return outcome;
}

}  // namespace drape::app
