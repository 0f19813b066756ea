// Tests of the first minute of a new user with the window.
#include "viewer_driver.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

namespace drape::app {
namespace {

using Vector = std::array<double, 3>;

std::string status(const Json& state) {
  return state["status"].get<std::string>();
}

void drag(ViewerDriver& viewer, const Place& from, const Place& to, int button = 1) {
  viewer.move(from);
  viewer.press(button);
  viewer.move({0.5 * (from.x + to.x), 0.5 * (from.y + to.y)});
  viewer.move(to);
}

TEST(FirstMinute, ThePictureSaysWhatToDoUntilTheFirstDrag) {
  ViewerDriver viewer({"grid", "--paused"});
  EXPECT_TRUE(hasButton(viewer.state(), "hint.drag"));
  const Place place = viewer.onCloth();
  drag(viewer, place, {place.x + 20.0, place.y});
  viewer.waitUntil("no hint", [](const Json& s) { return isAttached(s) && !hasButton(s, "hint.drag"); });
  viewer.release();
  EXPECT_FALSE(hasButton(viewer.frames(), "hint.drag"));
}

TEST(FirstMinute, TheStatusLineSpeaksOfTheClothAndAClickOnItOfTheSolver) {
  ViewerDriver viewer({"skirt", "--paused"});
  const std::string words = status(viewer.state());
  EXPECT_NE(words.find("vertices"), std::string::npos) << words;
  EXPECT_NE(words.find("paused"), std::string::npos) << words;
  viewer.click(viewer.find("status.facts", 0.1));
  viewer.waitUntil("the details", [](const Json& s) { return hasButton(s, "status.details"); });
  viewer.key("Escape");
  viewer.waitUntil("no details", [](const Json& s) { return !hasButton(s, "status.details"); });
  EXPECT_TRUE(viewer.process().running()) << "Esc closed the details and nothing else";
}

TEST(FirstMinute, TheStatusLineSaysThatTheClockIsTooSlow) {
  // Too slow for any machine.
  ViewerDriver viewer({"grid", "--set", "grid.resolution=33", "--set", "solver=newton", "--set", "substeps=30"});
  viewer.waitUntil("the pace",
                   [](const Json& s) { return status(s).find("real time: too slow") != std::string::npos; });
}

TEST(FirstMinute, MaterialAndAirAreInSightInAnOrdinaryWindow) {
  ViewerDriver viewer({}, "1440,900");
  const Json state = viewer.state();
  for (const char* key : {"material.preset", "drag", "lift", "wind.x", "wind.y", "wind.z"}) {
    ASSERT_TRUE(state["widgets"].contains(key)) << key;
    const Json& row = state["widgets"][key];
    EXPECT_TRUE(row["visible"].get<bool>()) << key;
    EXPECT_LE(row["y"].get<double>() + row["height"].get<double>(), state["view"]["height"].get<double>()) << key;
  }
  EXPECT_FALSE(state["widgets"].contains("solver")) << "numerical settings are in Advanced, which is closed";
}

TEST(FirstMinute, QuittingAsksBeforeChangesAreLost) {
  ViewerDriver viewer({"grid", "--paused", "--set", "drag=0.5"});
  viewer.click(viewer.find("drag", 0.6));
  viewer.waitUntil("a change", [](const Json& s) { return s["settings"]["drag"] != 0.5; });
  viewer.key("ctrl+q");
  viewer.waitUntil("the question", [](const Json& s) { return hasButton(s, "overlay.quit"); });
  viewer.key("Escape");
  viewer.waitUntil("no question", [](const Json& s) { return !hasButton(s, "overlay.quit"); });
  EXPECT_TRUE(viewer.process().running());
  quitWithQuestion(viewer);
}

TEST(FirstMinute, EscapeSaysHowToQuitWhereNothingIsOpen) {
  ViewerDriver viewer({"grid", "--set", "drag=0.5"});
  viewer.tap("Escape");
  viewer.waitUntil("the notice", [](const Json& s) { return says(s, "Ctrl+Q quits"); });
  EXPECT_TRUE(viewer.process().running());
}

TEST(FirstMinute, CtrlQQuitsAtOnceWhereNothingIsLost) {
  ViewerDriver viewer({"grid", "--set", "drag=0.5"});
  viewer.waitUntil("time to pass", [](const Json& s) { return s["step"] > 5; });
  viewer.tap("ctrl+q");
  EXPECT_EQ(viewer.process().waitFor(60.0), 0);
}

TEST(FirstMinute, CtrlQQuitsWhileATextIsTyped) {
  ViewerDriver viewer({"grid", "--paused"});
  viewer.key("ctrl+p");
  viewer.waitUntil("the search", [](const Json& s) { return hasButton(s, "overlay.search"); });
  viewer.tap("ctrl+q");
  EXPECT_EQ(viewer.process().waitFor(60.0), 0);
}

TEST(FirstMinute, ARightClickAndResetAllRestoreTheValuesOfTheScene) {
  ViewerDriver viewer({"flag"});
  const Json scene = viewer.state()["settings"];
  ASSERT_NE(scene["wind.x"], 0.0) << "the scene flag has wind";
  viewer.click(viewer.find("wind.x", 0.2));
  viewer.waitUntil("another wind", [&](const Json& s) { return s["settings"]["wind.x"] != scene["wind.x"]; });
  viewer.click(viewer.find("wind.x"), 3);
  viewer.waitUntil("the scene's wind", [&](const Json& s) { return s["settings"]["wind.x"] == scene["wind.x"]; });
  viewer.click(viewer.find("wind.x", 0.2));
  viewer.click(viewer.find("drag", 0.9));
  viewer.click(viewer.find("grid.resolution", 0.3));
  viewer.waitUntil("another mesh", [&](const Json& s) {
    return s["settings"]["grid.resolution"] != scene["grid.resolution"] && s["loading"] == "" &&
           s["settings"]["drag"] != scene["drag"];
  });
  viewer.click(viewer.find("button.reset_all"));
  const Json restored =
      viewer.waitUntil("the scene's own settings", [&](const Json& s) { return s["settings"] == scene; });
  EXPECT_EQ(restored["message"], "");
}

/// The bytes of the picture that F12 saves.
std::string pictureOf(const std::vector<std::string>& arguments) {
  ViewerDriver viewer(arguments);
  EXPECT_GT(viewer.state()["pins"], 0);
  viewer.key("F12");
  viewer.waitUntil("the picture",
                   [](const Json& s) { return s["message"].get<std::string>().find("grid-001") != std::string::npos; });
  std::ifstream stream(viewer.folder() / "grid-001.png", std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return bytes.str();
}

TEST(FirstMinute, PinsAreNotInThePicturesOfF12) {
  const std::string shown = pictureOf({"grid", "--paused"});
  const std::string hidden = pictureOf({"grid", "--paused", "--set", "view.pins=off"});
  EXPECT_FALSE(shown.empty());
  EXPECT_TRUE(shown == hidden) << "the two pictures differ";
}

TEST(FirstMinute, TheCameraStaysAboveTheGroundAndNearTheCloth) {
  ViewerDriver viewer({"grid", "--paused"});
  const Place free = viewer.besideCloth();
  drag(viewer, free, {free.x, 20.0});
  drag(viewer, free, {free.x, 20.0});
  viewer.release();
  EXPECT_GT(viewer.frames()["camera"]["position"].get<Vector>()[1], 0.0);
  viewer.move(free);
  for (int i = 0; i < 60; ++i) {
    viewer.send({"click", "5"});
  }
  const Json far = viewer.frames();
  const auto eye = far["camera"]["position"].get<Vector>();
  EXPECT_LT(std::hypot(eye[0], eye[1], eye[2]), 25.0);
}

TEST(FirstMinute, AShortTapOfReturnCountsHoweverSlowTheFrames) {
  ViewerDriver viewer({"grid", "--paused"});
  viewer.move(viewer.find("drag"));
  viewer.holdKey("Control_L");
  viewer.press();
  viewer.release();
  viewer.letKeyGo("Control_L");
  viewer.betweenTwoFrames({{"type", "1.7"}, {"key", "BackSpace"}, {"type", "25"}, {"key", "Return"}});
  viewer.waitUntil("the typed value", [](const Json& s) { return s["settings"]["drag"] == 1.25; });
}

TEST(FirstMinute, AClickBetweenTwoFramesCounts) {
  ViewerDriver viewer({"grid", "--paused"});
  const Place play = viewer.find("button.play");
  viewer.betweenTwoFrames({{"mousemove", std::to_string(std::lround(play.x)), std::to_string(std::lround(play.y))},
                           {"click", "1"},
                           {"mousemove", "800", "400"}});
  viewer.waitUntil("the clock to run", [](const Json& s) { return !s["paused"].get<bool>(); });
}

TEST(FirstMinute, ADragGoesOnBeyondTheWindowAndEndsThere) {
  // A window that is smaller than the display.
  ViewerDriver viewer({"curtain", "--paused"});
  viewer.resize(900, 600);
  // Without a window manager the keyboard focus follows the mouse, unless it is set explicitly.
  viewer.send({"search", "--onlyvisible", "--name", "Drape", "windowfocus"});
  viewer.frames();
  const Place place = viewer.onCloth();
  drag(viewer, place, {1250.0, 780.0});
  const Json outside = viewer.waitUntil(
      "the attachment", [](const Json& s) { return isAttached(s) && s["attachment"]["distance"] > 0.1; });
  viewer.release();
  viewer.waitUntil("the mouse to let go", [](const Json& s) { return !isAttached(s); });
  EXPECT_EQ(outside["step"], 0);
}

TEST(FirstMinute, ResizingKeepsThePanelsUsable) {
  ViewerDriver viewer({"grid", "--paused"});
  for (const auto& [width, height] : {std::pair(640, 400), std::pair(1280, 760)}) {
    viewer.resize(width, height);
    const Json state = viewer.frames();
    EXPECT_NEAR(state["view"]["x"].get<double>() + state["view"]["width"].get<double>(), width, 1.0);
    EXPECT_LT(state["view"]["height"].get<double>(), height);
  }
  viewer.click(viewer.find("button.play"));
  viewer.waitUntil("the clock to run", [](const Json& s) { return !s["paused"].get<bool>(); });
}

TEST(FirstMinute, AHiddenWindowComesBack) {
  ViewerDriver viewer({"grid"});
  viewer.send({"search", "--name", "Drape", "windowunmap"});
  viewer.send({"search", "--name", "Drape", "windowmap"});
  const Json back = viewer.frames();
  viewer.waitUntil("time to pass", [&](const Json& s) { return s["step"] > back["step"]; });
  EXPECT_TRUE(viewer.process().running());
}

TEST(FirstMinute, TheTimeUntilTheFirstFrameIsReported) {
  ViewerDriver viewer({"grid", "--paused"});
  const double seconds = viewer.state()["first_frame_seconds"];
  EXPECT_GT(seconds, 0.0);
  EXPECT_LT(seconds, 120.0) << "it counts from the start of the program, not of the machine";
}

TEST(FirstMinute, AnErrorCanBeReadToItsEndAndClosed) {
  ViewerDriver viewer({"grid", "--paused"});
  viewer.click(viewer.find("scene.path"));
  viewer.type("/no/such/folder/with-a-very-long-name-that-does-not-fit-into-any-line/shirt.obj");
  const Json failed = viewer.waitUntil("the notice", [](const Json& s) { return hasButton(s, "overlay.error"); });
  const Json notice = viewer.frames()["buttons"]["overlay.error"];
  EXPECT_LE(notice["x"].get<double>() + notice["width"].get<double>(), failed["window"]["width"].get<double>());
  viewer.click(viewer.find("button.close"));
  viewer.waitUntil("no notice", [](const Json& s) { return !hasButton(s, "overlay.error"); });
}

}  // namespace
}  // namespace drape::app
