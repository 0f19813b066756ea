#pragma once

#include <filesystem>
#include <string>

namespace drape::app {

/// Drape's folder among those of the user, by the XDG base directory specification: "drape" in the folder that the
/// variable of the environment names, else in `usual` below the home folder. Empty where neither names a folder.
[[nodiscard]] std::filesystem::path userFolder(const char* variable, const std::string& usual);

}  // namespace drape::app
