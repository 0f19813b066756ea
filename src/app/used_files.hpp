#pragma once

#include "scene/scene.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace drape::app {

/// The files that a command reads and writes. No output may replace a file of the scene or another output.
class UsedFiles {
 public:
  /// Takes the scene file, and the files of the cloths, the bodies and the stand.
  explicit UsedFiles(const scene::Scene& scene);

  /// Adds another file that the command reads. Ignores empty names.
  void read(const std::filesystem::path& file);

  /// Adds a file that the command is going to write. Ignores empty names and devices.
  /// @param option that names it, for messages
  /// Throws UsageError if the command reads it, or writes it with another option.
  void write(const std::filesystem::path& file, std::string_view option);

 private:
  std::map<std::string, std::string> users_;  // by absolute name: what uses the file, for messages
};

}  // namespace drape::app
