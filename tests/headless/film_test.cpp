#include "film_probe.hpp"
#include "program.hpp"

#include <gtest/gtest.h>
#include <cstdlib>

namespace drape::app::testing {
namespace {

class Film : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v ffmpeg >/dev/null && command -v ffprobe >/dev/null") != 0) {
      GTEST_SKIP() << "ffmpeg is not installed";
    }
  }
};

TEST_F(Film, hasThePicturesTheSizeAndTheRateThatWereAskedFor) {
  const auto folder = testFolder();
  const std::string start = "capture grid --frames 7 --resolution 161,121 --rate 25 --output ";
  for (const char* name : {"a.mp4", "a.webm"}) {
    const Outcome outcome = headless(start + (folder / name).string());
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(render::probeFilm(folder / name), "162,122,25/1,7") << name;
  }
  ASSERT_EQ(headless(start + (folder / "a.gif").string()).status, 0);
  EXPECT_EQ(render::probeFilm(folder / "a.gif"), "161,121,25/1,7");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.mp4.part.mp4"));
}

TEST_F(Film, playsAfterCtrlC) {
  const auto folder = testFolder();
  // Enough time for some pictures, and not for all of them.
  const std::string command = "timeout --foreground --signal=INT 4 " + std::string(DRAPE_HEADLESS) +
                              " capture grid --frames 100000 --resolution 64,48 --output " +
                              (folder / "a.mp4").string() + " >/dev/null 2>" + (folder / "errors").string();
  (void)std::system(command.c_str());
  EXPECT_NE(readFile(folder / "errors").find("stopped by a signal after"), std::string::npos);
  const std::string answer = render::probeFilm(folder / "a.mp4");
  EXPECT_EQ(answer.rfind("64,48,30/1,", 0), 0U) << answer;
  EXPECT_GT(std::stoi(answer.substr(answer.rfind(',') + 1)), 0);
}

TEST_F(Film, namesThePackageWhenTheProgramIsMissing) {
  const auto folder = testFolder();
  const std::string command = "PATH=/nowhere " + std::string(DRAPE_HEADLESS) + " capture grid --frames 2 --output " +
                              (folder / "a.mp4").string() + " 2>" + (folder / "errors").string();
  EXPECT_NE(std::system(command.c_str()), 0);
  EXPECT_NE(readFile(folder / "errors").find("Install the package ffmpeg"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "a.mp4"));
}

TEST_F(Film, saysWhyItCannotBeWritten) {
  const auto folder = testFolder();
  std::filesystem::create_directory(folder / "a.mp4.part.mp4");
  const Outcome outcome =
      headless("capture grid --frames 2 --resolution 64,48 --output " + (folder / "a.mp4").string());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.errors.find("ffmpeg failed"), std::string::npos) << outcome.errors;
}

}  // namespace
}  // namespace drape::app::testing
