#include "program.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <nlohmann/json.hpp>

namespace drape::app::testing {
namespace {

const std::string small = "measure grid --set grid.resolution=5 ";

nlohmann::json measurementOf(const std::string& arguments) {
  const auto file = testFolder() / "measurement.json";
  const Outcome outcome = headless(small + arguments + " --json " + file.string());
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  return nlohmann::json::parse(readFile(file));
}

TEST(Measure, findsTheErrorOfBackwardEulersFreeFall) {
  const auto json = measurementOf(
      "--set pins=none --seconds 0.1 --against one_iteration --reference-set time_step=1/30000 --summary 0.1");
  ASSERT_EQ(json["checkpoints"].size(), 3U);
  const auto& first = json["checkpoints"][0];
  // A step of h falls (n + 1) / n times too far in n steps: 6/5 against 1001/1000.
  EXPECT_NEAR(first["eps"], std::pow(1.2 / 1.001 - 1.0, 2), 1e-6);
  EXPECT_NEAR(first["squared_cosine"], 1.0, 1e-9);
  EXPECT_NEAR(first["motion_kept"], 1.2 / 1.001, 1e-6);
  EXPECT_EQ(first["vertices"], 25);
  EXPECT_LT(first["momentum"]["linear"][1].get<double>(), 0.0);
  EXPECT_EQ(first["reference_momentum"]["angular"].size(), 3U);
  EXPECT_EQ(json["summaries"][0]["mean_error"], json["checkpoints"][2]["mean_error"]);
  EXPECT_NEAR(json["diagonal"], std::sqrt(2.0), 1e-12);
  EXPECT_EQ(json["reference"]["kind"], "solver");
}

TEST(Measure, notesASummaryAfterTheEnd) {
  const Outcome late = headless(small + "--seconds 0.1 --against one_iteration --summary 0.1,5");
  EXPECT_EQ(late.status, 0) << late.errors;
  EXPECT_NE(late.errors.find("note: there is no summary at 5 s"), std::string::npos) << late.errors;
  EXPECT_EQ(late.errors.find("summary at 0.1 s"), std::string::npos) << late.errors;
  const Outcome usual = headless(small + "--seconds 0.1 --against one_iteration");
  EXPECT_EQ(usual.errors.find("no summary"), std::string::npos) << usual.errors;
}

TEST(Measure, findsNoErrorInTheReferenceItself) {
  const auto json = measurementOf("--seconds 0.1 --against same_step --reference-set solver=one_iteration");
  EXPECT_EQ(json["checkpoints"][2]["mean_error"], 0.0);
  EXPECT_EQ(json["reference"]["kind"], "same_step");
  EXPECT_GT(json["reference"]["largest_step_residual"], 1e-6);  // one sweep does not solve the step
}

TEST(Measure, reportsTheDistanceOfTheConvergedReferenceFromHalfItsStep) {
  const auto json = measurementOf(
      "--set stiffness=10 --seconds 0.1 --against converged --reference-set solver=one_iteration "
      "--reference-tolerance 1e-4 --restarted");
  EXPECT_EQ(json["restarted"], true);
  EXPECT_EQ(json["reference"]["doubt"], "");
  EXPECT_EQ(json["reference"]["trusted_checkpoints"], 3);
  EXPECT_LE(json["reference"]["halvings"].back()["difference"], 1e-4);
  EXPECT_EQ(json["reference"]["differences"].size(), 4U);
}

TEST(Measure, comparesOneIterationWithBothReferences) {
  const auto solved = measurementOf("--set stiffness=10 --seconds 0.2 --against same_step");
  const auto converged = measurementOf("--set stiffness=10 --seconds 0.2 --against converged");
  EXPECT_EQ(solved["reference"]["solver"], "newton");
  EXPECT_EQ(solved["reference"]["doubt"], "");
  EXPECT_LT(solved["reference"]["largest_step_residual"], 1e-8);
  EXPECT_EQ(converged["reference"]["solver"], "verlet");
  EXPECT_EQ(converged["reference"]["doubt"], "");
  // Only the converged reference shows the error of the time step.
  EXPECT_LT(10.0 * solved["checkpoints"][0]["mean_error"].get<double>(), converged["checkpoints"][0]["mean_error"]);
}

TEST(Measure, printsALineForEachCheckpoint) {
  const Outcome outcome = headless(small + "--seconds 0.2 --against one_iteration");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.errors.find("reference"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.output.find("  0.033 "), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("  0.200 "), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("to 0.200 s: mean error 0 mm"), std::string::npos) << outcome.output;
}

TEST(Measure, saysWhenTheReferenceDoesNotConverge) {
  const Outcome outcome = headless(small +
                                   "--seconds 0.1 --against converged --reference-set solver=one_iteration "
                                   "--reference-tolerance 1e-12 --restarted");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.errors.find("does not converge"), std::string::npos) << outcome.errors;
}

TEST(Measure, reportsABlowUpAndTheCheckpointsBefore) {
  const Outcome outcome = headless(
      "measure grid --set stiffness=1e7 --set derivative=axial --seconds 1 --against one_iteration "
      "--reference-set derivative=stabilised");
  EXPECT_EQ(outcome.status, 1) << outcome.errors;
  EXPECT_NE(outcome.errors.find("the cloth blew up after"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.output.find("eps"), std::string::npos) << outcome.output;
}

TEST(Measure, failsWhereTheClothIsStretchedBeyondAllMeasureThoughFinite) {
  const Outcome outcome =
      headless("measure grid --seconds 0.1 --against newton --set solver=verlet --set stiffness=100");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.errors.find("the cloth blew up after"), std::string::npos) << outcome.errors;
}

TEST(Measure, refusesWrongUse) {
  const auto refuses = [](const std::string& arguments, const std::string& because) {
    const Outcome outcome = headless(small + arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_NE(outcome.errors.find(because), std::string::npos) << outcome.errors;
  };
  refuses("--seconds 0.1", "--against");
  refuses("--seconds 0.1 --against nothing", "same_step, converged or a solver");
  refuses("--seconds 0.01 --against one_iteration", "at least 1/30 s");
  refuses("--seconds 0.1 --against one_iteration --set time_step=0.01", "use 1/90 s or 1/120 s");
  refuses("--seconds 0.1 --against one_iteration --reference-set mass=2", "would change the cloth");
  refuses("--seconds 0.1 --against one_iteration --reference-set sweeps=2", "odd");
  refuses("--seconds 0.1 --against one_iteration --reference-set time_step", "key=value");
}

TEST(Measure, failsBeforeTheRunWhenTheFileCannotBeWritten) {
  const Outcome outcome = headless(small + "--seconds 0.1 --against one_iteration --json /nowhere/file.json");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.errors.find("/nowhere/file.json"), std::string::npos) << outcome.errors;
}

}  // namespace
}  // namespace drape::app::testing
