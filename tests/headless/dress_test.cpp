#include "animation_files.hpp"
#include "program.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace drape::app::testing {
namespace {

const std::string assets = std::string(DRAPE_SOURCE) + "/assets/meshes/";

/// The lines of an OBJ file that start with one of the keywords.
std::vector<std::string> linesOf(const std::filesystem::path& file, const std::string& keyword) {
  std::istringstream text(readFile(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with(keyword + " ")) {
      lines.push_back(line);
    }
  }
  return lines;
}

/// A closed or open box of 12 triangles as an OBJ file.
std::string boxFile(const std::filesystem::path& file, double side, bool open) {
  std::ofstream text(file);
  for (int k = 0; k < 8; ++k) {
    text << "v " << side * (k & 1) << ' ' << side * ((k >> 1) & 1) << ' ' << side * ((k >> 2) & 1) << '\n';
  }
  text << "f 1 3 4\nf 1 4 2\nf 5 6 8\nf 5 8 7\nf 1 2 6\nf 1 6 5\nf 3 7 8\nf 3 8 4\nf 1 5 7\nf 1 7 3\n";
  text << (open ? "" : "f 2 4 8\nf 2 8 6\n");
  return file.string();
}

/// A tube around the vertical through (0.5, 0, 0.5) as an OBJ file.
std::string tubeFile(const std::filesystem::path& file, double radius, double bottom, double top) {
  constexpr int around = 24;
  std::ofstream text(file);
  for (int k = 0; k < 2 * around; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / around;
    text << "v " << 0.5 + radius * std::cos(angle) << ' ' << (k < around ? bottom : top) << ' '
         << 0.5 + radius * std::sin(angle) << '\n';
  }
  for (int k = 0; k < around; ++k) {
    const int next = (k + 1) % around;
    text << "f " << k + 1 << ' ' << k + 1 + around << ' ' << next + 1 << '\n';
    text << "f " << next + 1 << ' ' << k + 1 + around << ' ' << next + 1 + around << '\n';
  }
  return file.string();
}

/// A mesh of the tree whose vertices are moved, without its texture coordinates, as an OBJ file.
std::string movedMesh(const std::filesystem::path& file, const std::string& mesh,
                      const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& move) {
  std::ofstream text(file);
  for (const std::string& line : linesOf(assets + mesh, "v")) {
    std::istringstream words(line.substr(2));
    Eigen::Vector3d point;
    words >> point.x() >> point.y() >> point.z();
    text << "v " << move(point).transpose() << '\n';
  }
  for (const std::string& line : linesOf(assets + mesh, "f")) {
    std::istringstream words(line.substr(2));
    text << 'f';
    for (std::string word; words >> word;) {
      text << ' ' << word.substr(0, word.find('/'));
    }
    text << '\n';
  }
  return file.string();
}

std::string failure(const std::string& arguments) {
  const Outcome outcome = headless("dress " + arguments);
  EXPECT_EQ(outcome.status, 1) << arguments << outcome.output << outcome.errors;
  return outcome.errors;
}

TEST(Dress, refusesABodyOfTooManyTriangles) {
  const auto folder = testFolder();
  const auto file = folder / "scan.obj";
  std::ofstream text(file);
  text << "v 0 0 0\nv 1 0 0\nv 0 1.7 0\n";
  for (int face = 0; face < 300'001; ++face) {
    text << "f 1 2 3\n";
  }
  text.close();
  const std::string error =
      failure("builtin:tshirt.obj " + file.string() + " --output " + (folder / "out.obj").string());
  EXPECT_NE(error.find(file.string() + ": it has 300001 triangles, and the limit for this body is 300000"),
            std::string::npos)
      << error;
  EXPECT_FALSE(std::filesystem::exists(folder / "out.obj"));
}

TEST(Dress, writesAGarmentThatFitsTheFileAndSimulatesOnTheBody) {
  const auto folder = testFolder();
  const auto output = folder / "fitted.obj";
  const auto scene = folder / "fitted.toml";
  const Outcome outcome = headless("dress builtin:tshirt.obj mannequin --place file --move 0 -0.03 0.04 --output " +
                                   output.string() + " --scene " + scene.string());
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("pairs of triangles of the garment with the body"), std::string::npos);
  EXPECT_NE(outcome.output.find("no triangles at the end"), std::string::npos) << outcome.output;
  EXPECT_EQ(linesOf(output, "v").size(), linesOf(assets + "tshirt.obj", "v").size());
  EXPECT_EQ(linesOf(output, "vt").size(), linesOf(assets + "tshirt.obj", "vt").size());
  EXPECT_EQ(linesOf(output, "f").size(), linesOf(assets + "tshirt.obj", "f").size());
  const std::string text = readFile(scene);
  EXPECT_NE(text.find("title = 'tshirt.obj'"), std::string::npos) << text;
  EXPECT_NE(text.find("mesh = 'builtin:tshirt.obj'"), std::string::npos) << text;  // the rest shape
  EXPECT_NE(text.find("start = 'fitted.obj'"), std::string::npos) << text;
  const Outcome run = headless("run " + scene.string() + " --seconds 0.1 --check-intersections 1");
  EXPECT_NE(run.output.find("intersecting triangle pairs: none"), std::string::npos) << run.output << run.errors;
}

