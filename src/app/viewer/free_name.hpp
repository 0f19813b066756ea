#pragma once

#include <filesystem>
#include <string>

namespace drape::app {

/// A name for a file about a scene that is free in the folder: "flag-001.png", "flag-002.png", ... Throws InputError
/// when there is none.
/// @param extension with the dot
[[nodiscard]] std::filesystem::path freeName(const std::filesystem::path& folder, const std::string& scene,
                                             const std::string& extension);

}  // namespace drape::app
