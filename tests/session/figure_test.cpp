// Figures that change their motion and their size while the simulation runs.
#include "figure/moving_figure.hpp"
#include "scene/scene_file.hpp"
#include "scene/scene_writer.hpp"
#include "session/simulation.hpp"
#include "session/user_state.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace drape::session {
namespace {

/// A small sheet beside a ball and a figure.
std::shared_ptr<const scene::Scene> sceneWithFigure() {
  const scene::SceneDescription description = scene::parseScene(R"(
[cloth]
grid = "vertical"
position = [0.2, 1.2, 0.3]
[pins]
edges = ["top"]
[[bodies]]
name = "ball"
shape = "sphere"
radius = 0.1
position = [3, 0, 0]
[[bodies]]
name = "figure"
shape = "figure"
motion = "breathe"
[settings]
grid.resolution = 5
grid.width = 0.3
grid.height = 0.3
time_step = 0.01
stiffness = 80
damping = 0.02
solver = "xpbd"
substeps = 2
)",
                                                                "figures", "figures.toml", "/");
  return scene::buildScene(description, description.settings);
}

constexpr int figureBody = 1;

SetFigureCommand figureThat(std::string_view motion, double height = 0.0, double speed = 1.0) {
  SetFigureCommand command{figureBody, {figure::findMotion(motion), speed, {}}};
  if (height > 0.0) {
    command.figure.proportions.height = height;
  }
  return command;
}

class Figures : public ::testing::Test {
 protected:
  void advance(int steps) {
    for (int i = 0; i < steps; ++i) {
      simulation_.step();
    }
  }
  [[nodiscard]] static std::vector<Vec3> verticesOf(const Simulation& simulation) {
    const auto vertices = simulation.bodies().vertices(figureBody);
    return {vertices.begin(), vertices.end()};
  }
  [[nodiscard]] std::vector<Vec3> vertices() const { return verticesOf(simulation_); }
  [[nodiscard]] double height() const {
    const std::vector<Vec3> all = vertices();
    return std::ranges::max(all, {}, [](const Vec3& p) { return p.y(); }).y();
  }
  [[nodiscard]] figure::FigureOptions present() const {
    Snapshot snapshot;
    simulation_.capture(snapshot);
    EXPECT_FALSE(snapshot.bodies[0].figure) << "the ball";
    return *snapshot.bodies[figureBody].figure;
  }

  Simulation simulation_{sceneWithFigure()};
};

double furthest(const std::vector<Vec3>& first, const std::vector<Vec3>& second) {
  double distance = 0.0;
  for (std::size_t v = 0; v < first.size(); ++v) {
    distance = std::max(distance, (first[v] - second[v]).norm());
  }
  return distance;
}

TEST_F(Figures, TakeAnotherMotionAndSizeWithinASecond) {
  EXPECT_EQ(present().motion->name, "breathe");
  advance(150);
  const std::vector<Vec3> before = vertices();
  const double built = height();
  simulation_.apply(figureThat("t_pose", 1.95));
  EXPECT_EQ(simulation_.message(), "");
  EXPECT_EQ(furthest(vertices(), before), 0.0) << "at first it is where it was";
  EXPECT_EQ(present().motion->name, "t_pose");
  std::vector<Vec3> last = before;
  for (int step = 0; step < 110; ++step) {
    advance(1);
    EXPECT_LT(furthest(vertices(), last), 0.06) << "no jump in step " << step;
    last = vertices();
  }
  EXPECT_NEAR(height(), built + 0.2, 0.02);
}

TEST_F(Figures, KeepTheChoiceAfterAReset) {
  advance(20);
  simulation_.apply(figureThat("squat", 1.5));
  advance(200);
  simulation_.apply(ResetCommand{});
  EXPECT_EQ(present().motion->name, "squat");
  EXPECT_NEAR(height(), 1.75, 0.01) << "it starts in the rest pose, as it is built";
  advance(150);
  Simulation other(sceneWithFigure());
  other.apply(figureThat("squat", 1.5));
  for (int i = 0; i < 150; ++i) {
    other.step();
  }
  EXPECT_EQ(furthest(vertices(), verticesOf(other)), 0.0);
}

TEST_F(Figures, ForgetTheChoiceWithAnotherScene) {
  simulation_.apply(figureThat("squat"));
  simulation_.apply(LoadSceneCommand{sceneWithFigure()});
  EXPECT_EQ(present().motion->name, "breathe");
}

