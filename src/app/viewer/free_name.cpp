#include "app/viewer/free_name.hpp"

#include "messages/error.hpp"

#include <fmt/core.h>

namespace drape::app {

std::filesystem::path freeName(const std::filesystem::path& folder, const std::string& scene,
                               const std::string& extension) {
  constexpr int maxNumber = 9999;
  const std::string stem = std::filesystem::path(scene).stem().string();
  for (int number = 1; number <= maxNumber; ++number) {
    std::filesystem::path file = folder / fmt::format("{}-{:03}{}", stem.empty() ? "drape" : stem, number, extension);
    if (!std::filesystem::exists(file)) {
      return file;
    }
  }
  throw messages::InputError("there are too many " + extension + " files of this scene in " + folder.string() +
                             "; move some away");
}

}  // namespace drape::app
