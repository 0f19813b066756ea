#include "scene/scene_file.hpp"

#include "messages/error.hpp"
#include "settings/settings_table.hpp"

#include <gtest/gtest.h>

namespace drape::scene {
namespace {

SceneDescription parse(std::string_view text) {
  return parseScene(text, "test", "test.toml", "/folder");
}

/// The message with which a scene is refused, or "" when it is accepted.
std::string refusal(std::string_view text) {
  try {
    static_cast<void>(parse(text));
    return "";
  } catch (const messages::InputError& error) {
    return error.what();
  }
}

TEST(SceneFile, readsEverythingThatASceneMayHave) {
  const SceneDescription scene = parse(R"(
title = "A test"
help = "What it shows"
[cloth]
grid = "vertical"
position = [1, 2.5, -3]
rotation = [0, 0, 90]
pleats = { count = 4, gather = 0.5 }
[pins]
vertices = [1, 2]
nearest = [[0, 1, 2]]
boxes = [{ min = [0, 0, 0], max = [1, 1, 1] }]
top = 0.1
corners = ["top_left"]
edges = ["left"]
every = 2
[camera]
position = [3, 2, 1]
focal_point = [0, 1, 0]
view_angle = 50
[stand]
mesh = "pole.obj"
[ground]
height = -0.5
[settings]
time_step = "1/300"
stiffness = 250
sweeps = 3
wind.x = 4.5
view.wireframe = true
unit = "cm"
)");
  EXPECT_EQ(scene.title, "A test");
  EXPECT_EQ(std::get<GridSource>(scene.cloth().source).plane, GridSource::Plane::Vertical);
  EXPECT_EQ(scene.cloth().position, Vec3(1, 2.5, -3));
  EXPECT_NEAR(scene.cloth().rotation.z(), 0.5 * M_PI, 1e-15);
  EXPECT_EQ(scene.cloth().pleats->count, 4);
  EXPECT_EQ(scene.cloth().pins.at(0).vertices, (std::vector<int>{1, 2}));
  EXPECT_EQ(scene.cloth().pins.at(0).boxes.front().max, Vec3(1, 1, 1));
  EXPECT_EQ(scene.cloth().pins.at(0).every, 2);
  EXPECT_EQ(scene.camera->viewAngle, 50.0);
  EXPECT_EQ(scene.stand->mesh.path, "/folder/pole.obj");
  EXPECT_EQ(scene.groundHeight, -0.5);
  EXPECT_DOUBLE_EQ(scene.settings.step.timeStep, 1.0 / 300.0);
  EXPECT_EQ(scene.settings.step.material.stiffness, 250.0);
  EXPECT_EQ(scene.settings.step.jacobi.sweeps, 3);
  EXPECT_EQ(scene.settings.step.air.wind.x(), 4.5);
  EXPECT_TRUE(scene.settings.view.wireframe);
  EXPECT_EQ(scene.settings.mesh.unit, "cm");
}

TEST(SceneFile, takesFormerKeysOfSettingsAndNotesThePresentOnes) {
  const SceneDescription scene = parse("[cloth]\ngrid = \"vertical\"\n[settings]\nhand.max_force = 2\nstiffness = 9\n");
  EXPECT_EQ(scene.settings.attachment.maxForce, 2.0);
  ASSERT_EQ(scene.notes.size(), 1U);
  EXPECT_EQ(scene.notes.front(), "test.toml:4: the setting 'hand.max_force' is now called 'attachment.max_force'");
}

constexpr std::string_view gridWithSettings = "[cloth]\ngrid = \"vertical\"\n[settings]\n";

TEST(SceneFile, takesAFabricByNameAndThenItsSingleValues) {
  const std::string start(gridWithSettings);
  const settings::Settings denim = parse(start + "material.model = \"fabric\"\nmaterial.preset = \"denim\"").settings;
  EXPECT_TRUE(settings::weighsAsFabric(denim));
  EXPECT_EQ(denim.fabric.density, 0.324);
  EXPECT_EQ(denim.fabric.moduli.stretchWeft, 1014.0);
  // The order in the file does not matter.
  for (const char* text : {"fabric.shear = 80\nmaterial.preset = \"denim\"\ndensity = 0.4",
                           "density = 0.4\nmaterial.preset = \"denim\"\nfabric.shear = 80"}) {
    const settings::Settings changed = parse(start + "material.model = \"fabric\"\n" + text).settings;
    EXPECT_EQ(changed.fabric.moduli.shear, 80.0) << text;
    EXPECT_EQ(changed.fabric.moduli.stretchWeft, 1014.0) << text;
    EXPECT_FALSE(settings::weighsAsFabric(changed)) << text;
    EXPECT_EQ(changed.material.density, 0.4) << text;
    EXPECT_EQ(settings::settingValue(changed, settings::requireSetting("material.preset")),
              settings::SettingValue(std::string("denim, changed")))
        << text;
  }
}

TEST(SceneFile, refusesAFabricThatIsNoneWithFileLineAndSetting) {
  const std::string start(gridWithSettings);
  for (const auto& [text, expected] :
       {std::pair("fabric.shear = -1", "test.toml:4: fabric.shear must be"),
        std::pair("fabric.shear = nan", "test.toml:4: fabric.shear must be"),
        std::pair("material.preset = \"cardboard\"", "test.toml:4: material.preset must be silk"),
        std::pair("material.model = 3", "test.toml:4: material.model must be springs or fabric"),
        std::pair("fabric.bend_bias = 0", "test.toml:4: fabric.bend_bias must be at least a quarter"),
        std::pair("fabric.density = 0.2\nfabric.bend_warp = 0.001\n",
                  "test.toml:5: fabric.bend_bias must be at least a quarter"),
        std::pair("relaxation = 1\nsweeps = 2\n", "test.toml:5: sweeps must be odd")}) {
    EXPECT_NE(refusal(start + text).find(expected), std::string::npos) << refusal(start + text);
  }
}

TEST(SceneFile, findsMeshesBesideTheFileOrBuiltIn) {
  EXPECT_EQ(std::get<MeshFileSource>(parse("[cloth]\nmesh = \"a/b.obj\"").cloth().source).path, "/folder/a/b.obj");
  const auto builtin = std::get<MeshFileSource>(parse("[cloth]\nmesh = \"builtin:skirt.obj\"").cloth().source);
  EXPECT_TRUE(builtin.builtIn);
  EXPECT_EQ(builtin.path, "skirt.obj");
}

TEST(SceneFile, saysFileAndLineOfWhatIsNoToml) {
  EXPECT_NE(refusal("title = \"a\"\n[cloth\n").find("test.toml:2"), std::string::npos);
}

TEST(SceneFile, saysFileLineAndKeyOfWhatItDoesNotKnow) {
  const std::string message = refusal("[cloth]\ngrid = \"vertical\"\ncolour = 3\n");
  EXPECT_NE(message.find("test.toml:3"), std::string::npos) << message;
  EXPECT_NE(message.find("cloth.colour"), std::string::npos) << message;
}

TEST(SceneFile, holdsSettingsToTheirRangesWithFileAndLine) {
  const std::string message = refusal("[cloth]\ngrid = \"vertical\"\n[settings]\nstiffness = -1\n");
  EXPECT_NE(message.find("test.toml:4"), std::string::npos) << message;
  EXPECT_NE(message.find("0 to 1e+07 N/m"), std::string::npos) << message;
  EXPECT_NE(refusal("[cloth]\ngrid = \"vertical\"\n[settings]\nsweeps = 2\n"), "");
  EXPECT_NE(refusal("[cloth]\ngrid = \"vertical\"\n[settings]\nnonsense.key = 2\n"), "");
  EXPECT_NE(refusal("[cloth]\ngrid = \"vertical\"\n[settings]\nstiffness = [1]\n"), "");
  EXPECT_NE(refusal("[cloth]\ngrid = \"vertical\"\n[settings]\nstiffness = nan\n"), "");
}

TEST(SceneFile, namesTheTrueCauseWithFileAndLine) {
  const std::string sheet = "[cloth]\ngrid = \"vertical\"\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"[cloth]\ngrid = \"vertical\"\nposition = [1e30, 0, 0]",
       "test.toml:3: cloth.position must be three numbers from"},
      {"[cloth]\nmesh = \"\"", "test.toml:2: mesh has no name"},
      {"[cloth]\nmesh = \"builtin:\"", "test.toml:2: mesh has no name"},
      {sheet + "[stand]", "test.toml:3: mesh is missing"},
      {sheet + "[stand]\nmesh = \"\"", "test.toml:4: mesh has no name"},
      {sheet + "[[bodies]]\nshape = \"mesh\"\nmesh = \"\"", "test.toml:5: mesh has no name"},
      {sheet + "[camera]\nposition = [1, 2, 3]\nfocal_point = [1, 2, 3]",
       "test.toml:3: camera.position and camera.focal_point must be at least 0.01 m apart"},
      {sheet + "[pins]\nnearest = [[0, 0, 1e9]]", "test.toml:4: pins.nearest must be three numbers from"},
      {sheet + "[pins]\nnearest = [0, 0.5, 0]", "test.toml:4: pins.nearest must be a list of points: [[x, y, z], ...]"},
      {sheet + "[[seams]]\nfrom = { nearest = [0, 0.5, 0] }\nto = { nearest = [[0, 0, 0]] }",
       "test.toml:4: seams.from.nearest must be a list of points: [[x, y, z], ...]"},
      {"[cloth]\ngrid = \"vertical\"\nmesh = \"a.obj\"", "test.toml:3: [cloth] has both mesh and grid"},
      {sheet + "[[cloths]]\nname = \"a\"\ngrid = \"vertical\"",
       "test.toml:3: a scene has either a table [cloth] or tables [[cloths]], not both"},
      {"[cloth]\nmesh = \"a.obj\"\npleats = { count = 5 }", "test.toml:3: pleats belong to a grid"},
      {sheet + "[pins]\nevery = 3", "test.toml:4: pins.every belongs to pins.edges"},
      {sheet + "[pins]\nboxes = [{ min = [1, 1, 1], max = [2, 0, 2] }]", "test.toml:4: a box needs min and max"},
      {"[cloth]\nposition = [0, 1, 0]\ngrid = \"diagonal\"", "test.toml:3: cloth.grid must be \"horizontal\""},
      {sheet + "[[bodies]]\nshape = \"sphere\"\nstatic_friction = 0.1\nkinetic_friction = 0.3",
       "test.toml:6: kinetic_friction must not be larger"},
      {sheet + "rotation = [0, 1e7, 0]", "test.toml:3: cloth.rotation must be three numbers from"},
      {sheet + "[settings]\nfoo = 1", "test.toml:4: there is no setting 'foo'; 'drape-headless list settings'"},
      {sheet + "[settings]\nunit = \"yard\"",
       "test.toml:4: unit must be auto, m, dm, cm, mm, inch or foot, or metres per"},
      {sheet + "[settings]\nunit = true", "test.toml:4: unit must be"},
      {sheet + "[settings]\nup = \"w\"", "test.toml:4: up must be auto, y, z, x, -y or -z"}};
  for (const auto& [text, message] : cases) {
    EXPECT_TRUE(refusal(text).starts_with(message)) << text << "\n" << refusal(text);
  }
}

