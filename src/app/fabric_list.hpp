#pragma once

#include "settings/own_fabrics.hpp"

#include <filesystem>
#include <string>

namespace drape::app {

/// The file with the user's fabrics: fabrics.toml in $XDG_CONFIG_HOME/drape, else in ~/.config/drape. Empty where the
/// environment names no such folder.
[[nodiscard]] std::filesystem::path usualFabricFile();

/// The user's fabrics and their file.
class FabricList {
 public:
  /// Whether a file that the user names must exist.
  enum class Missing { Refused, Allowed };

  /// Reads the list. A usual file that does not exist is an empty list.
  /// @param file as given by the user; empty: usualFabricFile()
  /// Throws InputError when a file that the user named is missing (with Refused) or bad.
  explicit FabricList(const std::string& file, Missing missing = Missing::Refused);

  [[nodiscard]] const settings::OwnFabrics& fabrics() const { return fabrics_; }

  /// What is wrong with the usual file, which is then left alone. Empty if nothing is.
  [[nodiscard]] const std::string& problem() const { return problem_; }

  /// The file of the list; empty if there is none.
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

  /// Adds a fabric to the list and to its file. Throws InputError as saveFabric does, and when there is no file.
  void add(const settings::OwnFabric& fabric);

 private:
  std::filesystem::path file_;
  settings::OwnFabrics fabrics_;
  std::string problem_;
};

/// Writes a fabric into a list or a scene file, where it replaces one of the same name. A new file is written beside
/// the old one and renamed, so that nothing is lost when this fails. Throws InputError when the fabric is not allowed,
/// when the present content is bad, or when the file cannot be written.
void saveFabric(const std::filesystem::path& file, const settings::OwnFabric& fabric);

}  // namespace drape::app
