// Dressing in the window: dropped files, the command line, and bodies that pass through the cloth.
#include "animation_files.hpp"
#include "intersection/intersections.hpp"
#include "replay.hpp"
#include "viewer_driver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace drape::app {
namespace {

struct Mesh {
  std::vector<Eigen::Vector3d> positions;
  std::vector<std::array<int, 3>> triangles;
};

/// Reads the vertices of an OBJ file, and its polygons as triangles.
Mesh readObj(const std::filesystem::path& file) {
  Mesh mesh;
  std::ifstream text(file);
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword == "v") {
      Eigen::Vector3d point;
      words >> point.x() >> point.y() >> point.z();
      mesh.positions.push_back(point);
    } else if (keyword == "f") {
      std::vector<int> corners;
      for (std::string corner; words >> corner;) {
        corners.push_back(std::stoi(corner) - 1);
      }
      for (std::size_t k = 2; k < corners.size(); ++k) {
        mesh.triangles.push_back({corners[0], corners[k - 1], corners[k]});
      }
    }
  }
  return mesh;
}

std::string meshOfTree(const std::string& name) {
  return std::string(DRAPE_MESHES) + "/" + name;
}

/// The pairs of triangles of the garment in a file and a body of the tree that intersect.
std::size_t pairsIn(const std::filesystem::path& garment, const std::string& body) {
  const Mesh cloth = readObj(garment);
  const Mesh solid = readObj(meshOfTree(body));
  EXPECT_GT(cloth.triangles.size(), 1000U);
  EXPECT_GT(solid.triangles.size(), 1000U);
  return intersection::intersectingPairs({cloth.positions, cloth.triangles}, {solid.positions, solid.triangles}).size();
}

/// Files to drop: a T-shirt that is lower and further in front than it is worn, and a body.
class Wardrobe {
 public:
  [[nodiscard]] std::string shirt() const {
    const auto file = folder_.path() / "shirt.obj";
    std::ifstream original(meshOfTree("tshirt.obj"));
    std::ofstream moved(file);
    for (std::string line; std::getline(original, line);) {
      std::istringstream words(line);
      std::string keyword;
      Eigen::Vector3d point;
      if (words >> keyword >> point.x() >> point.y() >> point.z() && keyword == "v") {
        moved << "v " << point.x() << ' ' << point.y() - 0.03 << ' ' << point.z() + 0.04 << '\n';
      } else {
        moved << line << '\n';
      }
    }
    return file.string();
  }
  /// The mannequin in centimetres with z up.
  [[nodiscard]] std::string bodyInCentimetres() const {
    const auto file = folder_.path() / "body_cm.obj";
    const Mesh mesh = readObj(meshOfTree("mannequin.obj"));
    std::ofstream text(file);
    for (const Eigen::Vector3d& p : mesh.positions) {
      text << "v " << 100.0 * p.x() << ' ' << -100.0 * p.z() << ' ' << 100.0 * p.y() << '\n';
    }
    for (const auto& [a, b, c] : mesh.triangles) {
      text << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
    }
    return file.string();
  }
  [[nodiscard]] std::string body(const std::string& name = "mannequin.obj") const {
    const auto file = folder_.path() / name;
    std::filesystem::copy_file(meshOfTree("mannequin.obj"), file, std::filesystem::copy_options::overwrite_existing);
    return file.string();
  }

 private:
  TemporaryFolder folder_;
};

/// A file of a post with the clips "bend" and "still".
std::filesystem::path animatedPost(const TemporaryFolder& folder) {
  auto file = folder.path() / "body.gltf";
  io::BarFile bar;
  bar.isSolid = true;
  std::ofstream(file) << bar.text();
  return file;
}

bool isDressed(const Json& state) {
  return state["placed"].get<bool>() && state["dressing"].is_null();
}

/// Saves the cloth as it is. Its file has the coordinates of the garment's file.
std::filesystem::path savedCloth(ViewerDriver& viewer, const std::string& name) {
  viewer.key("e");
  viewer.waitUntil("the file of the cloth", [&](const Json& s) { return says(s, name); });
  return viewer.folder() / name;
}

