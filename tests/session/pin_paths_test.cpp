#include "scene/scene_file.hpp"
#include "scene/scene_writer.hpp"
#include "session/simulation.hpp"
#include "session/user_state.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

namespace drape::session {
namespace {

using testing::takeSteps;

/// A sheet that hangs at two corners, which rise and turn by a right angle within half a second.
constexpr const char* movingCorners = R"(
[cloth]
grid = "vertical"
position = [0, 1, 0]
[pins]
corners = ["top_left", "top_right"]
keyframes = [{ time = 0 }, { time = 0.5, position = [0.3, 0.1, 0], rotation = [0, 90, 0] }]
[settings]
grid.resolution = 5
time_step = 0.01
substeps = 5
stiffness = 50
drag = 0.2
)";

std::shared_ptr<const scene::Scene> cornersWith(const std::string& solver, const std::string& more = "") {
  const scene::SceneDescription description =
      scene::parseScene(movingCorners + ("solver = \"" + solver + "\"\n" + more), "corners", "corners.toml", "/");
  return scene::buildScene(description, description.settings);
}

/// Where a corner is at the end of the motion.
Vec3 endOf(const scene::Scene& scene, int pin) {
  const Vec3 centre = 0.5 * (scene.start.positions[0] + scene.start.positions[4]);
  const Vec3 turned =
      Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitY()) * Vec3(scene.start.positions[pin] - centre);
  return centre + turned + Vec3(0.3, 0.1, 0.0);
}

TEST(PinPaths, followTheirKeyframesWithEverySolver) {
  for (const char* solver : {"auto", "one_iteration", "xpbd", "newton", "verlet"}) {
    const auto scene = cornersWith(solver);
    Simulation simulation(scene);
    takeSteps(simulation, 60);
    EXPECT_FALSE(simulation.blewUp()) << solver;
    for (const int pin : {0, 4}) {
      EXPECT_NEAR((simulation.state().positions[pin] - endOf(*scene, pin)).norm(), 0.0, 1e-12) << solver;
    }
    EXPECT_GT((simulation.state().positions[24] - scene->start.positions[24]).norm(), 0.1) << "the rest follows";
  }
}

TEST(PinPaths, moveNearBodiesAsFarAsWithout) {
  // Near a body the step is divided into contact substeps.
  const auto scene = cornersWith("auto",
                                 "[[bodies]]\nname = \"ball\"\nshape = \"sphere\"\nradius = 0.2\n"
                                 "position = [0, 0.9, 0.21]\n");
  Simulation simulation(scene);
  takeSteps(simulation, 60);
  EXPECT_NEAR((simulation.state().positions[4] - endOf(*scene, 4)).norm(), 0.0, 1e-12);
}

TEST(PinPaths, wakeAClothThatSleeps) {
  // A sheet on the ground.
  const scene::SceneDescription description = scene::parseScene(R"(
[cloth]
grid = "horizontal"
position = [0, 0.005, 0]
[pins]
corners = ["top_left", "top_right"]
keyframes = [{ time = 0 }, { time = 0.5, position = [0.1, 0, 0] }]
[ground]
height = 0
[settings]
grid.resolution = 5
time_step = 0.01
stiffness = 50
drag = 0.5
damping = 0.1
)",
                                                                "lying", "lying.toml", "/");
  const auto scene = scene::buildScene(description, description.settings);
  Simulation simulation(scene);
  do {
    simulation.step();
  } while (!simulation.lastStepReport().choice->sleeping && simulation.state().time < 20.0);
  ASSERT_TRUE(simulation.lastStepReport().choice->sleeping);
  const std::vector<Vec3> before = simulation.state().positions;
  const double start = simulation.state().time;
  sim::contact::BodyMotion motion;
  motion.keyframes = {{start, Vec3::Zero(), Vec3::Zero()}, {start + 0.5, Vec3(0.2, 0.0, 0.0), Vec3::Zero()}};
  simulation.apply(SetPinPathsCommand{{scene::pathOf({0, 4}, motion, scene->start.positions)}, false});
  takeSteps(simulation, 60);
  EXPECT_NEAR((simulation.state().positions[0] - before[0] - Vec3(0.2, 0.0, 0.0)).norm(), 0.0, 1e-12);
  EXPECT_GT((simulation.state().positions[24] - before[24]).norm(), 0.1) << "the rest follows";
}

TEST(PinPaths, takeThePinsToTheirNewPlaceAtOnce) {
  const auto scene = testing::smallGrid(5);
  Simulation simulation(scene);
  takeSteps(simulation, 10);
  sim::contact::BodyMotion motion;
  motion.keyframes = {{0.0, Vec3::Zero(), Vec3::Zero()}, {0.001, Vec3(0.0, 0.2, 0.0), Vec3::Zero()}};
  const Vec3 before = simulation.state().positions[0];
  simulation.apply(SetPinPathsCommand{{scene::pathOf({0}, motion, scene->start.positions)}});
  EXPECT_NEAR((simulation.state().positions[0] - before - Vec3(0.0, 0.2, 0.0)).norm(), 0.0, 1e-12);
  simulation.apply(SetPinPathsCommand{});
  EXPECT_NEAR((simulation.state().positions[0] - before).norm(), 0.0, 1e-12) << "and back to their start";
  simulation.apply(SetPinPathsCommand{{scene::pathOf({0}, motion, scene->start.positions)}, false});
  EXPECT_NEAR((simulation.state().positions[0] - before).norm(), 0.0, 1e-12) << "unless they are there already";
}

