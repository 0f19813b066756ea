#include "compare_images.hpp"
#include "program.hpp"

#include <gtest/gtest.h>
#include <set>

namespace drape::app::testing {
namespace {

std::string pattern(const std::filesystem::path& folder) {
  return "'" + (folder / "f_{frame:3}.png").string() + "'";
}

TEST(Capture, writesAsManyPicturesAsAskedForOfThatSize) {
  const auto folder = testFolder();
  const Outcome outcome =
      headless("capture grid --frames 3 --every 10 --resolution 160,120 --output " + pattern(folder));
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  for (const char* name : {"f_000.png", "f_001.png", "f_002.png"}) {
    const render::Image image = render::readPng(folder / name);
    EXPECT_EQ(image.width, 160);
    EXPECT_EQ(image.height, 120);
    EXPECT_GT(std::set<std::uint8_t>(image.rgb.begin(), image.rgb.end()).size(), 16U) << "an empty picture";
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "f_003.png"));
  const auto moved =
      render::compareImages(render::readPng(folder / "f_000.png"), render::readPng(folder / "f_002.png"));
  EXPECT_GT(moved.pixels, 200);
}

TEST(Capture, drawsTheSamePictureEveryTime) {
  const auto folder = testFolder();
  const std::string arguments = "capture grid --frames 2 --every 20 --resolution 160,120 --output ";
  ASSERT_EQ(headless(arguments + pattern(folder / "a")).status, 0);
  ASSERT_EQ(headless(arguments + pattern(folder / "b")).status, 0);
  EXPECT_EQ(readFile(folder / "a" / "f_001.png"), readFile(folder / "b" / "f_001.png"));
}

TEST(Capture, takesTheCameraFromTheCommandLine) {
  const auto folder = testFolder();
  const std::string start = "capture grid --frames 1 --resolution 160,120 ";
  ASSERT_EQ(headless(start + "--output " + (folder / "a.png").string()).status, 0);
  ASSERT_EQ(
      headless(start + "--camera-position 4,1,0 --camera-focal-point 0,1,0 --output " + (folder / "b.png").string())
          .status,
      0);
  EXPECT_GT(render::compareImages(render::readPng(folder / "a.png"), render::readPng(folder / "b.png")).pixels, 500);
}

TEST(Capture, drawsTheGhost) {
  const auto folder = testFolder();
  const std::string start = "capture grid --frames 2 --every 40 --resolution 160,120 ";
  ASSERT_EQ(headless(start + "--output " + pattern(folder / "a")).status, 0);
  ASSERT_EQ(
      headless(start + "--set ghost.solver=one_iteration --set ghost.substeps=10 --output " + pattern(folder / "b"))
          .status,
      0);
  EXPECT_EQ(
      render::compareImages(render::readPng(folder / "a" / "f_000.png"), render::readPng(folder / "b" / "f_000.png"), 8)
          .pixels,
      0);
  EXPECT_GT(
      render::compareImages(render::readPng(folder / "a" / "f_001.png"), render::readPng(folder / "b" / "f_001.png"), 8)
          .pixels,
      100);
}

TEST(Capture, drawsThePanelsWhenAsked) {
  const auto folder = testFolder();
  const std::string start = "capture grid --frames 1 --resolution 960,600 ";
  ASSERT_EQ(headless(start + "--output " + (folder / "a.png").string()).status, 0);
  ASSERT_EQ(headless(start + "--ui --output " + (folder / "b.png").string()).status, 0);
  const auto panels = render::compareImages(render::readPng(folder / "a.png"), render::readPng(folder / "b.png"));
  EXPECT_GT(panels.pixels, 960 * 600 / 10);
}

TEST(Capture, drawsWhereTheDriverHasNoMultisampling) {
  const auto folder = testFolder();
  const std::string start = "capture grid --frames 1 --resolution 160,120 --output ";
  const Outcome outcome = headlessOnSoftpipe(start + (folder / "a.png").string());
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  ASSERT_EQ(headless(start + (folder / "b.png").string()).status, 0);
  const auto difference =
      render::compareImages(render::readPng(folder / "a.png"), render::readPng(folder / "b.png"), 32);
  EXPECT_LT(difference.pixels, 160 * 120 / 10) << "the same picture but for its edges";
}

TEST(Capture, refusesWrongUsageWithStatusTwo) {
  for (const char* arguments :
       {"capture grid --frames 2", "capture grid --frames 2 --output f.png", "capture grid --frames 0 --output f.png",
        "capture grid --frames 1 --resolution 0,0 --output f.png",
        "capture grid --frames 1 --resolution 100 --output f.png",
        "capture grid --frames 1 --resolution 100,abc --output f.png", "capture grid --frames 1 --output f.bmp",
        "capture grid --frames 2 --output f_{frame}.jpg",
        "capture grid --frames 1 --camera-position 1,2 --output f.png",
        "capture grid --frames 1 --camera-position 0,0,0 --camera-focal-point 0,0,0 --output f.png"}) {
    const Outcome outcome = headless(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments << '\n' << outcome.errors;
  }
}

TEST(Capture, failsWithStatusOneWhereItCannotWrite) {
  EXPECT_EQ(headless("capture grid --frames 1 --resolution 64,64 --output /proc/no/f.png").status, 1);
}

}  // namespace
}  // namespace drape::app::testing
