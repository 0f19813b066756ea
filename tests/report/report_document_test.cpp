#include "report/report_document.hpp"

#include "messages/error.hpp"
#include "xml_check.hpp"

#include <gtest/gtest.h>
#include <set>

namespace drape::report {
namespace {

Report small() {
  Report report;
  report.machine = {{"cpu", "one & <two>"}, {"cores", 2}, {"commit", "abc"}, {"build_type", "Release"}};
  report.options.quick = true;
  report.complete = true;
  for (const int resolution : {65, 129}) {
    report.rows["table1"].push_back({{"cell", std::to_string(resolution) + " float"},
                                     {"rounds", 1},
                                     {"resolution", resolution},
                                     {"precision", "float"},
                                     {"springs", 3 * resolution * resolution},
                                     {"update_ms", 1e-6 * resolution * resolution},
                                     {"update_ms_p99", nullptr}});
  }
  return report;
}

TEST(ReportDocument, hasAnArrayForEachSectionWhetherMeasuredOrNot) {
  const auto json = reportJson(small());
  for (const Section& section : sectionTable()) {
    EXPECT_TRUE(json[std::string(section.name)].is_array()) << section.name;
  }
  EXPECT_TRUE(json["machine"].is_object());
  EXPECT_EQ(json["table1"].size(), 2U);
}

TEST(ReportDocument, isGoneOnWithFromItsOwnJson) {
  const Report report = small();
  const SectionRows rows = rowsToResume(nlohmann::ordered_json::parse(reportJson(report).dump()), report);
  EXPECT_EQ(rows.at("table1"), report.rows.at("table1"));
}

TEST(ReportDocument, isNotGoneOnWithUnderOtherConditions) {
  const auto json = reportJson(small());
  Report other = small();
  other.machine["commit"] = "def";
  EXPECT_THROW((void)rowsToResume(json, other), messages::InputError);
  other = small();
  other.options.quick = false;
  EXPECT_THROW((void)rowsToResume(json, other), messages::InputError);
  EXPECT_THROW((void)rowsToResume(nlohmann::ordered_json::array(), small()), messages::InputError);
}

TEST(ReportDocument, isAWellFormedPageThatNeedsNoOtherFile) {
  const std::string html = reportHtml(small());
  EXPECT_EQ(testing::XmlCheck::faultOf(html), "");
  EXPECT_NE(html.find("one &amp; &lt;two&gt;"), std::string::npos);
  EXPECT_NE(html.find("<svg"), std::string::npos);
  EXPECT_NE(html.find("prefers-color-scheme: dark"), std::string::npos);
  EXPECT_NE(html.find("@media print"), std::string::npos);
  EXPECT_EQ(html.find("src="), std::string::npos);
  EXPECT_EQ(html.find("href="), std::string::npos);
}

TEST(ReportDocument, hasItsPicturesBesideTheMarkdownText) {
  const MarkdownReport markdown = reportMarkdown(small());
  ASSERT_FALSE(markdown.pictures.empty());
  std::set<std::string> names;
  for (const ReportPicture& picture : markdown.pictures) {
    EXPECT_NE(markdown.text.find("](" + picture.name + ")"), std::string::npos);
    EXPECT_EQ(testing::XmlCheck::faultOf(picture.svg), "");
    EXPECT_TRUE(names.insert(picture.name).second) << picture.name;
  }
  EXPECT_NE(markdown.text.find("one & \\<two>"), std::string::npos);
}

TEST(ReportDocument, showsSectionsOfWhichNothingWasMeasuredWithoutFailing) {
  for (const Section& section : sectionTable()) {
    EXPECT_NO_THROW((void)section.show({}, {})) << section.name;
  }
}

TEST(Table1, fitsHowTheTimeGrows) {
  // The times above are proportional to the number of springs.
  EXPECT_NE(reportMarkdown(small()).text.find("to the power 1 from 65x65"), std::string::npos)
      << reportMarkdown(small()).text;
}

TEST(Sections, haveCellsWithKeysOfTheirOwnThatDoNotChange) {
  for (const Section& section : sectionTable()) {
    if (section.plan == nullptr) {
      continue;
    }
    for (const bool quick : {true, false}) {
      ReportOptions options;
      options.quick = quick;
      const SectionPlan plan = section.plan(options);
      const SectionPlan again = section.plan(options);
      std::set<std::string> keys;
      ASSERT_EQ(plan.cells.size(), again.cells.size());
      for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        EXPECT_TRUE(keys.insert(plan.cells[i].key).second) << section.name << ": " << plan.cells[i].key;
        EXPECT_EQ(plan.cells[i].key, again.cells[i].key);
      }
    }
  }
}

}  // namespace
}  // namespace drape::report
