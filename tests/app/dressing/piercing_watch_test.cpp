#include "app/dressing/piercing_watch.hpp"
#include "session/simulation.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>
#include <chrono>
#include <memory>
#include <thread>
#include <utility>

namespace drape::app {
namespace {

using Clock = PiercingWatch::Clock;
using dressing::testing::ellipsoid;
using dressing::testing::modelOf;
using dressing::testing::tube;

/// A tube around a body that passes through it, or stays inside.
std::shared_ptr<const scene::Scene> tubeAround(double radiusOfBody) {
  const sim::ClothMesh cloth = tube(0.19, 0.4);
  const sim::ClothMesh egg = ellipsoid({radiusOfBody, 0.5, radiusOfBody});
  auto shape = std::make_shared<sim::contact::MeshShape>();
  shape->positions = egg.positions;
  shape->triangles = egg.triangles;
  sim::contact::Body body;
  body.name = "egg";
  body.shape = std::shared_ptr<const sim::contact::MeshShape>(shape);
  body.motion.keyframes = {sim::contact::Keyframe{}};
  auto scene = std::make_shared<scene::Scene>();
  scene->model = modelOf(cloth);
  scene->start.positions = cloth.positions;
  scene->start.velocities.assign(cloth.positions.size(), Vec3::Zero());
  scene->bodies = std::make_shared<const std::vector<sim::contact::Body>>(1, body);
  scene->settings.step.gravity = 0.0;
  return scene;
}

/// A simulation with its watch, and a clock of its own.
struct Watched {
  explicit Watched(std::shared_ptr<const scene::Scene> scene) : simulation(std::move(scene)) {}

  session::Simulation simulation;
  session::Snapshot snapshot;
  PiercingWatch watch;
  Clock::time_point now = Clock::now();

  void follow() {
    simulation.capture(snapshot);
    watch.follow(snapshot, now);
  }
  /// Follows until the look at the start has ended.
  void lookAtStart() {
    do {
      follow();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    } while (!watch.knowsStart());
  }
  /// Makes the tube wider or narrower by that factor.
  void scaleWidth(double factor, bool isStart) {
    std::vector<Vec3> places = simulation.state().positions;
    for (Vec3& place : places) {
      place = Vec3(factor * place.x(), place.y(), factor * place.z());
    }
    simulation.apply(session::PlaceClothCommand{places, isStart});
  }
  /// Lets a running look end. Later looks are due only after some time of the clock.
  void wait() {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    follow();
  }
};

TEST(PiercingWatch, looksAtTheStartBeforeAnyStep) {
  Watched pierced(tubeAround(0.2));
  pierced.lookAtStart();
  ASSERT_EQ(pierced.watch.found().piercings.size(), 1U);
  EXPECT_TRUE(pierced.watch.found().isStart);
  EXPECT_EQ(pierced.simulation.stepIndex(), 0);
  Watched worn(tubeAround(0.15));
  worn.lookAtStart();
  EXPECT_TRUE(worn.watch.found().piercings.empty());
}

TEST(PiercingWatch, ignoresBodiesWithoutContact) {
  Watched off(tubeAround(0.2));
  off.simulation.apply(session::SwitchBodyCommand{0, false});
  off.lookAtStart();
  EXPECT_TRUE(off.watch.found().piercings.empty());
}

TEST(PiercingWatch, looksAgainOnlyAfterTwoSecondsAndForgetsWhatIsCured) {
  Watched watched(tubeAround(0.2));
  watched.lookAtStart();
  watched.scaleWidth(1.3, false);
  watched.follow();
  watched.wait();
  EXPECT_FALSE(watched.watch.found().piercings.empty()) << "too early for another look";
  watched.now += std::chrono::seconds(3);
  watched.follow();
  while (!watched.watch.found().piercings.empty()) {
    watched.wait();
  }
  EXPECT_FALSE(watched.watch.found().isStart);
}

TEST(PiercingWatch, looksDuringTheRunWhereContactReportsClothInsideABody) {
  Watched watched(tubeAround(0.15));
  watched.lookAtStart();
  watched.scaleWidth(0.75, false);
  watched.now += std::chrono::seconds(3);
  watched.follow();
  watched.wait();
  EXPECT_TRUE(watched.watch.found().piercings.empty()) << "no step has told of it yet";
  watched.simulation.step();
  ASSERT_GT(watched.simulation.lastStepReport().contact.overlaps, 0);
  watched.follow();
  while (watched.watch.found().piercings.empty()) {
    watched.wait();
  }
  EXPECT_EQ(watched.watch.found().piercings.front().body, 0U);
}

TEST(PiercingWatch, looksAtTheNewStartOfADressedCloth) {
  Watched watched(tubeAround(0.2));
  watched.lookAtStart();
  watched.scaleWidth(1.3, true);
  watched.follow();
  EXPECT_FALSE(watched.watch.knowsStart());
  watched.lookAtStart();
  EXPECT_TRUE(watched.watch.found().piercings.empty());
}

}  // namespace
}  // namespace drape::app
