#include "app/viewer/screenshot_name.hpp"

#include "messages/error.hpp"

#include <array>
#include <cstdio>

namespace drape {

std::filesystem::path freeScreenshotName(const std::filesystem::path& folder, const std::string& scene) {
  constexpr int maxNumber = 9999;
  const std::string stem = std::filesystem::path(scene).stem().string();
  for (int number = 1; number <= maxNumber; ++number) {
    std::array<char, 16> digits{};
    std::snprintf(digits.data(), digits.size(), "-%03d.png", number);
    std::filesystem::path file = folder / ((stem.empty() ? "drape" : stem) + digits.data());
    if (!std::filesystem::exists(file)) {
      return file;
    }
  }
  throw InputError("there are too many pictures of this scene in " + folder.string() + "; move some away");
}

}  // namespace drape
