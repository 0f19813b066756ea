#include "app/output_file.hpp"

#include "messages/error.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

namespace drape::app {
namespace {

/// Read and write for everybody; the user's umask restricts it.
constexpr mode_t usualMode = 0666;

/// False, with errno, when the text could not be written completely.
bool writeAll(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(file, text.data(), text.size());
    if (count < 0 && errno != EINTR) {
      return false;
    }
    text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  }
  return true;
}

/// Pipes and devices cannot be truncated.
bool makeEmpty(int file) {
  struct stat status {};
  return fstat(file, &status) == 0 && (!S_ISREG(status.st_mode) || ftruncate(file, 0) == 0);
}

}  // namespace

void requireFree(const std::filesystem::path& file, Existing existing, std::string_view option) {
  std::error_code error;
  if (existing == Existing::Refused && std::filesystem::exists(file, error)) {
    throw messages::InputError(file.string() + " exists; choose another name" +
                               (option.empty() ? "" : ", or give " + std::string(option)));
  }
}

OutputFile::OutputFile(std::string name, std::string what) : name_(std::move(name)), what_(std::move(what)) {
  file_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, usualMode);
  isOurs_ = file_ >= 0;
  if (!isOurs_ && errno == EEXIST) {
    file_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, usualMode);
  }
  if (file_ < 0) {
    throw messages::InputError("cannot write " + what_ + " to " + name_ + ": " + std::strerror(errno) +
                               ". Check that the folder exists and is writable.");
  }
}

OutputFile::~OutputFile() {
  if (file_ >= 0) {
    ::close(file_);
    if (isOurs_ && !written_) {
      ::unlink(name_.c_str());
    }
  }
}

void OutputFile::write(const nlohmann::ordered_json& figures) {
  writeText(jsonText(figures, 2) + '\n');
}

void OutputFile::writeText(std::string_view text) {
  written_ = true;
  const bool complete = makeEmpty(file_) && writeAll(file_, text);
  const int reason = errno;
  const bool closed = ::close(std::exchange(file_, -1)) == 0;
  if (!complete || !closed) {
    throw messages::InputError(what_ + " could not be written completely to " + name_ + ": " +
                               std::strerror(complete ? errno : reason));
  }
}

bool replaceFile(const std::filesystem::path& file, std::string_view text) {
  auto unfinished = file;
  unfinished += ".part";
  std::ofstream stream(unfinished, std::ios::binary);
  stream << text;
  stream.close();
  std::error_code error;
  if (stream) {
    std::filesystem::rename(unfinished, file, error);
  }
  return stream && !error;
}

void makeFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw messages::InputError("cannot create the folder " + folder.string() + ": " + error.message());
  }
}

std::string jsonText(const nlohmann::ordered_json& json, int indent) {
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace drape::app
