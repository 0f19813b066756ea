// Another motion and another size for a figure, chosen in the window.
#include "replay.hpp"
#include "viewer_driver.hpp"

#include <gtest/gtest.h>

#include <string>

namespace drape::app {
namespace {

Json figureOf(const Json& state) {
  return state["bodies"][0]["figure"];
}

/// Chooses a motion from the list of the section Scene.
void choose(ViewerDriver& viewer, const std::string& motion) {
  viewer.click(viewer.find("body.figure.motion"));
  viewer.waitUntil("the list", [&](const Json& s) { return s["buttons"].contains("body.figure.motion=" + motion); });
  viewer.click(viewer.find("body.figure.motion=" + motion, 0.5, 0.0));
  viewer.waitUntil("the motion", [&](const Json& s) { return figureOf(s)["motion"] == motion; });
}

/// Closes the sections above the rows of the figure, so that these are in sight.
void closeSections(ViewerDriver& viewer) {
  clickHeadings(viewer, {"section.material", "section.air", "section.simulation", "section.contact"});
}

TEST(FigureInTheWindow, TakesAnotherMotionAndSizeWhileItMovesAndKeepsThem) {
  ViewerDriver viewer({"dance", "--paused"});
  closeSections(viewer);
  viewer.key("space");
  viewer.waitUntil("steps", [](const Json& s) { return s["step"] > 5; });
  EXPECT_EQ(figureOf(viewer.state())["motion"], "dance");
  choose(viewer, "squat");
  viewer.click(viewer.find("body.figure.waist", 0.9));
  const Json wide = viewer.waitUntil("the waist", [](const Json& s) { return figureOf(s).contains("waist"); });
  EXPECT_GT(figureOf(wide)["waist"], 0.9);
  EXPECT_LE(figureOf(wide)["waist"], 1.1);
  EXPECT_EQ(figureOf(wide)["motion"], "squat");
  EXPECT_FALSE(figureOf(wide).contains("hip")) << "what nobody chose stays as it is built";
  viewer.key("space");
  viewer.waitUntil("a pause", [](const Json& s) { return s["paused"].get<bool>(); });
  viewer.key("r");
  const Json again = viewer.waitUntil("the start", [](const Json& s) { return s["step"] == 0; });
  EXPECT_EQ(figureOf(again), figureOf(wide));
  viewer.key("ctrl+s");
  viewer.waitUntil("the file", [](const Json& s) {
    return s["message"].get<std::string>().find("dance-001.toml") != std::string::npos;
  });
  const std::string saved = contentOf(viewer.folder() / "dance-001.toml");
  EXPECT_NE(saved.find("motion = 'squat'"), std::string::npos) << saved;
  EXPECT_NE(saved.find("waist = "), std::string::npos) << saved;
}

TEST(FigureInTheWindow, GoesBackByUndo) {
  ViewerDriver viewer({"dance", "--paused"});
  closeSections(viewer);
  choose(viewer, "walk");
  viewer.tap("ctrl+z");
  const Json undone = viewer.waitUntil("the dance", [](const Json& s) { return figureOf(s)["motion"] == "dance"; });
  EXPECT_NE(undone["message"].get<std::string>().find("Undone: motion of figure Dance to Walk"), std::string::npos)
      << undone["message"];
}

TEST(FigureInTheWindow, IsRecordedAndReplayed) {
  const TemporaryFolder folder;
  const auto log = folder.path() / "session.json";
  ViewerDriver viewer({"dance", "--paused", "--record", log.string()});
  closeSections(viewer);
  viewer.key("space");
  viewer.waitUntil("steps", [](const Json& s) { return s["step"] > 3; });
  choose(viewer, "turn");
  const Json chosen = viewer.state();
  viewer.waitUntil("steps after it", [&](const Json& s) { return s["step"] > chosen["step"].get<int>() + 5; });
  quitWithQuestion(viewer);
  expectReplay(log);
}

}  // namespace
}  // namespace drape::app
