// Files that are dropped on the window, and the button that closes it.
#include "desktop.hpp"
#include "viewer_driver.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <set>

namespace drape::app {
namespace {

std::set<std::string> bodiesOf(const Json& state) {
  std::set<std::string> names;
  for (const Json& body : state["bodies"]) {
    names.insert(body["name"].get<std::string>());
  }
  return names;
}

/// Files to drop, in a folder that goes away with them.
class Files {
 public:
  std::string cloth(const std::string& name) {
    return write(name, "v 0 0.5 0\nv 0.6 0.5 0\nv 0.6 1.4 0\nv 0 1.4 0\nf 1 2 3 4\n");
  }
  std::string solid(const std::string& name) {
    return write(name,
                 "v 0 0 1\nv 1 0 1\nv 0 0 2\nv 0 1 1\n"
                 "f 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n");
  }
  std::string write(const std::string& name, const std::string& text) {
    const auto file = folder_.path() / name;
    std::ofstream(file) << text;
    return file.string();
  }
  [[nodiscard]] std::string missing() const { return (folder_.path() / "missing.obj").string(); }

 private:
  TemporaryFolder folder_;
};

TEST(Desktop, ADroppedMeshIsOpenedWhateverItsName) {
  Files files;
  ViewerDriver viewer({"grid", "--paused"});
  for (const char* name : {"plain.obj", "two words, 50% & \u00FCml\u00E4ute.obj", "coat%20new%C3%BC.obj"}) {
    EXPECT_TRUE(viewer.drop({files.cloth(name)})) << name;
    const Json opened = viewer.waitUntil(name, [&](const Json& s) { return s["scene"] == name; });
    EXPECT_EQ(opened["vertices"], 4) << name;
  }
}

TEST(Desktop, FilesThatAreDroppedTogetherAllCount) {
  Files files;
  const std::string scene = files.write("room.toml", "title = \"A room\"\n[cloth]\ngrid = \"vertical\"\n");
  ViewerDriver viewer({"grid", "--paused"});
  EXPECT_TRUE(viewer.drop({files.solid("lamp.obj"), scene, files.solid("large chair.obj")}));
  viewer.waitUntil("the question", [](const Json& s) { return hasButton(s, "overlay.drop"); });
  EXPECT_TRUE(hasButton(viewer.state(), "cloth.2"));
  viewer.key("Return");
  const Json room = viewer.waitUntil("the scene", [](const Json& s) { return s["scene"] == "room"; });
  EXPECT_EQ(bodiesOf(room), (std::set<std::string>{"ground", "lamp", "large chair"}));
  EXPECT_FALSE(hasButton(viewer.frames(), "overlay.drop"));

  EXPECT_TRUE(viewer.drop({files.solid("body.obj"), files.cloth("shawl.obj")}));
  viewer.waitUntil("the question", [](const Json& s) { return hasButton(s, "overlay.drop"); });
  viewer.click(viewer.find("button.drop.open"));
  const Json shawl = viewer.waitUntil("the shawl", [](const Json& s) { return s["scene"] == "shawl.obj"; });
  EXPECT_EQ(bodiesOf(shawl), (std::set<std::string>{"body", "ground"}));
}

TEST(Desktop, FilesThatCannotBeOpenedCauseAMessageEachTime) {
  Files files;
  const std::string notes = files.write("notes.txt", "This is no mesh.\n");
  ViewerDriver viewer({"grid", "--paused"});
  for (int attempt = 0; attempt < 2; ++attempt) {
    EXPECT_TRUE(viewer.drop({files.missing(), notes}));
    const Json failed = viewer.waitUntil("the error", [](const Json& s) { return hasButton(s, "overlay.error"); });
    EXPECT_TRUE(says(failed, "missing.obj")) << failed["message"];
    EXPECT_NE(failed["status"].get<std::string>().find("notes.txt"), std::string::npos) << failed["status"];
    viewer.key("Escape");
    viewer.waitUntil("no error", [](const Json& s) { return !hasButton(s, "overlay.error"); });
  }
  viewer.click(viewer.find("scene.path"));
  viewer.type("flag");
  const Json flag = viewer.waitUntil("the flag", [](const Json& s) { return s["scene"] == "flag"; });
  EXPECT_FALSE(says(flag, "notes.txt")) << flag["message"];
}

TEST(Desktop, ClosingTheWindowAsksBeforeChangesAreLost) {
  ViewerDriver viewer({"grid", "--paused", "--set", "drag=0.5"});
  viewer.click(viewer.find("drag", 0.6));
  viewer.waitUntil("a change", [](const Json& s) { return s["settings"]["drag"] != 0.5; });
  askToClose(viewer.display());
  viewer.waitUntil("the question", [](const Json& s) { return hasButton(s, "overlay.quit"); });
  viewer.key("Escape");
  viewer.waitUntil("no question", [](const Json& s) { return !hasButton(s, "overlay.quit"); });
  EXPECT_TRUE(viewer.process().running());
  askToClose(viewer.display());
  viewer.waitUntil("the question", [](const Json& s) { return hasButton(s, "overlay.quit"); });
  viewer.tap("Return");
  EXPECT_EQ(viewer.process().waitFor(60.0), 0);
}

TEST(Desktop, TheWindowHasASmallestSizeInWhichItCanBeUsed) {
  ViewerDriver viewer({"grid", "--paused"});
  EXPECT_EQ(smallestSize(viewer.display()), std::pair(640, 480));
  ViewerDriver large({"grid", "--paused", "--set", "view.font_scale=2"});
  EXPECT_EQ(smallestSize(large.display()), std::pair(800, 600)) << "a small screen has room for it";
}

TEST(Desktop, ClosingTheWindowQuitsAtOnceWhereNothingIsLost) {
  ViewerDriver viewer({"grid", "--paused"});
  askToClose(viewer.display());
  EXPECT_EQ(viewer.process().waitFor(60.0), 0);
}

}  // namespace
}  // namespace drape::app
