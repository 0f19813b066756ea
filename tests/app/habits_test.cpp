// Tests of what people reach for in the window: undo, search, saving, preferences, the file dialog.
#include "viewer_driver.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace drape::app {
namespace {

void writeFile(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

/// Drags a slider in several moves, as a hand does.
void dragSlider(ViewerDriver& viewer, const std::string& name, double from, double to) {
  const Place start = viewer.find(name, from);
  const Place end = viewer.find(name, to);
  viewer.move(start);
  viewer.press();
  for (const double share : {0.3, 0.6, 1.0}) {
    viewer.move({start.x + share * (end.x - start.x), start.y});
  }
  viewer.release();
}

TEST(Undo, CtrlZTakesBackADragAndCtrlShiftZRepeatsIt) {
  ViewerDriver viewer({"grid", "--paused", "--set", "drag=0.5", "--set", "lift=0.25"});
  dragSlider(viewer, "drag", 0.2, 0.8);
  const double dragged =
      viewer.waitUntil("another drag", [](const Json& s) { return s["settings"]["drag"] > 5.0; })["settings"]["drag"];
  viewer.click(viewer.find("lift", 0.7));
  const double lifted =
      viewer.waitUntil("another lift", [](const Json& s) { return s["settings"]["lift"] != 0.25; })["settings"]["lift"];
  viewer.tap("ctrl+z");
  viewer.waitUntil("the lift to be back",
                   [](const Json& s) { return s["settings"]["lift"] == 0.25 && says(s, "Undone: Lift 0.25 to "); });
  viewer.tap("ctrl+z");
  viewer.waitUntil("the drag to be back in one step",
                   [](const Json& s) { return s["settings"]["drag"] == 0.5 && says(s, "Undone: Drag 0.5 to "); });
  viewer.tap("ctrl+z");
  viewer.waitUntil("a message", [](const Json& s) { return says(s, "nothing to undo"); });
  viewer.tap("ctrl+shift+z");
  viewer.waitUntil("the drag again", [&](const Json& s) { return s["settings"]["drag"] == dragged; });
  viewer.tap("ctrl+y");
  viewer.waitUntil("the lift again",
                   [&](const Json& s) { return s["settings"]["lift"] == lifted && says(s, "Redone: Lift"); });
}

TEST(Undo, TakesBackPinsAndTheMeshOfAGrid) {
  ViewerDriver viewer({"grid", "--paused"});
  const int pins = viewer.state()["pins"];
  viewer.move(viewer.onCloth());
  viewer.press();
  viewer.waitUntil("the attachment", [](const Json& s) { return !s["attachment"].is_null(); });
  viewer.key("p");
  viewer.release();
  viewer.waitUntil("another pin", [&](const Json& s) { return s["pins"] == pins + 1 && s["attachment"].is_null(); });
  const int vertices = viewer.state()["vertices"];
  viewer.click(viewer.find("grid.resolution", 0.2));
  viewer.waitUntil("another mesh", [&](const Json& s) { return s["vertices"] != vertices && s["loading"] == ""; });
  viewer.tap("ctrl+z");
  viewer.waitUntil("the first mesh with the user's pin",
                   [&](const Json& s) { return s["vertices"] == vertices && s["pins"] == pins + 1; });
  viewer.tap("ctrl+z");
  viewer.waitUntil("the pins of the scene", [&](const Json& s) { return s["pins"] == pins; });
  viewer.tap("ctrl+y");
  viewer.waitUntil("the pin again", [&](const Json& s) { return s["pins"] == pins + 1; });
}

TEST(Undo, TakesBackResetAll) {
  ViewerDriver viewer({"flag", "--paused", "--set", "drag=1.5"});
  viewer.click(viewer.find("button.reset_all"));
  viewer.waitUntil("the scene's drag", [](const Json& s) { return s["settings"]["drag"] != 1.5; });
  viewer.tap("ctrl+z");
  viewer.waitUntil("the user's drag", [](const Json& s) { return s["settings"]["drag"] == 1.5; });
}

TEST(Undo, ARightClickOnTheScenesValueSetsTheDefault) {
  ViewerDriver viewer({"flag", "--paused"});
  const Json scene = viewer.state()["settings"];
  viewer.click(viewer.find("wind.x"), 3);
  viewer.waitUntil("the default", [](const Json& s) { return s["settings"]["wind.x"] == 0.0; });
  viewer.click(viewer.find("wind.x"), 3);
  viewer.waitUntil("the scene's", [&](const Json& s) { return s["settings"]["wind.x"] == scene["wind.x"]; });
}

TEST(SearchBox, FindsASettingByTypingAndShowsIt) {
  ViewerDriver viewer({"grid", "--paused"});
  EXPECT_FALSE(viewer.state()["widgets"].contains("time_step")) << "Advanced is closed";
  viewer.key("ctrl+p");
  viewer.waitUntil("the search", [](const Json& s) { return hasButton(s, "overlay.search"); });
  viewer.type("time st");
  const Json shown = viewer.waitUntil("the setting", [](const Json& s) {
    return !hasButton(s, "overlay.search") && s["widgets"].contains("time_step") &&
           s["widgets"]["time_step"]["visible"].get<bool>();
  });
  EXPECT_EQ(shown["pins"], viewer.state()["pins"]) << "the letters were no shortcuts";
}

TEST(SearchBox, SlashOpensItAndTheMouseOpensAScene) {
  ViewerDriver viewer({"grid", "--paused"});
  viewer.key("slash");
  viewer.waitUntil("the search", [](const Json& s) { return hasButton(s, "overlay.search"); });
  viewer.send({"type", "flag"});
  viewer.waitUntil("the scene", [](const Json& s) { return hasButton(s, "search.flag"); });
  viewer.click(viewer.find("search.flag", 0.3));
  viewer.waitUntil("the flag", [](const Json& s) { return s["scene"] == "flag"; });
}

TEST(SearchBox, LosesNoLetterHoweverSlowTheFrames) {
  ViewerDriver viewer({"grid", "--paused"});
  viewer.betweenTwoFrames({{"key", "ctrl+p"}, {"type", "wind.z"}});
  viewer.waitUntil("only the setting",
                   [](const Json& s) { return hasButton(s, "search.wind.z") && !hasButton(s, "search.wind.x"); });
}

TEST(SearchBox, EscapeClosesItAndNothingElse) {
  ViewerDriver viewer({"grid", "--paused"});
  viewer.key("ctrl+p");
  viewer.waitUntil("the search", [](const Json& s) { return hasButton(s, "overlay.search"); });
  viewer.key("Escape");
  viewer.waitUntil("no search", [](const Json& s) { return !hasButton(s, "overlay.search"); });
  EXPECT_TRUE(viewer.process().running());
}

TEST(SavedScene, OpensToTheSameSettingsAndPins) {
  ViewerDriver viewer({"grid", "--paused", "--set", "drag=0.5"});
  viewer.click(viewer.find("lift", 0.7));
  const Json changed = viewer.waitUntil("a change", [](const Json& s) { return s["settings"]["lift"] != 0.0; });
  viewer.key("ctrl+s");
  viewer.waitUntil("the message", [](const Json& s) { return says(s, "grid-001.toml"); });
  EXPECT_TRUE(std::filesystem::exists(viewer.folder() / "grid-001.toml"));
  viewer.click(viewer.find("scene.path"));
  viewer.type("grid-001.toml");
  const Json opened = viewer.waitUntil("the saved scene", [](const Json& s) { return s["scene"] == "grid-001"; });
  EXPECT_EQ(opened["settings"], changed["settings"]);
  EXPECT_EQ(opened["pins"], changed["pins"]);
}

TEST(SavedScene, OpensToTheSameView) {
  ViewerDriver viewer({"grid", "--paused"});
  viewer.key("3");
  viewer.key("5");
  const Json kept =
      viewer.waitUntil("the view", [](const Json& s) { return s["camera"]["orthographic"].get<bool>(); })["camera"];
  viewer.key("ctrl+s");
  viewer.waitUntil("the message", [](const Json& s) { return says(s, "grid-001.toml"); });
  viewer.click(viewer.find("scene.path"));
  viewer.type("grid-001.toml");
  const Json opened =
      viewer.waitUntil("the saved scene", [](const Json& s) { return s["scene"] == "grid-001"; })["camera"];
  EXPECT_TRUE(opened["orthographic"].get<bool>());
  for (const std::size_t axis : {0, 1, 2}) {
    EXPECT_NEAR(opened["position"][axis].get<double>(), kept["position"][axis].get<double>(), 1e-6);
    EXPECT_NEAR(opened["focal_point"][axis].get<double>(), kept["focal_point"][axis].get<double>(), 1e-6);
  }
}

TEST(SavedScene, ReplacesNoFileWithoutAsking) {
  ViewerDriver viewer({"grid", "--paused"});
  writeFile(viewer.folder() / "mine.toml", "precious");
  viewer.click(viewer.find("scene.save"));
  viewer.type("mine");
  viewer.waitUntil("the question", [](const Json& s) { return hasButton(s, "overlay.replace"); });
  viewer.key("Escape");
  viewer.waitUntil("no question", [](const Json& s) { return !hasButton(s, "overlay.replace"); });
  EXPECT_EQ(contentOf(viewer.folder() / "mine.toml"), "precious");
  viewer.click(viewer.find("scene.save.button"));
  viewer.waitUntil("the question", [](const Json& s) { return hasButton(s, "overlay.replace"); });
  viewer.click(viewer.find("button.replace"));
  viewer.waitUntil("the message", [](const Json& s) { return says(s, "Saved"); });
  EXPECT_NE(contentOf(viewer.folder() / "mine.toml").find("[cloth]"), std::string::npos);
}

TEST(SavedScene, IsNoChangeThatQuittingLoses) {
  ViewerDriver viewer({"grid", "--paused"});
  viewer.click(viewer.find("drag", 0.6));
  viewer.waitUntil("a change", [](const Json& s) { return s["settings"]["drag"] != 0.0; });
  viewer.key("ctrl+s");
  viewer.waitUntil("the message", [](const Json& s) { return says(s, "Saved"); });
  viewer.tap("ctrl+q");
  EXPECT_EQ(viewer.process().waitFor(60.0), 0);
}

/// The file of the preferences in the folder of a test.
std::filesystem::path preferencesIn(const std::filesystem::path& folder) {
  return folder / "state" / "drape" / "window.json";
}

TEST(Preferences, KeepThemeSectionsSizeAndRecentFiles) {
  const TemporaryFolder home;
  writeFile(home.path() / "own.toml", "[cloth]\ngrid = \"vertical\"\n");
  {
    ViewerDriver viewer({"grid", "--paused"}, DriverOptions{.windowSize = false, .home = home.path()});
    viewer.resize(1000, 640);
    viewer.click(viewer.find("section.view"));
    viewer.click(viewer.find("theme=light"));
    viewer.click(viewer.find("scene.path"));
    viewer.type((home.path() / "own.toml").string());
    viewer.waitUntil("the scene", [](const Json& s) { return s["scene"] == "own"; });
    viewer.tap("ctrl+q");
    EXPECT_EQ(viewer.process().waitFor(60.0), 0);
  }
  const Json kept = Json::parse(contentOf(preferencesIn(home.path())));
  EXPECT_EQ(kept["theme"], "light");
  EXPECT_EQ(kept["sections"]["View"], true);
  ViewerDriver viewer({"grid", "--paused"}, DriverOptions{.windowSize = false, .home = home.path()});
  const Json again = viewer.waitUntil("the size", [](const Json& s) { return s["window"]["width"] == 1000; });
  EXPECT_EQ(again["window"]["height"], 640);
  EXPECT_EQ(again["theme"], "light");
  EXPECT_TRUE(again["widgets"].contains("view.wireframe")) << "the section is open";
  viewer.click(viewer.find("recent"));
  viewer.click(viewer.find("recent=" + (home.path() / "own.toml").string()));
  viewer.waitUntil("the recent file", [](const Json& s) { return s["scene"] == "own"; });
}

TEST(Preferences, ADamagedFileIsReportedAndKeptUntilSomethingChanges) {
  const TemporaryFolder home;
  const std::filesystem::path file = preferencesIn(home.path());
  writeFile(file, "{ \"theme\": ");
  ViewerDriver viewer({"grid", "--paused"}, DriverOptions{.home = home.path()});
  viewer.waitUntil("the message", [&](const Json& s) { return says(s, file.string()) && says(s, "damaged"); });
  viewer.frames(40);
  EXPECT_EQ(contentOf(file), "{ \"theme\": ");
  viewer.click(viewer.find("section.view"));
  viewer.tap("Escape");
  viewer.tap("ctrl+q");
  EXPECT_EQ(viewer.process().waitFor(60.0), 0);
  EXPECT_EQ(Json::parse(contentOf(file))["sections"]["View"], true);
}

TEST(Preferences, AreNeitherReadNorWrittenWithNoSettings) {
  const TemporaryFolder home;
  const std::filesystem::path file = preferencesIn(home.path());
  writeFile(file, "{ \"theme\": \"light\" }");
  ViewerDriver viewer({"grid", "--paused", "--no-settings"}, DriverOptions{.home = home.path()});
  EXPECT_EQ(viewer.state()["theme"], "dark");
  viewer.click(viewer.find("section.view"));
  viewer.tap("ctrl+q");
  EXPECT_EQ(viewer.process().waitFor(60.0), 0);
  EXPECT_EQ(contentOf(file), "{ \"theme\": \"light\" }");
}

/// A program that stands for zenity, in a folder for PATH.
void writeZenity(const std::filesystem::path& folder, const std::string& script) {
  const std::filesystem::path file = folder / "programs" / "zenity";
  writeFile(file, "#!/bin/sh\n" + script);
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
}

TEST(FileDialog, OpensTheChosenFile) {
  const TemporaryFolder home;
  writeFile(home.path() / "own scene.toml", "[cloth]\ngrid = \"vertical\"\n");
  writeZenity(home.path(), "while ! test -e '" + (home.path() / "go").string() + "'; do sleep 0.05; done\necho '" +
                               (home.path() / "own scene.toml").string() + "'\n");
  ViewerDriver viewer({"grid"}, DriverOptions{.home = home.path(), .programs = home.path() / "programs"});
  viewer.key("ctrl+o");
  const Json before = viewer.frames();
  viewer.waitUntil("time to pass while the dialog is open", [&](const Json& s) { return s["step"] > before["step"]; });
  writeFile(home.path() / "go", "");
  viewer.waitUntil("the scene", [](const Json& s) { return s["scene"] == "own scene"; });
}

TEST(FileDialog, CancelledOpensNothing) {
  const TemporaryFolder home;
  writeZenity(home.path(), "touch '" + (home.path() / "asked").string() + "'\nexit 1\n");
  ViewerDriver viewer({"grid", "--paused"}, DriverOptions{.home = home.path(), .programs = home.path() / "programs"});
  viewer.key("ctrl+o");
  viewer.waitUntil("the dialog", [&](const Json&) { return std::filesystem::exists(home.path() / "asked"); });
  EXPECT_EQ(viewer.frames(10)["scene"], "grid");
  EXPECT_EQ(viewer.state()["message"], "");
}

TEST(FileDialog, WithoutZenityTheFieldTakesThePath) {
  const TemporaryFolder home;
  writeFile(home.path() / "own.toml", "[cloth]\ngrid = \"vertical\"\n");
  ViewerDriver viewer({"grid", "--paused"}, DriverOptions{.home = home.path(), .programs = "/no/such/folder"});
  viewer.key("ctrl+o");
  viewer.waitUntil("the message", [](const Json& s) { return says(s, "zenity"); });
  viewer.frames(6);
  viewer.type((home.path() / "own.toml").string());
  viewer.waitUntil("the scene", [](const Json& s) { return s["scene"] == "own"; });
}

}  // namespace
}  // namespace drape::app
