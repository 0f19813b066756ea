#include "report/section.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <tuple>

namespace drape::report {
namespace {

const Section& conclusions() {
  const auto table = sectionTable();
  return *std::find_if(table.begin(), table.end(), [](const Section& one) { return one.name == "conclusions"; });
}

SectionRows measured() {
  SectionRows rows;
  for (const auto& [method, setting, cost, error, state] :
       {std::tuple("slow", "n=1", 90000.0, 5e-5, "calm"), std::tuple("slow", "n=2", 50000.0, 5e-4, "calm"),
        std::tuple("fast", "n=1", 10.0, 9e-3, "calm"), std::tuple("fast", "n=2", 20.0, 8e-3, "calm"),
        std::tuple("fast", "n=3", 5.0, 1e-5, "frozen")}) {
    rows["work_precision"].push_back({{"scene", "hang"},
                                      {"resolution", 17},
                                      {"material", "springs"},
                                      {"stiffness", 10.0},
                                      {"time", 0.2},
                                      {"method", method},
                                      {"setting", setting},
                                      {"us_per_simulated_second", cost},
                                      {"error_mean", 1.414 * error},
                                      {"error_of_diagonal", error},
                                      {"state", state}});
  }
  return rows;
}

ReportRow answer(const ReportRows& rows, const char* question, const char* key, const ReportRow& value) {
  for (const ReportRow& row : rows) {
    if (row["question"] == question && row.value(key, ReportRow()) == value) {
      return row;
    }
  }
  return nullptr;
}

TEST(Conclusions, isTheCheapestCalmSettingUnderEachError) {
  const ReportRows rows = conclusions().derive(measured());
  EXPECT_EQ(answer(rows, "cheapest", "share", 1e-2)["setting"], "n=1");
  EXPECT_EQ(answer(rows, "cheapest", "share", 1e-2)["method"], "fast");
  EXPECT_EQ(answer(rows, "cheapest", "share", 1e-3)["method"], "slow");
  EXPECT_EQ(answer(rows, "cheapest", "share", 1e-3)["setting"], "n=2");
  EXPECT_EQ(answer(rows, "cheapest", "share", 1e-4)["setting"], "n=1");
}

TEST(Conclusions, isTheLeastErrorOfEachMethodForAMillisecondAFrame) {
  const ReportRows rows = conclusions().derive(measured());
  // 60000 us per simulated second: the finer setting of the slow method exceeds it.
  EXPECT_EQ(answer(rows, "budget", "method", "slow")["error_of_diagonal"], 5e-4);
  EXPECT_EQ(answer(rows, "budget", "method", "fast")["error_of_diagonal"], 8e-3);
}

/// A row of `auto` or another method, with that cost [us] and that error [m].
ReportRow measuredRow(const char* method, double cost, double error, const char* state = "calm") {
  return {{"scene", "hang"},
          {"resolution", 17},
          {"material", "springs"},
          {"stiffness", 10.0},
          {"time", 0.2},
          {"method", method},
          {"setting", "n=" + std::to_string(static_cast<int>(cost))},
          {"error_mean", error},
          {"us_per_simulated_second", cost},
          {"noise_floor", 1e-3},
          {"error_of_diagonal", error / 1.414},
          {"reference_difference", 0},
          {"state", state}};
}

TEST(Conclusions, comparesAutoWithTheBestOtherMethodAtEqualCost) {
  SectionRows rows;
  rows["work_precision"] = {measuredRow("auto", 1.0, 0.5),    // the cheapest of all
                            measuredRow("auto", 10.0, 0.06),  // twice the error of verlet at 10
                            measuredRow("auto", 20.0, 0.04),  // 1.33 times
                            measuredRow("auto", 25.0, 0.9),   // the previous setting is better and cheaper
                            measuredRow("auto", 30.0, 0.02),  // better
                            measuredRow("auto", 40.0, 2e-4),  // both below the noise floor
                            measuredRow("auto", 50.0, 9.0, "frozen"),
                            measuredRow("verlet", 10.0, 0.03),
                            measuredRow("xpbd", 10.0, 0.05),
                            measuredRow("xpbd", 11.0, 1e-6, "exploded"),
                            measuredRow("verlet", 35.0, 1e-5)};
  const ReportRow row = answer(conclusions().derive(rows), "equal_cost", "method", "auto");
  EXPECT_EQ(row["points"], 5);
  EXPECT_EQ(row["within"], 4);
  EXPECT_EQ(row["best"], 2);
  EXPECT_NEAR(row["ratio"].get<double>(), 2.0, 1e-9);
  EXPECT_EQ(row["setting"], "n=10");
  EXPECT_EQ(row["by_method"], "verlet");
  EXPECT_EQ(row["by_error_mean"], 0.03);
}

TEST(Conclusions, comparesTheMedianOfAllStartsWhereMotionIsChaotic) {
  SectionRows rows;
  rows["work_precision"] = {measuredRow("auto", 10.0, 0.06), measuredRow("verlet", 10.0, 0.01),
                            measuredRow("xpbd", 10.0, 0.03)};
  rows["work_precision"][0]["error_median"] = 0.04;
  rows["work_precision"][1]["error_median"] = 0.05;
  const ReportRow row = answer(conclusions().derive(rows), "equal_cost", "method", "auto");
  EXPECT_EQ(row["by_method"], "xpbd") << "verlet was accurate by accident";
  EXPECT_NEAR(row["ratio"].get<double>(), 4.0 / 3.0, 1e-9);
  EXPECT_EQ(row["error_mean"], 0.04);
  EXPECT_NEAR(row["error_of_diagonal"].get<double>(), 0.04 / 1.414, 1e-9);
}

TEST(Conclusions, haveAnEmptyComparisonWhereNoOtherMethodIsCalm) {
  SectionRows rows;
  rows["work_precision"] = {measuredRow("auto", 10.0, 0.06), measuredRow("verlet", 5.0, 0.01, "exploded")};
  const ReportRow row = answer(conclusions().derive(rows), "equal_cost", "method", "auto");
  EXPECT_EQ(row["points"], 0);
  for (const char* key : {"setting", "us_per_simulated_second", "error_mean", "error_of_diagonal", "by_error_mean"}) {
    ASSERT_TRUE(row.contains(key)) << key;
    EXPECT_TRUE(row[key].is_null()) << key;
  }
}

TEST(Conclusions, listsTheClothsOnWhichAutoIsBehind) {
  SectionRows rows;
  rows["work_precision"] = {measuredRow("auto", 10.0, 0.06), measuredRow("verlet", 10.0, 0.03)};
  const auto tables = [&] {
    int count = 0;
    for (const Block& block : conclusions().show({}, conclusions().derive(rows))) {
      const auto* table = std::get_if<TextTable>(&block);
      count += table != nullptr && table->title.find("larger error") != std::string::npos ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(tables(), 1);
  rows["work_precision"].push_back(measuredRow("auto", 9.0, 0.01));
  rows["work_precision"].front()["error_mean"] = 0.02;
  EXPECT_EQ(tables(), 0) << "it is nowhere behind";
}

TEST(Conclusions, saysWhereThereIsNoSetting) {
  SectionRows rows = measured();
  for (ReportRow& row : rows["work_precision"]) {
    row["state"] = "exploded";
  }
  const ReportRows answers = conclusions().derive(rows);
  EXPECT_TRUE(answer(answers, "cheapest", "share", 1e-2)["method"].is_null());
  EXPECT_TRUE(answer(answers, "budget", "method", "fast")["error_mean"].is_null());
  EXPECT_EQ(answer(answers, "equal_cost", "method", "auto")["points"], 0);
  EXPECT_TRUE(answer(answers, "equal_cost", "method", "auto")["ratio"].is_null());
  EXPECT_FALSE(conclusions().show({}, answers).empty());
  EXPECT_TRUE(conclusions().derive({}).empty());
}

}  // namespace
}  // namespace drape::report