TEST(PinPaths, areRefusedWithAReason) {
  Simulation simulation(testing::smallGrid(5));
  const auto refusal = [&](const std::vector<scene::PinPath>& paths) {
    simulation.apply(SetPinPathsCommand{paths});
    return simulation.message();
  };
  scene::PinPath still;
  still.vertices = {0};
  still.motion.keyframes.emplace_back();
  scene::PinPath backwards = still;
  backwards.motion.keyframes.push_back(still.motion.keyframes.front());
  scene::PinPath endless = still;
  endless.motion.loop = true;
  scene::PinPath outside = still;
  outside.vertices = {25};
  EXPECT_EQ(refusal({backwards}), "the times of the keyframes must ascend");
  EXPECT_EQ(refusal({endless}), "a loop needs at least two keyframes");
  EXPECT_EQ(refusal({outside}), "there is no vertex 25 in this cloth");
  EXPECT_EQ(refusal({still, still}), "the vertex 0 has keyframes twice");
  EXPECT_EQ(refusal({scene::PinPath{}}), "moving pins need keyframes with finite values");
  Snapshot snapshot;
  simulation.capture(snapshot);
  EXPECT_TRUE(snapshot.pinPaths->empty()) << "a refused command changes nothing";
}

TEST(PinPaths, areSavedWithTheScene) {
  const auto original = testing::smallGrid(5);
  Simulation simulation(original);
  sim::contact::BodyMotion motion;
  motion.keyframes = {{0.0, Vec3::Zero(), Vec3::Zero()}, {0.3, Vec3(0.1, 0.2, 0.3), Vec3(0.0, 1.0, 0.0)}};
  motion.loop = true;
  simulation.apply(SetPinsCommand{{0, 4, 20}});
  simulation.apply(SetPinPathsCommand{{scene::pathOf({0, 20}, motion, original->start.positions)}});
  Snapshot snapshot;
  simulation.capture(snapshot);
  scene::SceneNow now = scene::unchanged(*original);
  now.pinned = snapshot.model->pinned;
  now.pinPaths = *snapshot.pinPaths;
  const auto written = scene::writeScene(*original, now, std::filesystem::current_path());
  const scene::SceneDescription description =
      scene::parseScene(written.text, "saved", "saved.toml", std::filesystem::current_path());
  const auto again = scene::buildScene(description, description.settings);
  EXPECT_EQ(again->pinPaths, *snapshot.pinPaths) << written.text;
  EXPECT_EQ(again->model->pinned, snapshot.model->pinned);
  Simulation second(again);
  takeSteps(simulation, 20);
  takeSteps(second, 20);
  EXPECT_EQ(sim::stateHash(second.state()), sim::stateHash(simulation.state()));
}

TEST(PinPaths, areUndoneWithTheUsersOtherChanges) {
  const auto scene = testing::smallGrid(5);
  Simulation simulation(scene);
  Snapshot before;
  simulation.capture(before);
  sim::contact::BodyMotion motion;
  motion.keyframes = {{0.0, Vec3::Zero(), Vec3::Zero()}, {1.0, Vec3(0.0, 0.5, 0.0), Vec3::Zero()}};
  const SetPinPathsCommand command{{scene::pathOf({0}, motion, scene->start.positions)}};
  simulation.apply(command);
  Snapshot after;
  simulation.capture(after);
  EXPECT_TRUE(changesUserState(command));
  EXPECT_FALSE(areSame(userStateOf(before), userStateOf(after)));
  for (const Command& each : commandsBetween(userStateOf(after), userStateOf(before), *scene)) {
    simulation.apply(each);
  }
  simulation.capture(after);
  EXPECT_TRUE(areSame(userStateOf(before), userStateOf(after)));
}

TEST(PinPaths, workAgainstTheClothAreInTheEnergyBalance) {
  const auto scene = cornersWith("auto", "energy_balance = true\n");
  Simulation simulation(scene);
  simulation.apply(SetSettingCommand{"time_step", 0.001});  // the work is a sum over steps
  takeSteps(simulation, 500);
  Snapshot snapshot;
  simulation.capture(snapshot);
  ASSERT_TRUE(snapshot.balance.has_value());
  // Without the work of the pins, the method would seem to add the energy that lifts and speeds up the cloth.
  EXPECT_LT(std::abs(snapshot.balance->integrator()), 0.05 * std::abs(snapshot.balance->contact()));
}

}  // namespace
}  // namespace drape::session