TEST(SceneFile, takesAFactorAsUnitOfTheMesh) {
  EXPECT_EQ(parse("[cloth]\nmesh = \"a.obj\"\n[settings]\nunit = 0.0254\n").settings.mesh.unit, "0.0254");
  EXPECT_EQ(parse("[cloth]\nmesh = \"a.obj\"\n[settings]\nunit = \"inch\"\n").settings.mesh.unit, "inch");
  EXPECT_EQ(parse("[cloth]\nmesh = \"a.obj\"\n").settings.mesh.unit, "m") << "a scene is in metres";
}

TEST(SceneFile, refusesWrongTypesAndMissingParts) {
  for (const char* text :
       {"", "[cloth]", "[cloth]\ngrid = \"round\"", "[cloth]\ngrid = 3",
        "[cloth]\ngrid = \"vertical\"\nmesh = \"a.obj\"", "cloth = 3",
        "[cloth]\ngrid = \"vertical\"\nposition = [1, 2]", "[cloth]\ngrid = \"vertical\"\nposition = [1, 2, inf]",
        "[cloth]\ngrid = \"vertical\"\npleats = { count = 0 }", "[cloth]\ngrid = \"vertical\"\n[pins]\nvertices = [-1]",
        "[cloth]\ngrid = \"vertical\"\n[pins]\nvertices = [1.5]",
        "[cloth]\ngrid = \"vertical\"\n[pins]\nedges = \"left\"", "[cloth]\ngrid = \"vertical\"\n[pins]\ntop = 2.0",
        "[cloth]\ngrid = \"vertical\"\n[camera]\nview_angle = 0"}) {
    EXPECT_NE(refusal(text), "") << text;
  }
}

