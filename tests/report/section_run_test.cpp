#include "report/section_run.hpp"

#include "messages/error.hpp"

#include <gtest/gtest.h>
#include <array>

namespace drape::report {
namespace {

/// A section of three cells and two rounds; each cell counts its measurements.
Section countingSection(const char* name) {
  Section section;
  section.name = name;
  section.plan = [](const ReportOptions&) {
    SectionPlan plan;
    plan.rounds = 2;
    for (const std::string key : {"a", "b", "c"}) {
      plan.cells.push_back({key, 1.0, [key](const CellContext& context) {
                              const int before = context.own.empty() ? 0 : context.own.front().value("count", 0);
                              return ReportRows{{{"name", key}, {"count", before + 1}}};
                            }});
    }
    return plan;
  };
  section.show = [](const ReportOptions&, const ReportRows&) { return std::vector<Block>(); };
  return section;
}

const std::array sections{countingSection("counting")};

std::string cellsOf(const ReportRows& rows) {
  std::string text;
  for (const ReportRow& row : rows) {
    text += row.value("cell", "") + std::to_string(row.value("count", 0));
  }
  return text;
}

TEST(MeasureSections, measuresAllCellsOnceBeforeAnyTwice) {
  SectionRows rows;
  std::vector<std::string> seen;
  RunHooks hooks;
  hooks.measured = [&](const SectionRows& all) { seen.push_back(cellsOf(all.at("counting"))); };
  EXPECT_TRUE(measureSections(sections, {}, rows, hooks));
  EXPECT_EQ(seen, (std::vector<std::string>{"a1", "a1b1", "a1b1c1", "a2b1c1", "a2b2c1", "a2b2c2"}));
  EXPECT_EQ(rows["counting"][0]["rounds"], 2);
}

TEST(MeasureSections, measuresAllSectionsOnceBeforeAnyCellTwice) {
  const std::array two{countingSection("one"), countingSection("other")};
  SectionRows rows;
  std::vector<std::string> seen;
  RunHooks hooks;
  hooks.measured = [&](const SectionRows& all) {
    seen.push_back(cellsOf(all.at("one")) + " " + (all.contains("other") ? cellsOf(all.at("other")) : ""));
  };
  EXPECT_TRUE(measureSections(two, {}, rows, hooks));
  ASSERT_EQ(seen.size(), 12U);
  EXPECT_EQ(seen[5], "a1b1c1 a1b1c1");
  EXPECT_EQ(seen[6], "a2b1c1 a1b1c1");
}

TEST(MeasureSections, isCompleteWithoutRepeatsWhenThereIsNoTimeForThem) {
  SectionRows rows;
  RunHooks hooks;
  hooks.outOfTime = [] { return true; };
  EXPECT_TRUE(measureSections(sections, {}, rows, hooks));
  EXPECT_EQ(cellsOf(rows["counting"]), "a1b1c1");

  hooks.outOfTime = [&] { return cellsOf(rows["counting"]) == "a2b1c1"; };
  EXPECT_TRUE(measureSections(sections, {}, rows, hooks));
  EXPECT_EQ(cellsOf(rows["counting"]), "a2b1c1");
}

TEST(MeasureSections, keepsFinishedCellsWhenStoppedAndContinues) {
  SectionRows rows;
  int asked = 0;
  RunHooks stopping;
  stopping.stopped = [&] { return ++asked > 4; };
  EXPECT_FALSE(measureSections(sections, {}, rows, stopping));
  EXPECT_EQ(cellsOf(rows["counting"]), "a2b1c1");

  int measured = 0;
  RunHooks counting;
  counting.measured = [&](const SectionRows&) { ++measured; };
  EXPECT_TRUE(measureSections(sections, {}, rows, counting));
  EXPECT_EQ(cellsOf(rows["counting"]), "a2b2c2");
  EXPECT_EQ(measured, 2);
}

TEST(MeasureSections, dropsTheRowsOfACellThatWasStopped) {
  Section section = countingSection("counting");
  section.plan = [](const ReportOptions&) {
    SectionPlan plan;
    plan.cells.push_back({"a", 1.0, [](const CellContext& context) {
                            context.checkStop();
                            return ReportRows{{{"name", "a"}}};
                          }});
    return plan;
  };
  SectionRows rows;
  int asked = 0;
  RunHooks hooks;
  hooks.stopped = [&] { return ++asked > 1; };
  EXPECT_FALSE(measureSections(std::span(&section, 1), {}, rows, hooks));
  EXPECT_TRUE(rows["counting"].empty());
}

TEST(MeasureSections, reportsItsProgress) {
  SectionRows rows;
  std::vector<double> done;
  RunHooks hooks;
  hooks.progress = [&](std::string_view, double now, double total) {
    done.push_back(now);
    EXPECT_EQ(total, 6.0);
  };
  EXPECT_TRUE(measureSections(sections, {}, rows, hooks));
  EXPECT_EQ(done, (std::vector<double>{0.0, 1.0, 2.0, 3.0, 4.0, 5.0}));
}

TEST(MeasureSections, refusesASectionThatDoesNotExist) {
  ReportOptions options;
  options.only = {"nothing"};
  SectionRows rows;
  EXPECT_THROW(measureSections(sections, options, rows, {}), messages::UsageError);
}

}  // namespace
}  // namespace drape::report
