#include "program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

namespace drape::testing {
namespace {

nlohmann::json jsonIn(const std::filesystem::path& folder) {
  return nlohmann::json::parse(readFile(folder / "report.json"));
}

void expectHead(const nlohmann::json& json) {
  for (const char* array : {"table1", "growth", "work_precision", "stability"}) {
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
    EXPECT_TRUE(row["self_collision_ms"].is_null());
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

TEST(Report, measuresNothingAgainWhenItGoesOn) {
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

TEST(Report, writesWhatItHasWhenItIsInterrupted) {
  const auto folder = testFolder();
  // A full measurement of the frame update takes half a minute by its plan.
  const Outcome outcome = interruptedReport(1, "--only table1 --output " + folder.string());
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.errors.find("--resume"), std::string::npos) << outcome.errors;
  const auto json = jsonIn(folder);
  expectHead(json);
  EXPECT_EQ(json["complete"], false);
  EXPECT_LT(json["table1"].size(), 14U);
  EXPECT_NE(readFile(folder / "report.html").find("</html>"), std::string::npos);
}

/// The mean error after that time in a report's work_precision.
double errorOf(const nlohmann::json& json, const std::string& method, const std::string& setting, double time) {
  for (const auto& row : json["work_precision"]) {
    if (row["method"] == method && row["setting"] == setting && row["time"] == time) {
      return row["error_mean"].get<double>();
    }
  }
  ADD_FAILURE() << "no row for " << method << " " << setting;
  return 0.0;
}

void expectRows(const nlohmann::json& rows, std::initializer_list<const char*> keys) {
  EXPECT_FALSE(rows.empty());
  for (const auto& row : rows) {
    for (const char* key : keys) {
      EXPECT_TRUE(row.contains(key)) << key << " in " << row;
    }
  }
}

TEST(Report, holdsToItsSchemaAndToWhatIsKnownOfTheMethods) {
  const auto folder = testFolder();
  const Outcome outcome = report("--quick --output " + folder.string());
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto json = jsonIn(folder);
  expectHead(json);
  expectRows(json["work_precision"],
             {"scene", "resolution", "stiffness", "time", "method", "setting", "us_per_simulated_second", "error_mean",
              "error_rms", "eps", "S", "state", "trusted"});
  expectRows(json["stability"], {"method", "resolution", "stiffness", "step", "state"});
  expectRows(json["growth"], {"method", "resolution", "vertices"});
  for (const auto& row : json["work_precision"]) {
    EXPECT_EQ(row["rounds"], 3);
    EXPECT_GE(row["samples"].size(), 1U);
  }
  const auto error = [&json](const char* method, const char* setting) { return errorOf(json, method, setting, 0.2); };
  // Verlet is of second order: a quarter of the step, a sixteenth of the error.
  EXPECT_NEAR(error("verlet", "substeps=4") / error("verlet", "substeps=16"), 20.0, 8.0);
  // Backward Euler is of first order, and more sweeps bring one iteration nearer to it.
  EXPECT_NEAR(error("one_iteration", "substeps=4") / error("one_iteration", "substeps=16"), 4.0, 1.5);
  EXPECT_LT(error("one_iteration", "sweeps=9"), error("one_iteration", "sweeps=3"));
  // Exact solves of the same step end in the same place, whoever makes them.
  const double newton = error("newton", "substeps=1 tolerance=1e-6");
  EXPECT_NEAR(error("vbd", "iterations=10") / newton, 1.0, 0.05);
  EXPECT_NEAR(error("local_global", "iterations=10") / newton, 1.0, 0.05);
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
}  // namespace drape::testing
