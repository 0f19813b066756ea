#pragma once

#include "text/catalogue.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sys/types.h>

namespace drape::app {

/// The file dialog of the desktop: the program zenity, as a process of its own, so that the window goes on meanwhile.
class FileDialog {
 public:
  FileDialog() = default;
  FileDialog(const FileDialog&) = delete;
  FileDialog& operator=(const FileDialog&) = delete;
  /// Closes the dialog.
  ~FileDialog();

  /// The outcome of a dialog that was closed.
  struct Outcome {
    std::vector<std::string> files;  ///< none: cancelled, or it failed
    text::Sentence error;            ///< why it failed, in words, or empty
  };

  /// Shows the dialog for scenes and meshes. Does nothing while one is open.
  /// @param folder in which it starts; empty: the current one  @param texts of its language  @return false if zenity is
  /// not installed
  [[nodiscard]] bool open(const std::string& folder, const text::Catalogue& texts);

  [[nodiscard]] bool isOpen() const { return process_ > 0; }

  /// The outcome, once, after the user closed the dialog. Never waits.
  [[nodiscard]] std::optional<Outcome> poll();

  static constexpr std::string_view program = "zenity";

 private:
  [[nodiscard]] bool readAll();

  pid_t process_ = -1;
  int output_ = -1;  // of the program
  std::string text_;
};

}  // namespace drape::app
