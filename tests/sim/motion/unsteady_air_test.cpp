#include "sim/motion/unsteady_air.hpp"

#include "dense_cloth.hpp"
#include "sim/motion/momentum.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace drape::sim {
namespace {

using namespace drape::sim::testing;

constexpr double side = 0.2;        // [m]
constexpr double plateMass = 0.01;  // [kg]
constexpr double step = 1e-3;       // [s]

/// A rectangle of these sides in the xz plane.
std::shared_ptr<const ClothModel> plate(double length = side, double width = side, const std::vector<int>& pins = {}) {
  ClothMesh mesh = sheet(21);
  for (Vec3& position : mesh.positions) {
    position = Vec3(length * (position.x() - 0.5), 0.0, width * (position.z() - 0.5));
  }
  return buildClothModel(mesh, plateMass, MassLumping::Area, pins);
}

/// Air that acts as on a plate, and hardly slows it down.
CommonParameters thinAir() {
  CommonParameters parameters;
  parameters.timeStep = step;
  parameters.air.model = AirModel::Plate;
  parameters.air.drag = 1e-9;
  return parameters;
}

ClothState moving(const ClothModel& model, const Vec3& velocity, const Vec3& spin = Vec3::Zero()) {
  ClothState state = stateAtRest(model.restPositions);
  for (std::size_t v = 0; v < state.positions.size(); ++v) {
    state.velocities[v] = velocity + spin.cross(state.positions[v]);
  }
  return state;
}

RigidMotion motionOf(const ClothModel& model, const ClothState& state) {
  std::vector<std::size_t> all(state.positions.size());
  for (std::size_t v = 0; v < all.size(); ++v) {
    all[v] = v;
  }
  return rigidMotionOf(model, all, state);
}

/// The state after the unsteady air of a step in which nothing else changed the velocities by more than `by`.
ClothState after(const ClothModel& model, const CommonParameters& parameters, ClothState state,
                 const Vec3& by = Vec3::Zero()) {
  UnsteadyAir air;
  air.begin(model, parameters, state);
  for (Vec3& velocity : state.velocities) {
    velocity += by;
  }
  air.apply(model, state);
  return state;
}

double addedMass(double length, double width) {
  return addedMassFactor(std::min(length, width), std::max(length, width)) * 0.25 * std::numbers::pi * 1.225 * length *
         width * std::min(length, width);
}

TEST(AddedMass, isThatOfPotentialFlowForRectangles) {
  EXPECT_NEAR(addedMassFactor(1.0, 1.0), 0.579, 0.002);
  EXPECT_NEAR(addedMassFactor(1.0, 2.0), 0.757, 0.03);
  EXPECT_NEAR(addedMassFactor(1.0, 1e6), 1.0, 1e-6);
}

TEST(UnsteadyAir, makesAPlateHeavierAlongItsNormalOnly) {
  const auto model = plate(side, 2.0 * side);
  const Vec3 by(0.1, 0.2, 0.3);
  const Vec3 velocity = motionOf(*model, after(*model, thinAir(), moving(*model, Vec3::Zero()), by)).velocity;
  EXPECT_NEAR(velocity.x(), by.x(), 1e-12);
  EXPECT_NEAR(velocity.z(), by.z(), 1e-12);
  EXPECT_NEAR(velocity.y(), by.y() * plateMass / (plateMass + addedMass(side, 2.0 * side)), 3e-3 * by.y());
}

TEST(UnsteadyAir, leavesASteadyMotionAcrossOrAlongThePlateAsItIs) {
  const auto model = plate();
  for (const Vec3& velocity : {Vec3(0.0, -1.0, 0.0), Vec3(2.0, 0.0, 1.0), Vec3(0.0, 0.0, 0.0)}) {
    const ClothState start = moving(*model, velocity);
    EXPECT_LT(largestDifference(start, after(*model, thinAir(), start)), 1e-12);
  }
}

TEST(UnsteadyAir, isThatOfTheMotionRelativeToTheWind) {
  const auto model = plate();
  CommonParameters windy = thinAir();
  windy.air.wind = Vec3(3.0, -1.0, 2.0);
  const Vec3 spin(4.0, 0.0, 1.0);
  const Vec3 velocity(1.0, 0.5, 0.0);
  const RigidMotion still = motionOf(*model, after(*model, thinAir(), moving(*model, velocity, spin)));
  const RigidMotion carried = motionOf(*model, after(*model, windy, moving(*model, velocity + windy.air.wind, spin)));
  EXPECT_LT((carried.velocity - windy.air.wind - still.velocity).norm(), 1e-12);
  EXPECT_LT((carried.spin - still.spin).norm(), 1e-11);
}

TEST(UnsteadyAir, turnsAPlateAcrossItsMotion) {
  const auto model = plate();
  // It moves forwards and slightly down. Turned about -z, its front would go down; across the motion, it goes up.
  const RigidMotion motion = motionOf(*model, after(*model, thinAir(), moving(*model, Vec3(1.0, -0.2, 0.0))));
  const double torque = addedMass(side, side) * 1.0 * 0.2;
  const double air = std::numbers::pi / 128.0 * 1.225 * std::pow(side, 5) * addedMassFactor(side, side);
  const double inertia = plateMass * side * side / 12.0 + air;
  EXPECT_NEAR(motion.spin.z(), step * torque / inertia, 0.03 * step * torque / inertia);
  EXPECT_NEAR(motion.spin.x(), 0.0, 0.01 * motion.spin.z());  // the diagonals make the mesh asymmetric
}

TEST(UnsteadyAir, liftsAPlateThatTurnsBackwardsAndDoesNoWorkByThat) {
  const auto model = plate();
  const Vec3 velocity(1.0, 0.0, 0.0);  // along the plate: no added momentum
  const RigidMotion motion = motionOf(*model, after(*model, thinAir(), moving(*model, velocity, Vec3(0.0, 0.0, 5.0))));
  EXPECT_GT(motion.velocity.y(), 1e-5);
  const double lifted = (plateMass + addedMass(side, side)) * motion.velocity.y();
  EXPECT_NEAR(lifted, step * 0.5 * addedMassFactor(side, side) * 1.225 * std::pow(side, 3) * 5.0, 0.02 * lifted);
  const double energy =
      plateMass * motion.velocity.squaredNorm() + addedMass(side, side) * motion.velocity.y() * motion.velocity.y();
  EXPECT_NEAR(energy, plateMass, 1e-5 * plateMass);
}

/// The kinetic energy of the plate and of the air that moves with it [J].
double energyWithAir(const ClothModel& model, const ClothState& state) {
  const RigidMotion motion = motionOf(model, state);
  const Eigen::SelfAdjointEigenSolver<Mat3> axes(motion.moments.inertia);
  const Vec3 normal = axes.eigenvectors().col(2);
  const Vec3 spin = motion.spin - motion.spin.dot(normal) * normal;
  const double air = std::numbers::pi / 128.0 * 1.225 * std::pow(side, 5) * addedMassFactor(side, side);
  return 0.5 * (plateMass * motion.velocity.squaredNorm() + motion.spin.dot(motion.moments.inertia * motion.spin) +
                addedMass(side, side) * std::pow(motion.velocity.dot(normal), 2) + air * spin.squaredNorm());
}

TEST(UnsteadyAir, conservesTheEnergyOfAFlyingPlateAndItsAir) {
  const auto model = plate();
  const auto change = [&](double timeStep) {
    CommonParameters parameters = thinAir();
    parameters.timeStep = timeStep;
    ClothState state = moving(*model, Vec3(1.0, -0.4, 0.3), Vec3(1.0, 0.0, 3.0));
    const double start = energyWithAir(*model, state);
    UnsteadyAir air;
    for (double time = 0.0; time < 0.3; time += timeStep) {
      air.begin(*model, parameters, state);
      const RigidMotion motion = motionOf(*model, state);
      const Eigen::AngleAxisd turn(timeStep * motion.spin.norm(), motion.spin.normalized());
      for (std::size_t v = 0; v < state.positions.size(); ++v) {
        const Vec3 arm = turn * (state.positions[v] - motion.moments.barycentre);
        state.positions[v] = motion.moments.barycentre + timeStep * motion.velocity + arm;
        state.velocities[v] = motion.velocity + motion.spin.cross(arm);
      }
      air.apply(*model, state);
    }
    return std::abs(energyWithAir(*model, state) / start - 1.0);
  };
  EXPECT_LT(change(2e-3), 1e-3);
  EXPECT_LT(change(2.5e-4), 3e-4);
}

TEST(UnsteadyAir, returnsItsWork) {
  const auto model = plate();
  ClothState state = moving(*model, Vec3(1.0, -0.2, 0.0), Vec3(0.0, 1.0, 5.0));
  UnsteadyAir air;
  air.begin(*model, thinAir(), state);
  state.velocities[0] += Vec3(0.0, 1.0, 0.0);  // not a rigid motion
  const auto kinetic = [&] {
    double sum = 0.0;
    for (std::size_t v = 0; v < state.velocities.size(); ++v) {
      sum += 0.5 * model->vertexMass[v] * state.velocities[v].squaredNorm();
    }
    return sum;
  };
  const double before = kinetic();
  const double work = air.apply(*model, state);
  EXPECT_GT(std::abs(work), 1e-6 * before);
  EXPECT_NEAR(kinetic() - before, work, 1e-12 * before);
}

TEST(UnsteadyAir, leavesLessResistanceToRotationThanThatAtEveryPoint) {
  const auto model = plate();
  CommonParameters air = thinAir();
  air.air.drag = 1.2;
  const RigidMotion motion = motionOf(*model, after(*model, air, moving(*model, Vec3::Zero(), Vec3(0.0, 0.0, 5.0))));
  EXPECT_GT(motion.spin.z(), 5.0);  // the solver takes more
}

TEST(UnsteadyAir, staysBoundedInAStorm) {
  const auto model = plate();
  CommonParameters storm = thinAir();
  storm.timeStep = 1.0 / 30.0;
  storm.air.drag = 1.2;
  storm.air.lift = 1.0;
  storm.air.wind = Vec3(60.0, 25.0, -10.0);
  ClothState state = moving(*model, Vec3::Zero(), Vec3(3.0, 0.0, 10.0));
  state = after(*model, storm, state);
  const RigidMotion motion = motionOf(*model, state);
  EXPECT_LT(motion.velocity.norm(), 66.0);
  EXPECT_LT(motion.spin.norm() * side, 66.0);
}

TEST(UnsteadyAir, doesNotActWithoutAir) {
  const auto model = plate();
  CommonParameters vacuum = thinAir();
  vacuum.air.drag = 0.0;
  UnsteadyAir air;
  air.begin(*model, vacuum, moving(*model, Vec3(0.0, -1.0, 0.0)));
  EXPECT_FALSE(air.acts());
  EXPECT_EQ(air.longestStep(), std::numeric_limits<double>::infinity());
}

TEST(UnsteadyAir, doesNotActOnThePapersCloth) {
  const auto model = plate();
  for (const AirModel law : {AirModel::Paper, AirModel::Auto}) {
    CommonParameters parameters = thinAir();
    parameters.air.model = law;
    UnsteadyAir air;
    air.begin(*model, parameters, moving(*model, Vec3(0.0, -1.0, 0.0)));
    EXPECT_FALSE(air.acts());
  }
}

TEST(UnsteadyAir, doesNotActOnAPieceWithPins) {
  const auto model = plate(side, side, {0});
  UnsteadyAir air;
  air.begin(*model, thinAir(), moving(*model, Vec3(0.0, -1.0, 0.0)));
  EXPECT_FALSE(air.acts());
}

TEST(UnsteadyAir, fadesAsThePieceBends) {
  const auto model = plate();
  const auto gain = [&](double angle) {
    ClothState folded = moving(*model, Vec3::Zero());
    for (Vec3& position : folded.positions) {
      position = Vec3(std::cos(angle) * position.x(), std::sin(angle) * std::abs(position.x()), position.z());
    }
    UnsteadyAir air;
    air.begin(*model, thinAir(), folded);
    for (Vec3& velocity : folded.velocities) {
      velocity += Vec3(0.0, -1.0, 0.0);
    }
    air.apply(*model, folded);
    return 1.0 + motionOf(*model, folded).velocity.y();  // 0 where the piece is not heavier
  };
  EXPECT_GT(gain(0.2), 0.29);
  EXPECT_GT(gain(0.2), gain(0.6) + 0.05);  // the mean normals have the lengths 0.98 and 0.83
  EXPECT_GT(gain(0.6), 0.05);
  EXPECT_EQ(gain(0.85), 0.0);  // 0.66
}

TEST(UnsteadyAir, asksForShorterStepsTheFasterAndTheLighterAPieceIs) {
  const auto model = plate();
  const auto longest = [&](const Vec3& velocity) {
    UnsteadyAir air;
    air.begin(*model, thinAir(), moving(*model, velocity));
    return air.longestStep();
  };
  EXPECT_NEAR(longest(Vec3(2.0, 0.0, 0.0)), 0.25 * side / 2.0, 0.01 * side);
  EXPECT_NEAR(longest(Vec3(8.0, 0.0, 0.0)), 0.25 * longest(Vec3(2.0, 0.0, 0.0)), 1e-12);
  EXPECT_EQ(longest(Vec3::Zero()), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace drape::sim
