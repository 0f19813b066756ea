// Bodies in a running simulation, moved by the mouse and changed by the panels.

#include "scene/scene_file.hpp"
#include "session/simulation.hpp"
#include "test_scene.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace drape::session {
namespace {

std::shared_ptr<const scene::Scene> sceneOf(const std::string& text) {
  const scene::SceneDescription description = scene::parseScene(text, "bodies", "bodies.toml", "/");
  return scene::buildScene(description, description.settings);
}

constexpr const char* settings = R"(
[settings]
grid.resolution = 9
grid.width = 0.4
grid.height = 0.4
time_step = 0.01
stiffness = 80
damping = 0.02
solver = "xpbd"
substeps = 4
)";

constexpr const char* ball = R"(
[[bodies]]
name = "ball"
shape = "sphere"
radius = 0.1
)";

constexpr const char* freeSheet = R"(
[cloth]
grid = "horizontal"
position = [0, 0.505, 0]
)";

/// A free sheet on a table, and a ball beside it.
std::shared_ptr<const scene::Scene> sheetOnTable() {
  return sceneOf(std::string(freeSheet) + R"(
[[bodies]]
name = "table"
shape = "box"
size = [1.6, 0.1, 1.0]
position = [0, 0.45, 0]
static_friction = 0.3
kinetic_friction = 0.2
)" + ball + "position = [-0.5, 0.605, 0]\n" +
                 settings);
}

/// A sheet that hangs between its upper corners, and a ball behind it.
std::shared_ptr<const scene::Scene> hangingSheet() {
  return sceneOf(std::string(R"(
[cloth]
grid = "vertical"
position = [0, 1, 0]
[pins]
corners = ["top_left", "top_right"]
)") + ball + "position = [0, 1, -0.3]\n" +
                 settings);
}

/// A sheet whose middle is inside the top of a ball.
std::shared_ptr<const scene::Scene> sheetInBall() {
  return sceneOf(std::string("[cloth]\ngrid = \"horizontal\"\nposition = [0, 0.08, 0]\n") + ball + settings);
}

Vec3 meanPosition(const Simulation& simulation) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& position : simulation.state().positions) {
    sum += position;
  }
  return sum / static_cast<double>(simulation.state().positions.size());
}

double lowest(const Simulation& simulation) {
  double y = std::numeric_limits<double>::infinity();
  for (const Vec3& position : simulation.state().positions) {
    y = std::min(y, position.y());
  }
  return y;
}

TEST(Bodies, aBallThatIsDraggedSweepsTheClothAlong) {
  Simulation simulation(hangingSheet());
  testing::takeSteps(simulation, 5);
  simulation.apply(MoveBodyCommand{0, Vec3(0.0, 0.0, 0.45)});
  int contacts = 0;
  for (int i = 0; i < 30; ++i) {
    simulation.step();
    contacts = std::max(contacts, simulation.lastStepReport().contact.bodyContacts);
  }
  EXPECT_EQ(simulation.bodies().shift(0), Vec3(0.0, 0.0, 0.45));
  EXPECT_GT(contacts, 0);
  EXPECT_GT(meanPosition(simulation).z(), 0.1);
  EXPECT_FALSE(simulation.blewUp());
}

TEST(Bodies, clothThatIsPulledOverATableSlidesAndKeepsItsShape) {
  Simulation simulation(sheetOnTable());
  testing::takeSteps(simulation, 5);
  // A triangle at the right edge, pulled slowly to the right along the table.
  const Triangle corner = simulation.model().triangles.back();
  const Vec3 taken = simulation.state().positions[static_cast<std::size_t>(corner[0])];
  const int triangle = static_cast<int>(simulation.model().triangles.size()) - 1;
  simulation.apply(AttachCommand{{triangle, Vec3(1.0, 0.0, 0.0), taken}});
  for (int i = 1; i <= 60; ++i) {
    simulation.apply(MoveAttachmentCommand{taken + Vec3(0.005 * i, 0.0, 0.0)});
    simulation.step();
    ASSERT_GT(simulation.lastStepReport().contact.bodyContacts, 0) << i;
    ASSERT_GT(lowest(simulation), 0.5) << i;
  }
  EXPECT_GT(meanPosition(simulation).x(), 0.2) << "all of it follows";
  EXPECT_LT(sim::maxStretch(simulation.model(), simulation.state()), 0.1);
}

TEST(Bodies, theGroundStopsClothThatNothingHolds) {
  scene::SceneDescription description = scene::openScene("grid");
  description.settings.mesh.pins = "none";
  description.settings.grid.resolution = 9;
  Simulation simulation(scene::buildScene(description, description.settings));
  for (const char* look : {"seen", "not seen"}) {
    simulation.apply(SetSettingCommand{"view.ground", std::string(look) == "seen"});
    simulation.apply(ResetCommand{});
    while (simulation.state().time < 1.0) {
      simulation.step();
    }
    for (const Vec3& position : simulation.state().positions) {
      EXPECT_GT(position.y(), 0.0) << look;
      EXPECT_LT(position.y(), 0.02) << look;
    }
  }
}

