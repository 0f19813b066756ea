#include "scene/scene_writer.hpp"

#include "messages/error.hpp"
#include "scene/scene_file.hpp"
#include "scene/scene_parts.hpp"
#include "scene/toml_reader.hpp"
#include "scene/toml_text.hpp"

#include <gtest/gtest.h>

#include <unistd.h>
#include <filesystem>
#include <fstream>
#include <string>

namespace drape::scene {
namespace {

SceneDescription described(const std::string& text) {
  return parseScene(text, "test", "test.toml", std::filesystem::current_path());
}

std::shared_ptr<const Scene> builtFrom(const SceneDescription& description) {
  return buildScene(description, description.settings);
}

WrittenScene writtenAs(const Scene& scene) {
  return writeScene(scene, unchanged(scene), std::filesystem::current_path());
}

void expectSameMotion(const sim::contact::BodyMotion& a, const sim::contact::BodyMotion& b) {
  ASSERT_EQ(a.keyframes.size(), b.keyframes.size());
  for (std::size_t i = 0; i < a.keyframes.size(); ++i) {
    EXPECT_EQ(a.keyframes[i].time, b.keyframes[i].time);
    EXPECT_EQ(a.keyframes[i].position, b.keyframes[i].position);
    EXPECT_EQ(a.keyframes[i].rotation, b.keyframes[i].rotation);
  }
  EXPECT_EQ(a.loop, b.loop);
  EXPECT_EQ(a.spin, b.spin);
}

void expectSame(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.start.positions, b.start.positions);
  EXPECT_EQ(a.model->triangles, b.model->triangles);
  EXPECT_EQ(a.model->vertexMass, b.model->vertexMass);
  EXPECT_EQ(a.model->pinned, b.model->pinned);
  EXPECT_EQ(a.groundHeight, b.groundHeight);
  EXPECT_EQ(a.camera, b.camera);
  settings::Settings expected = a.settings;
  if (a.reading) {  // a written scene states what was guessed
    expected.mesh.unit = a.reading->unit;
    expected.mesh.up = a.reading->up;
  }
  EXPECT_TRUE(settings::differingSettings(expected, b.settings).empty());
  ASSERT_EQ(a.bodies->size(), b.bodies->size());
  for (std::size_t i = 0; i < a.bodies->size(); ++i) {
    const sim::contact::Body& one = (*a.bodies)[i];
    const sim::contact::Body& other = (*b.bodies)[i];
    EXPECT_EQ(one.name, other.name);
    EXPECT_EQ(one.surface, other.surface) << one.name;
    EXPECT_EQ(one.drawn, other.drawn) << one.name;
    EXPECT_EQ(one.pins.size(), other.pins.size()) << one.name;
    EXPECT_EQ(sim::contact::surfaceOf(one.shape).positions, sim::contact::surfaceOf(other.shape).positions) << one.name;
    expectSameMotion(one.motion, other.motion);
  }
}

TEST(SceneWriter, ReadsBackToEveryBuiltInScene) {
  for (const SceneInfo& info : sceneList()) {
    const auto scene = builtFrom(openScene(info.name));
    const WrittenScene written = writtenAs(*scene);
    const auto again = builtFrom(described(written.text));
    EXPECT_EQ(again->description.title, info.title);
    EXPECT_EQ(again->description.help, info.help);
    EXPECT_TRUE(written.notes.empty()) << info.name;
    expectSame(*scene, *again);
    if (HasFailure()) {
      FAIL() << info.name << ":\n" << written.text;
    }
  }
}

/// All that a scene may have, in odd numbers.
constexpr const char* everything = R"(
title = "All \"kinds\" of things"
help = "One line\nand another."
[[cloths]]
name = "upper"
grid = "horizontal"
position = [0.1, 1.3000000000000003, 0]
rotation = [17.3, -33.33, 0.1]
pleats = { count = 5, gather = 0.6 }
pins = [{ corners = ["top_left"], every = 3, edges = ["left"], body = "ball" }, { nearest = [[0, 1, 0.3]] }]
settings = { "grid.resolution" = 7, "material.preset" = "My wool", "density" = 0.3 }
[[cloths]]
name = "lower"
mesh = "builtin:skirt.obj"
bands = [{ nearest = [0, 1.05, 0], length = 0.93 }]
pins = { top = 0.07, boxes = [{ min = [-1, 1.4, -1], max = [1, 2, 1] }] }
[camera]
position = [1.5, 1.4, 2.6]
focal_point = [0, 0.83, 0]
view_angle = 41.7
orthographic = true
[stand]
mesh = "builtin:stand.obj"
solid = false
[[bodies]]
name = "ball"
shape = "sphere"
radius = 0.123
keyframes = [{ time = 0, position = [0, 1, 0] }, { time = 1.7, rotation = [0, 71.9, 3] }]
loop = true
static_friction = 0.7
[[bodies]]
name = "rod"
shape = "capsule"
radius = 0.03
length = 0.77
rotation = [0, 0, 90.1]
spin = [0, 33.7, 0]
drawn = false
[[bodies]]
name = "box"
shape = "box"
size = [0.3, 0.7, 0.11]
position = [0, -1, 0]
[[bodies]]
name = "floor"
shape = "plane"
size = 3.3
[ground]
solid = false
height = -2.1
[[fabrics]]
name = "My wool"
based_on = "wool"
shear = 31.5
[settings]
material.model = "fabric"
material.preset = "linen"
fabric.bend_warp = 1.7e-5
time_step = "1/290"
solver = "auto"
wind.x = 0.1
)";

