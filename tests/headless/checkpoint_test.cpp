#include "program.hpp"

#include <gtest/gtest.h>
#include <fstream>
#include <nlohmann/json.hpp>

namespace drape::app::testing {
namespace {

std::string hashOf(const std::filesystem::path& stats) {
  return nlohmann::json::parse(readFile(stats))["state_hash"];
}

TEST(Checkpoint, endsInTheBitsOfAnUninterruptedRun) {
  const auto folder = testFolder();
  const std::string start = "run skirt --stats " + (folder / "s.json").string() + " --seconds ";
  ASSERT_EQ(headless(start + "0.6").status, 0);
  const std::string wanted = hashOf(folder / "s.json");
  const std::string file = (folder / "c").string();
  ASSERT_EQ(headless(start + "0.3 --save " + file).status, 0);
  EXPECT_NE(hashOf(folder / "s.json"), wanted);
  const Outcome outcome = headless(start + "0.6 --resume " + file);
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(hashOf(folder / "s.json"), wanted);
}

TEST(Checkpoint, continuesTheFramesOfAnExport) {
  const auto folder = testFolder();
  const std::string file = (folder / "c").string();
  const auto run = [&](const std::string& arguments, const std::string& name) {
    const Outcome outcome = headless("run grid --seconds " + arguments + " --export " + (folder / name).string() +
                                     " --export " + (folder / (name + "_{frame:2}.obj")).string());
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
  };
  run("0.4", "whole.csv");
  run("0.2 --save " + file, "first.csv");
  run("0.4 --resume " + file, "second.csv");
  const std::string whole = readFile(folder / "whole.csv");
  const std::string second = readFile(folder / "second.csv");
  const std::size_t header = second.find('\n') + 1;
  EXPECT_EQ(whole.substr(whole.size() - (second.size() - header)), second.substr(header));
  EXPECT_FALSE(std::filesystem::exists(folder / "second.csv_05.obj"));
  EXPECT_EQ(readFile(folder / "second.csv_06.obj"), readFile(folder / "first.csv_06.obj"));
  EXPECT_EQ(readFile(folder / "second.csv_12.obj"), readFile(folder / "whole.csv_12.obj"));
}

TEST(Checkpoint, namesAnotherBody) {
  const auto folder = testFolder();
  const std::string scene = (folder / "ball.toml").string();
  const auto write = [&scene](const char* radius) {
    std::ofstream(scene) << "[cloth]\ngrid = \"horizontal\"\nposition = [0, 1, 0]\n"
                         << "[[bodies]]\nshape = \"sphere\"\nposition = [0, 0.5, 0]\nradius = " << radius << "\n";
  };
  write("0.15");
  const std::string file = (folder / "c").string();
  ASSERT_EQ(headless("run " + scene + " --seconds 0.1 --save " + file).status, 0);
  const std::string resume = "run " + scene + " --seconds 0.2 --resume " + file;
  const std::string note = "note: the bodies of the scene changed since the checkpoint was saved";
  EXPECT_EQ(headless(resume).errors.find(note), std::string::npos);
  write("0.16");
  const Outcome changed = headless(resume);
  EXPECT_EQ(changed.status, 0);
  EXPECT_NE(changed.errors.find(note), std::string::npos) << changed.errors;
}

TEST(Checkpoint, saysWhatIsWrongWithAFile) {
  const auto folder = testFolder();
  const std::string file = (folder / "c").string();
  const Outcome missing = headless("run grid --seconds 1 --resume " + file);
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(missing.errors.find("cannot be read (No such file"), std::string::npos) << missing.errors;
  ASSERT_EQ(headless("run grid --seconds 0.2 --save " + file).status, 0);
  const Outcome other = headless("run skirt --seconds 1 --resume " + file);
  EXPECT_EQ(other.status, 1);
  EXPECT_NE(other.errors.find("another mesh"), std::string::npos) << other.errors;
  const Outcome late = headless("run grid --seconds 0.1 --resume " + file);
  EXPECT_EQ(late.status, 2);
  EXPECT_NE(late.errors.find("the checkpoint is at 0.2 s"), std::string::npos) << late.errors;
  EXPECT_EQ(headless("run grid --seconds 0 --save " + (folder / "no" / "c").string()).status, 1);
}

}  // namespace
}  // namespace drape::app::testing
