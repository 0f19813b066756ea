#include "contact/contact_scene.hpp"
#include "sim/forces/diagnostics.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

namespace drape::sim::contact {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

constexpr int patchSize = 4;

/// A patch at rest on a sheet that is pinned at all vertices, on a slope. The patch is turned, so that edges cross. In
/// the rest shape the two are far apart: features that are close at rest keep less than the thickness.
testing::ContactScene patchOnSlope(double slope, const std::string& solver) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(-slope, Vec3::UnitZ()));
  const Eigen::Quaterniond aside(Eigen::AngleAxisd(0.3, Vec3::UnitY()));
  ClothMesh mesh;
  testing::addSheet(8, 2.0, Vec3::Zero(), turn, mesh);
  std::vector<int> pins(mesh.positions.size());
  std::iota(pins.begin(), pins.end(), 0);
  const int first = testing::addSheet(patchSize, 0.2, turn * Vec3(-0.5, 1.0, 0.0), turn * aside, mesh);
  testing::ContactScene scene(buildClothModel(mesh, 0.5, MassLumping::Area, pins), {}, solver);
  scene.parameters.contact.self = SelfCollision::Exact;
  scene.parameters.contact.staticFriction = 0.5;
  scene.parameters.contact.kineticFriction = 0.4;
  scene.parameters.material.stiffness = 50.0;
  scene.parameters.timeStep = 1.0 / 150.0;
  scene.parameters.substeps = solver == "verlet" ? 8 : 1;
  for (auto v = static_cast<std::size_t>(first); v < scene.state.positions.size(); ++v) {
    scene.state.positions[v] += turn * Vec3(0.0, ContactParameters{}.thickness - 1.0, 0.0);
  }
  return scene;
}

/// The mean of some values of the patch.
Vec3 meanOfPatch(const std::vector<Vec3>& values) {
  Vec3 sum = Vec3::Zero();
  constexpr int count = patchSize * patchSize;
  for (auto v = values.end() - count; v != values.end(); ++v) {
    sum += *v / count;
  }
  return sum;
}

class ExactFrictionWithSolver : public ::testing::TestWithParam<const char*> {};

TEST_P(ExactFrictionWithSolver, holdsClothOnClothBelowTheFrictionAngle) {
  testing::ContactScene scene = patchOnSlope(26.0 * degree, GetParam());  // arctan 0.5 is 26.57 degrees
  const Vec3 start = meanOfPatch(scene.state.positions);
  scene.run(1.0);
  EXPECT_LT((meanOfPatch(scene.state.positions) - start).norm(), 1e-3);
  EXPECT_EQ(scene.pairsWithItself(), 0U);
}