TEST(Dress, replacesFilesOnlyIfAskedToAndNeverItsInput) {
  const auto folder = testFolder();
  const auto output = folder / "fitted.obj";
  const auto scene = folder / "fitted.toml";
  const std::string arguments = "dress builtin:tshirt.obj mannequin --place file --move 0 -0.03 0.04 --output " +
                                output.string() + " --scene " + scene.string();
  std::ofstream(output) << "old";
  std::ofstream(scene) << "old";
  EXPECT_EQ(headless(arguments).status, 1);
  EXPECT_EQ(readFile(output), "old");
  const Outcome outcome = headless(arguments + " --replace");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_FALSE(linesOf(output, "f").empty());
  EXPECT_NE(readFile(scene).find("start = 'fitted.obj'"), std::string::npos);
  const std::string garment = readFile(output);
  EXPECT_EQ(headless("dress " + output.string() + " mannequin --output " + output.string() + " --replace").status, 2);
  EXPECT_EQ(readFile(output), garment);
}

TEST(Dress, fitsTheGarmentToTheBindPoseOfAFigureThatAClipMovesAfterwards) {
  const auto folder = testFolder();
  io::BarFile bar;
  bar.isSolid = true;
  bar.upperPose = R"(,"rotation":[0,0,0.70710678,0.70710678])";
  std::ofstream(folder / "bar.gltf") << bar.text();
  const std::string tube = tubeFile(folder / "tube.obj", 0.68, 0.1, 0.9);
  const std::string scene = (folder / "fitted.toml").string();
  const std::string arguments = tube + " " + (folder / "bar.gltf").string() + " --place file --set unit=m --set up=y" +
                                " --output " + (folder / "fitted.obj").string() + " --scene " + scene;
  EXPECT_NE(failure(arguments + " --clip jump").find("Choose one of 'bend', 'still'"), std::string::npos);
  EXPECT_NE(failure(arguments + " --clip bend --body-up z").find("leave --body-unit and --body-up out"),
            std::string::npos);
  const Outcome outcome = headless("dress " + arguments + " --clip bend");
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(readFile(scene).find("animation = { clip = 'bend', rate = 60, loop = true, blend = 1 }"), std::string::npos)
      << readFile(scene);
  const Outcome run = headless("run " + scene + " --seconds 1.5 --check-intersections 5");
  EXPECT_NE(run.output.find("intersecting triangle pairs: none"), std::string::npos) << run.output << run.errors;
  EXPECT_NE(failure("builtin:tshirt.obj mannequin --clip walk --output " + (folder / "shirt.obj").string())
                .find("'mannequin' has no clips"),
            std::string::npos);
}

TEST(Dress, keepsTheUnitOfTheFileWhereTheGarmentIsScaled) {
  const auto folder = testFolder();
  const std::string garment = movedMesh(folder / "centimetres.obj", "cape.obj",
                                        [](const Eigen::Vector3d& p) -> Eigen::Vector3d { return 100.0 * p; });
  const auto output = folder / "fitted.obj";
  const Outcome outcome = headless("dress " + garment + " mannequin --scale 1.1 --set up=y --output " +
                                   output.string() + " --scene " + (folder / "fitted.toml").string());
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  double low = 1e9;
  double high = -1e9;
  for (const std::string& line : linesOf(output, "v")) {
    std::istringstream words(line.substr(2));
    double x = 0.0;
    double y = 0.0;
    words >> x >> y;
    low = std::min(low, y);
    high = std::max(high, y);
  }
  EXPECT_NEAR(high - low, 110.0 * 0.902, 3.0);  // the cape is 0.902 m tall
  const Outcome run = headless("run " + (folder / "fitted.toml").string() + " --seconds 0.02 --check-intersections 1");
  EXPECT_NE(run.output.find("intersecting triangle pairs: none"), std::string::npos) << run.output << run.errors;
}

