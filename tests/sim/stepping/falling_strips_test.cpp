#include "sim/measures/energy_balance.hpp"
#include "sim/stepping/stepper.hpp"

#include "fabric_cloths.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace drape::sim {
namespace {

constexpr int vertices = 5;     // along each side
constexpr double chord = 0.2;   // [m]
constexpr double length = 0.8;  // [m]

/// A stiff strip with the Froude number sqrt(density / (density of the air times the chord)). It is inclined by 30
/// degrees about z; its length along z is four chords.
struct Strip {
  std::shared_ptr<const ClothModel> model;
  ClothState state;

  explicit Strip(double froude) {
    ClothMesh mesh = testing::sheet(vertices);
    for (Vec3& position : mesh.positions) {
      position = Vec3(chord * (position.x() - 0.5), 0.0, length * (position.z() - 0.5));
    }
    fabric::Material stiff;
    stiff.stretchWarp = stiff.stretchWeft = 2000.0;
    stiff.shear = 1000.0;
    stiff.bendWarp = stiff.bendWeft = stiff.bendBias = 0.005;
    const double mass = froude * froude * AirParameters{}.density * chord * chord * length;
    model = testing::asFabric(*buildClothModel(mesh, mass, MassLumping::Area, {}), stiff);
    state = stateAtRest(mesh.positions);
    for (Vec3& position : state.positions) {
      position = Eigen::AngleAxisd(std::numbers::pi / 6.0, Vec3::UnitZ()) * position;
    }
  }

  [[nodiscard]] Vec3 chordDirection() const {
    const int first = vertices / 2 * vertices;
    return (state.positions[first + vertices - 1] - state.positions[first]).normalized();
  }
};

/// The coefficients of falling plates.
StepParameters plateAir() {
  StepParameters parameters;
  parameters.air.drag = 2.4;
  parameters.air.edgeDrag = 0.4;
  parameters.air.lift = 1.0;
  return parameters;
}

/// How a strip turned about z.
struct Turning {
  double largest = 0.0;  // in one direction from the start [revolutions]
  int reversals = 0;
};

Turning fall(Strip strip, const char* solver, double seconds) {
  Stepper stepper(solver);
  const StepParameters parameters = plateAir();
  Turning turning;
  double turned = 0.0;
  double rate = 0.0;
  for (Vec3 before = strip.chordDirection(); strip.state.time < seconds;) {
    stepper.step(*strip.model, parameters, {}, strip.state);
    const Vec3 now = strip.chordDirection();
    const double by = std::atan2(before.x() * now.y() - before.y() * now.x(), before.dot(now));
    turning.reversals += by * rate < 0.0 ? 1 : 0;
    turned += by;
    rate = by;
    turning.largest = std::max(turning.largest, std::abs(turned) / (2.0 * std::numbers::pi));
    before = now;
  }
  return turning;
}

class FallingStrip : public ::testing::TestWithParam<const char*> {};

TEST_P(FallingStrip, fluttersWhereItsFroudeNumberIsSmall) {
  const Turning turning = fall(Strip(0.35), GetParam(), 3.0);
  EXPECT_LT(turning.largest, 0.4);
  EXPECT_GE(turning.reversals, 4);
}

TEST_P(FallingStrip, tumblesWhereItsFroudeNumberIsLarge) {
  EXPECT_GT(fall(Strip(0.85), GetParam(), 4.0).largest, 1.2);
}

INSTANTIATE_TEST_SUITE_P(All, FallingStrip, ::testing::Values("auto", "newton"),
                         [](const auto& info) { return std::string(info.param); });

TEST(FallingStrips, loseTheEnergyThatTheAirTakes) {
  Strip strip(0.85);
  Stepper stepper("auto");
  const StepParameters parameters = plateAir();
  EnergyBalance balance;
  while (strip.state.time < 1.5) {
    const ClothState before = strip.state;
    stepper.step(*strip.model, parameters, {}, strip.state);
    balance.add(*strip.model, parameters, {}, before, strip.state, nullptr, {.unsteadyAir = stepper.unsteadyAirWork()});
  }
  EXPECT_LT(balance.air(), 0.0);
  EXPECT_LT(std::abs(balance.integrator()), 0.1 * std::abs(balance.air()));
}

TEST(FallingStrips, haveTheSameMotionWithAnyNumberOfThreads) {
  std::vector<ClothState> ends;
  for (const int threads : {1, 3}) {
    Strip strip(0.6);
    Stepper stepper("auto");
    StepParameters parameters = plateAir();
    parameters.threads = threads;
    while (strip.state.time < 0.5) {
      stepper.step(*strip.model, parameters, {}, strip.state);
    }
    ends.push_back(strip.state);
  }
  EXPECT_EQ(testing::largestDifference(ends[0], ends[1]), 0.0);
}

}  // namespace
}  // namespace drape::sim