TEST_P(ExactFrictionWithSolver, letsClothSlideOnClothWithTheAccelerationThatFrictionLeaves) {
  const double slope = 35.0 * degree;
  testing::ContactScene scene = patchOnSlope(slope, GetParam());
  scene.run(0.4);
  const Vec3 down(std::cos(slope), -std::sin(slope), 0.0);
  const double expected = 9.81 * (std::sin(slope) - 0.4 * std::cos(slope)) * 0.4;
  EXPECT_NEAR(meanOfPatch(scene.state.velocities).dot(down), expected, 0.03 * expected);
  EXPECT_EQ(scene.pairsWithItself(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Solvers, ExactFrictionWithSolver, ::testing::Values("auto", "verlet"),
                         [](const auto& solver) { return std::string(solver.param); });

/// The largest amount by which the energy that contact has added so far rises above an earlier value [J].
double largestGainByContact(testing::ContactScene& scene, double seconds) {
  double sum = 0.0;
  double lowest = 0.0;
  double gain = 0.0;
  int contacts = 0;
  const auto energy = [&](const ClothState& state) { return energyOf(scene.model(), scene.parameters, state).total(); };
  scene.run(seconds, [&](const StepReport& report) {
    const ClothState* unresolved = scene.stepper().contact().unresolved();
    sum += scene.stepper().earlierContactWork() +
           (unresolved != nullptr ? energy(scene.state) - energy(*unresolved) : 0.0);
    lowest = std::min(lowest, sum);
    gain = std::max(gain, sum - lowest);
    contacts = std::max(contacts, report.contact.selfContacts);
  });
  EXPECT_GT(contacts, 5);
  EXPECT_LT(sum, 0.0);
  return gain;
}

/// A level sheet of n x n vertices that hangs over a line of pins along its middle column. @param n odd
std::shared_ptr<const ClothModel> sheetOverALine(int n) {
  std::vector<int> pins;
  for (int row = 0; row < n; ++row) {
    pins.push_back(n * row + n / 2);
  }
  return buildClothModel(testing::sheet(n), 0.1, MassLumping::Uniform, pins);
}

TEST(ExactSelfContact, neverAddsEnergyWhenASheetFoldsOverALine) {
  testing::ContactScene scene(sheetOverALine(17), {}, "auto");
  scene.parameters.contact.self = SelfCollision::Exact;
  scene.parameters.material.stiffness = 200.0;
  scene.parameters.material.damping = 0.002;
  scene.parameters.timeStep = 1.0 / 300.0;
  EXPECT_LT(largestGainByContact(scene, 1.2), 0.002);  // [J]; the fall releases 0.25 J
}

TEST(ExactSelfContact, neverAddsEnergyWhenASheetFallsOnItsEdge) {
  const Eigen::Quaterniond upright(Eigen::AngleAxisd(93.0 * degree, Vec3::UnitX()));
  testing::ContactScene scene(testing::freeSheet(17, 0.8, Vec3(0.0, 0.45, 0.0), upright),
                              {testing::bodyAt(PlaneShape{2.0}, Vec3::Zero())}, "auto");
  scene.parameters.contact.self = SelfCollision::Exact;
  scene.parameters.material.stiffness = 150.0;
  scene.parameters.material.damping = 0.02;
  scene.parameters.timeStep = 1.0 / 300.0;
  EXPECT_LT(largestGainByContact(scene, 0.8), 0.004);  // [J]; the fall releases 0.38 J
}

TEST(ExactSelfContact, neverAddsEnergyWhenFiveLayersFallOnEachOther) {
  ClothMesh mesh;
  for (int layer = 0; layer < 5; ++layer) {
    testing::addSheet(7, 0.3, Vec3(0.0, 0.02 + 0.02 * layer, 0.0),
                      Eigen::Quaterniond(Eigen::AngleAxisd(0.2 * layer, Vec3::UnitY())), mesh);
  }
  testing::ContactScene scene(buildClothModel(mesh, 0.1, MassLumping::Area, {}),
                              {testing::bodyAt(PlaneShape{2.0}, Vec3::Zero())}, "auto");
  scene.parameters.contact.self = SelfCollision::Exact;
  scene.parameters.material.stiffness = 100.0;
  scene.parameters.material.damping = 0.01;
  scene.parameters.timeStep = 1.0 / 300.0;
  EXPECT_LT(largestGainByContact(scene, 0.5), 0.0005);  // [J]; the fall releases 0.05 J
  EXPECT_EQ(scene.pairsWithItself(), 0U);
}

/// A bar that holds an end of a strip at x = side * 0.4 m. It turns about the x axis and moves inwards.
Body turningBar(double side, double turns, double seconds) {
  Body bar = testing::bodyAt(CapsuleShape{0.01, 0.15}, Vec3(0.44 * side, 0.0, 0.0), Vec3(90.0 * degree, 0.0, 0.0));
  const double angle = 90.0 * degree + side * turns * 360.0 * degree;
  bar.motion.keyframes.push_back({seconds, Vec3(0.34 * side, 0.0, 0.0), Vec3(angle, 0.0, 0.0)});
  return bar;
}

/// A strip of 0.8 m x 0.3 m between two bars that twist it.
testing::ContactScene twistedStrip(double turns, double seconds) {
  constexpr int columns = 28;
  constexpr int rows = 11;
  std::vector<Body> bars{turningBar(-1.0, turns, seconds), turningBar(1.0, turns, seconds)};
  ClothMesh mesh;
  std::vector<int> pins;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const int v = columns * row + column;
      mesh.positions.emplace_back(0.8 * column / (columns - 1) - 0.4, 0.0, 0.3 * row / (rows - 1) - 0.15);
      if (column == 0 || column + 1 == columns) {
        pins.push_back(v);
        bars[column == 0 ? 0 : 1].pins.push_back({v, -1});
      }
      if (column + 1 < columns && row + 1 < rows) {
        mesh.triangles.push_back({v, v + columns, v + 1});
        mesh.triangles.push_back({v + 1, v + columns, v + columns + 1});
      }
    }
  }
  testing::ContactScene scene(buildClothModel(mesh, 0.036, MassLumping::Area, pins), bars, "auto");
  scene.parameters.contact.self = SelfCollision::Exact;
  scene.parameters.material.stiffness = 200.0;
  scene.parameters.material.damping = 0.01;
  scene.parameters.air.drag = 0.3;
  scene.parameters.timeStep = 1.0 / 150.0;
  return scene;
}

