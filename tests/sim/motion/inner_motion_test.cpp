#include "sim/motion/inner_motion.hpp"

#include "dense_cloth.hpp"
#include "sim/forces/diagnostics.hpp"
#include "sim/model/pieces.hpp"
#include "sim/motion/momentum.hpp"

#include <gtest/gtest.h>

namespace drape::sim {
namespace {

using namespace drape::sim::testing;

/// Shaken, flying and spinning.
ClothState thrown(const ClothModel& model, double shaking) {
  ClothState state = shaken(model, shaking, 5);
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    if (!model.pinned[v]) {
      state.velocities[v] += Vec3(1.0, 0.5, 0.2) + Vec3(0.3, 2.0, 1.0).cross(state.positions[v]);
    }
  }
  return state;
}

TEST(InnerMotion, isNoneInAClothThatFliesAndSpinsAsOne) {
  const auto model = unevenSheet(5, {});
  const ClothState state = thrown(*model, 0.0);
  EXPECT_LT(InnerMotion(*model, freePieces(*model), state).energy(), 1e-20);
}

TEST(InnerMotion, isSlowedDownWithoutTouchingMomentum) {
  const auto model = unevenSheet(5, {});
  ClothState state = thrown(*model, 0.1);
  const Vec3 linear = linearMomentum(*model, state);
  const Vec3 angular = angularMomentum(*model, state, Vec3::Zero());
  const double kinetic = energyOf(*model, {}, state).kinetic;
  const InnerMotion inner(*model, freePieces(*model), state);
  ASSERT_GT(inner.energy(), 1e-3);
  inner.scale(0.5, state);
  EXPECT_LT((linearMomentum(*model, state) - linear).norm(), 1e-13 * linear.norm());
  EXPECT_LT((angularMomentum(*model, state, Vec3::Zero()) - angular).norm(), 1e-13 * angular.norm());
  EXPECT_NEAR(energyOf(*model, {}, state).kinetic, kinetic - 0.75 * inner.energy(), 1e-13 * kinetic);
}

TEST(InnerMotion, isAllMotionWhereSomethingIsPinned) {
  const auto model = unevenSheet(5, {0});
  ClothState state = thrown(*model, 0.1);
  const InnerMotion inner(*model, freePieces(*model), state);
  EXPECT_NEAR(inner.energy(), energyOf(*model, {}, state).kinetic, 1e-13 * inner.energy());
  inner.scale(0.0, state);
  EXPECT_EQ(energyOf(*model, {}, state).kinetic, 0.0);
}

}  // namespace
}  // namespace drape::sim
