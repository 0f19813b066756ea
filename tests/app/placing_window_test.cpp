// The mode Place with real mouse and keyboard: the gizmo, undo, To ground, saving and recording.
#include "replay.hpp"
#include "viewer_driver.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <string>

namespace drape::app {
namespace {

using Point = std::array<double, 3>;

Point middleOf(const Json& state) {
  Point middle{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    middle[axis] =
        0.5 * (state["cloth_bounds"]["min"][axis].get<double>() + state["cloth_bounds"]["max"][axis].get<double>());
  }
  return middle;
}

bool isPlacing(const Json& state) {
  return !state["placing"].is_null();
}

bool isBuilt(const Json& state) {
  return isPlacing(state) && !state["placing"]["builds"].get<bool>() && state["loading"].get<std::string>().empty();
}

/// Drags a handle of the gizmo in several moves, as a hand does.
void dragHandle(ViewerDriver& viewer, const std::string& handle, double across, double down) {
  const Json grip =
      viewer.waitUntil("the handle", [&](const Json& s) { return hasButton(s, handle); })["buttons"][handle];
  const Place from{grip["x"].get<double>() + 0.5 * grip["width"].get<double>(),
                   grip["y"].get<double>() + 0.5 * grip["height"].get<double>()};
  viewer.move(from);
  viewer.press();
  viewer.move({from.x + 0.5 * across, from.y + 0.5 * down});
  viewer.move({from.x + across, from.y + down});
  viewer.release();
}

TEST(PlacingWindow, AnArrowMovesTheClothAlongItsAxisAndUndoBringsItBack) {
  ViewerDriver viewer({"grid", "--paused"});
  const Json before = viewer.state();
  viewer.key("g");
  viewer.waitUntil("the mode", isPlacing);
  dragHandle(viewer, "gizmo.x", 90.0, 12.0);
  const Json moved = viewer.waitUntil(
      "the moved cloth", [&](const Json& s) { return isBuilt(s) && middleOf(s)[0] > middleOf(before)[0] + 0.05; });
  EXPECT_NEAR(middleOf(moved)[1], middleOf(before)[1], 1e-6);
  EXPECT_NEAR(middleOf(moved)[2], middleOf(before)[2], 1e-6);
  EXPECT_EQ(moved["step"], 0);
  EXPECT_EQ(moved["pins"], before["pins"]);
  EXPECT_EQ(moved["camera"], before["camera"]) << "the drag does not turn the view";
  viewer.tap("ctrl+z");
  const Json back = viewer.waitUntil("the cloth where it was", [&](const Json& s) {
    return isBuilt(s) && std::abs(middleOf(s)[0] - middleOf(before)[0]) < 1e-9;
  });
  EXPECT_TRUE(says(back, "placement of the cloth")) << back["message"];
  viewer.click(viewer.find("button.place_on_ground"));
  const Json onGround = viewer.waitUntil("the cloth on the ground", [](const Json& s) {
    return isBuilt(s) && s["cloth_bounds"]["min"][1].get<double>() < 0.1;
  });
  const double lowest = onGround["cloth_bounds"]["min"][1];
  const double offset = 0.002 + 0.5 * onGround["settings"]["cloth_thickness"].get<double>();
  EXPECT_NEAR(lowest, offset, 3e-6);
  EXPECT_GE(lowest, offset - 1e-8);
  viewer.key("Escape");
  viewer.waitUntil("the end of the mode", [](const Json& s) { return !isPlacing(s); });
  EXPECT_TRUE(viewer.process().running());
}

TEST(PlacingWindow, TheBoxIsDraggedByItsBackgroundAndTheViewStays) {
  ViewerDriver viewer({"grid", "--paused"});
  viewer.key("g");
  const Json before =
      viewer.waitUntil("the box", [](const Json& s) { return isPlacing(s) && hasButton(s, "overlay.placing"); });
  const Json& box = before["buttons"]["overlay.placing"];
  const Place from{box["x"].get<double>() + box["width"].get<double>() - 4.0, box["y"].get<double>() + 4.0};
  viewer.move(from);
  viewer.press();
  viewer.move({from.x + 40.0, from.y + 30.0});
  viewer.move({from.x + 80.0, from.y + 60.0});
  viewer.release();
  const Json after = viewer.waitUntil("the box in another place", [&](const Json& s) {
    return hasButton(s, "overlay.placing") &&
           std::abs(s["buttons"]["overlay.placing"]["x"].get<double>() - box["x"].get<double>() - 80.0) < 1.0;
  });
  EXPECT_NEAR(after["buttons"]["overlay.placing"]["y"].get<double>(), box["y"].get<double>() + 60.0, 1.0);
  EXPECT_EQ(after["camera"], before["camera"]);
}

TEST(PlacingWindow, PinsOfTheUserStayAndOneUndoTakesBackThePlacementAlone) {
  ViewerDriver viewer({"grid", "--paused"});
  viewer.key("l");
  viewer.click(viewer.onCloth());
  const Json border = viewer.waitUntil("the border", [](const Json& s) { return s["selection"]["vertices"] > 0; });
  viewer.key("p");
  const Json pinned =
      viewer.waitUntil("the pins", [&](const Json& s) { return s["pins"] == border["selection"]["vertices"]; });
  viewer.key("g");
  viewer.waitUntil("the mode", isPlacing);
  dragHandle(viewer, "gizmo.y", 0.0, -60.0);
  const Json moved = viewer.waitUntil("the moved cloth", [&](const Json& s) {
    return isBuilt(s) && middleOf(s)[1] > middleOf(pinned)[1] + 0.05 && s["pins"] == pinned["pins"];
  });
  viewer.tap("ctrl+z");
  viewer.waitUntil("the cloth where it was, with its pins", [&](const Json& s) {
    return isBuilt(s) && std::abs(middleOf(s)[1] - middleOf(pinned)[1]) < 1e-9 && s["pins"] == pinned["pins"];
  });
  viewer.tap("ctrl+y");
  viewer.waitUntil("the placement again", [&](const Json& s) {
    return isBuilt(s) && std::abs(middleOf(s)[1] - middleOf(moved)[1]) < 1e-9 && s["pins"] == pinned["pins"];
  });
}

TEST(PlacingWindow, ABodyIsChosenByAClickTurnedScaledAndSaved) {
  ViewerDriver viewer({"table_runner", "--paused"});
  const Json before = viewer.state();
  viewer.key("g");
  viewer.waitUntil("the mode", isPlacing);
  viewer.click(viewer.find("placing.thing"));
  viewer.click(viewer.find("placing.thing=table"));
  viewer.waitUntil("the table", [](const Json& s) { return s["placing"]["thing"] == "table"; });
  viewer.key("g");
  viewer.waitUntil("the rings", [](const Json& s) { return s["placing"]["tool"] == "turn"; });
  dragHandle(viewer, "gizmo.turn_y", 40.0, 10.0);
  viewer.waitUntil("the turned table", [](const Json& s) {
    return isBuilt(s) && std::abs(s["placing"]["rotation"][1].get<double>()) > 2.0;
  });
  viewer.key("g");
  viewer.waitUntil("the knob", [](const Json& s) { return s["placing"]["tool"] == "scale"; });
  dragHandle(viewer, "gizmo.size", 30.0, -30.0);
  const Json scaled =
      viewer.waitUntil("the larger table", [](const Json& s) { return isBuilt(s) && s["placing"]["scale"] > 1.1; });
  EXPECT_EQ(scaled["cloth_bounds"], before["cloth_bounds"]) << "the cloths stay";
  viewer.key("Escape");
  viewer.tap("ctrl+s");
  viewer.waitUntil("the message", [](const Json& s) { return says(s, "Saved"); });
  const std::string text = contentOf(viewer.folder() / "table_runner-001.toml");
  EXPECT_NE(text.find("placement = {"), std::string::npos) << text;
}

TEST(PlacingWindow, ARecordedSessionReplaysAPlacement) {
  const TemporaryFolder folder;
  const auto log = folder.path() / "session.json";
  ViewerDriver viewer({"sphere", "--record", log.string()});
  viewer.waitUntil("some steps", [](const Json& s) { return s["step"] > 5; });
  viewer.key("g");
  viewer.waitUntil("the mode", [](const Json& s) { return isPlacing(s) && s["paused"].get<bool>(); });
  dragHandle(viewer, "gizmo.x", 50.0, 0.0);
  viewer.waitUntil("the moved cloth", [](const Json& s) { return isBuilt(s) && s["step"] == 0; });
  viewer.key("Escape");
  viewer.waitUntil("steps after it", [](const Json& s) { return !s["paused"].get<bool>() && s["step"] > 20; });
  quitWithQuestion(viewer);
  EXPECT_NE(contentOf(log).find("\"placements\""), std::string::npos);
  expectReplay(log);
}

}  // namespace
}  // namespace drape::app
