#include "sim/model/cloth_state.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

namespace drape::sim {
namespace {

TEST(StateHash, changesWithTheLastBitOfAnyPositionOrVelocity) {
  const ClothState state = stateAtRest({Vec3(1.0, 2.0, 3.0), Vec3(4.0, 5.0, 6.0)});
  ClothState other = state;
  EXPECT_EQ(stateHash(state), stateHash(other));
  other.positions[1].z() = std::nextafter(6.0, 7.0);
  EXPECT_NE(stateHash(state), stateHash(other));
  other = state;
  other.velocities[0].x() = std::numeric_limits<double>::denorm_min();
  EXPECT_NE(stateHash(state), stateHash(other));
}

TEST(StateHash, isWrittenAsSixteenHexadecimalDigits) {
  EXPECT_EQ(toHex(0), "0000000000000000");
  EXPECT_EQ(toHex(0x0123456789abcdefULL), "0123456789abcdef");
}

TEST(IsFinite, noticesOneBadNumberAnywhere) {
  ClothState state = stateAtRest({Vec3::Zero(), Vec3::Zero()});
  EXPECT_TRUE(isFinite(state));
  state.velocities[1].y() = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(isFinite(state));
  state.velocities[1].y() = 0.0;
  state.positions[0].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(isFinite(state));
  state.positions[0].x() = -1e14;
  EXPECT_TRUE(isFinite(state));
  state.positions[0].x() = -1e16;
  EXPECT_FALSE(isFinite(state)) << "the cloth blew up";
}

}  // namespace
}  // namespace drape::sim
