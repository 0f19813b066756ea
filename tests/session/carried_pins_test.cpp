#include "scene/scene_file.hpp"
#include "session/simulation.hpp"
#include "sim/contact/bodies/motion.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <cmath>
#include <string>

namespace drape::session {
namespace {

/// A sheet pinned at two corners to a body that moves and rotates; the body itself is far from the sheet.
std::shared_ptr<const scene::Scene> carriedSheet(const std::string& solver) {
  const scene::SceneDescription description = scene::parseScene(R"(
[cloth]
grid = "vertical"
position = [0, 1, 0]
[pins]
corners = ["top_left", "top_right"]
body = "hand"
[[bodies]]
name = "hand"
shape = "sphere"
radius = 0.01
keyframes = [{ time = 0, position = [0, 5, 0], rotation = [0, 30, 0] },
             { time = 0.5, position = [0.3, 5.1, 0], rotation = [0, 50, 0] }]
[settings]
grid.resolution = 5
time_step = 0.01
substeps = 5
stiffness = 50
solver = ")" + solver + "\"\n",
                                                                "carried", "carried.toml", "/");
  return scene::buildScene(description, description.settings);
}

TEST(CarriedPins, goWithTheirBodyWhateverTheSolver) {
  for (const char* solver : {"one_iteration", "xpbd", "newton", "verlet"}) {
    const auto scene = carriedSheet(solver);
    Simulation simulation(scene);
    const sim::contact::BodyMotion& motion = scene->bodies->front().motion;
    const sim::contact::Pose start = sim::contact::poseAt(motion, 0.0);
    for (int i = 0; i < 60; ++i) {
      simulation.step();
      const sim::contact::Pose now = sim::contact::poseAt(motion, simulation.state().time);
      for (const std::size_t pin : {0U, 4U}) {
        const Vec3 expected = now.toWorld(start.toLocal(scene->start.positions[pin]));
        ASSERT_NEAR((simulation.state().positions[pin] - expected).norm(), 0.0, 1e-12) << solver << " step " << i;
      }
    }
    EXPECT_FALSE(simulation.blewUp()) << solver;
    EXPECT_GT((simulation.state().positions[0] - scene->start.positions[0]).norm(), 0.1);
    EXPECT_GT((simulation.state().positions[24] - scene->start.positions[24]).norm(), 0.1) << "the rest follows";
  }
}

TEST(CarriedPins, goWithTheMouseThatMovesTheirBody) {
  Simulation simulation(carriedSheet("one_iteration"));
  Simulation alone(carriedSheet("one_iteration"));
  const Vec3 shift(0.0, 0.3, -0.2);
  simulation.apply(MoveBodyCommand{0, shift});
  for (int i = 0; i < 30; ++i) {
    simulation.step();
    alone.step();
  }
  EXPECT_NEAR((simulation.state().positions[4] - alone.state().positions[4] - shift).norm(), 0.0, 1e-12);
}

TEST(CarriedPins, areTakenAlongFromWhereTheyArePutByHand) {
  Simulation simulation(carriedSheet("one_iteration"));
  Simulation alone(carriedSheet("one_iteration"));
  simulation.apply(MovePinsCommand{Vec3(0.0, 0.0, 0.1)});
  simulation.step();
  alone.step();
  const Vec3 apart = simulation.state().positions[0] - alone.state().positions[0];
  EXPECT_NEAR(apart.norm(), 0.1, 1e-12) << "and do not jump back";
}

TEST(CarriedPins, moveEvenlyOverTheSubsteps) {
  // A step with many substeps stays calm: pins that jumped at its start would overstretch their springs.
  const auto scene = carriedSheet("verlet");
  Simulation coarse(scene);
  coarse.apply(SetSettingCommand{"substeps", 40});
  Simulation fine(scene);
  fine.apply(SetSettingCommand{"time_step", 0.01 / 40.0});
  fine.apply(SetSettingCommand{"substeps", 1});
  for (int i = 0; i < 20; ++i) {
    coarse.step();
    for (int k = 0; k < 40; ++k) {
      fine.step();
    }
  }
  for (std::size_t v = 0; v < coarse.state().positions.size(); ++v) {
    EXPECT_NEAR((coarse.state().positions[v] - fine.state().positions[v]).norm(), 0.0, 1e-3);
  }
}

TEST(CarriedPins, goWithTheNearestVertexOfADeformingMesh) {
  sim::contact::MeshShape mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  mesh.triangles = {{0, 1, 2}};
  const std::vector<Vec3> later{Vec3(0, 0, 0), Vec3(1, 0, 0.25), Vec3(0, 1, 0)};
  sim::contact::BodyStep step;
  step.start = {Eigen::Quaterniond::Identity(), Vec3(0, 2, 0)};
  step.end = {Eigen::Quaterniond(Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitY())), Vec3(0, 3, 0)};
  step.startVertices = mesh.positions;
  step.endVertices = later;
  const Vec3 place(1.1, 2.0, 0.0);
  // A quarter turn about y takes x to -z and z to x.
  EXPECT_NEAR((sim::contact::carriedBy(step, {0, -1}, place) - Vec3(0, 3, -1.1)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((sim::contact::carriedBy(step, {0, 0}, place) - Vec3(0, 3, -1.1)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((sim::contact::carriedBy(step, {0, 1}, place) - Vec3(0.25, 3, -1.1)).norm(), 0.0, 1e-15);
}

TEST(CarriedPins, areWorkOfTheirBodyInTheEnergyBalance) {
  Simulation simulation(carriedSheet("verlet"));
  simulation.apply(SetSettingCommand{"time_step", 5e-4});
  simulation.apply(SetSettingCommand{"energy_balance", true});
  for (int i = 0; i < 600; ++i) {
    simulation.step();
  }
  Snapshot snapshot;
  simulation.capture(snapshot);
  const sim::EnergyBalance& balance = snapshot.balance.value();
  EXPECT_GT(balance.contact(), 0.01) << "the body lifts and swings the sheet";
  EXPECT_LT(std::abs(balance.integrator()), 0.02 * balance.contact());
}

TEST(CarriedPins, goBackWithAReset) {
  const auto scene = carriedSheet("one_iteration");
  Simulation simulation(scene);
  for (int i = 0; i < 30; ++i) {
    simulation.step();
  }
  const auto hash = sim::stateHash(simulation.state());
  simulation.apply(ResetCommand{});
  EXPECT_EQ(sim::stateHash(simulation.state()), sim::stateHash(scene->start));
  for (int i = 0; i < 30; ++i) {
    simulation.step();
  }
  EXPECT_EQ(sim::stateHash(simulation.state()), hash);
}

TEST(CarriedPins, stayWhereTheyAreOnceTheBodyIsSwitchedOff) {
  Simulation simulation(carriedSheet("one_iteration"));
  for (int i = 0; i < 10; ++i) {
    simulation.step();
  }
  const Vec3 there = simulation.state().positions[0];
  simulation.apply(SwitchBodyCommand{0, false});
  for (int i = 0; i < 10; ++i) {
    simulation.step();
  }
  EXPECT_EQ(simulation.state().positions[0], there);
}

}  // namespace
}  // namespace drape::session
