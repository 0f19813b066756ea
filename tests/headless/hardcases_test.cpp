#include "program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace drape::app::testing {
namespace {

const std::string quick = "hardcases --short --case heavy_gravity ";

TEST(HardCasesCommand, printsPassOrFailWithTheFiguresForEachSolver) {
  const auto file = testFolder() / "cases.json";
  const Outcome outcome = headless(quick + "--case 7 --solver verlet --solver newton --json " + file.string());
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("heavy_gravity"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("energy gained"), std::string::npos) << outcome.output;
  const auto rows = nlohmann::json::parse(readFile(file))["hard_cases"];
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0]["name"], "heavy_gravity");
  EXPECT_EQ(rows[1]["case"], 7);
  EXPECT_EQ(rows[3]["method"], "newton");
  EXPECT_EQ(rows[0]["passed"], true);
  for (const auto& figure : rows[0]["figures"]) {
    EXPECT_EQ(figure["passes"], true) << figure;
  }
}

TEST(HardCasesCommand, failsWithStatusOneAndSaysWhichSolverFailed) {
  const Outcome outcome = headless(quick + "--solver one_iteration --set derivative=axial");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.output.find("failed"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.errors.find("one_iteration 1"), std::string::npos) << outcome.errors;
}

TEST(HardCasesCommand, countsACaseThatASolverRefusesAsNoFailure) {
  const Outcome outcome = headless("hardcases --short --case fabric_folded --solver kang --markdown");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(outcome.output, "| case | kang |\n|---|---|\n| 24 fabric_folded | refused |\n");
}

TEST(HardCasesCommand, runsCasesOfContactFromJitteredStarts) {
  const auto file = testFolder() / "starts.json";
  const Outcome outcome =
      headless(quick + "--case contact_five_sheets --solver xpbd --starts 2 --json " + file.string());
  const auto rows = nlohmann::json::parse(readFile(file))["hard_cases"];
  ASSERT_EQ(rows.size(), 4U) << "other cases have one start";
  EXPECT_EQ(rows[0]["start"], 0);
  for (int start = 0; start < 3; ++start) {
    EXPECT_EQ(rows[1 + start]["name"], "contact_five_sheets");
    EXPECT_EQ(rows[1 + start]["start"], start);
  }
  EXPECT_NE(rows[2]["figures"], rows[3]["figures"]);
  EXPECT_NE(outcome.output.find("contact_five_sheets, start 2"), std::string::npos) << outcome.output;

  const auto alone = testFolder() / "start.json";
  const Outcome again = headless(quick + "--case contact_five_sheets --solver xpbd --start 2 --json " + alone.string());
  EXPECT_NE(again.output.find("contact_five_sheets, start 2"), std::string::npos) << again.output;
  const auto rowsAlone = nlohmann::json::parse(readFile(alone))["hard_cases"];
  ASSERT_EQ(rowsAlone.size(), 2U);
  EXPECT_EQ(rowsAlone[1]["start"], 2);
  EXPECT_EQ(rowsAlone[1]["figures"], rows[3]["figures"]);
}

TEST(HardCasesCommand, printsATableOfSolvers) {
  const Outcome outcome = headless(quick + "--solver verlet --markdown");
  EXPECT_EQ(outcome.output, "| case | verlet |\n|---|---|\n| 21 heavy_gravity | passed |\n");
}

TEST(HardCasesCommand, putsTheDefaultSolverOnTrial) {
  const Outcome outcome = headless(quick + "--markdown");
  EXPECT_EQ(outcome.output, "| case | auto |\n|---|---|\n| 21 heavy_gravity | passed |\n");
}

TEST(HardCasesCommand, refusesWrongUse) {
  EXPECT_EQ(headless("hardcases --case 44").status, 2);
  EXPECT_EQ(headless(quick + "--solver magic").status, 2);
  EXPECT_EQ(headless(quick + "--set magic=1").status, 2);
  EXPECT_EQ(headless(quick + "--max-seconds 0").status, 2);
  EXPECT_EQ(headless(quick + "--start -1").status, 2);
  EXPECT_EQ(headless(quick + "--start 1 --starts 2").status, 2);
  const Outcome outcome = headless(quick + "--json /nowhere/file.json");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.errors.find("/nowhere/file.json"), std::string::npos) << outcome.errors;
}

}  // namespace
}  // namespace drape::app::testing
