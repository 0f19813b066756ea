#include "report/sections/sections.hpp"
#include "report/sections/stretch_limit_view.hpp"

#include <gtest/gtest.h>
#include <variant>

namespace drape::report {
namespace {

ReportRow rowWith(double limit, double stiffness, double largest, double rest) {
  return {{"scene", "corners"},
          {"resolution", 33},
          {"material", "cotton"},
          {"strain_limit", limit},
          {"us_per_frame", 1000.0},
          {"us_per_frame_later", 500.0},
          {"stiffness_lowest", stiffness},
          {"stiffness_rest", stiffness},
          {"moved_mean", 1e-3},
          {"moved_max", 2e-3},
          {"noise_moved", 1e-5},
          {"rest_mean", 1e-3},
          {"rest_max", 2e-3},
          {"noise_rest", 1e-5},
          {"strain_largest", largest},
          {"strain_rest", rest},
          {"strain_largest_full", 0.02},
          {"speed_rest", 0.0}};
}

TEST(StretchLimit, findsTheDifferenceThatALoweredStiffnessMakesAndNoneAtFullStiffness) {
  ReportOptions options;
  options.quick = true;
  const SectionPlan plan = sections::stretchLimit().plan(options);
  ASSERT_EQ(plan.cells.size(), 2U);
  const ReportRow full = plan.cells[0].measure({{}, {}}).at(0);
  const ReportRow lowered = plan.cells[1].measure({{}, {}}).at(0);
  EXPECT_EQ(full["strain_limit"], 0.0);
  EXPECT_EQ(full["stiffness_lowest"], 1.0);
  EXPECT_EQ(lowered["strain_limit"], 0.01);
  EXPECT_LE(lowered["stiffness_lowest"].get<double>(), 0.25);
  EXPECT_LT(full["moved_mean"].get<double>(), 1e-4) << "only the budget is smaller";
  EXPECT_GT(lowered["moved_mean"].get<double>(), 10.0 * full["moved_mean"].get<double>());
  EXPECT_GT(lowered["moved_mean"].get<double>(), 10.0 * lowered["noise_moved"].get<double>());
  EXPECT_GT(lowered["strain_largest"].get<double>(), full["strain_largest"].get<double>());
  EXPECT_GE(lowered["moved_max"].get<double>(), lowered["moved_mean"].get<double>());
}

TEST(StretchLimit, saysWhereALoweredStiffnessStrainsTheClothTooMuch) {
  EXPECT_EQ(sections::limitNote(rowWith(0.0, 1.0, 0.5, 0.5)), "") << "there is no limit";
  EXPECT_EQ(sections::limitNote(rowWith(0.01, 1.0, 0.5, 0.5)), "") << "the stiffness is not lowered";
  EXPECT_EQ(sections::limitNote(rowWith(0.01, 0.5, 0.02, 0.005)), "") << "full stiffness strains it as much";
  EXPECT_EQ(sections::limitNote(rowWith(0.01, 0.5, 0.03, 0.005)), "above the limit while moving");
  EXPECT_EQ(sections::limitNote(rowWith(0.01, 0.5, 0.03, 0.011)), "above the limit at rest");
}

TEST(StretchLimit, marksTheseRowsAndPlotsTheLimitsAboveZero) {
  const auto blocks = sections::showStretchLimit(
      {}, {rowWith(0.0, 1.0, 0.02, 0.01), rowWith(0.01, 0.5, 0.03, 0.005), rowWith(0.03, 0.25, 0.02, 0.01)});
  ASSERT_EQ(blocks.size(), 3U);
  const auto& plot = std::get<Plot>(blocks[1]);
  ASSERT_EQ(plot.curves.size(), 1U);
  EXPECT_EQ(plot.curves[0].points.size(), 2U);
  const auto& table = std::get<TextTable>(blocks[2]);
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_FALSE(isBad(table, 0));
  EXPECT_TRUE(isBad(table, 1));
  EXPECT_FALSE(isBad(table, 2));
  EXPECT_EQ(table.rows[1].size(), table.header.size());
}

}  // namespace
}  // namespace drape::report