TEST(DressingInTheWindow, ABodyThatIsDroppedOnAGarmentWearsItAfterOneClick) {
  const Wardrobe wardrobe;
  ViewerDriver viewer({wardrobe.shirt(), "--paused"});
  ASSERT_TRUE(viewer.drop({wardrobe.body()}));
  viewer.waitUntil("the question", [](const Json& s) { return hasButton(s, "button.drop.dress"); });
  EXPECT_TRUE(hasButton(viewer.state(), "button.drop.alone"));
  viewer.click(viewer.find("button.drop.dress"));
  const Json dressed = viewer.waitUntil("the dressed body", isDressed);
  EXPECT_EQ(dressed["scene"], "shirt.obj");
  EXPECT_EQ(dressed["pins"], 0);
  viewer.waitUntil("no body in the cloth", [](const Json& s) { return s["piercing"].is_null(); });
  EXPECT_TRUE(viewer.state()["paused"].get<bool>()) << "as before";
  EXPECT_EQ(pairsIn(savedCloth(viewer, "shirt-001.obj"), "mannequin.obj"), 0U);
}

/// Drops the body on the garment, and dresses it.
Json dressByDrop(ViewerDriver& viewer, const Wardrobe& wardrobe) {
  EXPECT_TRUE(viewer.drop({wardrobe.body()}));
  viewer.waitUntil("the question", [](const Json& s) { return hasButton(s, "button.drop.dress"); });
  viewer.click(viewer.find("button.drop.dress"));
  return viewer.waitUntil("the dressed body", isDressed);
}

TEST(DressingInTheWindow, UndoAndRedoReturnToTheClothBeforeAndAfterDressing) {
  const Wardrobe wardrobe;
  ViewerDriver viewer({wardrobe.shirt(), "--paused"});
  const Json dressed = dressByDrop(viewer, wardrobe);
  viewer.tap("ctrl+z");
  viewer.waitUntil("the cloth before", [](const Json& s) { return !s["placed"].get<bool>() && says(s, "dressing"); });
  viewer.tap("ctrl+y");
  const Json again = viewer.waitUntil("the dressed body again", isDressed);
  EXPECT_EQ(again["cloth_bounds"], dressed["cloth_bounds"]);
  viewer.waitUntil("no body in the cloth", [](const Json& s) { return s["piercing"].is_null(); });
}

TEST(DressingInTheWindow, ADressedBodyIsSavedWithItsStartAndKeepsTheRestShapeOfTheGarment) {
  const Wardrobe wardrobe;
  ViewerDriver viewer({wardrobe.shirt(), "--paused"});
  dressByDrop(viewer, wardrobe);
  viewer.key("ctrl+s");
  viewer.waitUntil("the scene file", [](const Json& s) { return says(s, "shirt-001_start.obj"); });
  EXPECT_EQ(pairsIn(viewer.folder() / "shirt-001_start.obj", "mannequin.obj"), 0U);
  std::ostringstream scene;
  scene << std::ifstream(viewer.folder() / "shirt-001.toml").rdbuf();
  EXPECT_NE(scene.str().find("shirt.obj'"), std::string::npos) << scene.str();
  EXPECT_NE(scene.str().find("start = 'shirt-001_start.obj'"), std::string::npos) << scene.str();
  const auto output = viewer.folder() / "output.txt";
  const int status = runToEnd({.command = {DRAPE_HEADLESS, "run", (viewer.folder() / "shirt-001.toml").string(),
                                           "--seconds", "0.02", "--check-intersections", "1"},
                               .output = output});
  std::ostringstream text;
  text << std::ifstream(output).rdbuf();
  EXPECT_EQ(status, 0) << text.str();
  EXPECT_NE(text.str().find("intersecting triangle pairs: none"), std::string::npos) << text.str();
}

