#pragma once

#include <filesystem>
#include <string>

namespace drape::app {

/// A name for a picture of a scene that is free in the folder: "flag-001.png", "flag-002.png", ...
[[nodiscard]] std::filesystem::path freeScreenshotName(const std::filesystem::path& folder, const std::string& scene);

}  // namespace drape::app
