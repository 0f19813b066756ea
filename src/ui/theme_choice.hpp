#pragma once

#include <array>
#include <span>
#include <string_view>

namespace drape::ui {

/// The colours of the panels.
enum class Theme { Dark, Light };

/// A theme with its name in files and its name for the user.
struct ThemeInfo {
  Theme theme;
  std::string_view name;
  std::string_view title;
};

/// All themes, in the order of the enumeration; the first is the default.
[[nodiscard]] inline std::span<const ThemeInfo> themes() {
  static constexpr std::array<ThemeInfo, 2> list{{{Theme::Dark, "dark", "Dark"}, {Theme::Light, "light", "Light"}}};
  return list;
}

}  // namespace drape::ui
