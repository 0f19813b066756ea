#include "report/report_document.hpp"
#include "report/svg.hpp"
#include "report/validation/validation_rows.hpp"
#include "xml_check.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace drape::report::validation {
namespace {

constexpr std::array testResolutions{5, 10};

const Section& validationSection() {
  const auto table = sectionTable();
  return *std::ranges::find_if(table, [](const Section& section) { return section.name == "validation"; });
}

/// The rows of one case on all kinds of mesh.
ReportRows rowsOfCase(const ValidationCase& one) {
  ReportRows rows;
  for (const MeshKind kind : meshKinds) {
    rows.push_back(validationRow(runValidation(one, kind, testResolutions)));
  }
  return rows;
}

Report reportOf(const ReportRows& rows) {
  Report report;
  report.machine = {{"cpu", "one"}};
  report.complete = true;
  report.rows["validation"] = rows;
  return report;
}

TEST(ValidationSection, hasACellForEachCaseAndKindOfMesh) {
  const SectionPlan plan = validationSection().plan({});
  std::size_t cells = 0;
  for (const ValidationCase& one : validationTable()) {
    cells += kindsOf(one, false).size();
  }
  EXPECT_EQ(plan.cells.size(), cells);
  EXPECT_EQ(plan.cells[2].key, "end_load_modulus irregular");
}

TEST(ValidationSection, measuresTheNumbersOfTheCommand) {
  ReportOptions options;
  options.quick = true;
  const SectionPlan plan = validationSection().plan(options);
  const auto cell = std::ranges::find_if(plan.cells, [](const Cell& one) { return one.key == "twist irregular"; });
  ASSERT_NE(cell, plan.cells.end());
  const ReportRow measured = cell->measure({{}, {}}).at(0);
  const ValidationCase& one = requireValidationCase("twist");
  const ReportRow printed = validationRow(runValidation(one, MeshKind::Irregular, resolutionsOf(one, true)));
  EXPECT_EQ(measured["results"][1]["error"], printed["results"][1]["error"]);
  EXPECT_EQ(validationLine(measured).substr(0, 60), validationLine(printed).substr(0, 60));
}

TEST(ValidationSection, showsResultsThatAreOffInRedWithTheReason) {
  ValidationCase one = requireValidationCase("buckling");
  const std::string passed = reportHtml(reportOf(rowsOfCase(one)));
  EXPECT_EQ(passed.find("class=\"bad\""), std::string::npos);
  EXPECT_NE(passed.find("All results are within their aims."), std::string::npos);
  one.aim = 1e-4;
  one.reason = "The cells are too large.";
  const Report off = reportOf(rowsOfCase(one));
  const std::string html = reportHtml(off);
  EXPECT_EQ(drape::report::testing::XmlCheck::faultOf(html), "");
  EXPECT_NE(html.find("<tr class=\"bad\">"), std::string::npos);
  EXPECT_NE(html.find("3 of 3 results are off."), std::string::npos);
  EXPECT_NE(html.find("The cells are too large."), std::string::npos);
  EXPECT_NE(reportMarkdown(off).text.find("**off**"), std::string::npos);
}

TEST(ValidationSection, plotsTheLargestErrorOfTheKindsOfMesh) {
  const ValidationCase& one = requireValidationCase("buckling");
  const ReportRows rows = rowsOfCase(one);
  const auto blocks = validationSection().show({}, rows);
  const auto plot =
      std::ranges::find_if(blocks, [](const Block& block) { return std::holds_alternative<Plot>(block); });
  ASSERT_NE(plot, blocks.end());
  const Plot& drawn = std::get<Plot>(*plot);
  ASSERT_EQ(drawn.curves.size(), 1U);
  ASSERT_EQ(drawn.curves[0].points.size(), 2U);
  EXPECT_EQ(drawn.curves[0].points[1].x, 10.0);
  double largest = 0.0;
  for (const ReportRow& row : rows) {
    largest = std::max(largest, 100.0 * std::abs(row["results"][1].value("error", 0.0)));
  }
  EXPECT_DOUBLE_EQ(drawn.curves[0].points[1].y, largest);
}

TEST(ValidationSection, drawsAShapeAtRest) {
  ValidationCase one = requireValidationCase("cusick_denim");
  const auto shape = std::make_shared<DrapedShape>(
      DrapedShape{{{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.0, -0.05, 0.1}}, {Triangle{0, 2, 1}}});
  const ValidationSeries series{
      .validationCase = &one,
      .kind = MeshKind::Grid,
      .results = {{.resolution = 24,
                   .comparison = {.measured = 83.0, .exact = 70.0, .upper = 90.0, .note = "4 folds", .shape = shape}}}};
  const ReportRow row = validationRow(series);
  EXPECT_EQ(row["shape"]["positions"], ReportRow({0, 0, 0, 1000, 0, 0, 0, -500, 1000}));
  const std::string html = reportHtml(reportOf({row}));
  EXPECT_EQ(drape::report::testing::XmlCheck::faultOf(html), "");
  EXPECT_NE(html.find("<polygon"), std::string::npos);
  EXPECT_NE(html.find("cusick_denim: 83.0 %, 4 folds"), std::string::npos);
}

TEST(ValidationRows, aRangeIsMetAnywhereWithin) {
  const Comparison within{.measured = 30.0, .exact = 20.0, .upper = 40.0};
  EXPECT_EQ(within.error(), 0.0);
  EXPECT_DOUBLE_EQ((Comparison{.measured = 10.0, .exact = 20.0, .upper = 40.0}.error()), -0.5);
  EXPECT_NEAR((Comparison{.measured = 44.0, .exact = 20.0, .upper = 40.0}.error()), 0.1, 1e-12);
  ValidationCase one = requireValidationCase("buckling");
  const ValidationSeries series{
      .validationCase = &one, .kind = MeshKind::Grid, .results = {{.resolution = 10, .comparison = within}}};
  const ReportRow row = validationRow(series);
  EXPECT_EQ(aimOf(row), "20 to 40");
  EXPECT_EQ(figureOf(row, row["results"][0]), "30.0");
  EXPECT_EQ(row["passed"], true);
}

}  // namespace
}  // namespace drape::report::validation