TEST(ExactSelfContact, addsLittleEnergyToAStripThatIsTwistedIntoARope) {
  // Its layers press on each other with thousands of times their weight. A contact that the substeps lack lets them
  // move into each other, and the correction at the end stretches the springs.
  testing::ContactScene scene = twistedStrip(2.0, 1.6);
  const auto energy = [&](const ClothState& state) { return energyOf(scene.model(), scene.parameters, state).total(); };
  double largest = 0.0;  // by the correction at the end of a step [J]
  int contacts = 0;
  scene.run(1.6, [&](const StepReport& report) {
    const ClothState* unresolved = scene.stepper().contact().unresolved();
    largest = std::max(largest, unresolved != nullptr ? energy(scene.state) - energy(*unresolved) : 0.0);
    contacts = std::max(contacts, report.contact.selfContacts);
  });
  EXPECT_GT(contacts, 100);
  EXPECT_LT(largest, 0.02);  // [J]; the twist stores 2 J
  EXPECT_EQ(scene.pairsWithItself(), 0U);
}

/// The largest number of contact substeps while a sheet with edges of 0.1 m hits a sphere.
int contactSubstepsOfImpact(double speed, SelfCollision self) {
  testing::ContactScene scene(testing::freeSheet(9, 0.8, Vec3(0.0, 0.25, 0.0)),
                              {testing::bodyAt(SphereShape{0.2}, Vec3::Zero())}, "newton");
  scene.parameters.contact.self = self;
  scene.parameters.material.stiffness = 100.0;
  scene.parameters.timeStep = 1.0 / 300.0;
  for (Vec3& velocity : scene.state.velocities) {
    velocity.y() = -speed;
  }
  int largest = 0;
  scene.run(0.05, [&](const StepReport&) { largest = std::max(largest, scene.stepper().contactSubsteps()); });
  EXPECT_EQ(scene.pairs(0), 0);
  return largest;
}

TEST(ExactSelfContact, repeatsAStepInShorterContactSubstepsWhereContactMovesClothFar) {
  EXPECT_GT(contactSubstepsOfImpact(20.0, SelfCollision::Exact), 1);  // 67 mm in a step
  EXPECT_EQ(contactSubstepsOfImpact(2.0, SelfCollision::Exact), 1);
  EXPECT_EQ(contactSubstepsOfImpact(20.0, SelfCollision::Hash), 1);
}

