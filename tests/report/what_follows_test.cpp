#include "report/section.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <tuple>

namespace drape {
namespace {

const Section& whatFollows() {
  const auto table = sectionTable();
  return *std::find_if(table.begin(), table.end(), [](const Section& one) { return one.name == "what_follows"; });
}

SectionRows measured() {
  SectionRows rows;
  for (const auto& [method, setting, cost, error, state] :
       {std::tuple("slow", "n=1", 90000.0, 5e-5, "calm"), std::tuple("slow", "n=2", 50000.0, 5e-4, "calm"),
        std::tuple("fast", "n=1", 10.0, 9e-3, "calm"), std::tuple("fast", "n=2", 20.0, 8e-3, "calm"),
        std::tuple("fast", "n=3", 5.0, 1e-5, "frozen")}) {
    rows["work_precision"].push_back({{"scene", "hang"},
                                      {"resolution", 17},
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

TEST(WhatFollows, isTheCheapestCalmSettingUnderEachError) {
  const ReportRows rows = whatFollows().derive(measured());
  EXPECT_EQ(answer(rows, "cheapest", "share", 1e-2)["setting"], "n=1");
  EXPECT_EQ(answer(rows, "cheapest", "share", 1e-2)["method"], "fast");
  EXPECT_EQ(answer(rows, "cheapest", "share", 1e-3)["method"], "slow");
  EXPECT_EQ(answer(rows, "cheapest", "share", 1e-3)["setting"], "n=2");
  EXPECT_EQ(answer(rows, "cheapest", "share", 1e-4)["setting"], "n=1");
}

TEST(WhatFollows, isTheLeastErrorOfEachMethodForAMillisecondAFrame) {
  const ReportRows rows = whatFollows().derive(measured());
  // 60000 us for a simulated second: the finer setting of the slow method is beyond it.
  EXPECT_EQ(answer(rows, "budget", "method", "slow")["error_of_diagonal"], 5e-4);
  EXPECT_EQ(answer(rows, "budget", "method", "fast")["error_of_diagonal"], 8e-3);
}

TEST(WhatFollows, saysWhereThereIsNoSetting) {
  SectionRows rows = measured();
  for (ReportRow& row : rows["work_precision"]) {
    row["state"] = "exploded";
  }
  const ReportRows answers = whatFollows().derive(rows);
  EXPECT_TRUE(answer(answers, "cheapest", "share", 1e-2)["method"].is_null());
  EXPECT_TRUE(answer(answers, "budget", "method", "fast")["error_mean"].is_null());
  EXPECT_FALSE(whatFollows().show({}, answers).empty());
  EXPECT_TRUE(whatFollows().derive({}).empty());
}

}  // namespace
}  // namespace drape
