#include "report/sections/error_check_view.hpp"
#include "report/sections/sections.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <string>
#include <variant>

namespace drape::report {
namespace {

ReportOptions quickOptions() {
  ReportOptions options;
  options.quick = true;
  return options;
}

ReportRow rowWith(const char* state, double checked, double error) {
  return {{"scene", "hang"},   {"resolution", 17},    {"material", "springs"},
          {"stiffness", 10.0}, {"time", 0.2},         {"method", "auto"},
          {"state", state},    {"error", error},      {"checked_error", checked},
          {"spread", 1e-6},    {"noise_floor", 1e-6}, {"reference_difference", 1e-8}};
}

TEST(ErrorCheckSection, findsErrorsThatAreRightWithinAFactorOfFiveInAllCellsOfTheQuickForm) {
  const SectionPlan plan = sections::errorCheck().plan(quickOptions());
  ReportRows rows;
  for (const Cell& cell : plan.cells) {
    const ReportRows own = cell.measure({{}, {}});
    ASSERT_EQ(own.size(), 1U) << cell.key;
    EXPECT_EQ(sections::checkNote(own[0]), "") << cell.key << ": " << own[0];
    rows.push_back(own[0]);
  }
  const sections::CheckCounts counts = sections::countChecks(rows);
  EXPECT_EQ(counts.wrong, 0);
  EXPECT_EQ(counts.noResult, 0);
  EXPECT_GE(counts.right, 10) << "it says for few cloths that the error cannot be known";
}

TEST(ErrorCheckSection, callsAnErrorWrongThatIsOffByMoreThanAFactorOfFive) {
  EXPECT_EQ(sections::checkNote(rowWith("known", 2e-3, 1e-3)), "");
  EXPECT_EQ(sections::checkNote(rowWith("known", 6e-3, 1e-3)), "too large");
  EXPECT_EQ(sections::checkNote(rowWith("known", 1e-4, 1e-3)), "too small");
  EXPECT_EQ(sections::checkNote(rowWith("not known", 1e-4, 1e-3)), "") << "it does not claim anything";
  EXPECT_EQ(sections::checkNote(rowWith("known", 1e-9, 8e-7)), "") << "both are negligible";
}

ReportRow rowWithSpread(double spread, double jitter) {
  ReportRow row = rowWith("not known", 1e-3, 1e-3);
  row["spread"] = spread;
  row["noise_floor"] = jitter;
  return row;
}

TEST(ErrorCheckSection, callsASpreadWrongThatIsOffByMoreThanAFactorOfFive) {
  EXPECT_EQ(sections::checkNote(rowWithSpread(2e-3, 1e-3)), "");
  EXPECT_EQ(sections::checkNote(rowWithSpread(6e-3, 1e-3)), "spread too large");
  EXPECT_EQ(sections::checkNote(rowWithSpread(1e-4, 1e-3)), "spread too small");
}

TEST(ErrorCheckSection, countsItsRowsInOneLine) {
  ReportRow failed = rowWith("no reference", 1.0, 1.0);
  failed["error"] = failed["checked_error"] = nullptr;
  ReportRow blewUp = rowWith("known", 1e-3, 1e-3);
  blewUp["error"] = nullptr;
  const ReportRows rows{rowWith("known", 2e-3, 1e-3),
                        rowWith("known", 1e-3, 1e-3),
                        rowWith("known", 6e-3, 1e-3),
                        rowWithSpread(2e-3, 1e-3),
                        rowWithSpread(9e-3, 1e-3),
                        failed,
                        blewUp};
  EXPECT_EQ(std::get<Paragraph>(sections::showErrorCheck({}, rows).front()).text,
            "7 checks. Error right within a factor of 5: 2. Error not to be known: 1. Wrong: 2. No result: 2.");
}

TEST(ErrorCheckSection, marksWrongErrorsInRed) {
  const auto blocks = sections::showErrorCheck({}, {rowWith("known", 2e-3, 1e-3), rowWith("known", 1e-4, 1e-3)});
  const auto table =
      std::ranges::find_if(blocks, [](const Block& block) { return std::holds_alternative<TextTable>(block); });
  ASSERT_NE(table, blocks.end());
  EXPECT_FALSE(isBad(std::get<TextTable>(*table), 0));
  EXPECT_TRUE(isBad(std::get<TextTable>(*table), 1));
}

}  // namespace
}  // namespace drape::report
