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
      Shortcut{Key::Comma, ",", "one recorded state back",
               [](const session::Snapshot&) -> session::Command { return session::StepBackCommand{}; }, true},
      Shortcut{Key::R, "R", "return to the start",
               [](const session::Snapshot&) -> session::Command { return session::ResetCommand{}; }},
      Shortcut{Key::B, "B", "select vertices by a rectangle or a click", UiAction::SelectRectangle},
      Shortcut{Key::L, "L", "select an open border", UiAction::SelectBorder},
      Shortcut{Key::G, "G", "place a cloth or a body; again: move, turn, scale", UiAction::Place},
      Shortcut{Key::S, "S", "sew two open borders", UiAction::Sew},
      Shortcut{Key::None, "", "set an elastic band along an open border", UiAction::SetBand},
      Shortcut{Key::None, "", "pin the selected vertices", UiAction::PinSelected},
      Shortcut{Key::None, "", "release the selected vertices", UiAction::ReleaseSelected},
      Shortcut{Key::P, "P", "pin the pulled vertex or the selected ones, or release them",
               [](const session::Snapshot&) -> session::Command { return session::TogglePinCommand{}; }},
      Shortcut{Key::F, "F", "frame the cloth", UiAction::FrameCloth},
      Shortcut{Key::One, "1", "look from the front", UiAction::ViewFront},
      Shortcut{Key::Three, "3", "look from the right", UiAction::ViewRight},
      Shortcut{Key::Seven, "7", "look from the top", UiAction::ViewTop},
      Shortcut{Key::Five, "5", "perspective or orthographic view", UiAction::ToggleProjection},
      Shortcut{Key::T, "T", "turntable: turn around the cloth", UiAction::ToggleTurntable},
      Shortcut{Key::F5, "F5 to F8", "return to kept view 1, 2, 3 or 4", UiAction::RecallView1},
      Shortcut{Key::F6, "", "return to kept view 2", UiAction::RecallView2},
      Shortcut{Key::F7, "", "return to kept view 3", UiAction::RecallView3},
      Shortcut{Key::F8, "", "return to kept view 4", UiAction::RecallView4},
      Shortcut{Key::F5, "Ctrl+F5 to F8", "keep this view as 1, 2, 3 or 4", UiAction::KeepView1, false, true},
      Shortcut{Key::F6, "", "keep this view as 2", UiAction::KeepView2, false, true},
      Shortcut{Key::F7, "", "keep this view as 3", UiAction::KeepView3, false, true},
      Shortcut{Key::F8, "", "keep this view as 4", UiAction::KeepView4, false, true},
      Shortcut{Key::W, "W", "wireframe",
               [](const session::Snapshot& snapshot) -> session::Command {
                 return session::SetSettingCommand{"view.wireframe", !snapshot.settings.view.wireframe};
               }},
      Shortcut{Key::H, "H", "hide and show the panels", UiAction::TogglePanels},
      Shortcut{Key::P, "Ctrl+P   /", "find a setting, a command or a scene", UiAction::Search, false, true},
      Shortcut{Key::Slash, "", "", UiAction::Search},
      Shortcut{Key::Z, "Ctrl+Z", "undo", UiAction::Undo, true, true},
      Shortcut{Key::Z, "Ctrl+Shift+Z   Ctrl+Y", "redo", UiAction::Redo, true, true, true},
      Shortcut{Key::Y, "", "", UiAction::Redo, true, true},
      Shortcut{Key::None, "", "reset all: settings, pins and bodies of the scene", UiAction::ResetAll},
      Shortcut{Key::O, "Ctrl+O", "open a file", UiAction::OpenFile, false, true},
      Shortcut{Key::S, "Ctrl+S", "save the scene (TOML)", UiAction::SaveScene, false, true},
      Shortcut{Key::None, "", "light or dark panels", UiAction::NextTheme},
      Shortcut{Key::None, "", "untangle the cloth",
               [](const session::Snapshot&) -> session::Command { return session::UntangleCommand{}; }},
      Shortcut{Key::None, "", "dress the body with the cloth", UiAction::Dress},
      Shortcut{Key::None, "", "compare the sources of error", UiAction::CompareErrors},
      Shortcut{Key::F12, "F12", "save a picture", UiAction::Screenshot},
      Shortcut{Key::E, "E", "save the cloth (OBJ)", UiAction::SaveCloth},
      Shortcut{Key::E, "Ctrl+E", "export a frame, the motion or a film", UiAction::ShowExport, false, true},
      Shortcut{Key::Help, "F1   ?", "this list", UiAction::ToggleHelp},
      Shortcut{Key::Escape, "Esc", "release, close, leave a mode, stop dressing or reading a file", UiAction::Stop},
      Shortcut{Key::Q, quitKeys, "quit", UiAction::Quit, false, true},
  };
  return table;
}

const Shortcut* findShortcut(Key key, bool control, bool shift) {
  const std::span<const Shortcut> table = shortcuts();
  const auto find = [&](bool withControl) -> const Shortcut* {
    const auto found = std::ranges::find_if(table, [&](const Shortcut& each) {
      return each.key == key && each.control == withControl && (!withControl || each.shift == shift);
    });
    return found == table.end() || key == Key::None ? nullptr : &*found;
  };
  const Shortcut* withControl = control ? find(true) : nullptr;
  return withControl != nullptr ? withControl : find(false);
}

std::string keysInWords(std::string_view keys, const text::Catalogue& texts) {
  std::string words(keys);
  const auto replace = [&](std::string_view english, const std::string& translation) {
    for (std::size_t at = words.find(english); at != std::string::npos; at = words.find(english, at)) {
      words.replace(at, english.size(), translation);
      at += translation.size();
    }
  };
  replace("Ctrl", texts("key|Ctrl"));
  replace("Shift", texts("key|Shift"));
  replace("Space", texts("key|Space"));
  replace(" to ", ' ' + texts("to") + ' ');
  return words;
}

void request(const Shortcut& shortcut, const session::Snapshot& snapshot, UiOutput& output) {
  if (const auto* action = std::get_if<UiAction>(&shortcut.action)) {
    output.requests.emplace_back(*action);
  } else {
    output.commands.push_back(std::get<session::Command (*)(const session::Snapshot&)>(shortcut.action)(snapshot));
  }
}

}  // namespace drape::ui
