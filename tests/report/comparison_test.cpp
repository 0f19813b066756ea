#include "report/comparison.hpp"

#include "messages/error.hpp"
#include "report/plain_text.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace drape::report {
namespace {

Report reportOf(double time, std::vector<double> samples, double error, const char* state = "calm") {
  Report report;
  report.machine = {{"cpu", "one"}, {"commit", "abc"}, {"date", "today"}, {"build_type", "Release"}};
  report.rows["work_precision"] = {{{"cell", "a"},
                                    {"rounds", 3},
                                    {"us_per_simulated_second", time},
                                    {"samples", samples},
                                    {"error_mean", error},
                                    {"state", state}}};
  return report;
}

nlohmann::ordered_json compared(const Report& older, const Report& newer) {
  return compareReports(reportJson(older), newer);
}

TEST(Comparison, findsNothingInTwoReportsThatAreTheSame) {
  const Report report = reportOf(10.0, {9.0, 10.0, 11.0}, 0.1);
  const auto comparison = compared(report, report);
  EXPECT_TRUE(comparison["moved"].empty());
  EXPECT_EQ(comparison["compared"], 3);
}

TEST(Comparison, takesTheRoundsSamplesForTheNoiseOfATime) {
  const Report older = reportOf(10.0, {9.0, 10.0, 12.0}, 0.1);
  EXPECT_TRUE(compared(older, reportOf(13.0, {11.0, 13.0, 14.0}, 0.1))["moved"].empty());
  const auto slower = compared(older, reportOf(14.0, {13.0, 14.0, 15.0}, 0.1));
  ASSERT_EQ(slower["moved"].size(), 1U);
  EXPECT_EQ(slower["moved"][0]["verdict"], "slower");
  const auto faster = compared(older, reportOf(5.0, {4.0, 5.0, 6.0}, 0.1));
  ASSERT_EQ(faster["moved"].size(), 1U);
  EXPECT_EQ(faster["moved"][0]["verdict"], "faster");
}

TEST(Comparison, doesNotCallAFewPercentAMove) {
  const Report older = reportOf(10.0, {9.9, 10.0, 10.05}, 0.1);
  EXPECT_TRUE(compared(older, reportOf(10.3, {10.2, 10.3, 10.4}, 0.1))["moved"].empty());
}

TEST(Comparison, comparesNoTimeWithoutRepeats) {
  const auto comparison = compared(reportOf(10.0, {10.0}, 0.1), reportOf(99.0, {99.0}, 0.1));
  EXPECT_TRUE(comparison["moved"].empty());
  EXPECT_EQ(comparison["not_compared"], 1);
}

TEST(Comparison, grantsErrorsNoNoise) {
  const Report older = reportOf(10.0, {9.0, 11.0}, 0.1);
  const auto comparison = compared(older, reportOf(10.0, {9.0, 11.0}, 0.1001));
  ASSERT_EQ(comparison["moved"].size(), 1U);
  EXPECT_EQ(comparison["moved"][0]["figure"], "error_mean");
  EXPECT_EQ(comparison["moved"][0]["verdict"], "worse");
  EXPECT_EQ(compared(older, reportOf(10.0, {9.0, 11.0}, 0.1, "frozen"))["moved"][0]["verdict"], "other");
}

TEST(Comparison, doesNotCompareTimesOfTwoProcessors) {
  Report other = reportOf(99.0, {98.0, 99.0}, 0.1);
  other.machine["cpu"] = "two";
  const auto comparison = compared(reportOf(10.0, {9.0, 10.0}, 0.1), other);
  EXPECT_TRUE(comparison["moved"].empty());
  EXPECT_EQ(comparison["times_compared"], false);
}

TEST(Comparison, leavesOutRowsThatWereGivenUp) {
  EXPECT_TRUE(
      compared(reportOf(10.0, {9.0, 11.0}, 0.1), reportOf(99.0, {98.0, 99.0}, 0.2, "too slow"))["moved"].empty());
}

TEST(Comparison, refusesReportsWithOtherOptions) {
  const Report report = reportOf(10.0, {9.0, 11.0}, 0.1);
  EXPECT_NO_THROW(requireComparable(reportJson(report), report));
  Report other = report;
  other.options.quick = true;
  EXPECT_THROW(requireComparable(reportJson(other), report), messages::InputError);
  other = report;
  other.machine["build_type"] = "Debug";
  EXPECT_THROW(requireComparable(reportJson(other), report), messages::InputError);
  auto json = reportJson(report);
  json["format"] = 1;
  EXPECT_THROW(requireComparable(json, report), messages::InputError);
  EXPECT_THROW(requireComparable(3, report), messages::InputError);
}

TEST(PlainText, putsColumnsBeneathEachOther) {
  EXPECT_EQ(plainText({"title", {"a", "long"}, {{"bbb", "1"}}}), "title\na    long\nbbb     1\n");
}

}  // namespace
}  // namespace drape::report
