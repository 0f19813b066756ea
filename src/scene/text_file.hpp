#pragma once

#include <filesystem>
#include <string>

namespace drape::scene {

/// The content of a scene file or a list of fabrics. Throws InputError when it cannot be read or is above 1 MiB.
[[nodiscard]] std::string readTextFile(const std::filesystem::path& file);

}  // namespace drape::scene
