#include "render/image.hpp"

#include "messages/error.hpp"
#include "render/stb.hpp"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <system_error>

namespace drape::render {
namespace {

void appendBytes(void* target, void* data, int size) {
  auto* bytes = static_cast<std::string*>(target);
  bytes->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

/// Empty when the picture has no pixels or the wrong number of bytes.
std::string encodePng(const Image& image) {
  std::string bytes;
  const std::size_t pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  if (image.width <= 0 || image.height <= 0 || image.rgb.size() != 3 * pixels) {
    return bytes;
  }
  stbi_write_png_to_func(&appendBytes, &bytes, image.width, image.height, 3, image.rgb.data(), image.width * 3);
  return bytes;
}

}  // namespace

void writePng(const Image& image, const std::filesystem::path& file) {
  const std::string bytes = encodePng(image);
  if (bytes.empty()) {
    throw messages::InputError("cannot write '" + file.string() + "': the picture could not be encoded (" +
                               std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels)");
  }
  std::ofstream stream(file, std::ios::binary);
  if (!stream) {
    const std::error_code reason(errno, std::generic_category());
    throw messages::InputError("cannot write '" + file.string() + "': " + reason.message());
  }
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) {
    throw messages::InputError("cannot write '" + file.string() + "': the disk may be full");
  }
}

Image readPng(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    const std::error_code reason(errno, std::generic_category());
    throw messages::InputError("cannot read '" + file.string() + "': " + reason.message());
  }
  const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  Image image;
  int channels = 0;
  const auto* data = static_cast<const stbi_uc*>(static_cast<const void*>(bytes.data()));
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(data, static_cast<int>(bytes.size()), &image.width, &image.height, &channels, 3),
      &stbi_image_free);
  if (pixels == nullptr) {
    throw messages::InputError("cannot read '" + file.string() + "' as a picture: " + stbi_failure_reason());
  }
  const std::size_t size =
      std::size_t{3} * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  image.rgb.assign(pixels.get(), pixels.get() + size);
  return image;
}

}  // namespace drape::render
