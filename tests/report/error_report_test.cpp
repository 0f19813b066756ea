#include "report/error_report.hpp"

#include "messages/error.hpp"
#include "report/error_table.hpp"
#include "report/measurement.hpp"
#include "report/report_json.hpp"
#include "small_grid.hpp"

#include <gtest/gtest.h>
#include <cmath>

namespace drape::report {
namespace {

/// The exact free fall of a scene's cloth, as a reference.
Reference exactFall(const scene::Scene& scene, int checkpoints) {
  Reference reference;
  reference.settings = scene.settings;
  reference.trusted = checkpoints;
  for (int k = 0; k <= checkpoints; ++k) {
    sim::ClothState state = scene.start;
    state.time = k * checkpointInterval;
    const double gravity = scene.settings.step.gravity;
    for (std::size_t i = 0; i < state.positions.size(); ++i) {
      state.positions[i].y() -= 0.5 * gravity * state.time * state.time;
      state.velocities[i].y() -= gravity * state.time;
    }
    reference.trajectory.states.push_back(state);
  }
  return reference;
}

TEST(ErrorReport, findsTheClosedFormErrorOfBackwardEulersFreeFall) {
  const auto scene = testing::smallGrid({"pins=none"});
  const Reference exact = exactFall(*scene, 4);
  const Trajectory own = runTrajectory(*scene, scene->settings, 4, {.energy = true});
  const ErrorReport report = compareWithReference(*scene->model, scene->settings.step, own, exact);
  ASSERT_EQ(report.checkpoints.size(), 4U);
  // After n steps backward Euler has fallen g h^2 n (n + 1) / 2 instead of g h^2 n^2 / 2.
  const double drop = scene->settings.step.gravity / (150.0 * 150.0);
  for (int k = 1; k <= 4; ++k) {
    const CheckpointReport& at = report.checkpoints[static_cast<std::size_t>(k) - 1];
    const double share = 2.5 / (12.5 * (2 * k - 1));  // too far by 2.5 g h^2 in an interval of 12.5 (2k - 1) g h^2
    EXPECT_NEAR(at.displacement.eps, share * share, 1e-9) << k;
    EXPECT_NEAR(at.displacement.squaredCosine, 1.0, 1e-12);
    EXPECT_NEAR(at.meanError, 2.5 * k * drop, 1e-12);
    EXPECT_NEAR(at.rmsError, at.meanError, 1e-12);
    EXPECT_NEAR(at.motionKept, 1.0 + share, 1e-9);
    EXPECT_NEAR(at.energy.total() - at.balance.integrator(), 0.0, 1e-12);
    // Velocities are exact, so the momentum is that of the fall; there is no rotation.
    const double momentum = -scene->model->totalMass() * scene->settings.step.gravity * at.time;
    EXPECT_NEAR(at.momentum.linear.y(), momentum, 1e-12);
    EXPECT_NEAR(at.referenceMomentum.linear.y(), momentum, 1e-12);
    EXPECT_NEAR(at.momentum.angular.norm(), 0.0, 1e-12);
  }
  EXPECT_NEAR(report.checkpoints[0].displacement.eps, 0.04, 1e-9);
}

TEST(ErrorReport, ofARestartedRunCountsEachIntervalFromTheReference) {
  const auto scene = testing::smallGrid({"pins=none"});
  const Reference exact = exactFall(*scene, 3);
  const Trajectory own = runRestarted(*scene, scene->settings, exact.trajectory);
  const ErrorReport report = compareWithReference(*scene->model, scene->settings.step, own, exact);
  // Each interval of five steps falls 2.5 g h^2 too far, at any initial speed.
  for (const CheckpointReport& at : report.checkpoints) {
    EXPECT_NEAR(at.meanError, 2.5 * scene->settings.step.gravity / (150.0 * 150.0), 1e-12);
  }
  EXPECT_NEAR(report.checkpoints[0].displacement.eps, 0.04, 1e-9);
  EXPECT_LT(report.checkpoints[2].displacement.eps, 0.002);
}

TEST(ErrorReport, isAllZeroForTheReferenceItself) {
  const auto scene = testing::smallGrid();
  const Reference reference = solverReference(*scene, scene->settings, 3);
  const ErrorReport report = compareWithReference(*scene->model, scene->settings.step, reference.trajectory, reference);
  for (const CheckpointReport& at : report.checkpoints) {
    EXPECT_EQ(at.displacement.eps, 0.0);
    EXPECT_EQ(at.meanError, 0.0);
    EXPECT_EQ(at.motionKept, 1.0);
  }
}

TEST(ErrorReport, ofAFrozenClothIsOneWithNothingKept) {
  const auto scene = testing::smallGrid();
  const Reference reference = solverReference(*scene, scene->settings, 3);
  Trajectory frozen;
  frozen.states.assign(4, scene->start);
  const ErrorReport report = compareWithReference(*scene->model, scene->settings.step, frozen, reference);
  EXPECT_DOUBLE_EQ(report.checkpoints[0].displacement.eps, 1.0);
  EXPECT_EQ(report.checkpoints[0].motionKept, 0.0);
  const double times[] = {0.1};
  EXPECT_EQ(summarise(*scene->model, frozen, reference, report, times)[0].motionKept, 0.0);
}

TEST(ErrorReport, marksCheckpointsBeyondTheReferencesCheck) {
  const auto scene = testing::smallGrid();
  Reference reference = solverReference(*scene, scene->settings, 3);
  reference.trusted = 2;
  const ErrorReport report = compareWithReference(*scene->model, scene->settings.step, reference.trajectory, reference);
  EXPECT_TRUE(report.checkpoints[1].trusted);
  EXPECT_FALSE(report.checkpoints[2].trusted);
}

TEST(ErrorSummary, isThatOfTheNearestCheckpointAndEndsWithTheRun) {
  const auto scene = testing::smallGrid({"pins=none"});
  const Reference exact = exactFall(*scene, 4);
  const Trajectory own = runTrajectory(*scene, scene->settings, 4);
  const ErrorReport report = compareWithReference(*scene->model, scene->settings.step, own, exact);
  const double times[] = {0.07, 0.5};
  const auto summaries = summarise(*scene->model, own, exact, report, times);
  ASSERT_EQ(summaries.size(), 1U);
  EXPECT_NEAR(summaries[0].time, 2.0 / 30.0, 1e-15);
  EXPECT_EQ(summaries[0].meanError, report.checkpoints[1].meanError);
  EXPECT_NEAR(summaries[0].meanEps,
              0.5 * (report.checkpoints[0].displacement.eps + report.checkpoints[1].displacement.eps), 1e-15);
  // Falls of 15 and 40 h^2 g against 12.5 and 37.5.
  EXPECT_NEAR(summaries[0].motionKept, std::hypot(15.0, 40.0) / std::hypot(12.5, 37.5), 1e-9);
}

TEST(Measurement, comparesAMethodWithAnotherAndWritesTheErrors) {
  const auto scene = testing::smallGrid();
  MeasurementPlan plan;
  plan.checkpoints = 3;
  plan.against = ReferenceKind::Solver;
  plan.reference = testing::with(*scene, {"time_step=1/3000"});
  plan.summaryTimes = {0.1};
  const Measurement measurement = measure(*scene, scene->settings, plan);
  const auto json = measurementJson(measurement);
  EXPECT_EQ(json["checkpoints"].size(), 3U);
  EXPECT_GT(json["checkpoints"][2]["eps"], 0.0);
  EXPECT_EQ(json["reference"]["kind"], "solver");
  EXPECT_EQ(json["reference"]["settings"]["time_step"], 1.0 / 3000.0);
  EXPECT_EQ(json["method"]["settings"]["time_step"], 1.0 / 150.0);
  EXPECT_EQ(json["summaries"].size(), 1U);
  EXPECT_NE(errorTable(measurement).find("to 0.100 s: mean error"), std::string::npos);
}

TEST(Measurement, refusesAStepThatMissesTheCheckpoints) {
  const auto scene = testing::smallGrid({"time_step=0.01"});
  MeasurementPlan plan;
  plan.reference = scene->settings;
  EXPECT_THROW((void)measure(*scene, scene->settings, plan), messages::UsageError);
}

}  // namespace
}  // namespace drape::report