TEST(DressingInTheWindow, ADroppedBodyInAnotherUnitIsPlacedMovedAndThenDressed) {
  const Wardrobe wardrobe;
  ViewerDriver viewer({wardrobe.shirt(), "--paused"});
  ASSERT_TRUE(viewer.drop({wardrobe.bodyInCentimetres()}));
  viewer.waitUntil("the facts", [](const Json& s) { return hasButton(s, "drop.1.unit=inch"); });
  viewer.click(viewer.find("button.drop.place"));
  const auto isPlaced = [](const Json& s) {
    return !s["placing"].is_null() && !s["placing"]["builds"].get<bool>() && s["dressing"].is_null() &&
           s["loading"].get<std::string>().empty();
  };
  const Json placed = viewer.waitUntil("the garment on the body", [&](const Json& s) {
    return isPlaced(s) && !s["piercing"].is_null();  // nothing was removed yet
  });
  EXPECT_FALSE(placed["placed"].get<bool>());
  EXPECT_EQ(placed["placing"]["unit"], "m");
  const auto left = [](const Json& s) { return s["cloth_bounds"]["min"][0].get<double>(); };
  const Json grip = viewer.waitUntil("the handle", [](const Json& s) { return hasButton(s, "gizmo.x"); });
  const Json arrow = grip["buttons"]["gizmo.x"];
  const Place from{arrow["x"].get<double>() + 0.5 * arrow["width"].get<double>(),
                   arrow["y"].get<double>() + 0.5 * arrow["height"].get<double>()};
  viewer.move(from);
  viewer.press();
  viewer.move({from.x + 2.0, from.y});
  viewer.move({from.x + 4.0, from.y});
  viewer.release();
  viewer.waitUntil("the moved garment", [&](const Json& s) { return isPlaced(s) && left(s) > left(placed) + 0.001; });
  viewer.click(viewer.find("button.dress_placed"));
  const Json dressed = viewer.waitUntil("the dressed body", isDressed);
  EXPECT_TRUE(says(dressed, "from where you placed it")) << dressed["message"];
  EXPECT_TRUE(dressed["placing"].is_null());
  viewer.waitUntil("no body in the cloth", [](const Json& s) { return s["piercing"].is_null(); });
  EXPECT_TRUE(viewer.state()["paused"].get<bool>()) << "as before";
}

TEST(DressingInTheWindow, AnotherUnitBeforeAndAfterPlacingIsAppliedAtOnce) {
  const Wardrobe wardrobe;
  ViewerDriver viewer({wardrobe.shirt(), "--paused"});
  ASSERT_TRUE(
      viewer.drop({wardrobe.body("anna.obj")}));  // a body since it is closed, although its name does not say so
  viewer.waitUntil("the facts", [](const Json& s) { return hasButton(s, "drop.0.unit=foot"); });
  EXPECT_EQ(viewer.state()["scene"], "shirt.obj") << "until the user answers";
  viewer.click(viewer.find("drop.0.unit=foot"));
  viewer.click(viewer.find("button.drop.place"));
  const auto height = [](const Json& s) {
    return s["cloth_bounds"]["max"][1].get<double>() - s["cloth_bounds"]["min"][1].get<double>();
  };
  const auto isPlaced = [](const Json& s) {
    return !s["placing"].is_null() && !s["placing"]["builds"].get<bool>() && s["loading"].get<std::string>().empty();
  };
  const Json small = viewer.waitUntil("the small garment", isPlaced);
  EXPECT_LT(height(small), 0.4);
  EXPECT_EQ(small["placing"]["unit"], "foot");
  viewer.click(viewer.find("placing.unit=m"));
  const Json large = viewer.waitUntil("the garment in metres",
                                      [&](const Json& s) { return isPlaced(s) && s["placing"]["unit"] == "m"; });
  EXPECT_NEAR(height(large), height(small) / 0.3048, 1e-4);
  viewer.tap("ctrl+z");
  const Json back = viewer.waitUntil("the garment in feet",
                                     [&](const Json& s) { return isPlaced(s) && s["placing"]["unit"] == "foot"; });
  EXPECT_NEAR(height(back), height(small), 1e-6);
}

TEST(DressingInTheWindow, AClipThatIsChosenForADroppedBodyMovesItAndIsReplayed) {
  const TemporaryFolder folder;
  const std::filesystem::path body = animatedPost(folder);
  const auto log = folder.path() / "session.json";
  const Wardrobe wardrobe;
  ViewerDriver viewer({wardrobe.shirt(), "--record", log.string()});
  ASSERT_TRUE(viewer.drop({body.string()}));
  viewer.waitUntil("the list of clips", [](const Json& s) { return hasButton(s, "drop.1.motion"); });
  viewer.click(viewer.find("drop.1.motion"));
  viewer.waitUntil("the clips", [](const Json& s) { return hasButton(s, "drop.1.motion.1"); });
  viewer.click(viewer.find("drop.1.motion.0"));
  viewer.waitUntil("the choice", [](const Json& s) { return !hasButton(s, "drop.1.motion.1"); });
  viewer.click(viewer.find("button.drop.open"));
  viewer.waitUntil("the body", [](const Json& s) { return s["bodies"].size() == 1; });
  viewer.waitUntil("some steps", [](const Json& s) { return s["step"] > 5; });
  viewer.tap("ctrl+q");
  ASSERT_EQ(viewer.process().waitFor(60.0), 0);
  std::ifstream text(log);
  EXPECT_EQ(Json::parse(text)["clips"], Json::array({"bend"}));
  expectReplay(log);
}

