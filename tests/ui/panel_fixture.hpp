#pragma once

#include "session/simulation.hpp"
#include "ui/user_interface.hpp"

#include <gtest/gtest.h>

#include <string>

namespace drape::ui {

/// The panels of a small simulation, with simulated mouse and keyboard. Nothing is drawn.
class PanelFixture : public ::testing::Test {
 protected:
  explicit PanelFixture(const char* scene = "grid");

  /// Lays out one frame and returns the user's requests.
  UiOutput frame();
  /// The same several times, until the layout is stable.
  void settle();
  /// Passes commands to the simulation, as the viewer does.
  void apply(const UiOutput& output);

  void moveTo(const UiRect& rect, double across = 0.5);
  /// Press and release, with a frame for each.
  UiOutput click(const UiRect& rect, double across = 0.5, int button = 0);
  /// Presses at one position of a widget, moves to another and releases. Returns all requests.
  UiOutput drag(const UiRect& rect, double from, double to);
  /// Ctrl+click, the text, Enter.
  UiOutput typeInto(const UiRect& rect, const std::string& text);

  [[nodiscard]] const UiRect& widget(const std::string& key) const { return panels_.widgets().at(key); }
  [[nodiscard]] const UiRect& button(const std::string& name) const { return panels_.buttons().at(name); }

  session::Simulation simulation_;
  session::Snapshot snapshot_;
  UiStats stats_;
  UserInterface panels_;
};

/// Appends the requests of the second to the first.
void append(UiOutput& all, UiOutput more);

/// The value of the last command that sets `key`; fails the test when there is none.
settings::SettingValue lastValue(const UiOutput& output, const std::string& key);

}  // namespace drape::ui