TEST(SceneWriter, ReadsBackToAllThatASceneMayHave) {
  const auto scene = builtFrom(described(everything));
  const WrittenScene written = writtenAs(*scene);
  const auto again = builtFrom(described(written.text));
  EXPECT_EQ(again->description.help, "One line\nand another.");
  expectSame(*scene, *again);
  EXPECT_EQ(written.text, writtenAs(*again).text);
  EXPECT_NE(written.text.find("My wool"), std::string::npos) << written.text;
}

TEST(SceneWriter, WritesOnlyWhatDiffersFromTheDefaults) {
  SceneDescription description = openScene("grid");
  description.settings = settings::Settings();
  description.settings.step.air.drag = 0.75;
  const std::string text = writtenAs(*builtFrom(description)).text;
  const std::string settings = text.substr(text.find("[settings]"));
  EXPECT_EQ(settings, "[settings]\ndrag = 0.75\n");
}

TEST(SceneWriter, WritesWhichOfDensityAndMassCounts) {
  SceneDescription description = openScene("grid");
  settings::assignSettingExpression(description.settings, "mass=0.4");
  settings::assignSettingExpression(description.settings, "mass_given_as=density");
  const auto again = described(writtenAs(*builtFrom(description)).text);
  EXPECT_EQ(again.settings.material.mass, 0.4);
  EXPECT_EQ(again.settings.material.massGivenAs, "density");
}