TEST(DressingInTheWindow, AnotherClipOfTheBodyIsChosenInThePanelAndTheGarmentStaysDressed) {
  const TemporaryFolder folder;
  const std::filesystem::path body = animatedPost(folder);
  const auto log = folder.path() / "session.json";
  // A skirt around a post.
  ViewerDriver viewer(
      {"dress", "builtin:skirt.obj", body.string(), "--clip", "bend", "--body-unit", "dm", "--record", log.string()});
  const auto isWorn = [](const Json& s) { return isDressed(s) && s["step"] > 2; };
  const Json bends = viewer.waitUntil("the dressed body", isWorn);
  EXPECT_EQ(bends["bodies"][0]["clip"], "bend");

  viewer.click(viewer.find("body.body.clip"));
  viewer.waitUntil("the clips", [](const Json& s) { return hasButton(s, "body.body.clip=still"); });
  viewer.click(viewer.find("body.body.clip=still"));
  const auto hasClip = [](const char* clip) {
    return [clip](const Json& s) { return s["bodies"].size() == 1 && s["bodies"][0]["clip"] == clip; };
  };
  viewer.waitUntil("the other clip", hasClip("still"));
  viewer.waitUntil("the garment where it was dressed", isWorn);
  viewer.tap("ctrl+z");
  viewer.waitUntil("the clip before", hasClip("bend"));
  viewer.tap("ctrl+y");
  viewer.waitUntil("the other clip again", hasClip("still"));
  viewer.waitUntil("the dressed body again", isWorn);
  quitWithQuestion(viewer);
  expectReplay(log);
}

TEST(DressingInTheWindow, AGarmentThatIsDroppedOnABodyIsWornAfterOneClick) {
  const Wardrobe wardrobe;
  ViewerDriver viewer({"mannequin", "--paused"});
  ASSERT_TRUE(viewer.drop({wardrobe.shirt()}));
  viewer.waitUntil("the question", [](const Json& s) { return hasButton(s, "button.drop.dress"); });
  viewer.click(viewer.find("button.drop.dress"));
  const Json dressed = viewer.waitUntil("the dressed body", isDressed);
  EXPECT_EQ(dressed["scene"], "shirt.obj");
  viewer.waitUntil("no body in the cloth", [](const Json& s) { return s["piercing"].is_null(); });
}

TEST(DressingInTheWindow, AStartThatABodyPassesThroughIsNamedAndCuredByOneClick) {
  const Wardrobe wardrobe;
  ViewerDriver viewer({"grid", "--paused"});
  ASSERT_TRUE(viewer.drop({wardrobe.shirt(), wardrobe.body()}));
  viewer.waitUntil("the question", [](const Json& s) { return hasButton(s, "button.drop.open"); });
  viewer.click(viewer.find("button.drop.open"));
  const Json pierced = viewer.waitUntil("the line", [](const Json& s) { return hasButton(s, "pierced.dress"); });
  EXPECT_EQ(pierced["step"], 0) << "before the run";
  EXPECT_GT(pierced["piercing"]["pairs"], 100);
  EXPECT_NE(pierced["piercing"]["words"].get<std::string>().find("arm passes through the sleeve's wall"),
            std::string::npos)
      << pierced["piercing"];
  viewer.click(viewer.find("pierced.dress"));
  viewer.waitUntil("the dressed body", isDressed);
  viewer.waitUntil("no line",
                   [](const Json& s) { return s["piercing"].is_null() && !s["buttons"].contains("pierced.dress"); });
  EXPECT_EQ(pairsIn(savedCloth(viewer, "shirt-001.obj"), "mannequin.obj"), 0U);
}

