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

TEST(ErrorCheckSection, findsErrorsThatAreRightWithinAFactorOfFiveOnAHangingSheet) {
  const SectionPlan plan = sections::errorCheck().plan(quickOptions());
  int known = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const ReportRow row = plan.cells.at(i).measure({{}, {}}).at(0);
    EXPECT_EQ(row["state"], "known") << plan.cells[i].key;
    EXPECT_EQ(sections::checkNote(row), "") << plan.cells[i].key;
    known += row["state"] == "known" ? 1 : 0;
  }
  EXPECT_EQ(known, 3);
}

TEST(ErrorCheckSection, callsAnErrorWrongThatIsOffByMoreThanAFactorOfFive) {
  EXPECT_EQ(sections::checkNote(rowWith("known", 2e-3, 1e-3)), "");
  EXPECT_EQ(sections::checkNote(rowWith("known", 6e-3, 1e-3)), "too large");
  EXPECT_EQ(sections::checkNote(rowWith("known", 1e-4, 1e-3)), "too small");
  EXPECT_EQ(sections::checkNote(rowWith("not known", 1e-4, 1e-3)), "") << "it does not claim anything";
  EXPECT_EQ(sections::checkNote(rowWith("known", 1e-9, 8e-7)), "") << "both are negligible";
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
