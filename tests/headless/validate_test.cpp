#include "program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace drape::app::testing {
namespace {

TEST(ValidateCommand, printsTheErrorsOfEachKindOfMesh) {
  const auto file = testFolder() / "validation.json";
  const Outcome outcome =
      headless("validate --short --only own_weight --only end_load_modulus --json " + file.string());
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  for (const char* word : {"own_weight", "end_load_modulus", "grid", "alternating", "irregular", "20 cells"}) {
    EXPECT_NE(outcome.output.find(word), std::string::npos) << outcome.output;
  }
  const auto rows = nlohmann::json::parse(readFile(file))["validation"];
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_EQ(rows[0]["name"], "own_weight");
  EXPECT_EQ(rows[5]["name"], "end_load_modulus");
  EXPECT_EQ(rows[5]["mesh"], "irregular");
  EXPECT_EQ(rows[0]["passed"], true);
  ASSERT_EQ(rows[0]["results"].size(), 2U);
  EXPECT_EQ(rows[0]["results"][1]["resolution"], 20);
  EXPECT_NEAR(rows[0]["results"][1]["measured"].get<double>(), rows[0]["exact"].get<double>(), 1e-5);
}

TEST(ValidateCommand, failsWithStatusOneAndNamesTheCasesThatAreOff) {
  // With 20 cells the load is 0.2 % off, which is within the aim of the case.
  EXPECT_EQ(headless("validate --short --only buckling").status, 0);
  const Outcome outcome = headless("validate --short --only buckling --aim 0.01");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.output.find("off"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.errors.find("buckling irregular"), std::string::npos) << outcome.errors;
}

TEST(ValidateCommand, printsAMarkdownTable) {
  const Outcome outcome = headless("validate --short --markdown --only twist");
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_TRUE(outcome.output.starts_with("| case | mesh |")) << outcome.output;
  EXPECT_NE(outcome.output.find("| `twist` | irregular | 10, 20 | 0.796 %, 0.590 % |"), std::string::npos)
      << outcome.output;
}

TEST(ValidateCommand, refusesWrongUse) {
  const Outcome unknown = headless("validate --only magic");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.errors.find("own_weight"), std::string::npos) << "the names to choose from: " << unknown.errors;
  EXPECT_EQ(headless("validate --aim 0").status, 2);
  EXPECT_EQ(headless("validate --aim nan").status, 2);
  const Outcome outcome = headless("validate --only own_weight --json /nowhere/file.json");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.errors.find("/nowhere/file.json"), std::string::npos) << outcome.errors;
}

}  // namespace
}  // namespace drape::app::testing
