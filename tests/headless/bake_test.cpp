#include "program.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <cstdlib>
#include <fstream>

namespace drape::app::testing {
namespace {

std::string bakeInto(const std::filesystem::path& folder) {
  return "bake grid --frames 2-40 --rate 25 --checkpoint-every 0 --export " + (folder / "a.pc2").string() +
         " --export " + (folder / "f_{frame:3}.obj").string() + " --export " + (folder / "end.ply").string();
}

TEST(Bake, continuesAfterAKillToTheSameBytes) {
  const auto folder = testFolder();
  ASSERT_EQ(headless(bakeInto(folder / "whole")).status, 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "whole/a.pc2.bake"));
  // The system kills a program that writes past the largest file size [blocks of 512 bytes]: in the middle of a frame,
  // on a machine of any speed.
  for (const char* blocks : {"100", "300", "500"}) {
    const std::string command = "ulimit -c 0; ulimit -f " + std::string(blocks) + "; exec " +
                                std::string(DRAPE_HEADLESS) + " " + bakeInto(folder / "killed") + " >/dev/null 2>&1";
    const int status = std::system(command.c_str());
    EXPECT_TRUE(WIFSIGNALED(status)) << status;
    EXPECT_TRUE(std::filesystem::exists(folder / "killed/a.pc2.bake/checkpoint"));
  }
  const Outcome last = headless(bakeInto(folder / "killed"));
  EXPECT_EQ(last.status, 0) << last.errors;
  EXPECT_NE(last.errors.find("note: continues after frame"), std::string::npos) << last.errors;
  for (const char* name : {"a.pc2", "f_002.obj", "f_040.obj", "end.ply"}) {
    EXPECT_EQ(readFile(folder / "killed" / name), readFile(folder / "whole" / name)) << name;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "whole/f_001.obj"));
  EXPECT_FALSE(std::filesystem::exists(folder / "killed/a.pc2.bake"));
}

TEST(Bake, doesNotContinueWithOtherSettings) {
  const auto folder = testFolder();
  const std::string bake = "bake grid --frames 100000 --checkpoint-every 0 --export " + (folder / "a.csv").string();
  const std::string interrupted =
      "timeout --foreground --signal=INT 1 " + std::string(DRAPE_HEADLESS) + " " + bake + " >/dev/null 2>&1";
  EXPECT_NE(std::system(interrupted.c_str()), 0);
  const Outcome outcome = headless(bake + " --set drag=3");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.errors.find("drag is 3, and was 0"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("remove the folder"), std::string::npos) << outcome.errors;
  const Outcome finer = headless(bake + " --set grid.resolution=9");
  EXPECT_EQ(finer.status, 1);
  EXPECT_NE(finer.errors.find("another mesh"), std::string::npos) << finer.errors;
  EXPECT_NE(finer.errors.find("remove the folder"), std::string::npos) << finer.errors;
  EXPECT_TRUE(std::filesystem::exists(folder / "a.csv.bake/checkpoint")) << "the bake can continue";
}

TEST(Bake, doesNotContinueWithAnotherBody) {
  const auto folder = testFolder();
  const auto write = [&folder](const char* radius) {
    std::ofstream(folder / "ball.toml") << "[cloth]\ngrid = \"horizontal\"\nposition = [0, 1, 0]\n"
                                        << "[[bodies]]\nshape = \"sphere\"\nposition = [0, 0.5, 0]\nradius = " << radius
                                        << "\n";
  };
  write("0.15");
  const std::string bake = "bake " + (folder / "ball.toml").string() +
                           " --frames 100000 --checkpoint-every 0 --export " + (folder / "a.csv").string();
  const std::string interrupted =
      "timeout --foreground --signal=INT 1 " + std::string(DRAPE_HEADLESS) + " " + bake + " >/dev/null 2>&1";
  EXPECT_NE(std::system(interrupted.c_str()), 0);
  write("0.16");
  const Outcome outcome = headless(bake);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.errors.find("the bodies of the scene changed"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("remove the folder"), std::string::npos) << outcome.errors;
  EXPECT_TRUE(std::filesystem::exists(folder / "a.csv.bake/checkpoint")) << "the bake can continue";
}

TEST(Bake, startsFromTheCheckpointOfAnInterruptedBake) {
  const auto folder = testFolder();
  const std::string interrupted = "timeout --foreground --signal=INT 1 " + std::string(DRAPE_HEADLESS) +
                                  " bake grid --frames 100000 --export " + (folder / "a.csv").string() +
                                  " >/dev/null 2>" + (folder / "errors").string();
  EXPECT_NE(std::system(interrupted.c_str()), 0);
  EXPECT_NE(readFile(folder / "errors").find("the same command continues"), std::string::npos);
  const Outcome outcome = headless("bake grid --frames 2 --export " + (folder / "a.csv").string());
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(outcome.errors.find("note: continues after frame"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.output.find("2 frames"), std::string::npos) << outcome.output;
}

TEST(Bake, refusesFramesAndFilesThatDoNotFit) {
  const auto folder = testFolder();
  const std::string file = " --export " + (folder / "a.csv").string();
  EXPECT_EQ(headless("bake grid --frames 10").status, 2);
  EXPECT_EQ(headless("bake grid --frames 9-3" + file).status, 2);
  EXPECT_EQ(headless("bake grid --frames -3" + file).status, 2);
  EXPECT_EQ(headless("bake grid --frames x" + file).status, 2);
  EXPECT_EQ(headless("bake grid --frames 2 --film " + (folder / "a.pc2").string()).status, 2);
}

}  // namespace
}  // namespace drape::app::testing
