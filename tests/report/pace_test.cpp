#include "report/sections/pace_view.hpp"
#include "report/sections/sections.hpp"

#include <gtest/gtest.h>
#include <variant>

namespace drape::report {
namespace {

TEST(PaceSection, measuresTheCostOfAFabric) {
  ReportOptions options;
  options.quick = true;
  const SectionPlan plan = sections::pace().plan(options);
  ASSERT_EQ(plan.cells.size(), 2U);
  const ReportRow row = plan.cells.front().measure({{}, {}}).at(0);
  EXPECT_TRUE(row["ended"].get<bool>());
  EXPECT_GT(row["ms_per_frame"].get<double>(), 0.0);
  EXPECT_GE(row["evaluations_per_step"].get<double>(), 1.0);
  EXPECT_GT(row["strain_last"].get<double>(), 0.0);
}

TEST(PaceSection, marksWhatIsSlowerThanTheClockInRed) {
  ReportRow row{{"scene", "curtain"},       {"resolution", 33},     {"vertices", 1089},
                {"material", "cotton"},     {"ms_per_frame", 8.3},  {"evaluations_per_step", 20.0},
                {"stiffness_lowest", 0.25}, {"strain_last", 0.008}, {"ended", true}};
  ReportRow slow = row;
  slow["ms_per_frame"] = 33.4;
  const auto table = std::get<TextTable>(sections::showPace({}, {row, slow}).back());
  EXPECT_FALSE(isBad(table, 0));
  EXPECT_EQ(table.rows[0].at(4), "2x");
  EXPECT_TRUE(isBad(table, 1));
  EXPECT_EQ(table.rows[1].at(4), "0.5x, slower than the clock");
}

}  // namespace
}  // namespace drape::report
