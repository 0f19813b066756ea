// Tests of selected vertices and their pins, and of the camera: kept views, orthographic projection, turntable.
#include "viewer_driver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace drape::app {
namespace {

Place corner(const Json& view, double across, double down) {
  return {view["x"].get<double>() + across * view["width"].get<double>(),
          view["y"].get<double>() + down * view["height"].get<double>()};
}

/// Drags from one place to another in several moves, as a hand does.
void dragOver(ViewerDriver& viewer, const Place& from, const Place& to) {
  viewer.move(from);
  viewer.press();
  viewer.move({0.5 * (from.x + to.x), 0.5 * (from.y + to.y)});
  viewer.move(to);
  viewer.release();
}

int selectedIn(const Json& state) {
  return state["selection"]["vertices"];
}

double distanceOf(const Json& a, const Json& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double difference = a[i].get<double>() - b[i].get<double>();
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

TEST(Selection, ARectangleSelectsAndThePinsCanBeUndone) {
  ViewerDriver viewer({"grid", "--paused"});
  const Json start = viewer.state();
  const int pins = start["pins"];
  viewer.key("b");
  viewer.waitUntil("the selection", [](const Json& s) { return s["selection"]["on"].get<bool>(); });
  dragOver(viewer, corner(start["view"], 0.02, 0.2), corner(start["view"], 0.98, 0.9));
  const Json all = viewer.waitUntil("vertices", [](const Json& s) { return selectedIn(s) > 0; });
  EXPECT_EQ(selectedIn(all), all["vertices"]) << "the rectangle is around the cloth";
  EXPECT_EQ(all["camera"], start["camera"]) << "the drag does not turn the view";
  viewer.key("p");
  viewer.waitUntil("pins", [](const Json& s) { return s["pins"] == s["vertices"]; });
  viewer.tap("ctrl+z");
  viewer.waitUntil("the pins of the scene", [&](const Json& s) { return s["pins"] == pins; });
  viewer.tap("ctrl+y");
  viewer.waitUntil("the pins again", [](const Json& s) { return s["pins"] == s["vertices"]; });
  viewer.click(viewer.find("button.release_selected"));
  viewer.waitUntil("no pins", [](const Json& s) { return s["pins"] == 0; });
  viewer.key("Escape");
  viewer.waitUntil("no selection",
                   [](const Json& s) { return !s["selection"]["on"].get<bool>() && selectedIn(s) == 0; });
  EXPECT_TRUE(viewer.process().running());
}

TEST(Selection, AClickSelectsOneVertexAndShiftAndCtrlChangeTheSelection) {
  ViewerDriver viewer({"grid", "--paused"});
  viewer.key("b");
  const Json points = viewer.state()["cloth_points"];
  ASSERT_GE(points.size(), 2U);
  const Place one{points[0]["x"], points[0]["y"]};
  const Place other{points[1]["x"], points[1]["y"]};
  viewer.click(one);
  viewer.waitUntil("a vertex", [](const Json& s) { return selectedIn(s) == 1; });
  viewer.holdKey("shift");
  viewer.click(other);
  viewer.letKeyGo("shift");
  viewer.waitUntil("two vertices", [](const Json& s) { return selectedIn(s) == 2; });
  viewer.holdKey("ctrl");
  viewer.click(one);
  viewer.letKeyGo("ctrl");
  viewer.waitUntil("the other vertex", [](const Json& s) { return selectedIn(s) == 1; });
  EXPECT_TRUE(viewer.state()["attachment"].is_null()) << "the clicks do not pull the cloth";
}

TEST(Selection, ABorderIsSelectedFromThePanelAndPinned) {
  ViewerDriver viewer({"grid", "--paused"});
  const Json start = viewer.state();
  viewer.click(viewer.find("select=border"));
  viewer.waitUntil("the selection", [](const Json& s) { return s["selection"]["on"].get<bool>(); });
  viewer.click(viewer.onCloth());
  const Json border = viewer.waitUntil("the border", [](const Json& s) { return selectedIn(s) > 0; });
  const double side = std::sqrt(start["vertices"].get<double>());  // of a square grid
  EXPECT_EQ(selectedIn(border), std::lround(4.0 * side - 4.0));
  viewer.click(viewer.find("button.pin_selected"));
  viewer.waitUntil("pins", [&](const Json& s) { return s["pins"] == selectedIn(border); });
  viewer.click(viewer.find("button.end_selection"));
  viewer.waitUntil("no selection", [](const Json& s) { return !s["buttons"].contains("overlay.selection"); });
}

TEST(Selection, PinsGetKeyframesByADragAndAButton) {
  ViewerDriver viewer({"grid", "--paused", "--set", "grid.resolution=9", "--set", "pins=none"});
  const Json start = viewer.state();
  viewer.key("b");
  viewer.click(viewer.onCloth());
  viewer.waitUntil("a vertex", [](const Json& s) { return selectedIn(s) == 1; });
  viewer.key("p");
  viewer.waitUntil("a pin", [](const Json& s) { return s["pins"] == 1; });
  viewer.key("space");
  viewer.waitUntil("some time", [](const Json& s) { return s["time"].get<double>() > 0.2; });
  viewer.key("space");
  viewer.waitUntil("a pause", [](const Json& s) { return s["paused"].get<bool>(); });
  viewer.click(viewer.find("button.add_key"));
  const Json keyed = viewer.waitUntil("two keyframes", [](const Json& s) {
    return s["buttons"].contains("button.key.1") && !s["buttons"].contains("button.key.2");
  });
  viewer.tap("ctrl+z");
  viewer.waitUntil("no keyframes", [](const Json& s) { return !s["buttons"].contains("button.key.0"); });
  EXPECT_TRUE(viewer.process().running());
}

TEST(KeptViews, ComeBackInTheNextWindow) {
  const TemporaryFolder home;
  Json kept;
  {
    ViewerDriver viewer({"grid", "--paused"}, DriverOptions{.home = home.path()});
    viewer.key("3");
    viewer.key("5");
    kept =
        viewer.waitUntil("the view", [](const Json& s) { return s["camera"]["orthographic"].get<bool>(); })["camera"];
    viewer.tap("ctrl+F6");
    viewer.waitUntil("the message", [](const Json& s) {
      return s["message"].get<std::string>().find("now view 2") != std::string::npos;
    });
    viewer.tap("F5");
    viewer.waitUntil("that there is no other view", [](const Json& s) {
      return s["message"].get<std::string>().find("no view 1 yet") != std::string::npos;
    });
    viewer.tap("ctrl+q");
    ASSERT_TRUE(viewer.process().waitFor(30.0).has_value());
  }
  ViewerDriver viewer({"grid", "--paused"}, DriverOptions{.home = home.path()});
  ASSERT_NE(viewer.state()["camera"], kept);
  viewer.tap("F6");
  viewer.waitUntil("the kept view", [&](const Json& s) { return s["camera"] == kept; });
}

TEST(Projection, OfAnOrthographicViewHitsTheClothUnderTheMouse) {
  ViewerDriver viewer({"grid", "--paused"});
  viewer.key("7");
  viewer.key("f");
  viewer.key("5");
  viewer.waitUntil("the projection", [](const Json& s) { return s["camera"]["orthographic"].get<bool>(); });
  const Json point = viewer.frames()["cloth_points"][1];
  viewer.move({point["x"], point["y"]});
  viewer.press();
  const Json pulled = viewer.waitUntil("the attachment", [](const Json& s) { return !s["attachment"].is_null(); });
  viewer.release();
  EXPECT_EQ(pulled["attachment"]["triangle"], point["triangle"]);
  EXPECT_LT(distanceOf(pulled["attachment"]["point"], point["point"]), 0.005);
}

TEST(Turntable, TurnsUntilADragTurnsTheView) {
  ViewerDriver viewer({"grid", "--paused"});
  const Json start = viewer.state()["camera"];
  viewer.key("t");
  const Json turned = viewer.waitUntil(
      "a turn", [&](const Json& s) { return distanceOf(s["camera"]["position"], start["position"]) > 0.2; });
  EXPECT_TRUE(turned["camera"]["turns"]);
  EXPECT_LT(distanceOf(turned["camera"]["focal_point"], start["focal_point"]), 1e-6);
  EXPECT_NEAR(turned["camera"]["position"][1], start["position"][1], 1e-6) << "at the same height";
  viewer.move(viewer.besideCloth());
  viewer.press();
  viewer.release();
  const Json stopped = viewer.waitUntil("a stop", [](const Json& s) { return !s["camera"]["turns"].get<bool>(); });
  EXPECT_EQ(viewer.frames(10)["camera"]["position"], stopped["camera"]["position"]);
}

}  // namespace
}  // namespace drape::app
