#pragma once

#include <string>
#include <utility>
#include <vector>

namespace drape::app {

// What the rest of a desktop does with the viewer's window, by the protocols of X. Each throws std::runtime_error when
// there is no such display, no window on it that takes files, or no answer.

/// Drops files on the window at a place of the display, as a file manager does (XDND): says that it has files, moves
/// them over the window, lets go, and hands over the list of their addresses. Gives back whether the window took them.
[[nodiscard]] bool dropFiles(const std::string& display, int x, int y, const std::vector<std::string>& files);

/// Asks the window to close, as the button in its title bar does.
void askToClose(const std::string& display);

/// The smallest width and height that the window allows [pixels].
[[nodiscard]] std::pair<int, int> smallestSize(const std::string& display);

}  // namespace drape::app
