#include "program.hpp"

#include <gtest/gtest.h>
#include <cstdlib>

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
  int kills = 0;
  bool wasInterrupted = false;
  for (int status = 1; status != 0; ++kills) {
    // Later attempts have more time, so that one ends on a machine of any speed.
    const std::string seconds = std::to_string(0.05 * (kills + 1));
    const std::string command = "timeout --signal=KILL " + seconds + " " + std::string(DRAPE_HEADLESS) + " " +
                                bakeInto(folder / "killed") + " >/dev/null 2>&1";
    status = std::system(command.c_str());
    wasInterrupted =
        wasInterrupted || (status != 0 && std::filesystem::exists(folder / "killed/a.pc2.bake/checkpoint"));
  }
  EXPECT_TRUE(wasInterrupted);
  for (const char* name : {"a.pc2", "f_002.obj", "f_040.obj", "end.ply"}) {
    EXPECT_EQ(readFile(folder / "killed" / name), readFile(folder / "whole" / name)) << name;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "whole/f_001.obj"));
  EXPECT_FALSE(std::filesystem::exists(folder / "killed/a.pc2.bake"));
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
