#pragma once

#include <filesystem>
#include <string>

namespace drape::app::testing {

/// Whether Chromium is installed.
[[nodiscard]] bool hasBrowser();

/// A visit of a page in headless Chromium.
struct PageVisit {
  std::string result;   ///< the value of the script
  std::string console;  ///< the messages on the console, one per line
};

/// Opens a page in a window of this size [pixels] and evaluates a function body in JavaScript that returns a text.
/// @param folder for temporary files
[[nodiscard]] PageVisit visitPage(const std::string& html, int width, int height, const std::string& script,
                                  const std::filesystem::path& folder);

}  // namespace drape::app::testing
