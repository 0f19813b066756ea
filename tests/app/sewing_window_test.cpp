// Seams and elastic bands with real mouse and keyboard: sewing, undo, saving and recording.
#include "replay.hpp"
#include "viewer_driver.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace drape::app {
namespace {

/// Two sheets side by side, each with a pinned corner at the outside.
constexpr const char* sheets = R"(
[[cloths]]
name = "left"
grid = "vertical"
position = [-0.23, 1, 0]
pins = { corners = ["top_left", "bottom_left"] }

[[cloths]]
name = "right"
grid = "vertical"
position = [0.23, 1, 0]
pins = { corners = ["top_right", "bottom_right"] }

[camera]
position = [0, 1, 2]
focal_point = [0, 1, 0]

[ground]
height = 0

[settings]
grid.resolution = 9
grid.width = 0.4
grid.height = 0.4
)";

bool isSewing(const Json& state) {
  return !state["sewing"].is_null() && !state["sewing"]["places"].empty();
}

/// The place of the border that is the farthest to the left or to the right, among those of one sheet.
/// @param isLeft whether it belongs to the left sheet
Place innerBorder(const Json& state, bool isLeft) {
  const double middle = state["view"]["x"].get<double>() + 0.5 * state["view"]["width"].get<double>();
  Place found{isLeft ? 0.0 : 1e9, 0.0};
  for (const Json& each : state["sewing"]["places"]) {
    const Place place{each["x"].get<double>(), each["y"].get<double>()};
    if (isLeft ? place.x < middle && place.x > found.x : place.x > middle && place.x < found.x) {
      found = place;
    }
  }
  return found;
}

std::string fileWith(const TemporaryFolder& folder, const char* text) {
  const auto file = folder.path() / "sheets.toml";
  std::ofstream(file) << text;
  return file.string();
}

/// Picks the two borders between the sheets.
void pickBoth(ViewerDriver& viewer) {
  viewer.key("s");
  const Json start = viewer.waitUntil("the mode", isSewing);
  viewer.move(innerBorder(start, true));
  viewer.waitUntil("the border under the mouse", [](const Json& s) { return s["sewing"]["hovers"].get<bool>(); });
  viewer.click(innerBorder(start, true));
  viewer.waitUntil("a side", [](const Json& s) { return s["sewing"]["sides"] == 1; });
  viewer.click(innerBorder(start, false));
  viewer.waitUntil("pairs", [](const Json& s) { return s["sewing"]["pairs"] == 9; });
}

TEST(SewingWindow, TwoBordersAreSewnAndWeldedAndUndoOpensThem) {
  const TemporaryFolder folder;
  ViewerDriver viewer({fileWith(folder, sheets), "--paused"});
  const Json before = viewer.state();
  pickBoth(viewer);
  viewer.click(viewer.find("button.sew"));
  viewer.waitUntil("an open seam", [](const Json& s) { return s["seams"].size() == 1 && !s["seams"][0]["welded"]; });
  viewer.key("Escape");
  viewer.waitUntil("the end of the mode", [](const Json& s) { return s["sewing"].is_null(); });
  viewer.key("space");
  const Json welded = viewer.waitUntil("a weld", [](const Json& s) { return s["seams"][0]["welded"].get<bool>(); });
  EXPECT_GT(welded["time"].get<double>(), 0.5) << "it takes about a second";
  EXPECT_EQ(welded["camera"], before["camera"]);
  viewer.tap("ctrl+z");
  const Json open = viewer.waitUntil("no seam", [](const Json& s) { return s["seams"].empty(); });
  EXPECT_TRUE(says(open, "seam added")) << open["message"];
  viewer.tap("ctrl+y");
  viewer.waitUntil("the seam again", [](const Json& s) { return s["seams"].size() == 1; });
  viewer.click(viewer.find("button.remove_seam.0"));
  viewer.waitUntil("no seam again", [](const Json& s) { return s["seams"].empty(); });
  EXPECT_TRUE(viewer.process().running());
}

TEST(SewingWindow, ABandIsSetSavedAndRecorded) {
  const TemporaryFolder folder;
  const auto log = folder.path() / "session.json";
  ViewerDriver viewer({fileWith(folder, sheets), "--paused", "--record", log.string()});
  pickBoth(viewer);
  viewer.click(viewer.find("button.sew"));
  viewer.waitUntil("a seam", [](const Json& s) { return s["seams"].size() == 1; });
  viewer.click(viewer.find("sewing.kind=band"));
  const Json bands = viewer.waitUntil("bands", [](const Json& s) { return s["sewing"]["kind"] == "band"; });
  viewer.click(innerBorder(bands, false));
  viewer.waitUntil("a side", [](const Json& s) { return s["sewing"]["sides"] == 1; });
  viewer.click(viewer.find("button.set_band"));
  viewer.waitUntil("a band", [](const Json& s) { return s["bands"].size() == 1 && s["bands"][0] == 0.8; });
  viewer.click(viewer.find("sewing.length", 0.1));
  viewer.waitUntil("a shorter band", [](const Json& s) { return s["bands"][0] < 0.7; });
  viewer.click(viewer.find("button.end_sewing"));
  viewer.waitUntil("the end of the mode", [](const Json& s) { return s["sewing"].is_null(); });
  viewer.key("space");
  viewer.waitUntil("some steps", [](const Json& s) { return s["step"] > 30; });
  viewer.tap("ctrl+s");
  viewer.waitUntil("the message", [](const Json& s) { return says(s, "Saved"); });
  const auto saved = viewer.folder() / "sheets-001.toml";
  viewer.tap("ctrl+q");
  ASSERT_EQ(viewer.process().waitFor(60.0), 0);
  expectReplay(log);
  const auto output = folder.path() / "output.txt";
  EXPECT_EQ(runToEnd({.command = {DRAPE_HEADLESS, "run", saved.string(), "--seconds", "0.1"}, .output = output}), 0)
      << contentOf(output);
  const std::string text = contentOf(saved);
  EXPECT_NE(text.find("[[seams]]"), std::string::npos) << text;
  EXPECT_NE(text.find("bands = [{ vertices = ["), std::string::npos) << text;
}

}  // namespace
}  // namespace drape::app
