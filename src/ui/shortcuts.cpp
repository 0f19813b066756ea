#include "ui/shortcuts.hpp"

#include <algorithm>
#include <array>

namespace drape::ui {

std::span<const Shortcut> shortcuts() {
  static constexpr std::array table{
      Shortcut{Key::Space, "Space", "play and pause",
               [](const session::Snapshot& snapshot) -> session::Command {
                 return session::PauseCommand{!snapshot.paused};
               }},
      Shortcut{Key::Period, ".", "one step",
               [](const session::Snapshot&) -> session::Command { return session::SingleStepCommand{}; }, true},
      Shortcut{Key::R, "R", "return to the start",
               [](const session::Snapshot&) -> session::Command { return session::ResetCommand{}; }},
      Shortcut{Key::P, "P", "pin the pulled vertex, or release it",
               [](const session::Snapshot&) -> session::Command { return session::TogglePinCommand{}; }},
      Shortcut{Key::F, "F", "frame the cloth", UiAction::FrameCloth},
      Shortcut{Key::One, "1   3   7", "front, right, top", UiAction::ViewFront},
      Shortcut{Key::Three, "", "", UiAction::ViewRight},
      Shortcut{Key::Seven, "", "", UiAction::ViewTop},
      Shortcut{Key::W, "W", "wireframe",
               [](const session::Snapshot& snapshot) -> session::Command {
                 return session::SetSettingCommand{"view.wireframe", !snapshot.settings.view.wireframe};
               }},
      Shortcut{Key::H, "H", "hide and show the panels", UiAction::TogglePanels},
      Shortcut{Key::F12, "F12", "save a picture", UiAction::Screenshot},
      Shortcut{Key::Help, "F1   ?", "this list", UiAction::ToggleHelp},
      Shortcut{Key::Escape, "Esc", "release, close, stop reading a file, quit", UiAction::Quit},
  };
  return table;
}

const Shortcut& shortcutOf(Key key) {
  const std::span<const Shortcut> table = shortcuts();
  return *std::find_if(table.begin(), table.end(), [&](const Shortcut& shortcut) { return shortcut.key == key; });
}

}  // namespace drape::ui