TEST_F(Figures, RefuseWhatIsOutOfRangeAndOtherBodies) {
  for (const SetFigureCommand& wrong : {figureThat("walk", 3.0), figureThat("walk", 0.0, 5.0),
                                        figureThat("walk", 0.0, std::nan("")), figureThat("fly")}) {
    simulation_.apply(wrong);
    EXPECT_NE(simulation_.message().english().find("outside its range"), std::string::npos) << simulation_.message();
    EXPECT_EQ(present().motion->name, "breathe");
    simulation_.apply(SetSettingCommand{"gravity", 9.0});
  }
  SetFigureCommand ball = figureThat("walk");
  ball.body = 0;
  simulation_.apply(ball);
  EXPECT_NE(simulation_.message().english().find("\"ball\" is not a figure"), std::string::npos)
      << simulation_.message();
  ball.body = 9;
  simulation_.apply(ball);
  EXPECT_NE(simulation_.message().english().find("there is no body 9"), std::string::npos) << simulation_.message();
}

TEST_F(Figures, AreReplayedToTheSameBits) {
  advance(30);
  simulation_.apply(figureThat("dance"));
  advance(40);  // within the blend
  simulation_.apply(figureThat("turn", 1.6, 2.0));
  advance(130);
  simulation_.apply(ResetCommand{});
  advance(30);
  simulation_.apply(figureThat("walk", 1.9));
  advance(60);
  Simulation again(sceneWithFigure());
  again.replay(simulation_.log(), simulation_.stepsTaken());
  EXPECT_EQ(furthest(vertices(), verticesOf(again)), 0.0);
  EXPECT_EQ(sim::stateHash(again.state()), sim::stateHash(simulation_.state()));
}

TEST_F(Figures, AreUndone) {
  Snapshot before;
  Snapshot after;
  simulation_.capture(before);
  simulation_.apply(figureThat("dance", 1.6));
  simulation_.capture(after);
  const UserState from = userStateOf(after);
  const UserState to = userStateOf(before);
  EXPECT_FALSE(areSame(from, to));
  EXPECT_TRUE(changesUserState(figureThat("dance")));
  const std::vector<Command> commands = commandsBetween(from, to, simulation_.scene());
  ASSERT_EQ(commands.size(), 1U);
  simulation_.apply(commands.front());
  EXPECT_EQ(present(), *before.bodies[figureBody].figure);
}

TEST_F(Figures, GoBackWithTheTimelineToWhereTheyWereAndKeepTheChoice) {
  simulation_.apply(SetSettingCommand{"timeline.memory", 200.0});
  advance(100);
  const std::vector<Vec3> then = vertices();
  const double time = simulation_.state().time;
  advance(20);
  simulation_.apply(figureThat("squat"));
  advance(60);
  const std::vector<Vec3> within = vertices();
  const double later = simulation_.state().time;
  advance(60);
  const std::vector<Vec3> end = vertices();
  // A state within the blend goes on to the same positions.
  simulation_.apply(GoToCommand{later});
  EXPECT_NEAR(simulation_.state().time, later, 0.011);
  EXPECT_LT(furthest(vertices(), within), 0.05);
  while (simulation_.state().time < 2.4 - 0.001) {
    advance(1);
  }
  EXPECT_EQ(furthest(vertices(), end), 0.0);
  // In a state before the choice the figure is where it was; from there it does what was chosen.
  simulation_.apply(GoToCommand{time});
  EXPECT_LT(furthest(vertices(), then), 0.01);
  EXPECT_EQ(present().motion->name, "squat");
  std::vector<Vec3> last = vertices();
  for (int step = 0; step < 30; ++step) {
    advance(1);
    EXPECT_LT(furthest(vertices(), last), 0.06) << "no jump in step " << step;
    last = vertices();
  }
}

TEST_F(Figures, AreSavedWithTheScene) {
  advance(10);
  simulation_.apply(figureThat("raise_arms", 1.65, 1.5));
  scene::SceneNow now{simulation_.settings(), simulation_.model().pinned, {}, {}};
  Snapshot snapshot;
  simulation_.capture(snapshot);
  for (const BodyStatus& body : snapshot.bodies) {
    now.bodies.push_back({body.on, body.shift, body.surface, body.figure});
  }
  const auto written = scene::writeScene(simulation_.scene(), now, std::filesystem::current_path());
  EXPECT_TRUE(written.notes.empty());
  const scene::SceneDescription again =
      scene::parseScene(written.text, "saved", "saved.toml", std::filesystem::current_path());
  EXPECT_EQ(again.bodies.at(figureBody).figure, present()) << written.text;
  Simulation second(scene::buildScene(again, again.settings));
  simulation_.apply(ResetCommand{});
  for (int i = 0; i < 120; ++i) {
    simulation_.step();
    second.step();
  }
  EXPECT_EQ(furthest(vertices(), verticesOf(second)), 0.0);
}

}  // namespace
}  // namespace drape::session
