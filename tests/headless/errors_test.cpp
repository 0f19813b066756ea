#include "program.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace drape::app::testing {
namespace {

TEST(ErrorSources, ofACoarseSheetAreMostlyItsMesh) {
  const auto file = testFolder() / "errors.json";
  const Outcome outcome =
      headless("errors grid --set solver=auto --set grid.resolution=9 --times 0.1,0.2 --json " + file.string());
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("Most of the error comes from the mesh"), std::string::npos) << outcome.output;
  const auto json = nlohmann::json::parse(readFile(file));
  ASSERT_EQ(json["sources"].size(), 2U);
  const auto& last = json["sources"][1];
  EXPECT_EQ(last["time"], 0.2);
  EXPECT_GT(last["mesh"].get<double>(), 10.0 * last["method"].get<double>());
}

TEST(ErrorSources, areLabelledWithTheRoundedTime) {
  const auto file = testFolder() / "errors.json";
  const Outcome outcome =
      headless("errors grid --set grid.resolution=5 --tolerance 1e-3 --times 0.04,0.09 --json " + file.string());
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto json = nlohmann::json::parse(readFile(file));
  EXPECT_NEAR(json["sources"][0]["time"].get<double>(), 1.0 / 30.0, 1e-12);
  EXPECT_NEAR(json["sources"][1]["time"].get<double>(), 0.1, 1e-12);
  EXPECT_EQ(outcome.output.find("0.04"), std::string::npos) << outcome.output;
}

TEST(ErrorSources, ofAMeshFileAreThoseOfItsSubdivision) {
  const Outcome outcome = headless("errors curtain --times 0.0333333 --tolerance 1e-4");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  const Outcome opened = headless("errors skirt --times 0.0333333 --tolerance 1e-4");
  EXPECT_EQ(opened.status, 0) << opened.errors;
}

TEST(ErrorSources, areRefusedWhereTheyCannotBeCompared) {
  const Outcome seams = headless("errors sewing");
  EXPECT_EQ(seams.status, 1);
  EXPECT_NE(seams.errors.find("seams"), std::string::npos) << seams.errors;
  const Outcome step = headless("errors grid --set time_step=0.007");
  EXPECT_EQ(step.status, 2);
  EXPECT_NE(step.errors.find("divides 1/30 s"), std::string::npos) << step.errors;
  EXPECT_EQ(headless("errors grid --times -1").status, 2);
  EXPECT_EQ(headless("errors grid --times 20").status, 2);
  EXPECT_EQ(headless("errors grid --times 0").status, 2);
}

}  // namespace
}  // namespace drape::app::testing
