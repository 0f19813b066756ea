// Tests of the language of the window: the option, the system, the row in the section View, and what is kept.
#include "viewer_driver.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace drape::app {
namespace {

bool shows(const Json& state, const std::string& words) {
  return state["status"].get<std::string>().find(words) != std::string::npos;
}

/// The language in the preferences of a folder.
std::string keptLanguage(const std::filesystem::path& home) {
  return Json::parse(contentOf(home / "state" / "drape" / "window.json"))["language"];
}

TEST(Language, TheOptionStartsTheWindowInGerman) {
  ViewerDriver viewer({"grid", "--paused", "--language", "de"});
  const Json state = viewer.state();
  EXPECT_EQ(state["language"], "de");
  EXPECT_TRUE(shows(state, "angehalten")) << state["status"];
  EXPECT_TRUE(shows(state, " Knoten")) << state["status"];
  EXPECT_TRUE(hasButton(state, "button.play")) << "names do not depend on the language";
  viewer.click(viewer.find("button.reset_all"));
  viewer.tap("ctrl+z");
  viewer.waitUntil("a German message", [](const Json& s) { return says(s, "nichts rückgängig"); });
}

TEST(Language, TheRowChangesItAtOnceAndIsKept) {
  const TemporaryFolder home;
  {
    ViewerDriver viewer({"grid", "--paused"}, DriverOptions{.home = home.path()});
    EXPECT_EQ(viewer.state()["language"], "en");
    EXPECT_NO_THROW(viewer.send({"search", "--name", "A sheet that falls from two corners .* Drape"}));
    viewer.click(viewer.find("section.view"));
    viewer.click(viewer.find("language=de"));
    const Json german =
        viewer.waitUntil("German", [](const Json& s) { return s["language"] == "de" && shows(s, "angehalten"); });
    EXPECT_TRUE(hasButton(german, "language=en")) << "the section is still open";
    EXPECT_NO_THROW(viewer.send({"search", "--name", "Ein Blatt, das an zwei Ecken h.*ngt .* Drape"}));
    viewer.tap("ctrl+q");
    EXPECT_EQ(viewer.process().waitFor(60.0), 0);
  }
  EXPECT_EQ(keptLanguage(home.path()), "de");
  {
    ViewerDriver viewer({"grid", "--paused"}, DriverOptions{.home = home.path()});
    EXPECT_EQ(viewer.state()["language"], "de");
    viewer.click(viewer.find("language=en"));
    viewer.waitUntil("English", [](const Json& s) { return s["language"] == "en" && shows(s, "paused"); });
    viewer.tap("ctrl+q");
    EXPECT_EQ(viewer.process().waitFor(60.0), 0);
  }
  EXPECT_EQ(keptLanguage(home.path()), "en");
}

TEST(Language, FollowsTheSystemUntilTheUserChooses) {
  const TemporaryFolder home;
  {
    ViewerDriver viewer({"grid", "--paused"}, DriverOptions{.home = home.path(), .locale = "de_DE.UTF-8"});
    EXPECT_EQ(viewer.state()["language"], "de");
    viewer.click(viewer.find("section.view"));  // writes the preferences
    viewer.tap("ctrl+q");
    EXPECT_EQ(viewer.process().waitFor(60.0), 0);
  }
  EXPECT_EQ(keptLanguage(home.path()), "") << "the user has chosen none";
  ViewerDriver viewer({"grid", "--paused"}, DriverOptions{.home = home.path(), .locale = "fr_FR.UTF-8"});
  EXPECT_EQ(viewer.state()["language"], "en");
}

TEST(Language, ACatalogueOfTheUserCanBeGiven) {
  const TemporaryFolder home;
  std::ofstream(home.path() / "own.toml") << "title = \"Own\"\n[texts]\n\"paused\" = \"at rest\"\n";
  ViewerDriver viewer({"grid", "--paused", "--language", (home.path() / "own.toml").string()});
  const Json state = viewer.state();
  EXPECT_EQ(state["language"], "own");
  EXPECT_TRUE(shows(state, "at rest")) << state["status"];
}

TEST(Language, AnUnknownOneIsWrongUsage) {
  const TemporaryFolder folder;
  const std::filesystem::path output = folder.path() / "output.txt";
  EXPECT_EQ(runToEnd({.command = {DRAPE_PROGRAM, "grid", "--language", "klingon"}, .output = output}), 2);
  const std::string text = contentOf(output);
  EXPECT_NE(text.find("klingon"), std::string::npos) << text;
  EXPECT_NE(text.find("en (English), de (Deutsch)"), std::string::npos) << text;
}

}  // namespace
}  // namespace drape::app
