// Pins that move with a body do not slow the cloth down.
#include "sim/motion/moving_frame.hpp"

#include "contact/contact_scene.hpp"
#include "sim/measures/measures.hpp"

#include <gtest/gtest.h>
#include <algorithm>

namespace drape::sim {
namespace {

using testing::ContactScene;

/// A sheet whose first row goes along with a body far away, evenly from the start, and moves with it.
std::unique_ptr<ContactScene> carriedSheet(const std::string& solver, const Vec3& velocity) {
  constexpr int n = 6;
  contact::Body carrier = testing::bodyAt(contact::SphereShape{0.01}, Vec3(0.0, 9.0, 0.0));
  carrier.motion.keyframes.clear();
  for (int k = -3; k <= 10; ++k) {
    carrier.motion.keyframes.push_back({0.1 * k, Vec3(0.0, 9.0, 0.0) + 0.1 * k * velocity, Vec3::Zero()});
  }
  std::vector<int> pins;
  for (int v = 0; v < n; ++v) {
    pins.push_back(v);
    carrier.pins.push_back({v, -1});
  }
  auto scene = std::make_unique<ContactScene>(buildClothModel(testing::sheet(n), 0.1, MassLumping::Area, pins),
                                              std::vector<contact::Body>{carrier}, solver);
  scene->parameters.timeStep = 1.0 / 300.0;
  scene->parameters.substeps = 4;
  scene->parameters.gravity = 0.0;
  scene->parameters.material.stiffness = 20.0;
  scene->parameters.material.damping = 0.1;
  scene->parameters.air.drag = 0.5;
  scene->parameters.air.wind = velocity;  // so that the air does not brake it
  for (auto v = static_cast<std::size_t>(n); v < scene->state.velocities.size(); ++v) {
    scene->state.velocities[v] = velocity;
  }
  return scene;
}

double maxDistanceFrom(const std::vector<Vec3>& rest, const Vec3& shift, const ClothState& state) {
  double largest = 0.0;
  for (std::size_t v = 0; v < rest.size(); ++v) {
    largest = std::max(largest, (state.positions[v] - rest[v] - shift).norm());
  }
  return largest;
}

TEST(MovingFrame, movesASheetWithItsPinsForAnyDamping) {
  const Vec3 velocity(0.5, 0.3, 2.0);
  for (const SolverInfo& solver : solverTable()) {
    const auto scene = carriedSheet(std::string(solver.name), velocity);
    scene->run(0.3);
    EXPECT_LT(maxDistanceFrom(scene->model().restPositions, 0.3 * velocity, scene->state), 2e-5) << solver.name;
  }
}

TEST(MovingFrame, doesTheSameUnderEveryIntegration) {
  const Vec3 velocity(0.5, 0.3, 2.0);
  for (const Integration integration : {Integration::Theta, Integration::Bdf2}) {
    const auto scene = carriedSheet("pcg", velocity);
    scene->parameters.integration = integration;
    scene->run(0.3);
    EXPECT_LT(maxDistanceFrom(scene->model().restPositions, 0.3 * velocity, scene->state), 2e-5);
  }
}

TEST(MovingFrame, showsTheSameMotionAsARoomThatMoves) {
  // Relative to its pins, a sheet with moving pins swings like one with pins at rest.
  const Vec3 velocity(1.0, -0.5, 0.5);
  std::vector<ClothState> ends;
  for (const Vec3& each : {Vec3(Vec3::Zero()), velocity}) {
    const auto scene = carriedSheet("xpbd", each);
    const ClothState shaken = testing::shaken(scene->model(), 0.02, 7);
    for (std::size_t v = 0; v < shaken.positions.size(); ++v) {
      scene->state.positions[v] = shaken.positions[v];
      scene->state.velocities[v] += shaken.velocities[v];
    }
    scene->parameters.gravity = 9.81;
    scene->run(0.3);
    ends.push_back(scene->state);
  }
  EXPECT_GT(maxDistanceFrom(ends[0].positions, Vec3::Zero(), carriedSheet("xpbd", velocity)->state), 0.01);
  EXPECT_LT(maxDistanceFrom(ends[0].positions, 0.3 * velocity, ends[1]), 1e-4);
}

TEST(MovingFrame, changesNothingWhereItRests) {
  const auto model = testing::pinnedSheet(5);
  const ClothState before = testing::shaken(*model, 0.1, 3);
  ClothState state = before;
  MovingFrame frame{Vec3::Zero()};
  frame.enter(*model, 0.1, state);
  frame.leave(*model, 0.1, state);
  EXPECT_EQ(stateHash(state), stateHash(before));
}

TEST(MovingFrame, leavesPinsWithoutABodyInPlace) {
  const auto scene = carriedSheet("xpbd", Vec3(0.1, 0.2, 0.3));
  std::vector<bool> pinned = scene->model().pinned;
  pinned.back() = true;
  ContactScene other(withPins(scene->model(), pinned), scene->world().bodies(), "xpbd");
  other.parameters = scene->parameters;
  other.run(0.1);
  EXPECT_EQ(other.state.positions.back(), other.model().restPositions.back());
  EXPECT_EQ(other.state.velocities.back(), Vec3(0, 0, 0));
}

}  // namespace
}  // namespace drape::sim
