#pragma once

#include "session/snapshot.hpp"
#include "text/catalogue.hpp"
#include "ui/ui_output.hpp"

#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace drape::ui {

/// The keys with an action. None: a command without a key, which the search finds.
enum class Key {
  None,
  Space,
  Period,
  Comma,
  Slash,
  One,
  Three,
  Five,
  Seven,
  B,
  E,
  F,
  G,
  H,
  L,
  O,
  P,
  Q,
  R,
  S,
  T,
  W,
  Y,
  Z,
  Help,
  F5,
  F6,
  F7,
  F8,
  F12,
  Escape
};

/// A command with its key, declared once. The keyboard, the list of keys in the window and the search read it here.
struct Shortcut {
  Key key;
  std::string_view keys;  ///< in the list of keys; empty: it has no key, or the entry of another key names it
  std::string_view help;  ///< what it does; empty: the same as the entry of another key
  std::variant<UiAction, session::Command (*)(const session::Snapshot& snapshot)> action;
  bool repeats = false;  ///< whether a held key repeats it
  bool control = false;  ///< whether Ctrl must be held
  bool shift = false;    ///< with Ctrl: whether Shift must be held too
};

/// The keys that quit, as the list of keys names them.
inline constexpr std::string_view quitKeys = "Ctrl+Q";

/// All of them, in the order of the list of keys.
[[nodiscard]] std::span<const Shortcut> shortcuts();

/// The shortcut of a key, or nullptr. With Ctrl, a key without a shortcut of its own acts as without Ctrl.
[[nodiscard]] const Shortcut* findShortcut(Key key, bool control = false, bool shift = false);

/// The keys of a shortcut in the language of the window: "Strg+Z".
[[nodiscard]] std::string keysInWords(std::string_view keys, const text::Catalogue& texts);

/// Adds the command or the action of a shortcut to `output`.
void request(const Shortcut& shortcut, const session::Snapshot& snapshot, UiOutput& output);

}  // namespace drape::ui
