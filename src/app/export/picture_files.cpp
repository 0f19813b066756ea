#include "app/export/picture_files.hpp"

#include "app/output_file.hpp"
#include "messages/error.hpp"
#include "text/words.hpp"

#include <fmt/core.h>
#include <filesystem>

namespace drape::app {
namespace {

/// Throws UsageError for an ending of another format than PNG. A name without an ending is allowed.
void requirePicture(const std::filesystem::path& file) {
  const std::string ending = text::lowerCase(file.extension().string());
  if (!ending.empty() && ending != ".png") {
    throw messages::UsageError(file.string() + ": pictures are .png, and films .mp4, .webm or .gif");
  }
}

}  // namespace

PictureFiles::PictureFiles(const std::string& file, int pictures, int width, int height, double rate)
    // The name of a film has no number.
    : pattern_(file, isFilm(file) ? 1 : pictures), rate_(rate) {
  if (!isFilm(file)) {
    requirePicture(file);
  }
  if (const auto folder = std::filesystem::path(pattern_.name(0)).parent_path(); !folder.empty()) {
    makeFolder(folder);
  }
  if (isFilm(file)) {
    film_.emplace(pattern_.name(0), width, height, rate);
  }
}

void PictureFiles::add(const render::Image& picture) {
  if (film_) {
    film_->add(picture);
  } else {
    render::writePng(picture, pattern_.name(count_));
  }
  ++count_;
}

void PictureFiles::finish() {
  if (film_) {
    film_->finish();
  }
}

std::string PictureFiles::summary() const {
  std::string text = fmt::format("{} {}", count_, count_ == 1 ? "picture" : "pictures");
  text += film_ ? fmt::format(" at {:.6g} a second: ", rate_) : ": ";
  text += pattern_.name(0);
  return film_ || count_ < 2 ? text : text + " to " + pattern_.name(count_ - 1);
}

}  // namespace drape::app
