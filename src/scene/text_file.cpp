#include "scene/text_file.hpp"

#include "messages/error.hpp"

#include <fstream>
#include <iterator>

namespace drape::scene {
namespace {

constexpr std::uintmax_t largestTextFile = 1U << 20U;  // [bytes]

}  // namespace

std::string readTextFile(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw messages::InputError(file.string() + " is a folder; give a file");
  }
  if (const std::uintmax_t size = std::filesystem::file_size(file, error); !error && size > largestTextFile) {
    throw messages::InputError(file.string() + " is larger than the limit for such files (1 MiB)");
  }
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) {
    throw messages::InputError(file.string() + " cannot be read; check its name and permissions");
  }
  return text;
}

}  // namespace drape::scene