TEST(Bodies, aStandAndAGroundThatAreNotTouchedChangeNoBit) {
  const auto afterSteps = [](bool bodies) {
    scene::SceneDescription description = scene::openScene("skirt");
    description.settings.step.contact.bodies = bodies;
    description.settings.step.automatic.strainLimit = 0.0;  // the choice of the stretch stiffness counts bodies
    Simulation simulation(scene::buildScene(description, description.settings));
    testing::takeSteps(simulation, 40);
    EXPECT_EQ(simulation.lastStepReport().contact.bodyContacts, 0);
    return simulation.state().positions;
  };
  EXPECT_EQ(afterSteps(true), afterSteps(false));
}

TEST(Bodies, clothPassesThroughABodyThatIsSwitchedOff) {
  Simulation simulation(sheetOnTable());
  testing::takeSteps(simulation, 20);
  EXPECT_GT(lowest(simulation), 0.5);
  simulation.apply(SwitchBodyCommand{0, false});
  testing::takeSteps(simulation, 40);
  EXPECT_LT(lowest(simulation), 0.4) << "through the table";
  EXPECT_GT(lowest(simulation), 0.0) << "and down to the ground";
}

TEST(Bodies, aMessageNamesClothThatCannotLeaveABody) {
  // A mast of 4 m through the middle of a sheet.
  Simulation simulation(sceneOf(std::string("[cloth]\ngrid = \"horizontal\"\nposition = [0, 0.5, 0]\n"
                                            "[[bodies]]\nname = \"mast\"\nshape = \"capsule\"\nradius = 0.05\n"
                                            "length = 4\n") +
                                settings));
  simulation.step();
  EXPECT_NE(simulation.message().english().find("pushed out slowly"), std::string::npos) << simulation.message();
  while (simulation.state().time < 2.0) {
    simulation.step();
  }
  EXPECT_NE(simulation.message().english().find("cannot push it out"), std::string::npos) << simulation.message();
  EXPECT_NE(simulation.message().english().find("Move or scale"), std::string::npos) << simulation.message();
}

TEST(Bodies, aStartInsideABodyIsReportedUntilTheClothIsOut) {
  Simulation simulation(sheetInBall());
  EXPECT_EQ(simulation.message(), "");
  simulation.step();
  EXPECT_NE(simulation.message().english().find("starts inside a body"), std::string::npos) << simulation.message();
  EXPECT_NE(simulation.message().english().find("pushed out slowly"), std::string::npos) << simulation.message();
  const sim::contact::ContactReport first = simulation.lastStepReport().contact;
  EXPECT_GE(first.overlaps, 8) << "those around the middle vertex at least";
  EXPECT_NEAR(first.deepestOverlap, 0.02, 1e-3);
  simulation.apply(SetSettingCommand{"gravity", 9.0});
  simulation.step();
  EXPECT_NE(simulation.message().english().find("is inside a body"), std::string::npos) << "and still, whatever is set";
  Snapshot snapshot;
  simulation.capture(snapshot);
  EXPECT_EQ(snapshot.message, simulation.message());
  testing::takeSteps(simulation, 11);
  EXPECT_EQ(simulation.message(), "") << "until it is out";
  EXPECT_EQ(simulation.lastStepReport().contact.overlaps, 0);
  for (const Vec3& position : simulation.state().positions) {
    EXPECT_GT(position.norm(), 0.1);
  }
}

TEST(Bodies, aSingleTriangleInsideABodyIsOneTriangle) {
  // A ball above the middle of one of the cells of 0.25 m: it touches neither their edges nor their vertices.
  Simulation simulation(
      testing::sceneFrom("[cloth]\ngrid = \"horizontal\"\nposition = [0, 1, 0]\n"
                         "[[bodies]]\nshape = \"sphere\"\nradius = 0.02\n"
                         "position = [0.1, 1.01, 0.05]\n"
                         "[settings]\ngrid.resolution = 5\ngrid.width = 1\ngrid.height = 1\n"));
  simulation.step();
  EXPECT_EQ(simulation.lastStepReport().contact.overlaps, 1);
  EXPECT_NE(simulation.message().english().find("(1 triangle, up to "), std::string::npos) << simulation.message();
}

TEST(Bodies, takeAnotherSurfaceByCommand) {
  Simulation simulation(sheetOnTable());
  testing::takeSteps(simulation, 10);
  const double before = lowest(simulation);
  simulation.apply(SetSurfaceCommand{0, {0.3, 0.2, 0.01}});
  testing::takeSteps(simulation, 20);
  const double thicker = 0.01 - simulation.scene().bodies->at(0).surface.thickness;
  EXPECT_NEAR(lowest(simulation), before + thicker, 1e-3);
  Snapshot snapshot;
  simulation.capture(snapshot);
  EXPECT_EQ(snapshot.bodies[0].surface.thickness, 0.01);
  simulation.apply(ResetCommand{});
  EXPECT_EQ(simulation.bodies().surface(0).thickness, 0.01) << "as everything that was set";
}