/// A mesh file in its own folder.
class OwnFolder {
 public:
  OwnFolder() : path_(std::filesystem::temp_directory_path() / ("drape-writer-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path_ / "meshes");
    std::ofstream(path_ / "meshes" / "sheet.obj") << "v 0 0 0\nv 100 0 0\nv 100 0 100\nv 0 0 100\nf 1 2 3\nf 1 3 4\n";
  }
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;
  ~OwnFolder() { std::filesystem::remove_all(path_); }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

TEST(SceneWriter, NamesMeshesRelativeToTheFileWhereTheyLieBelowIt) {
  const OwnFolder folder;
  const auto scene = builtFrom(openScene((folder.path() / "meshes" / "sheet.obj").string()));
  const auto written = writeScene(*scene, unchanged(*scene), folder.path());
  EXPECT_NE(written.text.find("meshes/sheet.obj"), std::string::npos) << written.text;
  EXPECT_EQ(written.text.find(folder.path().string()), std::string::npos) << written.text;
  expectSame(*scene, *builtFrom(parseScene(written.text, "sheet", "sheet.toml", folder.path())));
  const auto elsewhere = writeScene(*scene, unchanged(*scene), "/some/other/folder");
  EXPECT_NE(elsewhere.text.find((folder.path() / "meshes" / "sheet.obj").string()), std::string::npos);
}

TEST(SceneWriter, KeepsTheUnitOfBodiesThatWereDroppedWithTheCloth) {
  const OwnFolder folder;
  const std::string mesh = (folder.path() / "meshes" / "sheet.obj").string();
  const auto scene = builtFrom(openParts({.scene = {}, .cloth = mesh, .bodies = {mesh}}));
  ASSERT_LT(scene->summary.size[0], 2.0) << "it is read in centimetres";
  const auto written = writeScene(*scene, unchanged(*scene), folder.path());
  expectSame(*scene, *builtFrom(parseScene(written.text, "sheet", "sheet.toml", folder.path())));
}

TEST(SceneWriter, StatesTheUnitAndTheUpAxisThatWereGuessed) {
  const OwnFolder folder;
  const auto scene = builtFrom(openScene((folder.path() / "meshes" / "sheet.obj").string()));
  ASSERT_EQ(scene->settings.mesh.unit, "auto");
  ASSERT_TRUE(scene->reading && scene->reading->needsReview());
  const auto written = writeScene(*scene, unchanged(*scene), folder.path());
  const auto again = builtFrom(parseScene(written.text, "sheet", "sheet.toml", folder.path()));
  EXPECT_EQ(again->settings.mesh.unit, "cm") << written.text;
  EXPECT_EQ(again->settings.mesh.up, "y") << written.text;
  EXPECT_FALSE(again->reading && again->reading->needsReview()) << "nothing is asked again";
  expectSame(*scene, *again);
}

TEST(SceneWriter, StatesTheUnitOfEachOfSeveralCloths) {
  const OwnFolder folder;
  std::ofstream(folder.path() / "meshes" / "metre.obj") << "v 0 2 0\nv 1.2 2 0\nv 1.2 2 1\nv 0 2 1\nf 1 2 3\nf 1 3 4\n";
  const auto parsed = [&](const std::string& text) {
    return builtFrom(parseScene(text, "two", "two.toml", folder.path()));
  };
  const auto scene = parsed(R"(
[[cloths]]
name = "large"
mesh = "meshes/sheet.obj"
settings = { unit = "auto" }
[[cloths]]
name = "small"
mesh = "meshes/metre.obj"
[settings]
unit = "auto"
)");
  const auto written = writeScene(*scene, unchanged(*scene), folder.path());
  const auto again = parsed(written.text);
  EXPECT_EQ(again->start.positions, scene->start.positions) << written.text;
  EXPECT_EQ(settingsOf(again->cloths[0].own, again->settings).mesh.unit, "cm") << written.text;
  EXPECT_EQ(settingsOf(again->cloths[1].own, again->settings).mesh.unit, "m") << written.text;
  EXPECT_FALSE(again->reading && again->reading->needsReview());
}

TEST(SceneWriter, WritesPinsBodiesAndShiftsOfTheUser) {
  const auto scene = builtFrom(described(everything));
  SceneNow now = unchanged(*scene);
  now.pinned.assign(now.pinned.size(), false);
  now.pinned[3] = true;
  now.pinned[static_cast<std::size_t>(scene->cloths[1].firstVertex) + 11] = true;
  for (const sim::contact::Body& body : *scene->bodies) {
    now.bodies.push_back({true, Vec3::Zero(), body.surface});
  }
  now.bodies[0].shift = Vec3(0.5, 0.0, -0.25);
  now.bodies[1].on = false;
  const WrittenScene written = writeScene(*scene, now, std::filesystem::current_path());
  const auto again = builtFrom(described(written.text));
  EXPECT_EQ(again->model->pinned, now.pinned) << written.text;
  EXPECT_EQ((*again->bodies)[0].motion.keyframes.front().position, Vec3(0.5, 1.0, -0.25));
  ASSERT_EQ(written.notes.size(), 2U);
  EXPECT_NE(written.notes[0].english().find("rod is switched off"), std::string::npos) << written.notes[0];
}

TEST(SceneWriter, SwitchesTheGroundOff) {
  const auto scene = builtFrom(openScene("grid"));
  SceneNow now = unchanged(*scene);
  ASSERT_EQ(scene->bodies->size(), 1U);
  now.bodies.push_back({false, Vec3::Zero(), scene->bodies->front().surface});
  const WrittenScene written = writeScene(*scene, now, std::filesystem::current_path());
  EXPECT_TRUE(written.notes.empty());
  EXPECT_TRUE(builtFrom(described(written.text))->bodies->empty()) << written.text;
}

TEST(TomlText, FindsTheDegreesOfEveryAngle) {
  for (const double degrees : {45.0, 17.3, -33.33, 0.1, 1e-7, 90.1, 720.0, 123456.789}) {
    const Vec3 radians = degree * Vec3(degrees, 0.0, degrees);
    const TomlReader reader("a = " + degreesText(radians), "test");
    EXPECT_EQ(Vec3(degree * reader.vector("a", 1e6).value_or(Vec3::Zero())), radians) << degrees;
  }
  EXPECT_EQ(degreesText(degree * Vec3(45.0, 0.0, -33.33)), "[45, 0, -33.33]");
}

TEST(TomlText, FindsTheRateOfEveryInterval) {
  for (const double rate : {30.0, 24.0, 29.97, 60.0, 1000.0, 0.3}) {
    EXPECT_EQ(rateText(1.0 / rate), settings::formatValue(rate));
  }
}

}  // namespace
}  // namespace drape::scene
