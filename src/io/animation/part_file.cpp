#include "io/animation/part_file.hpp"

#include "messages/error.hpp"

#include <unistd.h>
#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace drape::io::animation {
namespace {

constexpr std::size_t pieceSize = std::size_t{1} << 16;

std::filesystem::path partOf(std::filesystem::path file) {
  file += ".part";
  return file;
}

off_t asOffset(std::uint64_t offset) {
  return static_cast<off_t>(offset);
}

}  // namespace

PartFile::PartFile(std::filesystem::path file)
    : name_(std::move(file)), part_(partOf(name_)), file_(std::fopen(part_.c_str(), "wb+")) {
  if (!file_) {
    throw messages::InputError("cannot write " + name_.string() + ": " + std::strerror(errno) +
                               ". Check that the folder exists and is writable.");
  }
}

PartFile::~PartFile() {
  if (!committed_) {
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);
  }
}

void PartFile::require(bool success) const {
  if (!success) {
    throw messages::InputError(name_.string() + " could not be written completely: " +
                               std::strerror(errno != 0 ? errno : EIO) + ". Nothing was replaced.");
  }
}

void PartFile::write(std::string_view bytes) {
  errno = 0;
  require(std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) == bytes.size());
}

void PartFile::writeAt(std::uint64_t offset, std::string_view bytes) {
  errno = 0;
  require(fseeko(file_.get(), asOffset(offset), SEEK_SET) == 0);
  write(bytes);
  require(fseeko(file_.get(), 0, SEEK_END) == 0);
}

std::size_t PartFile::readAt(std::uint64_t offset, char* into, std::size_t size) {
  errno = 0;
  require(fseeko(file_.get(), asOffset(offset), SEEK_SET) == 0);
  const std::size_t count = std::fread(into, 1, size, file_.get());
  require(std::ferror(file_.get()) == 0);
  return count;
}

void PartFile::moveEnd(std::uint64_t from, std::uint64_t to) {
  std::array<char, pieceSize> piece{};
  for (std::size_t count = 0; (count = readAt(from, piece.data(), piece.size())) > 0; from += count, to += count) {
    writeAt(to, std::string_view(piece.data(), count));
  }
  require(std::fflush(file_.get()) == 0 && ftruncate(fileno(file_.get()), asOffset(to)) == 0);
  require(fseeko(file_.get(), 0, SEEK_END) == 0);
}

void PartFile::append(PartFile& other) {
  std::array<char, pieceSize> piece{};
  std::size_t count = 0;
  for (std::uint64_t at = 0; (count = other.readAt(at, piece.data(), piece.size())) > 0; at += count) {
    write(std::string_view(piece.data(), count));
  }
}

void PartFile::commit() {
  errno = 0;
  require(std::fflush(file_.get()) == 0 && fsync(fileno(file_.get())) == 0);
  require(std::fclose(file_.release()) == 0);
  std::error_code problem;
  std::filesystem::rename(part_, name_, problem);
  if (problem) {
    throw messages::InputError("cannot write " + name_.string() + ": " + problem.message());
  }
  committed_ = true;
}

}  // namespace drape::io::animation
