#include "ui/measure_history.hpp"

#include <gtest/gtest.h>

namespace drape::ui {
namespace {

session::Snapshot at(double time, double kinetic, const std::shared_ptr<const scene::Scene>& scene) {
  session::Snapshot snapshot;
  snapshot.scene = scene;
  snapshot.time = time;
  snapshot.energy.kinetic = kinetic;
  return snapshot;
}

TEST(MeasureHistory, KeepsTheNewestAndThinsOutTheRest) {
  const auto scene = std::make_shared<const scene::Scene>();
  MeasureHistory history;
  constexpr double step = 1e-3;
  for (int i = 0; i <= 5000; ++i) {
    history.add(at(i * step, i, scene));
  }
  const auto& samples = history.samples();
  EXPECT_EQ(samples.back().energy.kinetic, 5000.0);
  EXPECT_EQ(samples.front().time, 0.0);
  EXPECT_LT(samples.size(), 260U);
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    EXPECT_GE(samples[i].time - samples[i - 1].time, MeasureHistory::spacing - 1e-12);
    EXPECT_LT(samples[i].time - samples[i - 1].time, MeasureHistory::spacing + 1.5 * step);
  }
}

TEST(MeasureHistory, KeepsTheChoicesOfAuto) {
  const auto scene = std::make_shared<const scene::Scene>();
  session::Snapshot snapshot = at(0.0, 1.0, scene);
  MeasureHistory history;
  history.add(snapshot);
  snapshot.time = 1.0;
  snapshot.stepReport.choice = sim::adaptive::StepChoice{.substeps = 12};
  history.add(snapshot);
  EXPECT_FALSE(history.samples().front().choice);
  ASSERT_TRUE(history.samples().back().choice);
  EXPECT_EQ(history.samples().back().choice->substeps, 12);
}

TEST(MeasureHistory, DropsOldSamples) {
  const auto scene = std::make_shared<const scene::Scene>();
  MeasureHistory history;
  for (int i = 0; i <= 300; ++i) {
    history.add(at(0.1 * i, 1.0, scene));
  }
  EXPECT_GE(history.samples().front().time, 30.0 - MeasureHistory::window - 1e-9);
  EXPECT_LT(history.samples().front().time, 30.0 - MeasureHistory::window + 0.2);
}

TEST(MeasureHistory, TakesTheSameMomentOnce) {
  const auto scene = std::make_shared<const scene::Scene>();
  MeasureHistory history;
  history.add(at(0.0, 1.0, scene));
  history.add(at(0.0, 2.0, scene));
  ASSERT_EQ(history.samples().size(), 1U);
  EXPECT_EQ(history.samples().front().energy.kinetic, 2.0);
}

TEST(MeasureHistory, StartsAgainWithAResetAndWithAnotherScene) {
  const auto scene = std::make_shared<const scene::Scene>();
  MeasureHistory history;
  history.add(at(0.0, 1.0, scene));
  history.add(at(2.0, 1.0, scene));
  history.add(at(0.0, 1.0, scene));
  EXPECT_EQ(history.samples().size(), 1U);
  history.add(at(2.0, 1.0, scene));
  history.add(at(3.0, 1.0, std::make_shared<const scene::Scene>()));
  EXPECT_EQ(history.samples().size(), 1U);
}

TEST(MeasureHistory, StaysWhenTheTimelineGoesBackUntilAnotherMotionReplacesIt) {
  const auto scene = std::make_shared<const scene::Scene>();
  MeasureHistory history;
  for (int i = 0; i <= 300; ++i) {
    history.add(at(0.1 * i, i, scene));
  }
  session::Snapshot earlier = at(8.0, 80.0, scene);
  earlier.timeline = session::TimelineStatus{.end = 30.0};
  history.add(earlier);
  EXPECT_EQ(history.present(), 8.0);
  EXPECT_LT(history.samples().front().time, 4.0);
  EXPECT_NEAR(history.samples().back().time, 13.0, 0.05) << "the plot shows the time around the present";
  EXPECT_EQ(history.samples().back().energy.kinetic, 130.0);
  session::Snapshot another = at(8.1, 7.0, scene);
  another.timeline = session::TimelineStatus{.end = 8.1};
  history.add(another);
  EXPECT_EQ(history.samples().back().energy.kinetic, 7.0);
  EXPECT_EQ(history.present(), 8.1);
}

TEST(MeasureHistory, HasTheGhostsDistanceOnlyWithAGhost) {
  const auto scene = std::make_shared<const scene::Scene>();
  MeasureHistory history;
  history.add(at(0.0, 1.0, scene));
  session::Snapshot haunted = at(1.0, 1.0, scene);
  haunted.ghost.emplace().meanDistance = 0.25;
  history.add(haunted);
  EXPECT_FALSE(history.samples()[0].ghostDistance.has_value());
  EXPECT_EQ(history.samples()[1].ghostDistance, 0.25);
}

}  // namespace
}  // namespace drape::ui
