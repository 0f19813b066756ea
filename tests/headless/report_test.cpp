#include "program.hpp"

#include <gtest/gtest.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

namespace drape::app::testing {
namespace {

nlohmann::json jsonIn(const std::filesystem::path& folder) {
  return nlohmann::json::parse(readFile(folder / "report.json"));
}

void expectHead(const nlohmann::json& json) {
  for (const char* array : {"table1", "table2", "work_precision", "what_follows", "stability", "hard_cases",
                            "stretch_limit", "growth", "threads", "collision", "validation"}) {
    EXPECT_TRUE(json[array].is_array()) << array;
  }
  ASSERT_TRUE(json["machine"].is_object());
  for (const char* name : {"cpu", "simd", "compiler", "flags", "build_type", "commit", "date"}) {
    EXPECT_FALSE(json["machine"][name].get<std::string>().empty()) << name;
  }
  EXPECT_GT(json["machine"]["cores"], 0);
}

TEST(Report, measuresTheFrameUpdateAndWritesAllItsFiles) {
  const auto folder = testFolder() / "new" / "folder";
  const Outcome outcome = report("--quick --only table1 --output " + folder.string());
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto json = jsonIn(folder);
  expectHead(json);
  EXPECT_EQ(json["complete"], true);
  EXPECT_EQ(json["settings"]["quick"], true);
  EXPECT_TRUE(json["growth"].empty());
  std::set<std::pair<int, std::string>> measured;
  for (const auto& row : json["table1"]) {
    measured.emplace(row["resolution"].get<int>(), row["precision"].get<std::string>());
    EXPECT_GT(row["update_ms"], 0.0);
    EXPECT_EQ(row["self_collision_ms"].is_null(), row["resolution"] > 33);
  }
  EXPECT_EQ(measured.size(), 10U);
  const auto& first = json["table1"][0];
  EXPECT_EQ(first["vertices"], 289);
  EXPECT_EQ(first["springs"], 800);
  EXPECT_EQ(first["triangles"], 512);
  EXPECT_EQ(first["paper_update_ms"], 0.5);
  EXPECT_NE(readFile(folder / "report.md").find("pictures/table1.svg"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder / "pictures" / "table1.svg"));
  EXPECT_NE(readFile(folder / "report.html").find("</html>"), std::string::npos);
}

TEST(Report, measuresNothingAgainWhenItContinues) {
  const auto folder = testFolder();
  const std::string arguments = "--quick --only table1 --output " + folder.string();
  ASSERT_EQ(report(arguments).status, 0);
  const auto before = jsonIn(folder);
  ASSERT_EQ(report(arguments + " --resume").status, 0);
  EXPECT_EQ(jsonIn(folder)["table1"], before["table1"]);
  const Outcome other = report(arguments + " --threads 2 --resume");
  EXPECT_EQ(other.status, 1);
  EXPECT_NE(other.errors.find("same options"), std::string::npos) << other.errors;
}

TEST(Report, writesItsResultsWhenItIsInterrupted) {
  const auto folder = testFolder();
  // A full measurement of the frame update takes half a minute.
  const Outcome outcome = interruptedReport(1, "--only table1 --output " + folder.string());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.errors.find("--resume"), std::string::npos) << outcome.errors;
  const auto json = jsonIn(folder);
  expectHead(json);
  EXPECT_EQ(json["complete"], false);
  EXPECT_LE(json["table1"].size(), 14U);
  EXPECT_NE(readFile(folder / "report.html").find("</html>"), std::string::npos);
}

TEST(Report, listsTheChangesSinceAnEarlierOne) {
  const auto folder = testFolder();
  const std::string arguments = "--quick --only table1 --output " + folder.string();
  ASSERT_EQ(report(arguments).status, 0);
  const std::string file = (folder / "report.json").string();
  // --resume keeps the same values, whether or not it measures again.
  const Outcome same = report(arguments + " --resume --compare " + file);
  EXPECT_EQ(same.status, 0) << same.errors;
  EXPECT_NE(same.output.find("0 changed beyond noise"), std::string::npos) << same.output;

  auto older = jsonIn(folder);
  older["comparison"] = nullptr;
  for (auto& row : older["table1"]) {
    for (auto& sample : row["samples"]) {
      sample = 1e3 * sample.get<double>();
    }
    row["update_ms"] = 1e3 * row["update_ms"].get<double>();
  }
  const auto slow = folder / "slow.json";
  std::ofstream(slow) << older;
  const Outcome moved = report(arguments + " --resume --compare " + slow.string());
  EXPECT_EQ(moved.status, 3) << moved.errors;
  EXPECT_NE(moved.output.find("10 faster"), std::string::npos) << moved.output;
  EXPECT_EQ(jsonIn(folder)["comparison"]["moved"].size(), 10U);
  EXPECT_NE(readFile(folder / "report.html").find("Changes since an earlier report"), std::string::npos);
}

TEST(Report, refusesToCompareWithWrongFiles) {
  const auto folder = testFolder();
  const auto refuses = [&](const std::string& text, const std::string& because) {
    std::ofstream(folder / "old.json") << text;
    const Outcome outcome = report("--quick --only table1 --output " + (folder / "new").string() + " --compare " +
                                   (folder / "old.json").string());
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.errors.find(because), std::string::npos) << outcome.errors;
  };
  refuses("no JSON", "is not JSON");
  refuses("{}", "is not a report.json");
  refuses(R"({"format": 1, "settings": {}, "machine": {}})", "format");
  refuses(R"({"format": 2, "settings": {"quick": false, "scene": "", "threads": 1}, "machine": {}})", "same options");
}

TEST(Report, refusesWrongUse) {
  const auto refuses = [](const std::string& arguments, int status, const std::string& because) {
    const Outcome outcome = report(arguments);
    EXPECT_EQ(outcome.status, status) << arguments;
    EXPECT_NE(outcome.errors.find(because), std::string::npos) << outcome.errors;
  };
  const std::string folder = testFolder().string();
  refuses("--quick", 2, "--output");
  refuses("--only nothing --output " + folder, 2, "table1");
  refuses("--threads 0 --output " + folder, 2, "--threads");
  refuses("--scene nothing --output " + folder, 1, "nothing");
  refuses("--scene skirt --output " + folder, 1, "grid");
  refuses("--output /proc/nowhere", 1, "/proc/nowhere");
}

}  // namespace
}  // namespace drape::app::testing
