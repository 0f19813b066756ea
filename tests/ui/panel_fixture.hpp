#pragma once

#include "session/simulation.hpp"
#include "ui/user_interface.hpp"

#include <gtest/gtest.h>

#include <string>

namespace drape {

/// The panels over a small simulation, with a mouse and a keyboard that a test moves. Nothing is drawn.
class PanelFixture : public ::testing::Test {
 protected:
  explicit PanelFixture(const char* scene = "grid");

  /// Lays out one frame and gives what the user asked for in it.
  UiOutput frame();
  /// The same a few times, so that what takes a frame to settle has settled.
  void settle();
  /// Hands commands to the simulation, as the viewer would.
  void apply(const UiOutput& output);

  void moveTo(const UiRect& rect, double across = 0.5);
  /// Presses and lets go, a frame each.
  UiOutput click(const UiRect& rect, double across = 0.5, int button = 0);
  /// Presses at one place of a widget, moves to another and lets go. Gives everything that was asked for on the way.
  UiOutput drag(const UiRect& rect, double from, double to);
  /// Ctrl+click, the text, Enter.
  UiOutput typeInto(const UiRect& rect, const std::string& text);

  [[nodiscard]] const UiRect& widget(const std::string& key) const { return panels_.widgets().at(key); }
  [[nodiscard]] const UiRect& button(const std::string& name) const { return panels_.buttons().at(name); }

  Simulation simulation_;
  Snapshot snapshot_;
  UiStats stats_;
  UserInterface panels_;
};

/// Adds what the second asked for to the first.
void append(UiOutput& all, UiOutput more);

/// The value of the last command that sets `key`; fails the test when there is none.
SettingValue lastValue(const UiOutput& output, const std::string& key);

}  // namespace drape
