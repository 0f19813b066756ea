#include "messages/error.hpp"
#include "scene/scene.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace drape::scene {
namespace {

/// A folder that is removed after the test.
class Folder {
 public:
  Folder() {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return (path_ / name).string();
  }
  [[nodiscard]] std::string string() const { return path_.string(); }

 private:
  std::filesystem::path path_ =
      std::filesystem::path(::testing::TempDir()) / ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

int pinCount(const Scene& scene) {
  return static_cast<int>(std::count(scene.model->pinned.begin(), scene.model->pinned.end(), true));
}

std::string refusalOfOpening(const std::string& nameOrPath) {
  try {
    static_cast<void>(openScene(nameOrPath));
    return "";
  } catch (const messages::InputError& error) {
    return error.what();
  }
}

constexpr const char* quad = "v 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4\n";

TEST(Scenes, areBuiltInWithTitlesAndBuildWithPinsOrBodiesThatHoldTheCloth) {
  const auto scenes = sceneList();
  for (const char* name : {"grid", "flag", "curtain", "skirt"}) {
    EXPECT_TRUE(std::any_of(scenes.begin(), scenes.end(), [&](const SceneInfo& s) { return s.name == name; })) << name;
  }
  for (const SceneInfo& info : scenes) {
    const SceneDescription description = openScene(info.name);
    const auto scene = buildScene(description, description.settings);
    EXPECT_FALSE(info.title.empty());
    EXPECT_FALSE(info.help.empty());
    EXPECT_TRUE(pinCount(*scene) > 0 || !scene->bodies->empty()) << info.name;
    EXPECT_TRUE(sim::isFinite(scene->start)) << info.name;
    EXPECT_EQ(scene->renderMesh.triangles.size(), scene->model->triangles.size()) << info.name;
  }
}

TEST(Scenes, haveThePapersSheetAsGrid) {
  SceneDescription description = openScene("grid");
  description.settings.grid.resolution = 17;
  const auto scene = buildScene(description, description.settings);
  EXPECT_EQ(scene->model->vertexCount(), 289);
  EXPECT_EQ(scene->model->springs.size(), 800U);
  EXPECT_NEAR(scene->model->totalMass(), 0.1, 1e-14);
  EXPECT_EQ(pinCount(*scene), 2);
  EXPECT_TRUE(scene->model->pinned[0]);
  EXPECT_TRUE(scene->model->pinned[16]);
  for (std::size_t v = 0; v < 289; ++v) {
    EXPECT_EQ(scene->start.positions[v].y(), scene->start.positions[0].y());
    EXPECT_EQ(scene->start.velocities[v], Vec3(Vec3::Zero()));
  }
}

TEST(Scenes, openAMeshFileHangingByItsTop) {
  const Folder folder;
  const SceneDescription description = openScene(folder.write("sheet.obj", quad));
  const auto scene = buildScene(description, description.settings);
  EXPECT_EQ(scene->model->vertexCount(), 4);
  EXPECT_EQ(pinCount(*scene), 2);
  EXPECT_LT(scene->groundHeight, 0.0);
  settings::Settings free = description.settings;
  free.mesh.pins = "none";
  EXPECT_EQ(pinCount(*buildScene(description, free)), 0);
}

const sim::contact::Body* bodyNamed(const Scene& scene, const std::string& name) {
  const auto found = std::find_if(scene.bodies->begin(), scene.bodies->end(),
                                  [&](const sim::contact::Body& body) { return body.name == name; });
  return found == scene.bodies->end() ? nullptr : &*found;
}

std::shared_ptr<const Scene> built(const std::string& nameOrPath) {
  const SceneDescription description = openScene(nameOrPath);
  return buildScene(description, description.settings);
}

TEST(Scenes, areSolidWhereTheyDrawAStandOrTheGround) {
  for (const SceneInfo& info : sceneList()) {
    const auto scene = built(info.name);
    const sim::contact::Body* ground = bodyNamed(*scene, "ground");
    ASSERT_NE(ground, nullptr) << info.name;
    EXPECT_EQ(ground->motion.keyframes.at(0).position.y(), scene->groundHeight) << info.name;
    const sim::contact::Body* stand = bodyNamed(*scene, "stand");
    ASSERT_EQ(stand != nullptr, scene->stand.has_value()) << info.name;
    if (stand != nullptr) {
      const auto& mesh = *std::get<std::shared_ptr<const sim::contact::MeshShape>>(stand->shape);
      EXPECT_EQ(mesh.positions, scene->stand->positions) << info.name;
      EXPECT_EQ(mesh.triangles, scene->stand->triangles) << info.name;
    }
  }
}

TEST(Scenes, haveTheirGroundAtZeroOrBelowClothThatStartsLower) {
  const Folder folder;
  const auto groundOf = [&](const std::string& height, const std::string& pins) {
    return built(
               folder.write("mine.toml", "[cloth]\ngrid = \"horizontal\"\nposition = [0, " + height + ", 0]\n" + pins))
        ->groundHeight;
  };
  EXPECT_EQ(groundOf("0.5", ""), 0.0);
  EXPECT_NEAR(groundOf("0", ""), -0.25, 1e-12);
  EXPECT_NEAR(groundOf("-3", ""), -3.25, 1e-12);
  // A sheet of 1 m that hangs from one edge reaches 1 m down; from one corner it reaches the length of its diagonal.
  EXPECT_LT(groundOf("-3", "[pins]\nedges = [\"top\"]"), -4.0);
  EXPECT_GT(groundOf("-3", "[pins]\nedges = [\"top\"]"), -4.2);
  EXPECT_LT(groundOf("-3", "[pins]\ncorners = [\"top_left\"]"), -3.0 - std::sqrt(2.0));
}

TEST(Scenes, thatAreBuiltInKeepTheClothFromPassingThroughItselfIfTheirSolverIsAuto) {
  using sim::contact::SelfCollision;
  for (const SceneInfo& info : sceneList()) {
    const settings::Settings settings = openScene(info.name).settings;
    const SelfCollision self = settings.step.contact.self;
    if (settings.solver.name == "auto") {
      EXPECT_TRUE(self == SelfCollision::Auto || self == SelfCollision::Exact) << info.name;
    }
  }
}

TEST(Scenes, giveAnOpenedMeshAirDampingSelfCollisionAndASolidGroundBelowIt) {
  const Folder folder;
  const auto scene = built(folder.write("sheet.obj", quad));
  const sim::StepParameters& step = scene->description.settings.step;
  EXPECT_GT(step.air.drag, 0.0);
  EXPECT_GT(step.air.lift, 0.0);
  EXPECT_GT(step.material.damping, 0.0);
  EXPECT_EQ(step.contact.self, sim::contact::SelfCollision::Exact);
  EXPECT_NE(bodyNamed(*scene, "ground"), nullptr);
  EXPECT_LT(scene->groundHeight, -0.2);
  // A scene file starts from the defaults of the table.
  const auto mine = built(folder.write("mine.toml", "[cloth]\nmesh = \"sheet.obj\"\n"));
  EXPECT_EQ(mine->description.settings.step.air.drag, settings::Settings().step.air.drag);
  EXPECT_EQ(mine->description.settings.step.contact.self, sim::contact::SelfCollision::Auto);
}

TEST(Scenes, takeAMeshFilesUnitFromTheSettings) {
  const Folder folder;
  const SceneDescription description = openScene(folder.write("sheet.obj", quad));
  settings::Settings centimetres = description.settings;
  centimetres.mesh.unit = "cm";
  EXPECT_NEAR(buildScene(description, centimetres)->model->restArea(), 2e-4, 1e-12);
}

TEST(Scenes, turnAMeshUprightWhoseZPointsUp) {
  const Folder folder;
  const SceneDescription description = openScene(folder.write("sheet.obj", "v 0 0 0\nv 1 0 0\nv 1 0 2\nf 1 2 3\n"));
  settings::Settings settings = description.settings;
  settings.mesh.up = "z";
  const auto scene = buildScene(description, settings);
  EXPECT_EQ(scene->start.positions[2], Vec3(1.0, 2.0, 0.0));
  EXPECT_EQ(scene->summary.size[1], 2.0);
  EXPECT_TRUE(scene->model->pinned[2]);
}

TEST(Scenes, openAUsersFileWithAMeshBesideIt) {
  const Folder folder;
  folder.write("sheet.obj", quad);
  const auto file = folder.write("mine.toml", "[cloth]\nmesh = \"sheet.obj\"\n[settings]\nstiffness = 42\n");
  const SceneDescription description = openScene(file);
  EXPECT_EQ(description.name, "mine");
  EXPECT_EQ(buildScene(description, description.settings)->settings.step.material.stiffness, 42.0);
}

TEST(Scenes, areMovedByAutoUnlessTheyArePapersOrSayOtherwise) {
  const Folder folder;
  const auto mesh = folder.write("sheet.obj", quad);
  EXPECT_EQ(openScene(mesh).settings.solver.name, "auto");
  const std::string cloth = "[cloth]\nmesh = \"sheet.obj\"\n";
  EXPECT_EQ(openScene(folder.write("mine.toml", cloth)).settings.solver.name, "auto");
  EXPECT_EQ(openScene(folder.write("hers.toml", cloth + "[settings]\nsolver = \"xpbd\"\n")).settings.solver.name,
            "xpbd");
  for (const char* papers : {"grid", "fold", "falling_sheet", "falling_sheet_in_air", "edge_drop"}) {
    EXPECT_EQ(openScene(papers).settings.solver.name, "one_iteration") << papers;
  }
  for (const char* ours : {"flag", "curtain", "skirt"}) {
    EXPECT_EQ(openScene(ours).settings.solver.name, "auto") << ours;
  }
}

TEST(Scenes, turnTheClothAboutItsOwnOriginBeforeTheyPlaceIt) {
  SceneDescription description = openScene("grid");
  description.cloth().rotation = Vec3(0.0, 0.0, 0.5 * M_PI);
  description.cloth().position = Vec3(3.0, 2.0, 1.0);
  description.settings.grid.resolution = 2;
  const auto scene = buildScene(description, description.settings);
  // x becomes y: the level sheet stands in the plane x = 3, with its top left corner below.
  EXPECT_NEAR((scene->start.positions[0] - Vec3(3.0, 1.5, 0.5)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((scene->start.positions[1] - Vec3(3.0, 2.5, 0.5)).norm(), 0.0, 1e-12);
  EXPECT_EQ(scene->start.positions[1], scene->model->restPositions[1]);
}

/// A quad like the one above, tilted more in each file.
void writeFrames(const Folder& folder, int count) {
  for (int k = 0; k < count; ++k) {
    const std::string height = std::to_string(0.1 * k);
    folder.write("tilt_00" + std::to_string(k + 1) + ".obj",
                 "v 0 0 0\nv 1 0 0\nv 1 " + height + " 1\nv 0 " + height + " 1\nf 1 4 3 2\n");
  }
}

constexpr const char* tiltingScene = R"([cloth]
grid = "horizontal"
position = [0.5, 1.0, 0.5]
[pins]
edges = ["top"]
body = "tilt"
[settings]
grid.resolution = 5
[[bodies]]
name = "tilt"
shape = "mesh"
mesh = "tilt_###.obj"
scale = 2
frames = { first = 1, last = 3, rate = 10, loop = true }
)";

TEST(Scenes, readADeformingBodyFromOneFileAFrame) {
  const Folder folder;
  writeFrames(folder, 3);
  const SceneDescription description = openScene(folder.write("tilting.toml", tiltingScene));
  const auto scene = buildScene(description, description.settings);
  const auto& mesh = *std::get<std::shared_ptr<const sim::contact::MeshShape>>(scene->bodies->at(0).shape);
  ASSERT_EQ(mesh.frames.size(), 3U);
  EXPECT_EQ(mesh.triangles.size(), 2U);
  EXPECT_TRUE(mesh.loop);
  EXPECT_DOUBLE_EQ(mesh.frameTime, 0.1);
  EXPECT_EQ(mesh.positions, mesh.frames[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    double highest = 0.0;
    for (const Vec3& position : mesh.frames[k]) {
      highest = std::max(highest, position.y());
    }
    EXPECT_NEAR(highest, 0.2 * static_cast<double>(k), 1e-6);
  }
  // Pins move with its nearest vertex: each pin gets one.
  ASSERT_EQ(scene->bodies->at(0).pins.size(), 5U);
  for (const sim::contact::CarriedPin& pin : scene->bodies->at(0).pins) {
    EXPECT_GE(pin.anchor, 0);
  }
}

TEST(Scenes, sayWhichFrameOfABodyIsMissingOrDoesNotFit) {
  const auto failure = [](const Folder& folder) -> std::string {
    const SceneDescription description = openScene(folder.write("tilting.toml", tiltingScene));
    try {
      static_cast<void>(buildScene(description, description.settings));
      return "";
    } catch (const messages::InputError& error) {
      return error.what();
    }
  };
  const Folder folder;
  writeFrames(folder, 2);
  EXPECT_NE(failure(folder).find("tilt_003.obj"), std::string::npos) << failure(folder);
  folder.write("tilt_003.obj", "v 0 0 0\nv 1 0 0\nv 1 0 1\nf 1 3 2\n");
  EXPECT_NE(failure(folder).find("tilt_003.obj does not have the same triangles as"), std::string::npos)
      << failure(folder);
}

TEST(Scenes, sayWhatIsWrongWithAFileThatCannotBeOpened) {
  const Folder folder;
  EXPECT_NE(refusalOfOpening("no_such_scene").find("built-in scenes are"), std::string::npos);
  EXPECT_EQ(refusalOfOpening("no_such_shirt.obj"), "there is no file 'no_such_shirt.obj'");
  EXPECT_NE(refusalOfOpening(folder.string()).find("is a folder"), std::string::npos);
  EXPECT_NE(refusalOfOpening(folder.write("picture.png", "x")).find("known extensions"), std::string::npos);
  EXPECT_NE(refusalOfOpening(folder.write("empty.toml", "")).find("[cloth]"), std::string::npos);
}

TEST(Scenes, sayWhatToExportInsteadOfAFormatThatIsNotRead) {
  const Folder folder;
  EXPECT_NE(refusalOfOpening(folder.write("shirt.fbx", "x")).find("'.fbx' files are not supported. Open it in Blender"),
            std::string::npos);
}

TEST(Scenes, tellWhatIsWrongWithTheMeshOfABody) {
  const Folder folder;
  folder.write("body.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 1 0 1\nf 1 3 2\nf 2 3 4\nf 1 1 2\n");
  const SceneDescription description =
      openScene(folder.write("body.toml",
                             "[cloth]\ngrid = \"vertical\"\n[[bodies]]\nname = \"b\"\nshape = \"mesh\"\n"
                             "mesh = \"body.obj\"\n"));
  const auto scene = buildScene(description, description.settings);
  ASSERT_EQ(scene->summary.warnings.size(), 1U);
  EXPECT_NE(scene->summary.warnings[0].find("body.obj: 1 face has no area"), std::string::npos);
}

TEST(Scenes, leaveOutFarVerticesWhenAsked) {
  const Folder folder;
  std::string mesh;
  for (int i = 0; i < 25; ++i) {
    mesh += "v " + std::to_string(i % 5) + (i == 24 ? " 1e5 " : " 0 ") + std::to_string(i / 5) + "\n";
  }
  for (int i = 1; i < 20; ++i) {
    if (i % 5 != 0) {
      mesh += "f " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 6) + " " +
              std::to_string(i + 5) + "\n";
    }
  }
  const SceneDescription description = openScene(folder.write("far.obj", mesh));
  EXPECT_THROW(static_cast<void>(buildScene(description, description.settings)), messages::InputError);
  settings::Settings settings = description.settings;
  settings.mesh.outliers = "leave_out";
  EXPECT_EQ(buildScene(description, settings)->summary.outliers, 1);
}

TEST(Scenes, tellTheirProgressAndCanBeCancelled) {
  const SceneDescription description = openScene("skirt");
  double last = 0.0;
  std::stop_source stop;
  const io::ImportWatch watch{[&](double share, std::string_view) {
                                last = share;
                                if (share > 0.5) {
                                  stop.request_stop();
                                }
                              },
                              stop.get_token()};
  EXPECT_THROW(static_cast<void>(buildScene(description, description.settings, watch)), io::Cancelled);
  EXPECT_GT(last, 0.5);
  EXPECT_LT(last, 1.0);
}

TEST(Scenes, sayTheLineOfTheSceneFileWhosePinsOrMeshAreWrong) {
  const Folder folder;
  folder.write("sheet.obj", quad);
  const auto failure = [&](const std::string& text) -> std::string {
    const SceneDescription description = openScene(folder.write("mine.toml", text));
    try {
      static_cast<void>(buildScene(description, description.settings));
      return "";
    } catch (const messages::InputError& error) {
      return error.what();
    }
  };
  const std::string cloth = "[cloth]\nmesh = \"sheet.obj\"\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {cloth + "[pins]\nvertices = [4]\n", "mine.toml:4: pins.vertices contains vertex 4"},
      {cloth + "[pins]\nedges = [\"left\"]\n", "mine.toml:3: pins.corners and pins.edges belong to a grid"},
      {"[cloth]\ngrid = \"vertical\"\n\n[pins]\nedges = [\"front\"]\n", "mine.toml:4: "},
      {"[cloth]\nmesh = \"none.obj\"\n", "mine.toml:2: "},
      {"[cloth]\nmesh = \"builtin:none.obj\"\n", "mine.toml:2: there is no built-in mesh 'none.obj'"},
      {cloth + "[stand]\nmesh = \"stand.obj\"\n", "mine.toml:4: "},
      {cloth + "[[bodies]]\nshape = \"mesh\"\nmesh = \"body.obj\"\n", "mine.toml:5: "}};
  for (const auto& [text, message] : cases) {
    EXPECT_NE(failure(text).find(message), std::string::npos) << text << failure(text);
  }
}

TEST(Scenes, sayWhichBuiltInMeshesThereAre) {
  const Folder folder;
  const auto file = folder.write("mine.toml", "[cloth]\nmesh = \"builtin:hat.obj\"\n");
  const SceneDescription description = openScene(file);
  EXPECT_THROW(static_cast<void>(buildScene(description, description.settings)), messages::InputError);
}

}  // namespace
}  // namespace drape::scene