TEST(Bodies, refuseAnInvalidSurface) {
  Simulation simulation(sheetOnTable());
  const sim::contact::SurfaceProperties before = simulation.bodies().surface(0);
  for (const sim::contact::SurfaceProperties& wrong :
       {sim::contact::SurfaceProperties{-0.1, 0.0, 0.002}, sim::contact::SurfaceProperties{0.5, 0.6, 0.002},
        sim::contact::SurfaceProperties{0.5, 0.4, 0.0}, sim::contact::SurfaceProperties{0.5, NAN, 0.002}}) {
    simulation.apply(SetSurfaceCommand{0, wrong});
    EXPECT_NE(simulation.message().english().find("a body's"), std::string::npos) << simulation.message();
    EXPECT_EQ(simulation.bodies().surface(0), before);
  }
}

TEST(Bodies, refuseCommandsForABodyThatDoesNotExist) {
  Simulation simulation(sheetOnTable());
  for (const int body : {-1, static_cast<int>(simulation.scene().bodies->size())}) {
    simulation.apply(MoveBodyCommand{body, Vec3::Zero()});
    EXPECT_NE(simulation.message().english().find("there is no body"), std::string::npos);
    simulation.apply(SetSettingCommand{"gravity", 9.0});
    simulation.apply(SwitchBodyCommand{body, false});
    EXPECT_NE(simulation.message().english().find("there is no body"), std::string::npos);
  }
}

TEST(Bodies, aLogWithBodiesIsReplayedToTheSameBits) {
  const auto scene = sheetOnTable();
  Simulation original(scene);
  testing::takeSteps(original, 4);
  original.apply(MoveBodyCommand{1, Vec3(0.4, 0.0, 0.03)});
  testing::takeSteps(original, 7);
  original.apply(MoveBodyCommand{1, Vec3(0.6, 0.02, 0.0)});
  testing::takeSteps(original, 9);
  original.apply(SwitchBodyCommand{1, false});
  original.apply(SetSurfaceCommand{0, {0.05, 0.02, 0.004}});
  testing::takeSteps(original, 3);
  original.apply(SwitchBodyCommand{1, true});
  original.apply(SetSettingCommand{"bodies", false});
  testing::takeSteps(original, 2);
  original.apply(SetSettingCommand{"bodies", true});
  testing::takeSteps(original, 8);
  original.apply(ResetCommand{});
  original.apply(MoveBodyCommand{1, Vec3(0.3, 0.0, 0.0)});
  testing::takeSteps(original, 12);
  original.apply(PauseCommand{true});

  Simulation again(scene);
  again.replay(original.log());
  EXPECT_EQ(sim::stateHash(again.state()), sim::stateHash(original.state()));
  EXPECT_EQ(again.stepsTaken(), original.stepsTaken());
  EXPECT_EQ(again.bodies().pose(1).position, original.bodies().pose(1).position);
  // ... and without one of these commands the motion differs.
  std::vector<LoggedCommand> shorter = original.log();
  shorter.erase(shorter.end() - 2);
  Simulation other(scene);
  other.replay(shorter);
  EXPECT_NE(sim::stateHash(other.state()), sim::stateHash(original.state()));
}

TEST(Bodies, contactsAreInASnapshotOnlyWhenTheyAreToBeDrawn) {
  Simulation simulation(sheetOnTable());
  testing::takeSteps(simulation, 10);
  Snapshot snapshot;
  simulation.capture(snapshot);
  EXPECT_TRUE(snapshot.contactPoints.empty());
  simulation.apply(SetSettingCommand{"view.contacts", true});
  simulation.capture(snapshot);
  ASSERT_GE(snapshot.contactPoints.size(), 81U) << "every vertex lies on the table";
  for (const sim::contact::ContactPoint& contact : snapshot.contactPoints) {
    EXPECT_NEAR(contact.normal.y(), 1.0, 1e-3);
    EXPECT_NEAR(contact.point.y(), 0.5, 0.006);
  }
}

/// A free sheet above a box of this height.
std::shared_ptr<const scene::Scene> sheetOverBox(double height) {
  return sceneOf(std::string(freeSheet) + R"(
[[bodies]]
name = "box"
shape = "box"
position = [0, 0, 0]
size = [1, )" + std::to_string(height) +
                 ", 1]\n" + settings);
}

TEST(Bodies, OfANewSceneAreMetAsIfNoOtherSceneHadBeenThere) {
  Simulation simulation(sheetOverBox(0.4));
  testing::takeSteps(simulation, 40);
  for (int i = 1; i <= 8; ++i) {  // the bodies of a new scene may be where those of an earlier one were in memory
    const double height = 0.4 + 0.06 * i;
    simulation.apply(LoadSceneCommand{sheetOverBox(height)});
    testing::takeSteps(simulation, 40);
    Simulation fresh(sheetOverBox(height));
    testing::takeSteps(fresh, 40);
    EXPECT_EQ(simulation.state().positions, fresh.state().positions) << "a box " << height << " m high";
  }
}

}  // namespace
}  // namespace drape::session
