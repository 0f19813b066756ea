// Sessions that the window records.
#include "replay.hpp"
#include "viewer_driver.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace drape::app {
namespace {

TEST(Record, ASessionInTheWindowReplaysToTheSameBits) {
  const TemporaryFolder folder;
  const auto log = folder.path() / "session.json";
  ViewerDriver viewer({"grid", "--paused", "--set", "drag=0.5", "--record", log.string()});
  const Place place = viewer.onCloth();
  viewer.move(place);
  viewer.press();
  viewer.waitUntil("an attachment", [](const Json& s) { return !s["attachment"].is_null(); });
  viewer.key("space");
  viewer.move({place.x + 60.0, place.y - 40.0});
  viewer.waitUntil("steps with an attachment", [](const Json& s) { return s["step"] > 20; });
  viewer.release();
  viewer.click(viewer.find("drag", 0.6));
  const Json changed = viewer.waitUntil("a change of drag", [](const Json& s) { return s["settings"]["drag"] != 0.5; });
  viewer.waitUntil("steps after it", [&](const Json& s) { return s["step"] > changed["step"].get<int>() + 10; });
  quitWithQuestion(viewer);
  expectReplay(log);
}

TEST(Record, AFileThatCannotBeWrittenIsAnErrorAtOnce) {
  const TemporaryFolder folder;
  const auto output = folder.path() / "output.txt";
  const VirtualDisplay display;
  const int status = runToEnd({.command = {DRAPE_PROGRAM, "grid", "--record", "/no/such/folder/session.json"},
                               .environment = {{"DISPLAY", display.name()}},
                               .output = output});
  std::ifstream text(output);
  const std::string words{std::istreambuf_iterator<char>(text), {}};
  EXPECT_EQ(status, 1);
  EXPECT_NE(words.find("/no/such/folder/session.json"), std::string::npos) << words;
}

}  // namespace
}  // namespace drape::app
