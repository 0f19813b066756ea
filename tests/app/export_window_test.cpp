// Tests of the section Export: frames, motions and films from the window.
#include "film_probe.hpp"
#include "viewer_driver.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace drape::app {
namespace {

bool tells(const Json& state, const std::string& words) {
  return state["message"].get<std::string>().find(words) != std::string::npos;
}

std::string bytesOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// Opens the section and chooses the contents: "frame", "motion" or "film".
void openExport(ViewerDriver& viewer, const std::string& kind) {
  viewer.key("ctrl+e");
  viewer.waitUntil("the section", [](const Json& s) { return s["buttons"].contains("button.export"); });
  viewer.click(viewer.find("export.kind=" + kind));
}

void fill(ViewerDriver& viewer, const std::string& field, const std::string& text) {
  viewer.click(viewer.find(field));
  viewer.clearField();
  viewer.type(text);
}

void choose(ViewerDriver& viewer, const std::string& list, const std::string& entry) {
  viewer.click(viewer.find(list));
  viewer.waitUntil("the list", [&](const Json& s) { return s["buttons"].contains(list + "=" + entry); });
  const Json rect = viewer.frames()["buttons"][list + "=" + entry];
  viewer.click({rect["x"].get<double>() + 10.0, rect["y"].get<double>() + 0.5 * rect["height"].get<double>()});
}

void startExport(ViewerDriver& viewer) {
  viewer.click(viewer.find("button.export"));
}

bool isOver(const Json& state, const std::string& words) {
  return state["export"].is_null() && tells(state, words);
}

TEST(ExportFromTheWindow, WritesTheClothAsItIs) {
  ViewerDriver viewer({"grid", "--paused"});
  openExport(viewer, "frame");
  startExport(viewer);
  viewer.waitUntil("an OBJ", [](const Json& s) { return tells(s, "grid-001.obj"); });
  choose(viewer, "export.format", "frame.ply");
  fill(viewer, "export.file", "mine");
  startExport(viewer);
  viewer.waitUntil("a PLY", [](const Json& s) { return tells(s, "mine.ply"); });
  viewer.key("e");
  viewer.waitUntil("another OBJ", [](const Json& s) { return tells(s, "grid-002.obj"); });
  EXPECT_EQ(bytesOf(viewer.folder() / "grid-001.obj"), bytesOf(viewer.folder() / "grid-002.obj"));
  EXPECT_EQ(bytesOf(viewer.folder() / "mine.ply").substr(0, 3), "ply");
}

TEST(ExportFromTheWindow, AMotionHasTheBytesThatDrapeHeadlessWrites) {
  ViewerDriver viewer({"grid"});
  openExport(viewer, "motion");
  fill(viewer, "export.to", "0.5");
  fill(viewer, "export.file", "motion");
  startExport(viewer);
  viewer.waitUntil("the file", [](const Json& s) { return isOver(s, "motion.pc2: 16 frames"); });
  const std::filesystem::path other = viewer.folder() / "headless.pc2";
  ASSERT_EQ(runToEnd({.command = {DRAPE_HEADLESS, "run", "grid", "--seconds", "0.5", "--export", other.string()}}), 0);
  EXPECT_EQ(bytesOf(viewer.folder() / "motion.pc2"), bytesOf(other));
}

TEST(ExportFromTheWindow, AMotionCanBeginAtThePresentState) {
  ViewerDriver viewer({"grid"});
  viewer.waitUntil("some motion", [](const Json& s) { return s["time"] > 0.3; });
  viewer.key("space");
  viewer.waitUntil("a pause", [](const Json& s) { return s["paused"].get<bool>(); });
  viewer.key("e");
  viewer.waitUntil("the present cloth", [](const Json& s) { return tells(s, "grid-001.obj"); });
  openExport(viewer, "motion");
  choose(viewer, "export.format", "motion.obj");
  viewer.click(viewer.find("export.start=present"));
  fill(viewer, "export.to", "0.1");
  startExport(viewer);
  viewer.waitUntil("the files", [](const Json& s) { return isOver(s, "4 frames"); });
  const std::filesystem::path folder = viewer.folder() / "grid-001";
  EXPECT_EQ(bytesOf(folder / "frame_0000.obj"), bytesOf(viewer.folder() / "grid-001.obj"));
  EXPECT_TRUE(std::filesystem::exists(folder / "frame_0003.obj"));
  EXPECT_FALSE(std::filesystem::exists(folder / "frame_0004.obj"));
}

TEST(ExportFromTheWindow, AFilmHasTheSizeTheRateAndThePicturesThatWereChosen) {
  ViewerDriver viewer({"grid", "--paused"});
  openExport(viewer, "film");
  fill(viewer, "export.from", "0.2");
  fill(viewer, "export.to", "0.6");
  fill(viewer, "export.rate", "25");
  choose(viewer, "export.size", "640x360");
  startExport(viewer);
  viewer.waitUntil("the film", [](const Json& s) { return isOver(s, "grid-001.mp4: 11 frames"); });
  EXPECT_EQ(render::probeFilm(viewer.folder() / "grid-001.mp4"), "640,360,25/1,11");
  choose(viewer, "export.format", "film.png");
  startExport(viewer);
  viewer.waitUntil("the pictures", [](const Json& s) { return isOver(s, "frame_{frame:4}.png: 11 frames"); });
  EXPECT_EQ(bytesOf(viewer.folder() / "grid-001" / "frame_0010.png").substr(0, 4), "\x89PNG");
  EXPECT_EQ(viewer.state()["step"], 0) << "the cloth of the window did not move";
}

TEST(ExportFromTheWindow, CancelLeavesNoUnfinishedFile) {
  ViewerDriver viewer({"grid", "--paused"});
  openExport(viewer, "film");
  fill(viewer, "export.to", "3600");
  startExport(viewer);
  viewer.waitUntil("a part of it", [](const Json& s) { return !s["export"].is_null() && s["export"]["share"] > 0.0; });
  viewer.click(viewer.find("button.cancel_export"));
  viewer.waitUntil("the end", [](const Json& s) { return isOver(s, "cancelled"); });
  for (const auto& entry : std::filesystem::directory_iterator(viewer.folder())) {
    EXPECT_EQ(entry.path().string().find(".mp4"), std::string::npos) << entry.path();
  }
}

TEST(ExportFromTheWindow, TheWindowAsksBeforeItClosesDuringAnExport) {
  ViewerDriver viewer({"grid", "--paused"});
  openExport(viewer, "motion");
  fill(viewer, "export.to", "3600");
  startExport(viewer);
  viewer.waitUntil("the export", [](const Json& s) { return !s["export"].is_null(); });
  viewer.key("ctrl+q");
  viewer.waitUntil("the question", [](const Json& s) { return s["buttons"].contains("overlay.quit"); });
  viewer.key("Escape");
  viewer.waitUntil("no question",
                   [](const Json& s) { return !s["buttons"].contains("overlay.quit") && !s["export"].is_null(); });
}

TEST(ExportFromTheWindow, ErrorsAreNamedAndNothingIsReplaced) {
  ViewerDriver viewer({"grid", "--paused"});
  std::ofstream(viewer.folder() / "mine.pc2") << "old";
  // A disk without space for two files: they are written beside their names.
  std::filesystem::create_symlink("/dev/full", viewer.folder() / "full.pc2.part");
  std::filesystem::create_symlink("/dev/full", viewer.folder() / "full.mp4.part.mp4");
  openExport(viewer, "motion");
  fill(viewer, "export.to", "0.5");
  const auto expectError = [&](const std::string& file, const std::string& words) {
    fill(viewer, "export.file", file);
    startExport(viewer);
    viewer.waitUntil("the error " + words, [&](const Json& s) { return isOver(s, words); });
  };
  expectError("mine.pc2", "mine.pc2 exists; choose another name");
  EXPECT_EQ(bytesOf(viewer.folder() / "mine.pc2"), "old");
  expectError("/proc/nowhere/a.pc2", "cannot create the folder /proc/nowhere");
  expectError("/proc/a.pc2", "cannot write /proc/a.pc2");
  expectError("full.pc2", "No space left on device");
  expectError("a{b}.pc2", "the placeholder for the number is");
  fill(viewer, "export.from", "0.6");
  expectError("late.pc2", "before it begins");
  viewer.click(viewer.find("export.kind=film"));
  fill(viewer, "export.from", "0");
  expectError("full.mp4", "No space left on device");
}

TEST(ExportFromTheWindow, AMissingFfmpegIsNamed) {
  ViewerDriver viewer({"grid", "--paused"}, DriverOptions{.programs = "/nowhere"});
  openExport(viewer, "film");
  startExport(viewer);
  viewer.waitUntil("the message", [](const Json& s) { return isOver(s, "Install the package ffmpeg"); });
}

}  // namespace
}  // namespace drape::app
