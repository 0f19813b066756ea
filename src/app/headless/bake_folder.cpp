#include "app/headless/bake_folder.hpp"

#include "app/output_file.hpp"
#include "messages/error.hpp"

#include <fmt/core.h>
#include <unistd.h>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

namespace drape::app {
namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double));

std::string lineOf(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

}  // namespace

BakeFolder::BakeFolder(std::filesystem::path folder, std::size_t vertices, const std::string& pictures)
    : folder_(std::move(folder)), vertices_(vertices) {
  makeFolder(folder_);
  const std::filesystem::path description = folder_ / "pictures.txt";
  if (hasCheckpoint() && lineOf(description) != pictures) {
    throw messages::InputError(folder_.string() + ": the unfinished bake draws other pictures (" + lineOf(description) +
                               "). Use the same options as then, or remove the folder.");
  }
  const std::filesystem::path file = folder_ / "positions";
  positions_.reset(std::fopen(file.c_str(), std::filesystem::exists(file) ? "rb+" : "wb+"));
  require(positions_ != nullptr && replaceFile(description, pictures + "\n"), "cannot be written");
}

void BakeFolder::require(bool success, const char* what) const {
  if (!success) {
    throw messages::InputError(folder_.string() + ": " + what + " (" + std::strerror(errno != 0 ? errno : EIO) +
                               "). Check the folder and the space on the disk.");
  }
}

std::filesystem::path BakeFolder::picture(std::int64_t frame) const {
  return folder_ / fmt::format("frame_{:06}.png", frame);
}

void BakeFolder::keep(std::int64_t frames) {
  const auto bytes = static_cast<std::uintmax_t>(frames) * vertices_ * sizeof(Vec3);
  if (std::filesystem::file_size(folder_ / "positions") < bytes) {
    throw messages::InputError(folder_.string() + ": the unfinished bake is damaged. Remove the folder to start anew.");
  }
  require(ftruncate(fileno(positions_.get()), static_cast<off_t>(bytes)) == 0, "cannot be written");
}

void BakeFolder::append(const std::vector<Vec3>& positions) {
  errno = 0;
  require(fseeko(positions_.get(), 0, SEEK_END) == 0 &&
              std::fwrite(positions.data(), sizeof(Vec3), positions.size(), positions_.get()) == positions.size(),
          "cannot be written");
}

void BakeFolder::synchronise() {
  errno = 0;
  require(std::fflush(positions_.get()) == 0 && fsync(fileno(positions_.get())) == 0, "cannot be written");
}

std::vector<Vec3> BakeFolder::positions(std::int64_t frame) {
  std::vector<Vec3> read(vertices_);
  const auto offset = static_cast<off_t>(static_cast<std::uint64_t>(frame) * vertices_ * sizeof(Vec3));
  errno = 0;
  require(fseeko(positions_.get(), offset, SEEK_SET) == 0 &&
              std::fread(static_cast<void*>(read.data()), sizeof(Vec3), vertices_, positions_.get()) == vertices_,
          "cannot be read");
  return read;
}

void BakeFolder::remove() {
  positions_.reset();
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

}  // namespace drape::app