TEST(DressingInTheWindow, AMovingClothThatABodyPassesThroughIsCuredAndGoesOn) {
  // Without contact for a moment the cloth falls into the body. Slow motion keeps contact from freeing it before the
  // click.
  ViewerDriver viewer({"mannequin", "--paused", "--set", "bodies=off", "time_step=0.01", "speed=0.01"});
  viewer.send({"key", "--repeat", "25", "--delay", "60", "period"});
  viewer.waitUntil("a fall", [](const Json& s) { return s["step"] > 18; });
  EXPECT_TRUE(viewer.state()["piercing"].is_null()) << "bodies are off";
  viewer.click(viewer.find("bodies"));
  viewer.key("space");
  viewer.waitUntil("the line", [](const Json& s) { return hasButton(s, "pierced.dress"); });
  viewer.click(viewer.find("pierced.dress"));
  viewer.waitUntil("the end", [](const Json& s) { return s["dressing"].is_null() && s["piercing"].is_null(); });
  viewer.waitUntil("motion", [](const Json& s) { return !s["paused"].get<bool>(); });
  viewer.key("space");
  viewer.waitUntil("a pause", [](const Json& s) { return s["paused"].get<bool>(); });
  EXPECT_EQ(pairsIn(savedCloth(viewer, "mannequin-001.obj"), "mannequin.obj"), 0U);
}

TEST(DressingInTheWindow, TheCommandDressOpensTheDressedBodyAndItsSessionReplays) {
  const TemporaryFolder folder;
  const auto log = folder.path() / "session.json";
  ViewerDriver viewer({"--record", log.string(), "dress", "builtin:tshirt.obj", "mannequin", "--place", "file",
                       "--move", "0", "-0.03", "0.04"});
  viewer.waitUntil("the dressed body", isDressed);
  const Json moving = viewer.waitUntil("some steps", [](const Json& s) { return s["step"] > 5; });
  EXPECT_FALSE(moving["paused"].get<bool>());
  viewer.tap("ctrl+q");
  ASSERT_EQ(viewer.process().waitFor(60.0), 0);
  expectReplay(log);
}

TEST(DressingInTheWindow, AGarmentThatCannotBeWornStaysAndTheReasonIsShown) {
  ViewerDriver viewer({"dress", "builtin:tshirt.obj", "mannequin", "--place", "file", "--move", "0", "0.3", "0"});
  const Json failed = viewer.waitUntil("the reason", [](const Json& s) { return hasButton(s, "overlay.error"); });
  EXPECT_TRUE(says(failed, "the right arm passes through the sleeve's wall")) << failed["message"];
  EXPECT_FALSE(failed["placed"].get<bool>());
}

TEST(DressingInTheWindow, EscapeCancelsIt) {
  ViewerDriver viewer(
      {"dress", "builtin:tshirt.obj", "mannequin", "--place", "file", "--move", "0", "-0.03", "0.04", "--paused"});
  viewer.waitUntil("the progress", [](const Json& s) { return hasButton(s, "button.cancel_dressing"); });
  viewer.tap("Escape");
  const Json ended = viewer.waitUntil("the end", [](const Json& s) { return s["dressing"].is_null(); });
  EXPECT_FALSE(ended["placed"].get<bool>());
  EXPECT_TRUE(viewer.process().running()) << "Escape did not quit";
}

TEST(DressingFromTheCommandLine, WrongUseIsNamed) {
  const TemporaryFolder folder;
  const auto output = folder.path() / "output.txt";
  const auto statusOf = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), DRAPE_PROGRAM);
    return runToEnd({.command = arguments, .environment = {{"DISPLAY", ""}}, .output = output});
  };
  EXPECT_EQ(statusOf({"dress", "builtin:tshirt.obj"}), 2) << "the body is missing";
  EXPECT_EQ(statusOf({"dress", "builtin:tshirt.obj", "mannequin", "--scale", "0"}), 2);
  EXPECT_EQ(statusOf({"dress", "builtin:tshirt.obj", "somebody"}), 1);
  std::ifstream text(output);
  const std::string words{std::istreambuf_iterator<char>(text), {}};
  EXPECT_NE(words.find("no mesh file"), std::string::npos) << words;
}

}  // namespace
}  // namespace drape::app
