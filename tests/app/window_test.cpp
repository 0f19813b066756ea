#include "viewer_driver.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

namespace drape::app {
namespace {

using Vector = std::array<double, 3>;

Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Vector operator*(double factor, const Vector& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double norm(const Vector& a) {
  return std::sqrt(dot(a, a));
}

Vector normalized(const Vector& a) {
  const double length = norm(a);
  return {a[0] / length, a[1] / length, a[2] / length};
}

double cameraDistance(const Json& state) {
  return norm(state["camera"]["position"].get<Vector>() - state["camera"]["focal_point"].get<Vector>());
}

/// The expected motion of the target in the world for a mouse motion in window units.
Vector expectedMove(const Json& state, const Vector& taken, double dx, double dy) {
  const auto eye = state["camera"]["position"].get<Vector>();
  const Vector forward = normalized(state["camera"]["focal_point"].get<Vector>() - eye);
  const Vector right = normalized(cross(forward, {0.0, 1.0, 0.0}));
  const Vector up = cross(right, forward);
  const double depth = dot(taken - eye, forward);
  const double angle = state["camera"]["view_angle"].get<double>() * std::acos(-1.0) / 180.0;
  const double unit = 2.0 * depth * std::tan(angle / 2.0) / state["view"]["height"].get<double>();
  Vector move{};
  for (std::size_t i = 0; i < 3; ++i) {
    move[i] = unit * (dx * right[i] - dy * up[i]);
  }
  return move;
}

/// Presses on the cloth and waits until the simulation has the attachment.
Json takeCloth(ViewerDriver& viewer, const Place& place) {
  viewer.move(place);
  viewer.press();
  return viewer.waitUntil("the attachment", isAttached);
}

class Pulling : public ::testing::TestWithParam<const char*> {};

TEST_P(Pulling, TheHeldPointFollowsTheMouse) {
  ViewerDriver viewer({GetParam(), "--paused", "--set", "stiffness=60", "--set", "damping=0.02"});
  const Place place = viewer.onCloth();
  const Json taken = takeCloth(viewer, place);
  const auto start = taken["attachment"]["target"].get<Vector>();
  EXPECT_LT(taken["attachment"]["distance"], 1e-6) << "the attachment starts where the cloth is";

  constexpr double dx = 70.0;
  constexpr double dy = -45.0;
  viewer.move({place.x + dx, place.y + dy});
  const Json moved = viewer.waitUntil("the target", [&](const Json& s) {
    return isAttached(s) && norm(s["attachment"]["target"].get<Vector>() - start) > 1e-3;
  });
  const Vector expected = expectedMove(moved, start, dx, dy);
  const Vector actual = moved["attachment"]["target"].get<Vector>() - start;
  EXPECT_LT(norm(actual - expected), 0.01 * norm(expected));
  const double apart = moved["attachment"]["distance"];
  EXPECT_NEAR(apart, norm(expected), 0.01 * norm(expected)) << "nothing moves while paused";

  viewer.key("space");
  viewer.waitUntil("the cloth to follow", [&](const Json& s) { return s["attachment"]["distance"] < 0.15 * apart; });
  viewer.release();
  viewer.waitUntil("the mouse to let go", [](const Json& s) { return !isAttached(s); });
}

INSTANTIATE_TEST_SUITE_P(Scenes, Pulling, ::testing::Values("grid", "skirt"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST(Window, ControlAndLeftPullsARunningCloth) {
  ViewerDriver viewer({"grid", "--set", "speed=0.01"});
  viewer.holdKey("Control_L");
  // The cloth moves, so a click may miss it. Clicks are this many frames apart, since two in a row are a double click.
  constexpr int apart = 30;
  for (int attempt = 0; attempt < 20 && !isAttached(viewer.frames(apart)); ++attempt) {
    viewer.release();
    viewer.frames(apart);
    viewer.move(viewer.onCloth());
    viewer.press();
  }
  const Json attached = viewer.waitUntil("the attachment", isAttached);
  viewer.letKeyGo("Control_L");
  viewer.waitUntil("time to pass", [&](const Json& s) { return s["step"] > attached["step"]; });
  EXPECT_TRUE(isAttached(viewer.state())) << "the button is still down";
  viewer.release();
  viewer.waitUntil("the mouse to let go", [](const Json& s) { return !isAttached(s); });
}

TEST(Window, PPinsTheAttachedVertexAndReleasesIt) {
  ViewerDriver viewer({"grid", "--paused"});
  const Place place = viewer.onCloth();
  const Json before = takeCloth(viewer, place);
  const int pins = before["pins"];
  viewer.key("p");
  viewer.waitUntil("another pin", [&](const Json& s) { return s["pins"] == pins + 1 && s["attachment"]["pinned"]; });
  viewer.release();
  const Json released = viewer.waitUntil("the mouse to let go", [](const Json& s) { return !isAttached(s); });
  EXPECT_EQ(released["pins"], pins + 1);
  viewer.key("space");
  const Json later = viewer.waitUntil("time to pass", [](const Json& s) { return s["step"] > 20; });
  EXPECT_EQ(later["pins"], pins + 1);
  viewer.key("space");
  viewer.key("r");
  viewer.waitUntil("the start", [](const Json& s) { return s["step"] == 0 && s["paused"]; });
  takeCloth(viewer, place);
  viewer.key("p");
  viewer.waitUntil("one pin less", [&](const Json& s) { return s["pins"] == pins; });
}

/// A scene file in its own folder.
class SceneFile {
 public:
  explicit SceneFile(const char* text) { std::ofstream(path()) << text; }
  [[nodiscard]] std::string path() const { return (folder_.path() / "scene.toml").string(); }

 private:
  TemporaryFolder folder_;
};

/// A sheet hangs to the right of a ball.
constexpr const char* ballBesideSheet = R"([cloth]
grid = "vertical"
position = [0.35, 1.0, 0]
[pins]
corners = ["top_left", "top_right"]
[camera]
position = [0, 1.0, 4.0]
focal_point = [0, 1.0, 0]
[settings]
grid.resolution = 9
grid.width = 0.6
grid.height = 0.6
solver = "xpbd"
[[bodies]]
name = "ball"
shape = "sphere"
radius = 0.12
position = [-0.4, 0.9, 0.05]
)";

TEST(Window, AMouseDragMovesABodyWhichSweepsTheClothAlong) {
  const SceneFile scene(ballBesideSheet);
  ViewerDriver viewer({scene.path(), "--set", "view.shadows=off"});
  const Json before = viewer.waitUntil("time to pass", [](const Json& s) { return s["step"] > 5; });
  const Json& ball = before["bodies"][0];
  ASSERT_EQ(ball["name"], "ball");
  EXPECT_EQ(before["contacts"]["bodies"], 0);
  const Place middle{ball["x"], ball["y"]};
  constexpr double dx = 90.0;
  viewer.move(middle);
  viewer.press();
  viewer.move({std::round(middle.x) + dx, std::round(middle.y)});
  // The mouse hits the ball where the ray through its centre enters it.
  const auto centre = ball["position"].get<Vector>();
  const Vector towardsEye = normalized(before["camera"]["position"].get<Vector>() - centre);
  const Vector expected = expectedMove(before, centre + 0.12 * towardsEye, dx, 0.0);
  ASSERT_GT(norm(expected), 0.2);
  const Json moved = viewer.waitUntil("the ball to arrive", [&](const Json& s) {
    return norm(s["bodies"][0]["shift"].get<Vector>() - expected) < 0.02 * norm(expected);
  });
  EXPECT_EQ(moved["camera"], before["camera"]) << "the view stays";
  EXPECT_TRUE(moved["attachment"].is_null()) << "there is no attachment";
  viewer.move({std::round(middle.x) + 2.0 * dx, std::round(middle.y)});
  viewer.waitUntil("the cloth to be touched", [](const Json& s) { return s["contacts"]["bodies"] > 0; });
  viewer.release();
  const Json released = viewer.frames();
  viewer.move(middle);
  EXPECT_LT(norm(viewer.frames()["bodies"][0]["shift"].get<Vector>() - released["bodies"][0]["shift"].get<Vector>()),
            0.02)
      << "the attachment is gone";
  viewer.key("r");
  viewer.waitUntil("the ball to be back",
                   [](const Json& s) { return norm(s["bodies"][0]["shift"].get<Vector>()) == 0.0; });
}

/// A sheet lies on a table, seen from above.
constexpr const char* sheetOnTable = R"([cloth]
grid = "horizontal"
position = [-0.2, 0.506, 0]
[camera]
position = [0, 2.5, 0.01]
focal_point = [0, 0.5, 0]
[settings]
grid.resolution = 9
grid.width = 0.4
grid.height = 0.4
solver = "xpbd"
substeps = 4
stiffness = 100
damping = 0.02
[[bodies]]
name = "table"
shape = "box"
size = [2.0, 0.1, 1.0]
position = [0, 0.45, 0]
static_friction = 0.3
kinetic_friction = 0.2
)";

TEST(Window, ClothPulledOverABodySlidesOnIt) {
  const SceneFile scene(sheetOnTable);
  ViewerDriver viewer({scene.path(), "--set", "view.shadows=off"});
  viewer.waitUntil("the sheet to lie", [](const Json& s) { return s["contacts"]["bodies"] >= 81; });
  const Place place = viewer.onCloth();
  const auto taken = takeCloth(viewer, place)["attachment"]["point"].get<Vector>();
  for (int i = 1; i <= 6; ++i) {
    viewer.move({place.x + 20.0 * i, place.y});
  }
  const Json pulled = viewer.waitUntil("the cloth to follow", [&](const Json& s) {
    return isAttached(s) && s["attachment"]["distance"] < 0.02 &&
           s["attachment"]["point"].get<Vector>()[0] > taken[0] + 0.2;
  });
  EXPECT_GT(pulled["contacts"]["bodies"], 0) << "it still lies on the table";
  EXPECT_LT(pulled["max_stretch"], 0.2) << "it slides as a whole";
  viewer.release();
  const Json rest = viewer.waitUntil("the mouse to let go", [](const Json& s) { return !isAttached(s); });
  for (const Json& point : rest["cloth_points"]) {
    EXPECT_GT(point["point"].get<Vector>()[1], 0.5) << "on the table";
  }
}

TEST(Window, AStiffnessDragReachesTheRunningSimulation) {
  ViewerDriver viewer({"grid", "--set", "stiffness=10"});
  viewer.move(viewer.find("stiffness", 0.2));
  viewer.press();
  const Json low = viewer.waitUntil("the low end", [](const Json& s) { return s["settings"]["stiffness"] != 10.0; });
  viewer.move(viewer.find("stiffness", 0.7));
  viewer.waitUntil("a stiffer cloth", [&](const Json& s) {
    return s["settings"]["stiffness"].get<double>() > 100.0 * low["settings"]["stiffness"].get<double>();
  });
  viewer.release();
  const Json after = viewer.state();
  viewer.waitUntil("time to pass", [&](const Json& s) { return s["step"] > after["step"]; });
}

TEST(Window, TypedValuesAndRightClicks) {
  ViewerDriver viewer({"grid", "--paused"});
  const Json before = viewer.state();
  viewer.move(viewer.find("drag"));
  viewer.holdKey("Control_L");
  viewer.press();
  viewer.release();
  viewer.letKeyGo("Control_L");
  viewer.type("1.75");
  const Json typed = viewer.waitUntil("the typed value", [](const Json& s) { return s["settings"]["drag"] == 1.75; });
  EXPECT_EQ(typed["step"], before["step"]) << "a full stop in a number is no shortcut";
  viewer.click(viewer.find("drag"), 3);
  viewer.waitUntil("the scene's value", [](const Json& s) { return s["settings"]["drag"] == 0.0; });
}

TEST(Window, TheClockIsStoppedSteppedAndSetBack) {
  ViewerDriver viewer({"grid"});
  viewer.waitUntil("time to pass", [](const Json& s) { return s["step"] > 5; });
  viewer.key("space");
  const Json paused = viewer.waitUntil("the pause", [](const Json& s) { return s["paused"].get<bool>(); });
  EXPECT_EQ(viewer.frames(8)["step"], paused["step"]);
  viewer.key("period");
  const int next = paused["step"].get<int>() + 1;
  viewer.waitUntil("one step", [&](const Json& s) { return s["step"] == next; });
  EXPECT_EQ(viewer.frames(8)["step"], next);
  viewer.key("r");
  const Json start = viewer.waitUntil("the start", [](const Json& s) { return s["step"] == 0; });
  EXPECT_EQ(start["time"], 0.0);
  viewer.click(viewer.find("button.play"));
  viewer.waitUntil("time to pass", [](const Json& s) { return !s["paused"] && s["step"] > 5; });
}

TEST(Window, KeysShowAndHide) {
  ViewerDriver viewer({"grid", "--paused"});
  viewer.key("h");
  const Json hidden = viewer.waitUntil("no panels", [](const Json& s) { return !s["panels"]; });
  EXPECT_EQ(hidden["view"]["width"], hidden["window"]["width"]);
  viewer.key("h");
  viewer.waitUntil("the panels", [](const Json& s) { return s["panels"].get<bool>(); });
  viewer.key("w");
  viewer.waitUntil("the wireframe", [](const Json& s) { return s["settings"]["view.wireframe"].get<bool>(); });
  viewer.key("w");
  viewer.waitUntil("no wireframe", [](const Json& s) { return !s["settings"]["view.wireframe"]; });
  viewer.key("F1");
  viewer.waitUntil("the help", [](const Json& s) { return s["help"].get<bool>(); });
  viewer.key("Escape");
  viewer.waitUntil("no help", [](const Json& s) { return !s["help"]; });
  EXPECT_TRUE(viewer.process().running());
}

TEST(Window, TheMouseMovesTheCameraAndNotTheCloth) {
  ViewerDriver viewer({"grid", "--paused"});
  const Json before = viewer.state();
  const Place free = viewer.besideCloth();
  const Place there{free.x + 60.0, free.y - 40.0};

  viewer.move(free);
  viewer.wheel(true);
  const Json nearer = viewer.waitUntil(
      "a nearer camera", [&](const Json& s) { return cameraDistance(s) < 0.97 * cameraDistance(before); });

  viewer.press();
  viewer.move(there);
  viewer.release();
  const Json turned = viewer.waitUntil("another side", [&](const Json& s) { return s["camera"] != nearer["camera"]; });
  EXPECT_EQ(turned["camera"]["focal_point"], nearer["camera"]["focal_point"]);
  EXPECT_NEAR(cameraDistance(turned), cameraDistance(nearer), 1e-6);

  viewer.move(viewer.besideCloth());
  viewer.press(2);
  viewer.move({640.0, 300.0});
  viewer.release(2);
  const Json panned = viewer.waitUntil(
      "another place", [&](const Json& s) { return s["camera"]["focal_point"] != turned["camera"]["focal_point"]; });
  EXPECT_TRUE(panned["attachment"].is_null());
  EXPECT_EQ(panned["step"], before["step"]);
  EXPECT_EQ(panned["energy"], before["energy"]);

  viewer.key("3");
  const Json right = viewer.waitUntil("the view from the right", [](const Json& s) {
    const auto eye = s["camera"]["position"].get<Vector>() - s["camera"]["focal_point"].get<Vector>();
    return eye[0] > 0.99 * norm(eye);
  });
  viewer.key("f");
  viewer.waitUntil("the whole cloth", [&](const Json& s) { return s["camera"] != right["camera"]; });
}

TEST(Window, DoubleClickLooksAtThePoint) {
  ViewerDriver viewer({"grid", "--paused"});
  const Json before = viewer.state();
  const Place place = viewer.onCloth();
  viewer.move(place);
  const auto point = before["cloth_points"][0]["point"].get<Vector>();
  const auto looksAtIt = [&](const Json& s) {
    return norm(s["camera"]["focal_point"].get<Vector>() - point) < 0.02 * cameraDistance(s);
  };
  ASSERT_FALSE(looksAtIt(before));
  // Two clicks within a third of a second; under load the second may be too late, so try again.
  for (int attempt = 0; attempt < 20 && !looksAtIt(viewer.state()); ++attempt) {
    viewer.doubleClick();
  }
  EXPECT_TRUE(looksAtIt(viewer.frames()));
}

TEST(Window, ASceneIsBuiltAgainWhenItsMeshChanges) {
  ViewerDriver viewer({"grid"});
  const Json before = viewer.state();
  viewer.move(viewer.find("grid.resolution", 0.2));
  viewer.press();
  viewer.release();
  viewer.waitUntil("another mesh", [&](const Json& s) {
    return s["vertices"] != before["vertices"] && s["loading"] == "" &&
           s["settings"]["grid.resolution"] != before["settings"]["grid.resolution"];
  });
}

/// Opens the list of a choice and clicks one of its words.
void pickFromList(ViewerDriver& viewer, const std::string& key, const std::string& word) {
  const std::string entry = key + "=" + word;
  viewer.click(viewer.find(key, 0.5, 20.0));
  viewer.waitUntil("the list", [&](const Json& s) { return s["buttons"].contains(entry); });
  const Json rect = viewer.frames()["buttons"][entry];  // a list gets its position in its second frame
  viewer.click({rect["x"].get<double>() + 10.0, rect["y"].get<double>() + rect["height"].get<double>() / 2.0});
}

TEST(Window, AMeshInAnotherUnitIsLookedAtFromWhereItFillsTheView) {
  ViewerDriver viewer({"skirt", "--paused"});
  const Json metres = viewer.state();
  pickFromList(viewer, "unit", "cm");
  const Json centimetres =
      viewer.waitUntil("another unit", [](const Json& s) { return s["settings"]["unit"] == "cm"; });
  viewer.waitUntil("a nearer camera", [&](const Json& s) { return cameraDistance(s) < 0.2 * cameraDistance(metres); });
  EXPECT_EQ(centimetres["vertices"], metres["vertices"]);
}

TEST(Window, AMeshFileAsksHowItWasReadAndOneClickChangesThat) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "towel.obj";
  std::ofstream(file) << "v 0 0 0\nv 60 0 0\nv 60 90 0\nv 0 90 0\nf 1 2 3 4\n";
  ViewerDriver viewer({file.string(), "--paused"});
  EXPECT_EQ(viewer.state()["settings"]["unit"], "auto");
  viewer.click(viewer.find("reading.unit=m"));
  viewer.waitUntil("metres", [](const Json& s) {
    return s["settings"]["unit"] == "m" && s["loading"] == "" && s["buttons"].contains("reading.unit=cm");
  });
  viewer.click(viewer.find("reading.unit=cm"));
  viewer.waitUntil("centimetres again", [](const Json& s) {
    return s["settings"]["unit"] == "cm" && s["loading"] == "" && s["buttons"].contains("reading.up=z");
  });
  viewer.click(viewer.find("reading.accept"));
  viewer.waitUntil("no line", [](const Json& s) { return !s["buttons"].contains("overlay.reading"); });
}

TEST(Window, AnotherSceneIsOpenedFromTheList) {
  ViewerDriver viewer({"grid", "--paused"});
  viewer.click(viewer.find("scene.choice"));
  viewer.waitUntil("the list", [](const Json& s) { return s["buttons"].contains("scene.choice=flag"); });
  const Json list = viewer.frames();  // a list gets its position in its second frame
  const Json& entry = list["buttons"]["scene.choice=flag"];
  viewer.click({entry["x"].get<double>() + 10.0, entry["y"].get<double>() + 5.0});
  const Json flag = viewer.waitUntil("the flag", [](const Json& s) { return s["scene"] == "flag"; });
  EXPECT_TRUE(flag["paused"]) << "the clock stays as it was";
  EXPECT_NE(flag["camera"], list["camera"]);
}

TEST(Window, AnotherSolverIsPickedFromTheListWhileTheClothMoves) {
  ViewerDriver viewer({"grid", "--set", "stiffness=10", "--set", "substeps=10"});
  const Json before = viewer.waitUntil("time to pass", [](const Json& s) { return s["step"] > 5; });
  ASSERT_EQ(before["settings"]["solver"], "one_iteration");
  viewer.click(viewer.find("section.advanced", 0.5, 20.0));
  pickFromList(viewer, "solver", "verlet");
  const Json after =
      viewer.waitUntil("the other solver", [](const Json& s) { return s["settings"]["solver"] == "verlet"; });
  EXPECT_GE(after["step"], before["step"]) << "the cloth goes on from where it is";
  viewer.waitUntil("time to pass", [&](const Json& s) { return s["step"] > after["step"].get<int>() + 5; });
  EXPECT_FALSE(viewer.state()["widgets"].contains("sweeps")) << "a setting of the first solver only";
}

TEST(Window, AutoShowsItsChoices) {
  ViewerDriver viewer({"grid", "--set", "solver=auto"});
  const Json chosen = viewer.waitUntil("a choice", [](const Json& s) { return !s["choice"].is_null(); })["choice"];
  EXPECT_GE(chosen["substeps"], 1.0);
  EXPECT_FALSE(chosen["words"].get<std::string>().empty());
  viewer.click(viewer.find("section.advanced", 0.5, 20.0));
  pickFromList(viewer, "solver", "verlet");
  viewer.waitUntil("a solver without choices", [](const Json& s) { return s["choice"].is_null(); });
}

TEST(Window, AGhostIsCalledAndSentAway) {
  ViewerDriver viewer({"grid", "--paused"});  // so that it starts with the cloth, however slow the clicks are
  EXPECT_TRUE(viewer.state()["ghost"].is_null());
  viewer.click(viewer.find("section.ghost"));
  pickFromList(viewer, "ghost.solver", "one_iteration");
  viewer.waitUntil("the ghost", [](const Json& s) { return !s["ghost"].is_null(); });
  viewer.move(viewer.find("ghost.substeps", 0.7));
  viewer.press();
  viewer.release();
  viewer.click(viewer.find("button.play"));
  viewer.waitUntil("a distance", [](const Json& s) { return s["ghost"]["distance"] > 1e-3; });
  pickFromList(viewer, "ghost.solver", "off");
  viewer.waitUntil("no ghost", [](const Json& s) { return s["ghost"].is_null(); });
}

TEST(Window, SavesAFabricInTheListAndUsesIt) {
  const TemporaryFolder folder;
  const std::string list = (folder.path() / "new" / "fabrics.toml").string();
  ViewerDriver viewer({"grid", "--paused", "--fabrics", list, "--set", "solver=auto", "--set", "material.model=fabric",
                       "--set", "material.preset=denim", "--set", "fabric.shear=60"});
  EXPECT_EQ(viewer.state()["settings"]["material.preset"], "denim, changed");
  viewer.click(viewer.find("fabric.name"));
  viewer.type("My denim");
  viewer.waitUntil("the own fabric", [](const Json& s) { return s["settings"]["material.preset"] == "My denim"; });
  std::stringstream text;
  text << std::ifstream(list).rdbuf();
  EXPECT_NE(text.str().find("name = 'My denim'"), std::string::npos) << text.str();
  EXPECT_NE(text.str().find("shear = 60"), std::string::npos) << text.str();
}

TEST(Window, ABadFileLeavesTheSceneRunning) {
  ViewerDriver viewer({"grid"});
  viewer.click(viewer.find("scene.path"));
  viewer.type("no-such-shirt.obj");
  const Json failed = viewer.waitUntil("the message", [](const Json& s) {
    return s["message"].get<std::string>().find("no-such-shirt.obj") != std::string::npos;
  });
  EXPECT_EQ(failed["scene"], "grid");
  viewer.waitUntil("time to pass", [&](const Json& s) { return s["step"] > failed["step"]; });
}

TEST(Window, F12SavesAPictureAndOverwritesNone) {
  ViewerDriver viewer({"grid", "--paused"});
  viewer.key("F12");
  viewer.key("F12");
  viewer.waitUntil("the message", [](const Json& s) {
    return s["message"].get<std::string>().find("grid-002.png") != std::string::npos;
  });
  for (const char* name : {"grid-001.png", "grid-002.png"}) {
    std::ifstream stream(viewer.folder() / name, std::ios::binary);
    std::string start(4, '\0');
    stream.read(start.data(), 4);
    EXPECT_EQ(start, "\x89PNG") << name;
  }
}

TEST(Window, ESavesTheClothAndTheFieldSavesItUnderANameThatIsFree) {
  ViewerDriver viewer({"grid", "--paused"});
  viewer.key("e");
  viewer.key("e");
  const auto waitForMessage = [&](const std::string& part) {
    viewer.waitUntil("the message " + part,
                     [&](const Json& s) { return s["message"].get<std::string>().find(part) != std::string::npos; });
  };
  waitForMessage("grid-002.obj");
  const auto saveAs = [&](const std::string& name) {
    viewer.click(viewer.find("cloth.path"));
    viewer.key("ctrl+a");
    viewer.type(name);
  };
  saveAs("mine.ply");
  waitForMessage("Saved");
  waitForMessage("mine.ply");
  saveAs("grid-001.obj");
  waitForMessage("exists");
  saveAs("mine.docx");
  waitForMessage("docx");
  std::ifstream first(viewer.folder() / "grid-001.obj");
  const std::string text{std::istreambuf_iterator<char>(first), {}};
  EXPECT_NE(text.find("\nv "), std::string::npos);
  std::ifstream second(viewer.folder() / "mine.ply", std::ios::binary);
  std::string start(3, '\0');
  second.read(start.data(), 3);
  EXPECT_EQ(start, "ply");
}

TEST(Window, EscapeLetsGoAndNeverQuits) {
  ViewerDriver viewer({"grid", "--paused"});
  takeCloth(viewer, viewer.onCloth());
  viewer.key("Escape");
  viewer.waitUntil("the mouse to let go", [](const Json& s) { return !isAttached(s); });
  viewer.release();
  viewer.tap("Escape");
  viewer.waitUntil("the keys that quit", [](const Json& s) { return says(s, "Ctrl+Q"); });
  EXPECT_TRUE(viewer.process().running());
}

/// Runs the viewer without any display and returns its exit status and its messages.
std::pair<int, std::string> runWithoutDisplay(const std::vector<std::string>& arguments) {
  const TemporaryFolder folder;
  std::vector<std::string> command{DRAPE_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  const int status = runToEnd({.command = command,
                               .environment = {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}},
                               .output = folder.path() / "output.txt"});
  std::ifstream stream(folder.path() / "output.txt");
  std::ostringstream text;
  text << stream.rdbuf();
  return {status, text.str()};
}

TEST(CommandLine, ABadSceneIsAFailure) {
  const auto [status, text] = runWithoutDisplay({"no-such-scene"});
  EXPECT_EQ(status, 1);
  EXPECT_NE(text.find("no-such-scene"), std::string::npos) << text;
}

TEST(CommandLine, ASettingOutOfRangeIsWrongUsage) {
  const auto [status, text] = runWithoutDisplay({"grid", "--set", "drag=-3"});
  EXPECT_EQ(status, 2);
  EXPECT_NE(text.find("drag"), std::string::npos) << text;
}

TEST(CommandLine, WrongOptionsAreWrongUsage) {
  EXPECT_EQ(runWithoutDisplay({"--no-such-option"}).first, 2);
  EXPECT_EQ(runWithoutDisplay({"grid", "--window-size", "wide"}).first, 2);
  EXPECT_EQ(runWithoutDisplay({"grid", "--window-size", "1280,720,3"}).first, 2);
}

TEST(CommandLine, WithoutADisplayItSaysSo) {
  const auto [status, text] = runWithoutDisplay({"grid"});
  EXPECT_EQ(status, 1);
  EXPECT_NE(text.find("display"), std::string::npos) << text;
}

TEST(CommandLine, HelpDescribesTheStatusFile) {
  const auto [status, text] = runWithoutDisplay({"--help"});
  EXPECT_EQ(status, 0);
  EXPECT_NE(text.find("cloth_points"), std::string::npos) << text;
}

}  // namespace
}  // namespace drape::app
