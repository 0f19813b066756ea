#include "viewer_driver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

namespace drape::app {
namespace {

std::size_t picks(const Json& state) {
  return state["picked"].size();
}

bool saysPart(const Json& state, const std::string& part) {
  return state["message"].get<std::string>().find(part) != std::string::npos;
}

TEST(FieldsInTheWindow, AColourMapColoursTheClothAndShowsItsLegend) {
  ViewerDriver viewer({"skirt", "--set", "view.colour_map=strain_warp"});
  const Json shown =
      viewer.waitUntil("the colour map", [](const Json& s) { return !s["colour_map"].is_null() && s["time"] > 0.1; });
  EXPECT_TRUE(shown["colour_map"]["shown"]);
  EXPECT_EQ(shown["colour_map"]["low"], 100.0);
  EXPECT_GT(shown["colour_map"]["high"], 100.0);
  EXPECT_TRUE(shown["buttons"].contains("hint.colour_map"));
}

TEST(FieldsInTheWindow, AMissingQuantityIsNamed) {
  ViewerDriver viewer({"grid", "--paused", "--set", "view.colour_map=stress"});
  const Json shown = viewer.waitUntil("the colour map", [](const Json& s) { return !s["colour_map"].is_null(); });
  EXPECT_FALSE(shown["colour_map"]["shown"]);
  EXPECT_NE(shown["colour_map"]["problem"].get<std::string>().find("fabric"), std::string::npos);
}

TEST(FieldsInTheWindow, ARightClickMarksAVertexAndEscapeRemovesTheMarks) {
  ViewerDriver viewer({"grid", "--paused"});
  const Json camera = viewer.state()["camera"];
  const Place place = viewer.onCloth();
  viewer.click(place, 3);
  const Json one = viewer.waitUntil("a mark", [](const Json& s) { return picks(s) == 1; });
  EXPECT_TRUE(one["attachment"].is_null()) << "it does not pull the cloth";
  EXPECT_EQ(one["camera"], camera) << "and does not turn the view";
  const Json points = viewer.frames()["cloth_points"];
  ASSERT_GE(points.size(), 2U);
  viewer.click({points[1]["x"], points[1]["y"]}, 3);
  viewer.waitUntil("two marks", [](const Json& s) { return picks(s) == 2; });
  viewer.key("Escape");
  viewer.waitUntil("no mark", [](const Json& s) { return picks(s) == 0; });
  EXPECT_FALSE(viewer.frames()["buttons"].contains("overlay.picked")) << "and the window is still open";
}

TEST(FieldsInTheWindow, ARightClickOnAMarkedVertexRemovesIt) {
  ViewerDriver viewer({"grid", "--paused"});
  const Place place = viewer.onCloth();
  viewer.click(place, 3);
  viewer.waitUntil("a mark", [](const Json& s) { return picks(s) == 1; });
  viewer.click(place, 3);
  viewer.waitUntil("no mark", [](const Json& s) { return picks(s) == 0; });
}

TEST(FieldsInTheWindow, ARightClickBesideTheClothDoesNothing) {
  ViewerDriver viewer({"grid", "--paused"});
  viewer.click(viewer.besideCloth(), 3);
  EXPECT_EQ(picks(viewer.frames()), 0U);
}

TEST(FieldsInTheWindow, TheValuesAreWrittenToNewFiles) {
  ViewerDriver viewer({"grid", "--paused"});
  viewer.click(viewer.onCloth(), 3);
  const Json marked = viewer.waitUntil("a mark", [](const Json& s) { return picks(s) == 1; });
  viewer.key("space");
  viewer.waitUntil("some samples", [&](const Json& s) { return s["time"] > marked["time"].get<double>() + 0.3; });
  viewer.click(viewer.find("button.write_csv"));
  viewer.waitUntil("the file", [](const Json& s) { return saysPart(s, "grid-001.csv"); });
  viewer.click(viewer.find("button.write_csv"));
  viewer.waitUntil("another file", [](const Json& s) { return saysPart(s, "grid-002.csv"); });
  std::ifstream stream(viewer.folder() / "grid-001.csv");
  std::string titles;
  std::getline(stream, titles);
  const std::string vertex = std::to_string(marked["picked"][0].get<int>());
  EXPECT_NE(titles.find("vertex " + vertex + " speed [m/s]"), std::string::npos) << titles;
  std::string row;
  int rows = 0;
  while (std::getline(stream, row)) {
    ++rows;
    EXPECT_EQ(std::count(row.begin(), row.end(), ','), std::count(titles.begin(), titles.end(), ',')) << row;
  }
  EXPECT_GT(rows, 5);
}

TEST(FieldsInTheWindow, F12SavesThePictureWithTheLegend) {
  ViewerDriver viewer({"grid", "--paused", "--set", "view.colour_map=bending"});
  viewer.waitUntil("the colour map", [](const Json& s) { return !s["colour_map"].is_null(); });
  viewer.key("F12");
  viewer.waitUntil("the file", [](const Json& s) { return saysPart(s, "grid-001.png"); });
  EXPECT_TRUE(viewer.frames()["buttons"].contains("button.play")) << "the panels are back";
}

TEST(TimelineInTheWindow, TheSliderReturnsToAnEarlierTimeAndPauses) {
  ViewerDriver viewer({"grid"});
  const Json played = viewer.waitUntil(
      "a timeline", [](const Json& s) { return !s["timeline"].is_null() && s["timeline"]["end"] > 0.8; });
  EXPECT_GT(played["timeline"]["megabytes"], 0.0);
  viewer.move(viewer.find("timeline", 0.5));
  viewer.press();
  const Json middle = viewer.waitUntil("a pause", [](const Json& s) { return s["paused"].get<bool>(); });
  viewer.move(viewer.find("timeline", 0.1));
  const Json early = viewer.waitUntil("an earlier time", [&](const Json& s) { return s["time"] < middle["time"]; });
  viewer.release();
  EXPECT_NEAR(early["time"].get<double>(), 0.1 * early["timeline"]["end"].get<double>(), 0.1);
  EXPECT_GE(early["timeline"]["end"], middle["time"]) << "the later states are still there";
  viewer.key("space");
  viewer.waitUntil("the cloth to move on", [&](const Json& s) { return s["time"] > early["time"]; });
}

TEST(TimelineInTheWindow, CommaGoesBackByOneState) {
  ViewerDriver viewer({"grid"});
  viewer.waitUntil("a timeline", [](const Json& s) { return !s["timeline"].is_null() && s["timeline"]["end"] > 0.3; });
  viewer.key("space");
  const Json paused = viewer.waitUntil("a pause", [](const Json& s) { return s["paused"].get<bool>(); });
  viewer.key("comma");
  const Json back = viewer.waitUntil("an earlier state", [&](const Json& s) { return s["step"] < paused["step"]; });
  EXPECT_TRUE(back["paused"]);
  EXPECT_GE(back["timeline"]["end"], paused["time"]) << "the later states are still there";
}

}  // namespace
}  // namespace drape::app
