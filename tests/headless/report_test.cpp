#include "program.hpp"
#include "render/image.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

namespace drape::app::testing {
namespace {

nlohmann::json jsonIn(const std::filesystem::path& folder) {
  return nlohmann::json::parse(readFile(folder / "report.json"));
}

void expectHead(const nlohmann::json& json) {
  for (const char* array : {"answer", "budget", "table1", "table2", "work_precision", "conclusions", "stability",
                            "hard_cases", "stretch_limit", "growth", "threads", "collision", "validation"}) {
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

/// Viewers without style sheets once showed every curve in black.
TEST(Report, drawsColouredPicturesForAnotherViewer) {
  if (std::system("command -v rsvg-convert >/dev/null") != 0) {
    GTEST_SKIP() << "rsvg-convert is not installed";
  }
  const auto folder = testFolder();
  ASSERT_EQ(report("--quick --only table1 --output " + folder.string()).status, 0);
  const auto png = folder / "table1.png";
  const std::string command =
      "rsvg-convert " + (folder / "pictures" / "table1.svg").string() + " --output " + png.string();
  ASSERT_EQ(std::system(command.c_str()), 0);
  const render::Image picture = render::readPng(png);
  int white = 0;
  int blue = 0;
  for (std::size_t i = 0; i + 2 < picture.rgb.size(); i += 3) {
    white += picture.rgb[i] == 255 && picture.rgb[i + 1] == 255 && picture.rgb[i + 2] == 255 ? 1 : 0;
    blue += picture.rgb[i + 2] > picture.rgb[i] + 100 ? 1 : 0;
  }
  EXPECT_GT(blue, 300);
  EXPECT_GT(white, picture.width * picture.height / 2);
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
    EXPECT_FALSE(std::filesystem::exists(folder / "new")) << "no empty folder is left behind";
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
  refuses("--only nothing --output " + folder + "/new", 2, "table1");
  EXPECT_FALSE(std::filesystem::exists(folder + "/new")) << "no empty folder is left behind";
  refuses("--threads 0 --output " + folder, 2, "--threads");
  refuses("--scene nothing --output " + folder, 1, "nothing");
  refuses("--scene skirt --output " + folder, 1, "grid");
  refuses("--output /proc/nowhere", 1, "/proc/nowhere");
}

/// A piece of cloth that falls on a ball: its own scene file, mesh and contact.
std::filesystem::path ballScene(const std::filesystem::path& folder, const std::string& settings) {
  std::ofstream mesh(folder / "patch.obj");
  constexpr int side = 8;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      mesh << "v " << 0.04 * column - 0.14 << " 0.31 " << 0.04 * row - 0.14 << '\n';
    }
  }
  for (int row = 0; row + 1 < side; ++row) {
    for (int column = 0; column + 1 < side; ++column) {
      const int corner = row * side + column + 1;
      mesh << "f " << corner << ' ' << corner + side << ' ' << corner + 1 << '\n';
      mesh << "f " << corner + 1 << ' ' << corner + side << ' ' << corner + side + 1 << '\n';
    }
  }
  std::ofstream(folder / "ball.toml") << "title = \"A ball\"\nhelp = \"A piece of cloth falls on a ball.\"\n"
                                         "[cloth]\nmesh = \"patch.obj\"\n"
                                         "[[bodies]]\nname = \"ball\"\nshape = \"sphere\"\nradius = 0.15\n"
                                         "position = [0, 0.15, 0]\n[settings]\ntime_step = \"1/150\"\nstiffness = 20\n"
                                      << settings;
  return folder / "ball.toml";
}

TEST(ReportForABudget, findsTheErrorsOfAClothThatTouchesABody) {
  const auto folder = testFolder();
  const Outcome outcome =
      report("--quick --scene " + ballScene(folder, "").string() +
             " --budget 1000 --seconds 0.2 --set damping=0.01 --output " + (folder / "out").string());
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("For 1000 ms a frame take "), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("Two starts that differ by a micrometre part by"), std::string::npos);
  const auto json = jsonIn(folder / "out");
  EXPECT_EQ(json["settings"]["set"], nlohmann::json::array({"damping=0.01"}));
  EXPECT_TRUE(json["table1"].empty());
  double minError = 1.0;
  double maxError = 0.0;
  for (const auto& row : json["budget"]) {
    EXPECT_EQ(row["contact"], "bodies and itself") << row;
    EXPECT_FALSE(row["noise_floor"].is_null());
    if (row["state"] == "calm") {
      EXPECT_GT(row["us_per_simulated_second"], 0.0);
      minError = std::min(minError, row["error_mean"].get<double>());
      maxError = std::max(maxError, row["error_mean"].get<double>());
    }
  }
  // The settings differ, and the finest of them is close to the reference.
  EXPECT_LT(minError, 1e-3);
  EXPECT_GT(maxError, 2.0 * minError);
  EXPECT_NE(readFile(folder / "out" / "report.html").find("Cloth with contact"), std::string::npos);
}

TEST(ReportForABudget, needsNoFolderAndSaysWhenNothingIsThatCheap) {
  const Outcome outcome = report("--quick --scene grid --set grid.resolution=33 --budget 0.01 --seconds 0.1");
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("0.01 ms a frame"), std::string::npos) << outcome.output;
}

TEST(ReportForABudget, refusesWrongUse) {
  const auto refuses = [](const std::string& arguments, int status, const std::string& because) {
    const Outcome outcome = report(arguments);
    EXPECT_EQ(outcome.status, status) << arguments;
    EXPECT_NE(outcome.errors.find(because), std::string::npos) << outcome.errors;
  };
  refuses("--budget 2", 2, "--scene");
  refuses("--scene grid --budget 0", 2, "--budget");
  refuses("--scene grid --budget many", 2, "--budget");
  refuses("--scene nothing.obj --budget 2", 1, "nothing.obj");
  refuses("--scene grid --budget 2 --set stiffnes=3", 2, "stiffnes");
  refuses("--scene grid --budget 2 --set stiffness=-3", 2, "stiffness");
  refuses("--scene grid --budget 2 --set time_step=0.007", 2, "time_step");
  refuses("--scene grid --budget 2 --only table1", 2, "--only");
  refuses("--scene grid --budget 2 --seconds 100", 2, "--seconds");
  refuses("--scene grid --budget 2 --resume", 2, "--output");
  refuses("--set stiffness=3 --output " + testFolder().string(), 2, "--budget");
}

}  // namespace
}  // namespace drape::app::testing