const char* const sheetText = "[cloth]\ngrid = \"horizontal\"\n";

TEST(SceneBodies, areReadWithShapeMotionFrictionAndThickness) {
  const std::string text = std::string(sheetText) + R"(
[[bodies]]
name = "ball"
shape = "sphere"
radius = 0.25
position = [1, 2, 3]
spin = [0, 180, 0]
static_friction = 0.7
kinetic_friction = 0.6
thickness = 0.003

[[bodies]]
shape = "capsule"
radius = 0.05
length = 0.8
keyframes = [{ time = 0, position = [0, 1, 0] }, { time = 2, rotation = [0, 90, 0] }]
loop = true

[[bodies]]
shape = "box"
size = [1, 2, 3]

[ground]
height = -0.5
solid = true
static_friction = 0.3
)";
  const SceneDescription description = parseScene(text, "test", "test.toml", {});
  ASSERT_EQ(description.bodies.size(), 3U);
  const sim::contact::Body& ball = description.bodies[0].body;
  EXPECT_EQ(ball.name, "ball");
  EXPECT_EQ(std::get<sim::contact::SphereShape>(ball.shape).radius, 0.25);
  EXPECT_EQ(ball.motion.keyframes.at(0).position, Vec3(1, 2, 3));
  EXPECT_NEAR(ball.motion.spin.y(), M_PI, 1e-12);
  EXPECT_EQ(ball.surface.staticFriction, 0.7);
  EXPECT_EQ(ball.surface.kineticFriction, 0.6);
  EXPECT_EQ(ball.surface.thickness, 0.003);
  const sim::contact::Body& rod = description.bodies[1].body;
  EXPECT_EQ(std::get<sim::contact::CapsuleShape>(rod.shape).halfLength, 0.4);
  ASSERT_EQ(rod.motion.keyframes.size(), 2U);
  EXPECT_EQ(rod.motion.keyframes[1].position, Vec3(0, 1, 0));  // what a keyframe does not say stays
  EXPECT_NEAR(rod.motion.keyframes[1].rotation.y(), 0.5 * M_PI, 1e-12);
  EXPECT_TRUE(rod.motion.loop);
  EXPECT_EQ(std::get<sim::contact::BoxShape>(description.bodies[2].body.shape).half, Vec3(0.5, 1.0, 1.5));

  const auto scene = buildScene(description, description.settings);
  ASSERT_EQ(scene->bodies->size(), 4U);
  EXPECT_EQ(scene->bodies->back().name, "ground");
  EXPECT_EQ(scene->bodies->back().motion.keyframes.at(0).position.y(), -0.5);
  EXPECT_EQ(scene->bodies->back().surface.staticFriction, 0.3);
  EXPECT_LE(scene->bodies->back().surface.kineticFriction, 0.3);
}

