#include "sim/contact/exact/exact_self_contact.hpp"

#include "contact/contact_scene.hpp"
#include "sim/forces/diagnostics.hpp"
#include "test_meshes.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

namespace drape::sim::contact {
namespace {

/// A sheet that falls on its edge and folds.
testing::ContactScene sheetOnItsEdge(const std::string& solver, int n, double timeStep, double stiffness) {
  const Eigen::Quaterniond upright(Eigen::AngleAxisd(93.0 * std::numbers::pi / 180.0, Vec3::UnitX()));
  testing::ContactScene scene(testing::freeSheet(n, 0.8, Vec3(0.0, 0.45, 0.0), upright),
                              {testing::bodyAt(PlaneShape{2.0}, Vec3::Zero())}, solver);
  scene.parameters.contact.self = SelfCollision::Exact;
  scene.parameters.material.stiffness = stiffness;
  scene.parameters.material.damping = 0.01;
  scene.parameters.timeStep = timeStep;
  scene.parameters.substeps = solver == "verlet" ? 32 : 1;
  return scene;
}

/// The same with edges that are shorter than two thicknesses, so that neighbours are within reach.
testing::ContactScene thickSheetOnItsEdge(const std::string& solver) {
  testing::ContactScene scene = sheetOnItsEdge(solver, 17, 1.0 / 150.0, 60.0);
  scene.parameters.contact.thickness = 0.03;
  return scene;
}

/// A free sheet without gravity whose halves move towards each other.
testing::ContactScene closingBook(const std::string& solver, double speed, double timeStep) {
  testing::ContactScene scene(testing::freeSheet(13, 1.0, Vec3::Zero()), {}, solver);
  scene.parameters.contact.self = SelfCollision::Exact;
  scene.parameters.gravity = 0.0;
  scene.parameters.material.stiffness = 300.0;
  scene.parameters.timeStep = timeStep;
  scene.parameters.substeps = solver == "verlet" ? 64 : 1;
  for (std::size_t v = 0; v < scene.state.positions.size(); ++v) {
    const double x = scene.state.positions[v].x();
    scene.state.positions[v] = Vec3(0.1 * x, std::abs(x), scene.state.positions[v].z());
    scene.state.velocities[v] = Vec3(x > 0.0 ? -speed : speed, 0.0, 0.0) * std::abs(x);
  }
  return scene;
}

class ExactSelfContactWithSolver : public ::testing::TestWithParam<const char*> {};

TEST_P(ExactSelfContactWithSolver, letsNoTrianglesIntersectWhenASheetFallsOnItsEdge) {
  testing::ContactScene scene = sheetOnItsEdge(GetParam(), 13, 1.0 / 150.0, 60.0);
  int contacts = 0;
  std::size_t pairs = 0;
  scene.run(0.8, [&](const StepReport& report) {
    contacts = std::max(contacts, report.contact.selfContacts);
    pairs = std::max(pairs, scene.pairsWithItself());
    EXPECT_EQ(report.contact.crossings, 0);
  });
  EXPECT_GT(contacts, 3);
  EXPECT_EQ(pairs, 0U);
}

TEST_P(ExactSelfContactWithSolver, letsNoTrianglesIntersectWhenHalvesMeetAtHighSpeed) {
  for (const double speed : {20.0, 200.0}) {  // 0.17 m and 1.7 m in a step at the border
    testing::ContactScene scene = closingBook(GetParam(), speed, 1.0 / 60.0);
    for (int i = 0; i < 20; ++i) {
      scene.step();
      ASSERT_EQ(scene.pairsWithItself(), 0U) << speed << " m/s, step " << i;
    }
  }
}

TEST_P(ExactSelfContactWithSolver, letsNoTrianglesIntersectInClothThatIsThickForItsEdges) {
  testing::ContactScene scene = thickSheetOnItsEdge(GetParam());
  int contacts = 0;
  scene.run(0.8, [&](const StepReport& report) {
    contacts = std::max(contacts, report.contact.selfContacts);
    ASSERT_EQ(scene.pairsWithItself(), 0U);
  });
  EXPECT_GT(contacts, 3);
}

INSTANTIATE_TEST_SUITE_P(Solvers, ExactSelfContactWithSolver,
                         ::testing::Values("one_iteration", "verlet", "auto", "newton"),
                         [](const auto& instance) { return std::string(instance.param); });

TEST(ExactSelfContact, letsNoTrianglesIntersectInSoftAndStiffClothAtLargeSteps) {
  for (const double stiffness : {10.0, 1e5}) {
    testing::ContactScene scene = sheetOnItsEdge("one_iteration", 17, 1.0 / 60.0, stiffness);
    std::size_t pairs = 0;
    scene.run(0.8, [&](const StepReport&) { pairs = std::max(pairs, scene.pairsWithItself()); });
    EXPECT_EQ(pairs, 0U) << stiffness;
  }
}

TEST(ExactSelfContact, hasTheSameBitsForAnyNumberOfThreads) {
  testing::ContactScene one = sheetOnItsEdge("auto", 25, 1.0 / 150.0, 60.0);
  testing::ContactScene three = sheetOnItsEdge("auto", 25, 1.0 / 150.0, 60.0);
  three.parameters.threads = 3;
  one.run(0.5);
  three.run(0.5);
  EXPECT_EQ(one.state.positions, three.state.positions);
}

/// Compares each of some steps with the same step of a stepper that has made no other.
void expectSameBitsFromCopiedStates(const std::function<testing::ContactScene()>& make, int steps, int every) {
  testing::ContactScene scene = make();
  for (int i = 0; i < steps; ++i) {
    const ClothState before = scene.state;
    scene.step();
    if (i % every == 0) {
      testing::ContactScene fresh = make();
      fresh.state = before;
      fresh.step();
      ASSERT_EQ(scene.state.positions, fresh.state.positions) << "step " << i;
    }
  }
}

TEST(ExactSelfContact, continuesWithTheSameBitsFromACopiedState) {
  expectSameBitsFromCopiedStates([]() { return sheetOnItsEdge("auto", 25, 1.0 / 150.0, 60.0); }, 120, 5);
  expectSameBitsFromCopiedStates([]() { return sheetOnItsEdge("one_iteration", 25, 1.0 / 60.0, 60.0); }, 50, 1);
  expectSameBitsFromCopiedStates([]() { return thickSheetOnItsEdge("auto"); }, 120, 5);
  expectSameBitsFromCopiedStates([]() { return closingBook("one_iteration", 20.0, 1.0 / 60.0); }, 30, 1);
}

/// A ring of round cross-section, in the xz plane.
std::shared_ptr<const MeshShape> ringMesh(double radius, double tube) {
  constexpr int around = 32;
  constexpr int across = 12;
  MeshShape mesh;
  for (int i = 0; i < around; ++i) {
    for (int k = 0; k < across; ++k) {
      const double a = 2.0 * std::numbers::pi * i / around;
      const double b = 2.0 * std::numbers::pi * k / across;
      const double far = radius + tube * std::cos(b);
      mesh.positions.emplace_back(far * std::cos(a), tube * std::sin(b), far * std::sin(a));
      const int next = (i + 1) % around * across;
      const int above = (k + 1) % across;
      mesh.triangles.push_back({i * across + k, i * across + above, next + above});
      mesh.triangles.push_back({i * across + k, next + above, next + k});
    }
  }
  return std::make_shared<const MeshShape>(std::move(mesh));
}

/// A sheet that is pulled through a ring by its middle.
testing::ContactScene sheetThroughARing() {
  constexpr int n = 29;
  ClothMesh sheet = testing::sheet(n);
  for (Vec3& position : sheet.positions) {
    position = 0.7 * (position - Vec3(0.5, 0.0, 0.5)) + Vec3(0.0, 0.1, 0.0);
  }
  constexpr int middle = n * n / 2;
  testing::ContactScene scene(buildClothModel(sheet, 0.1, MassLumping::Area, {middle}),
                              {testing::bodyAt(ringMesh(0.16, 0.03), Vec3::Zero())}, "one_iteration");
  scene.parameters.contact.self = SelfCollision::Exact;
  scene.parameters.material.stiffness = 100.0;
  scene.parameters.material.damping = 0.02;
  scene.parameters.timeStep = 1.0 / 150.0;
  scene.movedPins = {{middle, Vec3(0.0, -0.008, 0.0)}};
  return scene;
}

TEST(ExactSelfContact, continuesWithTheSameBitsFromACopiedStateWhereClothMeetsItselfOnAMesh) {
  expectSameBitsFromCopiedStates(sheetThroughARing, 80, 4);
}

TEST(ExactSelfContact, continuesAfterStepsWithTheHash) {
  testing::ContactScene scene = thickSheetOnItsEdge("auto");
  scene.parameters.contact.self = SelfCollision::Hash;
  scene.run(0.1);
  scene.parameters.contact.self = SelfCollision::Exact;
  scene.run(0.5, [&](const StepReport&) { ASSERT_EQ(scene.pairsWithItself(), 0U); });
}

TEST(ExactSelfContact, changesNothingWhereNothingIsNear) {
  testing::ContactScene exact(testing::freeSheet(13, 1.0, Vec3(0.0, 5.0, 0.0)), {}, "auto");
  testing::ContactScene off(testing::freeSheet(13, 1.0, Vec3(0.0, 5.0, 0.0)), {}, "auto");
  exact.parameters.contact.self = SelfCollision::Exact;
  off.parameters.contact.self = SelfCollision::Off;
  exact.run(0.2);
  off.run(0.2);
  EXPECT_EQ(exact.state.positions, off.state.positions);
}

TEST(ExactSelfContact, conservesMomentumInContact) {
  testing::ContactScene scene = closingBook("verlet", 2.0, 1.0 / 1000.0);
  const auto momentumOf = [&]() {
    Vec3 sum = Vec3::Zero();
    for (std::size_t v = 0; v < scene.state.velocities.size(); ++v) {
      sum += scene.model().vertexMass[v] * scene.state.velocities[v];
    }
    return sum;
  };
  const Vec3 before = momentumOf();
  int contacts = 0;
  scene.run(0.3, [&](const StepReport& report) { contacts = std::max(contacts, report.contact.selfContacts); });
  EXPECT_GT(contacts, 3);
  EXPECT_LT((momentumOf() - before).norm(), 1e-6 * scene.model().totalMass());
}

/// A sheet with edges that are many times as long as others, which are shorter than the cloth is thick.
std::shared_ptr<const ClothModel> gradedSheet() {
  ClothMesh mesh = testing::sheet(25);
  const Eigen::Quaterniond tilt(Eigen::AngleAxisd(0.4, Vec3(1.0, 0.0, 0.7).normalized()));
  const auto graded = [](double x) { return 2.0 * x * std::abs(x); };
  testing::RandomVectors random(4);
  for (Vec3& position : mesh.positions) {
    const Vec3 moved = position + random.next(0.01);
    position = tilt * Vec3(graded(moved.x()), 0.0, graded(moved.z())) + Vec3(0.0, 0.6, 0.0);
  }
  return buildClothModel(mesh, 0.15, MassLumping::Area, {});
}

/// Separating features can stretch short edges by more energy than the motion has in that moment. It is removed as soon
/// as it moves the cloth.
TEST(ExactSelfContact, addsEnergyToAGradedMeshForMomentsOnly) {
  testing::ContactScene scene(gradedSheet(), {testing::bodyAt(SphereShape{0.2}, Vec3(0.0, 0.2, 0.0))}, "auto");
  scene.parameters.contact.self = SelfCollision::Exact;
  scene.parameters.contact.thickness = 0.004;
  scene.parameters.material.stiffness = 1e4;
  scene.parameters.timeStep = 1.0 / 60.0;
  const double start = energyOf(scene.model(), scene.parameters, scene.state).total();
  double work = 0.0;
  std::vector<double> gained;
  scene.run(1.5, [&](const StepReport& report) {
    work = std::max(work, report.contact.guardWork);
    gained.push_back(energyOf(scene.model(), scene.parameters, scene.state).total() - start);
  });
  EXPECT_GT(work, 0.0) << "the guard had nothing to do";
  const double fall = 0.15 * 9.81 * 0.4;
  EXPECT_LT(std::ranges::max(gained), fall);
  EXPECT_LT(*std::min_element(gained.end() - 30, gained.end()), 0.1 * fall) << "the least gain of the last 0.5 s";
}

TEST(ExactSelfContact, recoversFromABodyThatLeavesNoRoom) {
  ClothMesh mesh;
  for (const double height : {0.02, 0.04, 0.06}) {
    const Eigen::Quaterniond tilt(Eigen::AngleAxisd(2.0 * height, Vec3(0.6, 0.0, 0.8)));
    testing::addSheet(9, 0.3, Vec3(height, height, 0.0), tilt, mesh);
  }
  Body press = testing::bodyAt(BoxShape{Vec3(0.3, 0.02, 0.3)}, Vec3::Zero());
  press.motion.keyframes = {{0.0, Vec3(0.0, 0.15, 0.0), Vec3::Zero()},
                            {0.3, Vec3(0.0, 0.02, 0.0), Vec3::Zero()},
                            {0.4, Vec3(0.0, 0.02, 0.0), Vec3::Zero()},
                            {0.7, Vec3(0.0, 0.3, 0.0), Vec3::Zero()}};
  testing::ContactScene scene(buildClothModel(mesh, 0.05, MassLumping::Area, {}),
                              {testing::bodyAt(PlaneShape{1.0}, Vec3::Zero()), press}, "auto");
  scene.parameters.contact.self = SelfCollision::Exact;
  int infeasible = 0;
  scene.run(1.0, [&](const StepReport& report) { infeasible = std::max(infeasible, report.contact.infeasible); });
  EXPECT_GT(infeasible, 0) << "the press left room";
  EXPECT_EQ(scene.pairsWithItself(), 0U);
  EXPECT_EQ(scene.pairs(0) + scene.pairs(1), 0);
  EXPECT_LT(maxStretch(scene.model(), scene.state), 0.1);
}

TEST(ExactSelfContact, movesOnWithAStartThatIntersects) {
  // Every second column lies on the other side of the folded sheet, so that its halves intersect.
  testing::ContactScene scene = closingBook("auto", 0.0, 1.0 / 150.0);
  for (std::size_t v = 0; v < scene.state.positions.size(); ++v) {
    scene.state.positions[v].x() -=
        scene.state.positions[v].z() > 0.1 && scene.state.positions[v].x() > 0.02 ? 0.12 : 0;
  }
  ASSERT_GT(scene.pairsWithItself(), 0U);
  scene.parameters.gravity = 9.81;
  const double start = energyOf(scene.model(), scene.parameters, scene.state).total();
  const double height = scene.state.positions[0].y();
  scene.run(0.4);
  EXPECT_TRUE(isFinite(scene.state));
  EXPECT_LT(scene.state.positions[0].y(), height - 0.3);  // it falls
  EXPECT_LT(energyOf(scene.model(), scene.parameters, scene.state).total(), start + 0.05);
}

}  // namespace
}  // namespace drape::sim::contact
