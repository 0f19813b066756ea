#include "report/section.hpp"
#include "report/sections/budget_choice.hpp"
#include "report/sections/paper_claims.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace drape::report {
namespace {

/// A row of work_precision or of the section budget.
ReportRow setting(const std::string& method, double msPerFrame, double error, const std::string& state = "calm") {
  return {{"scene", "hang"},
          {"resolution", 33},
          {"material", "springs"},
          {"stiffness", 10.0},
          {"time", 0.5},
          {"method", method},
          {"setting", "substeps=1"},
          {"us_per_simulated_second", 60e3 * msPerFrame},
          {"error_mean", error},
          {"error_of_diagonal", error},
          {"state", state},
          {"noise_floor", 1e-5},
          {"reference_difference", 1e-6}};
}

const Section& answerSection() {
  return sectionTable().front();
}

ReportRow answerFor(const ReportRows& answers, const std::string& kind, double budget) {
  const auto found = std::find_if(answers.begin(), answers.end(), [&](const ReportRow& row) {
    return row.value("kind", "") == kind && row.value("budget_ms", 0.0) == budget;
  });
  EXPECT_NE(found, answers.end()) << kind;
  return found == answers.end() ? ReportRow() : *found;
}

std::string verdictOn(const SectionRows& rows, const std::string& claim) {
  for (const ReportRow& row : sections::claimRows(rows)) {
    if (row.value("claim", "").starts_with(claim)) {
      return row.value("verdict", "");
    }
  }
  return "no such claim";
}

/// What the section budget says about a setting that moves that part of the converged motion [-].
std::string choiceOf(double motionKept) {
  ReportRow row = setting("one_iteration", 0.1, 1e-6);
  row["motion_kept"] = motionKept;
  row["error_max"] = 1e-6;
  row["reference_step"] = 1e-3;
  const auto budget = std::ranges::find(sectionTable(), std::string("budget"), &Section::name);
  const std::vector<Block> blocks = budget->show({}, {row});
  return std::get<Paragraph>(blocks.front()).text;
}

TEST(BudgetChoice, saysThatTheChosenSettingHardlyMoves) {
  EXPECT_NE(choiceOf(0.04).find("moved only 4 % as far"), std::string::npos) << choiceOf(0.04);
  EXPECT_EQ(choiceOf(0.9).find("moved only"), std::string::npos) << choiceOf(0.9);
}

TEST(BudgetChoice, takesTheSmallestErrorThatTheBudgetAllows) {
  const ReportRows rows{setting("cheap", 0.05, 1e-2), setting("better", 0.4, 1e-3), setting("best", 3.0, 1e-4),
                        setting("wild", 0.01, 1e-6, "exploded")};
  EXPECT_EQ((*sections::bestForBudget(rows, 0.1))["method"], "cheap");
  EXPECT_EQ((*sections::bestForBudget(rows, 0.5))["method"], "better");
  EXPECT_EQ((*sections::bestForBudget(rows, 8.0))["method"], "best");
  EXPECT_EQ(sections::bestForBudget(rows, 0.02), nullptr);
  EXPECT_EQ((*sections::cheapestCalm(rows))["method"], "cheap");
}

TEST(BudgetChoice, takesTheCheapestOfThoseThatCannotBeToldApart) {
  // Two starts part by 0.01 mm, so these errors are equal.
  const ReportRows rows{setting("dear", 3.0, 1e-6), setting("cheap", 0.4, 9e-6), setting("worse", 0.2, 2e-5)};
  EXPECT_EQ((*sections::bestForBudget(rows, 8.0))["method"], "cheap");
  EXPECT_EQ(sections::errorFloor(rows), 1e-5);
  EXPECT_EQ(sections::errorText(rows[1], sections::errorFloor(rows)), "less than 10 um");
  EXPECT_EQ(sections::errorText(rows[2], sections::errorFloor(rows)), "20 um");
}

TEST(Answer, comesFirstAndHasAFieldForEachKindAndBudget) {
  SectionRows all;
  all["work_precision"] = {setting("auto", 0.4, 1e-3), setting("verlet", 3.0, 1e-4)};
  EXPECT_EQ(answerSection().name, "answer");
  const ReportRows answers = answerSection().derive(all);
  EXPECT_TRUE(answerFor(answers, "Soft sheet", 0.1)["method"].is_null());
  EXPECT_EQ(answerFor(answers, "Soft sheet", 0.1)["cheapest"], "auto substeps=1");
  EXPECT_EQ(answerFor(answers, "Soft sheet", 0.5)["method"], "auto");
  EXPECT_EQ(answerFor(answers, "Soft sheet", 8.0)["method"], "verlet");
  EXPECT_TRUE(answerFor(answers, "Flag in wind", 8.0)["cloth"].is_null());
  const auto blocks = answerSection().show({}, answers);
  const TextTable& table = std::get<TextTable>(blocks.at(0));
  ASSERT_EQ(table.rows.size(), 5U);
  EXPECT_EQ(table.rows[0].size(), 6U);
  EXPECT_EQ(table.rows[0][1], "none");
  EXPECT_EQ(table.rows[0][2], "auto substeps=1\n0.4 ms, off by 1 mm");
  EXPECT_EQ(table.rows[4][1], "not measured");
}

TEST(Answer, tellsWhatItTakesWhereNoSettingIsFastEnough) {
  SectionRows all;
  all["work_precision"] = {setting("auto", 30.0, 2e-2), setting("verlet", 60.0, 6e-3)};
  const auto blocks = answerSection().show({}, answerSection().derive(all));
  const TextTable& table = std::get<TextTable>(blocks.at(0));
  EXPECT_EQ(table.rows[0][1], "none");
  EXPECT_EQ(table.rows[0][5],
            "none\nThe cheapest is auto substeps=1: 30 ms, off by 20 mm\n"
            "The smallest error has verlet substeps=1: 60 ms, off by 6 mm");
}

TEST(Answer, hasNoTableOfMethodsWhereNoneWasMeasured) {
  SectionRows all;
  const ReportRow row{
      {"precision", "float"}, {"resolution", 17}, {"springs", 800}, {"update_ms", 0.1}, {"self_collision_ms", 0.1}};
  all["table1"].push_back(row);
  const auto blocks = answerSection().show({}, answerSection().derive(all));
  ASSERT_EQ(blocks.size(), 1U);
  EXPECT_EQ(std::get<TextTable>(blocks[0]).header[0], "claim");
}

TEST(Answer, isMissingWhereNothingThatItNeedsWasMeasured) {
  EXPECT_TRUE(answerSection().derive({}).empty());
}

TEST(PaperClaims, areDecidedByTheRows) {
  SectionRows rows;
  EXPECT_EQ(verdictOn(rows, "An update takes time linear"), "not measured");
  const auto update = [](int resolution, double milliseconds) -> ReportRow {
    return {{"precision", "float"},
            {"resolution", resolution},
            {"springs", 3 * resolution * resolution},
            {"update_ms", milliseconds},
            {"self_collision_ms", 0.1}};
  };
  rows["table1"] = {update(17, 0.1), update(65, 1.0), update(129, 4.0)};
  EXPECT_EQ(verdictOn(rows, "An update takes time linear"), "confirmed");
  EXPECT_EQ(verdictOn(rows, "Table 1"), "confirmed");
  rows["table1"] = {update(17, 0.6), update(65, 1.0), update(129, 16.0)};
  EXPECT_EQ(verdictOn(rows, "An update takes time linear"), "refuted");
  EXPECT_EQ(verdictOn(rows, "Table 1"), "not testable");  // another machine may be slower
}

TEST(PaperClaims, aboutErrorsCountRunsUnderThePapersConditions) {
  const auto run = [](double stiffness, double eps, int within) -> ReportRow {
    return {{"method", "one_iteration"},
            {"mode", "free-running"},
            {"start", "flat, edge"},
            {"stiffness", stiffness},
            {"checkpoints", 25},
            {"eps_max", eps},
            {"S_min", 0.9},
            {"checkpoints_within_paper", within}};
  };
  SectionRows rows;
  rows["table2"] = {run(10.0, 0.1, 3), run(1000.0, 1e-4, 25)};
  EXPECT_EQ(verdictOn(rows, "Table 2"), "refuted");
  EXPECT_EQ(verdictOn(rows, "Figs. 7 and 8"), "refuted");
  rows["table2"].push_back(run(10.0, 4e-4, 25));
  EXPECT_EQ(verdictOn(rows, "Table 2"), "confirmed");
  EXPECT_EQ(verdictOn(rows, "Figs. 7 and 8"), "confirmed");
}

TEST(PaperClaims, aboutStabilityCountLargeStepsAndCompressedSheets) {
  const auto cell = [](const char* method, double step, const char* state) -> ReportRow {
    return {{"method", method}, {"step", step}, {"state", state}};
  };
  SectionRows rows;
  rows["stability"] = {cell("one_iteration", 1.0 / 60.0, "calm"), cell("one_iteration", 1.0 / 300.0, "explodes"),
                       cell("verlet", 1.0 / 30.0, "explodes")};
  EXPECT_EQ(verdictOn(rows, "Sufficiently stable"), "confirmed");
  rows["stability"].push_back(cell("one_iteration", 1.0 / 30.0, "rattles"));
  EXPECT_EQ(verdictOn(rows, "Sufficiently stable"), "refuted");
  ReportRow crushed = setting("one_iteration", 1.0, 1.0, "exploded");
  crushed["scene"] = "crush";
  crushed["setting"] = "substeps=4 integration=theta theta=0.5";
  rows["work_precision"] = {crushed};
  EXPECT_EQ(verdictOn(rows, "No instability under compression"), "not measured");
  crushed["setting"] = "substeps=4";
  rows["work_precision"].push_back(crushed);
  EXPECT_EQ(verdictOn(rows, "No instability under compression"), "refuted");
}

}  // namespace
}  // namespace drape::report
