// The comparison of the sources of error in the window.
#include "viewer_driver.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace drape::app {
namespace {

/// Closes the open sections above Performance and opens that, so that it is in sight.
void openPerformance(ViewerDriver& viewer) {
  const std::vector<std::string> sections{"section.material", "section.air",   "section.simulation",
                                          "section.contact",  "section.scene", "section.export",
                                          "section.view",     "section.ghost", "section.performance"};
  for (std::size_t i = 0; i + 1 < sections.size(); ++i) {
    const Json buttons = viewer.frames()["buttons"];
    const Json& heading = buttons[sections[i]];
    const double toNext = buttons[sections[i + 1]]["y"].get<double>() - heading["y"].get<double>();
    if (toNext > 2.0 * heading["height"].get<double>()) {
      clickHeadings(viewer, {sections[i]});
    }
  }
  clickHeadings(viewer, {"section.performance"});
  viewer.waitUntil("the button", [](const Json& s) { return s["buttons"].contains("compare_errors"); });
}

TEST(ErrorSourcesInTheWindow, AreComparedInTheBackgroundUntilASettingChanges) {
  ViewerDriver viewer({"grid", "--set", "grid.resolution=9", "--set", "time_step=1/150"});
  openPerformance(viewer);
  viewer.click(viewer.find("compare_errors"));
  const Json done = viewer.waitUntil("the result", [](const Json& s) { return !s["errors"]["sources"].empty(); });
  EXPECT_TRUE(done["errors"]["share"].is_null());
  const Json& last = done["errors"]["sources"].back();
  EXPECT_EQ(last["time"], 0.5);
  EXPECT_GT(last["mesh"], 0.0);
  EXPECT_GT(last["material"], 0.0);
  EXPECT_GT(done["step"], 0) << "the cloth goes on moving";
  viewer.key("r");
  clickHeadings(viewer, {"section.air"});
  viewer.waitUntil("the slider", [](const Json& s) { return s["widgets"].contains("drag"); });
  viewer.click(viewer.find("drag", 0.8));
  viewer.waitUntil("no result", [](const Json& s) { return s["errors"]["sources"].empty(); });
}

TEST(ErrorSourcesInTheWindow, ACancelledComparisonEndsSoon) {
  ViewerDriver viewer({"walk", "--paused"});
  openPerformance(viewer);
  viewer.click(viewer.find("compare_errors"));
  viewer.waitUntil("progress", [](const Json& s) { return !s["errors"]["share"].is_null(); });
  viewer.click(viewer.find("compare_errors"));
  const Json end = viewer.waitUntil("its end", [](const Json& s) { return s["errors"]["share"].is_null(); });
  EXPECT_TRUE(end["errors"]["sources"].empty());
}

}  // namespace
}  // namespace drape::app