TEST(ExactSelfContact, countsCrossingsInALaterContactSubstepAndRecoversOnceThereIsRoom) {
  // All vertices are pinned, and a body far away carries those of a small sheet through the large one and back.
  ClothMesh mesh;
  testing::addSheet(5, 1.0, Vec3::Zero(), Eigen::Quaterniond::Identity(), mesh);
  const Eigen::Quaterniond upright(Eigen::AngleAxisd(90.0 * degree, Vec3::UnitX()));
  const int first = testing::addSheet(2, 0.1, Vec3(0.03, 1.0541, 0.04), upright, mesh);
  std::vector<int> pins(mesh.positions.size());
  std::iota(pins.begin(), pins.end(), 0);
  constexpr double timeStep = 1.0 / 60.0;  // five contact substeps of 4 mm: the sheets are 4.1 mm apart
  Body carrier = testing::bodyAt(SphereShape{0.1}, Vec3(0.0, 5.0, 0.0));
  carrier.motion.keyframes = {{0.0, Vec3(0.0, 5.0, 0.0), Vec3::Zero()},
                              {timeStep, Vec3(0.0, 4.98, 0.0), Vec3::Zero()},
                              {2.0 * timeStep, Vec3(0.0, 4.98, 0.0), Vec3::Zero()},
                              {0.5, Vec3(0.0, 5.1, 0.0), Vec3::Zero()}};
  for (int v = first; v < static_cast<int>(mesh.positions.size()); ++v) {
    carrier.pins.push_back({v, -1});
  }
  testing::ContactScene scene(buildClothModel(mesh, 0.1, MassLumping::Uniform, pins), {carrier}, "auto");
  scene.parameters.contact.self = SelfCollision::Exact;
  scene.parameters.timeStep = timeStep;
  for (auto v = static_cast<std::size_t>(first); v < scene.state.positions.size(); ++v) {
    scene.state.positions[v].y() -= 1.0;
  }
  const StepReport entering = scene.step();
  EXPECT_EQ(scene.stepper().contactSubsteps(), 5);
  EXPECT_GT(entering.contact.crossings, 0);
  EXPECT_GT(scene.pairsWithItself(), 0U);
  EXPECT_FALSE(scene.state.hasNoSelfIntersection);
  scene.run(0.6);
  EXPECT_EQ(scene.pairsWithItself(), 0U);
  EXPECT_TRUE(scene.state.hasNoSelfIntersection);
  EXPECT_EQ(scene.step().contact.crossings, 0);
}

TEST(ExactSelfContact, keepsTheReportOfSleepingClothAndItsBits) {
  // Both halves of a sheet that hangs over a line of pins lie against each other.
  testing::ContactScene scene(sheetOverALine(7), {}, "auto");
  scene.parameters.contact.self = SelfCollision::Exact;
  scene.parameters.material.stiffness = 200.0;
  scene.parameters.material.damping = 0.1;
  scene.parameters.air.drag = 1.0;
  scene.parameters.timeStep = 1.0 / 60.0;
  StepReport report;
  for (int i = 0; i < 6000 && !(report.choice && report.choice->sleeping); ++i) {
    report = scene.step();
  }
  ASSERT_TRUE(report.choice && report.choice->sleeping);
  const std::vector<Vec3> positions = scene.state.positions;
  for (int i = 0; i < 10; ++i) {
    report = scene.step();
    EXPECT_TRUE(report.choice->sleeping);
    EXPECT_GT(report.contact.selfContacts, 5);
    EXPECT_EQ(report.contact.selfSeconds, 0.0);
    EXPECT_EQ(static_cast<int>(scene.stepper().contact().points().size()), report.contact.selfContacts);
  }
  EXPECT_EQ(scene.state.positions, positions);
}

TEST(ExactSelfContact, comesToRestInLayersOnABody) {
  // A sheet that has fallen on its edge lies folded on the ground. Springs do not resist bending, so this takes a
  // while.
  const Eigen::Quaterniond upright(Eigen::AngleAxisd(93.0 * degree, Vec3::UnitX()));
  testing::ContactScene scene(testing::freeSheet(17, 0.8, Vec3(0.0, 0.45, 0.0), upright),
                              {testing::bodyAt(PlaneShape{2.0}, Vec3::Zero())}, "auto");
  scene.parameters.contact.self = SelfCollision::Exact;
  scene.parameters.material.stiffness = 150.0;
  scene.parameters.material.damping = 0.02;
  scene.parameters.air.drag = 0.3;
  scene.parameters.timeStep = 1.0 / 150.0;
  StepReport report;
  for (int i = 0; i < 6000 && !(report.choice && report.choice->sleeping); ++i) {
    report = scene.step();
  }
  EXPECT_TRUE(report.choice && report.choice->sleeping);
  EXPECT_GT(report.contact.selfContacts, 10);
  EXPECT_EQ(scene.pairsWithItself(), 0U);
  report = scene.step();
  EXPECT_GT(report.contact.bodyContacts, 0);
  EXPECT_EQ(report.contact.bodySeconds + report.contact.selfSeconds, 0.0) << "contact of sleeping cloth costs time";
}

}  // namespace
}  // namespace drape::sim::contact
