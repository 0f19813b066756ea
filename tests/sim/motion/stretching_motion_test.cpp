#include "sim/motion/stretching_motion.hpp"

#include "sim/forces/diagnostics.hpp"
#include "sim/motion/momentum.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <functional>

namespace drape::sim {
namespace {

/// A flat sheet at rest with a velocity of each vertex [m/s].
ClothState flatSheetMoving(const ClothModel& model, const std::function<Vec3(const Vec3&)>& velocityAt) {
  ClothState state = stateAtRest(model.restPositions);
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    state.velocities[v] = velocityAt(state.positions[v]);
  }
  return state;
}

TEST(StretchingMotion, losesExactlyTheEnergyAskedForAndKeepsTheMomentum) {
  const auto model = testing::irregularSheet(9, {});
  ClothState state = testing::shaken(*model, 0.01, 3);
  const double kinetic = kineticEnergy(*model, state);
  const Vec3 linear = linearMomentum(*model, state);
  const Vec3 angular = angularMomentum(*model, state, Vec3::Zero());
  const double asked = 0.3 * kinetic;
  EXPECT_DOUBLE_EQ(removeStretchingMotion(*model, asked, 8, state), asked);
  EXPECT_NEAR(kinetic - kineticEnergy(*model, state), asked, 1e-12 * kinetic);
  EXPECT_LT((linearMomentum(*model, state) - linear).norm(), 1e-13 * linear.norm());
  EXPECT_LT((angularMomentum(*model, state, Vec3::Zero()) - angular).norm(), 1e-13 * angular.norm());
}

TEST(StretchingMotion, isNoneInRotationAndFolding) {
  const auto model = buildClothModel(testing::sheet(9), 0.1, MassLumping::Area, {});
  const auto rotation = [](const Vec3& x) -> Vec3 { return Vec3(1.0, 2.0, 0.5) + Vec3(0.3, 2.0, 1.0).cross(x); };
  const auto folding = [](const Vec3& x) -> Vec3 { return Vec3(0.0, std::sin(9.0 * x.x()), 0.0); };
  for (const std::function<Vec3(const Vec3&)>& velocity :
       {std::function<Vec3(const Vec3&)>(rotation), std::function<Vec3(const Vec3&)>(folding)}) {
    ClothState state = flatSheetMoving(*model, velocity);
    EXPECT_LT(removeStretchingMotion(*model, 1.0, 4, state), 1e-25);
  }
}

TEST(StretchingMotion, losesShortWavesBeforeLongOnes) {
  const auto model = buildClothModel(testing::sheet(17), 0.1, MassLumping::Area, {});
  const auto left = [&](double waves) {
    ClothState state = flatSheetMoving(
        *model, [&](const Vec3& x) -> Vec3 { return Vec3(std::cos(2.0 * M_PI * waves * x.x()), 0.0, 0.0); });
    const double kinetic = kineticEnergy(*model, state);
    removeStretchingMotion(*model, kinetic, 4, state);
    return kineticEnergy(*model, state) / kinetic;
  };
  EXPECT_GT(left(0.5), 0.9) << "the sheet as a whole";
  EXPECT_LT(left(8.0), 0.1) << "neighbours against each other";
}

TEST(StretchingMotion, leavesPinsAndEdgesWithoutALengthAlone) {
  const auto model = testing::pinnedSheet(5);
  ClothState state = testing::shaken(*model, 0.01, 3);
  state.positions.assign(state.positions.size(), Vec3::Zero());
  const std::uint64_t before = stateHash(state);
  EXPECT_EQ(removeStretchingMotion(*model, 1.0, 4, state), 0.0);
  EXPECT_EQ(stateHash(state), before);
  state = testing::shaken(*model, 0.01, 3);
  EXPECT_GT(removeStretchingMotion(*model, 1.0, 4, state), 0.0);
  EXPECT_EQ(state.velocities[0], Vec3(Vec3::Zero()));
}

}  // namespace
}  // namespace drape::sim