TEST(SceneBodies, areRefusedWithFileAndLineWhenTheyMakeNoSense) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"[[bodies]]\nradius = 1", "bodies.shape must be one of plane, sphere, capsule, box, mesh"},
      {"[[bodies]]\nshape = \"cone\"", "not \"cone\""},
      {"[[bodies]]\nshape = \"sphere\"\nradius = 0", "bodies.radius must be a number from"},
      {"[[bodies]]\nshape = \"sphere\"\nsize = [1, 1, 1]", "there is no 'bodies.size'"},
      {"[[bodies]]\nshape = \"box\"\nsize = [1, 0, 1]", "bodies.size must be three lengths"},
      {"[[bodies]]\nshape = \"mesh\"", "needs mesh = "},
      {"[[bodies]]\nshape = \"mesh\"\nmesh = \"a.obj\"\nframes = { last = 3 }", "needs a number pattern"},
      {"[[bodies]]\nshape = \"sphere\"\nloop = true", "at least two keyframes"},
      {"[[bodies]]\nshape = \"sphere\"\nkeyframes = [{ time = 1 }, { time = 1 }]", "must ascend"},
      {"[[bodies]]\nshape = \"sphere\"\nstatic_friction = 0.2\nkinetic_friction = 0.3", "must not be larger"},
      {"[[bodies]]\nname = \"a\"\nshape = \"sphere\"\n[[bodies]]\nname = \"a\"\nshape = \"sphere\"", "two bodies"},
      {"[ground]\nsolid = false\nthickness = 0.1", "need solid = true"}};
  for (const auto& [body, message] : cases) {
    const std::string refused = refusal(sheetText + body);
    EXPECT_NE(refused.find(message), std::string::npos) << body << "\n" << refused;
    EXPECT_NE(refused.find("toml:"), std::string::npos) << refused;
  }
}

