#pragma once

#include "session/snapshot.hpp"
#include "ui/ui_output.hpp"

#include <span>
#include <string_view>
#include <variant>

namespace drape::ui {

/// The keys with an action.
enum class Key { Space, Period, One, Three, Seven, F, H, P, R, W, Help, F12, Escape };

/// A key and its action, declared once. The keyboard and the list of keys in the window read it here.
struct Shortcut {
  Key key;
  std::string_view keys;  ///< in the list of keys; empty: the entry of another key names it
  std::string_view help;  ///< what they do
  std::variant<UiAction, session::Command (*)(const session::Snapshot& snapshot)> action;
  bool repeats = false;  ///< whether a held key repeats it
};

/// All of them, in the order of the list of keys.
[[nodiscard]] std::span<const Shortcut> shortcuts();

/// The shortcut of a key.
[[nodiscard]] const Shortcut& shortcutOf(Key key);

}  // namespace drape::ui