TEST(Dress, readsTheBodyInItsOwnUnitAndTellsWhatItFound) {
  const auto folder = testFolder();
  const std::string body = movedMesh(
      folder / "body.obj", "mannequin.obj",
      [](const Eigen::Vector3d& p) -> Eigen::Vector3d { return Eigen::Vector3d(p.x(), -p.z(), p.y()) / 0.0254; });
  const auto scene = folder / "fitted.toml";
  const std::string arguments = "dress builtin:tshirt.obj " + body + " --output ";
  const Outcome outcome = headless(arguments + (folder / "fitted.obj").string() + " --scene " + scene.string());
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  for (const char* fact : {"unit: inches (the size of a person)", "up axis: z (by its shape)", "1 piece, ",
                           "m (width x height x depth)", "unit: metres (as the file format prescribes)"}) {
    EXPECT_NE(outcome.output.find(fact), std::string::npos) << fact << " is not in " << outcome.output;
  }
  const Outcome run = headless("run " + scene.string() + " --seconds 0.1 --check-intersections 1");
  EXPECT_NE(run.output.find("intersecting triangle pairs: none"), std::string::npos) << run.output << run.errors;
  const Outcome tiny = headless(arguments + (folder / "tiny.obj").string() + " --body-unit mm --body-up z");
  EXPECT_EQ(tiny.status, 1);
  EXPECT_NE(tiny.output.find("unit: millimetres (chosen)"), std::string::npos) << tiny.output;
  EXPECT_NE(tiny.output.find("up axis: z (chosen)"), std::string::npos) << tiny.output;
  const Outcome giant = headless(arguments + (folder / "giant.obj").string() + " --body-unit dm --body-up z");
  EXPECT_NE(giant.errors.find("the body is 6.87 m tall, more than a person"), std::string::npos) << giant.errors;
  EXPECT_NE(failure("builtin:tshirt.obj mannequin --body-unit cm --output " + (folder / "no.obj").string())
                .find("the body mannequin is built in"),
            std::string::npos);
  EXPECT_EQ(headless(arguments + "out.obj --body-unit parsec").status, 2);
  EXPECT_EQ(headless(arguments + "out.obj --body-up sideways").status, 2);
}

TEST(Dress, saysWhatIsWrongWithBadInput) {
  const auto folder = testFolder();
  const std::string shirt = assets + "tshirt.obj";
  const std::string to = " --output " + (folder / "out.obj").string();
  const std::string open = boxFile(folder / "open.obj", 1.0, true);
  EXPECT_NE(failure(shirt + " " + open + to).find("the body has holes that are too large"), std::string::npos);
  const std::string box = boxFile(folder / "box.obj", 1.0, false);
  EXPECT_NE(failure(shirt + " " + box + " --set unit=66" + to).find("cannot wear"), std::string::npos);
  EXPECT_NE(failure(shirt + " " + (folder / "none.obj").string() + to).find("no such file"), std::string::npos);
  EXPECT_NE(failure((folder / "none.obj").string() + " mannequin" + to).find("none.obj"), std::string::npos);
  EXPECT_NE(failure(shirt + " somebody" + to).find("no mesh file"), std::string::npos);
  EXPECT_NE(failure("builtin:none.obj mannequin" + to).find("built-in meshes are"), std::string::npos);
  EXPECT_NE(failure("flag mannequin" + to).find("the garment must be a mesh"), std::string::npos);
  EXPECT_NE(failure(shirt + " mannequin --output " + (folder / "no" / "out.obj").string()).find("out.obj"),
            std::string::npos);
  EXPECT_NE(failure(shirt + " mannequin --output " + box).find("exists; choose another name, or give --replace"),
            std::string::npos);
  EXPECT_NE(failure(shirt + " mannequin --scene " + (folder / "no" / "out.toml").string() + to).find("out.toml"),
            std::string::npos);
  const Outcome unknown = headless("dress " + shirt + " mannequin --output " + (folder / "out.xyz").string());
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.errors.find("out.xyz"), std::string::npos) << unknown.errors;
  const std::string raised = failure(shirt + " mannequin --place file --move 0 0.3 0" + to);
  EXPECT_NE(raised.find("the right arm passes through the sleeve's wall"), std::string::npos) << raised;
  EXPECT_FALSE(std::filesystem::exists(folder / "out.obj"));
}

TEST(PiercedStart, isNamedBeforeARun) {
  const auto folder = testFolder();
  std::ofstream(folder / "pierced.toml") << "[cloth]\nmesh = \"" << assets << "tshirt.obj\"\nposition = [0, 0.2, 0]\n"
                                         << "[[bodies]]\nshape = \"mesh\"\nmesh = \"builtin:mannequin.obj\"\n";
  const std::string scene = (folder / "pierced.toml").string();
  const Outcome named = headless("run " + scene + " --seconds 0.01");
  EXPECT_NE(named.errors.find("left arm passes through the sleeve's wall"), std::string::npos) << named.errors;
  EXPECT_NE(named.errors.find("drape-headless dress"), std::string::npos) << named.errors;
  EXPECT_EQ(headless("run " + scene + " --seconds 0.01 --set bodies=off").errors.find("passes"), std::string::npos);
  EXPECT_EQ(headless("run mannequin --seconds 0.01").errors, "");
}

TEST(Dress, refusesOptionsOutOfRange) {
  const std::string start = "dress " + assets + "tshirt.obj mannequin --output x.obj ";
  for (const char* options :
       {"--move 0 0 11", "--move 0 0", "--turn 400", "--scale 0", "--place best", "--max-seconds -1"}) {
    EXPECT_EQ(headless(start + options).status, 2) << options;
  }
  const Outcome outcome = headless("dress builtin:tshirt.obj mannequin --output x.glb --scene x.toml");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.errors.find("a scene needs the garment as an OBJ file"), std::string::npos) << outcome.errors;
}

}  // namespace
}  // namespace drape::app::testing