TEST(SceneFile, hasASolidGroundUnlessItSaysOtherwise) {
  EXPECT_TRUE(parse(sheetText).ground);
  EXPECT_TRUE(parse(std::string(sheetText) + "[ground]\nheight = 1").ground);
  EXPECT_FALSE(parse(std::string(sheetText) + "[ground]\nsolid = false").ground);
  EXPECT_FALSE(parse(sheetText).groundHeight);
  EXPECT_EQ(parse(std::string(sheetText) + "[ground]\nstatic_friction = 0.2").ground->surface.staticFriction, 0.2);
}

TEST(SceneFile, hasASolidStandUnlessItSaysOtherwise) {
  const std::string stand = std::string(sheetText) + "[stand]\nmesh = \"pole.obj\"\n";
  EXPECT_TRUE(parse(stand).stand->body);
  EXPECT_FALSE(parse(stand + "solid = false").stand->body);
  EXPECT_EQ(parse(stand + "thickness = 0.004").stand->body->surface.thickness, 0.004);
  EXPECT_NE(refusal(stand + "solid = false\nthickness = 0.004").find("need solid = true"), std::string::npos);
  const std::string noMesh = refusal(std::string(sheetText) + "[stand]\nsolid = true");
  EXPECT_NE(noMesh.find("toml:3: mesh is missing"), std::string::npos) << noMesh;
}

TEST(SceneFile, takesSeveralTablesOfPinsEachWithItsOwnBody) {
  const std::string bodies =
      "[[bodies]]\nname = \"left\"\nshape = \"sphere\"\n[[bodies]]\nname = \"right\"\nshape = \"sphere\"\n";
  const std::string pins =
      "[[pins]]\ncorners = [\"top_left\"]\nbody = \"left\"\n[[pins]]\ncorners = [\"top_right\"]\nbody = ";
  const std::string sheet = "[cloth]\ngrid = \"vertical\"\n";
  const SceneDescription scene = parse(sheet + pins + "\"right\"\n" + bodies);
  ASSERT_EQ(scene.cloth().pins.size(), 2U);
  EXPECT_EQ(scene.cloth().pins[0].body, "left");
  EXPECT_EQ(scene.cloth().pins[1].body, "right");
  EXPECT_EQ(scene.cloth().pins[1].corners, std::vector<std::string>{"top_right"});
  const std::string nobody = refusal(sheet + pins + "\"centre\"\n" + bodies);
  EXPECT_NE(nobody.find("toml:6: pins.body: there is no body with the name \"centre\""), std::string::npos) << nobody;
}

TEST(SceneFile, takesAsCarrierOfThePinsOnlyABodyThatThereIs) {
  const std::string scene = "[cloth]\ngrid = \"vertical\"\n[pins]\ncorners = [\"top_left\"]\nbody = \"hero\"\n";
  const std::string hero = "[[bodies]]\nname = \"hero\"\nshape = \"sphere\"\n";
  EXPECT_EQ(parse(scene + hero).cloth().pins.at(0).body, "hero");
  EXPECT_NE(refusal(scene).find("no body with the name \"hero\""), std::string::npos) << refusal(scene);
}

TEST(SceneFormat, ofANewerVersionIsNamedBeforeItsUnknownKeys) {
  const std::string cloth = "[cloth]\ngrid = \"vertical\"\n";
  EXPECT_EQ(refusal("format = 1\n" + cloth), "");
  EXPECT_EQ(refusal("title = \"From the future\"\nformat = 3\nmagnets = 3\n" + cloth),
            "test.toml:2: a newer version of Drape wrote this scene (format 3); this version reads formats up to 2. "
            "Update Drape.");
}

TEST(SceneFormat, decidesOnSelfCollisionInAFileThatDoesNotSetIt) {
  using sim::contact::SelfCollision;
  const std::string cloth = "[cloth]\ngrid = \"vertical\"\n";
  const auto chosenIn = [](const std::string& scene) { return parse(scene).settings.step.contact.self; };
  EXPECT_EQ(chosenIn(cloth), SelfCollision::Auto);
  EXPECT_EQ(chosenIn("format = 2\n" + cloth), SelfCollision::Auto);
  EXPECT_EQ(chosenIn("format = 1\n" + cloth), SelfCollision::Off) << "as when it was saved";
  EXPECT_EQ(chosenIn("format = 1\n" + cloth + "[settings]\nself_collision = \"hash\"\n"), SelfCollision::Hash);
}

}  // namespace
}  // namespace drape::scene
