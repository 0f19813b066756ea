#include "intersection/intersections.hpp"
#include "program.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace drape::app::testing {
namespace {

/// The vertices and triangles of an OBJ file, without texture coordinates.
struct ObjMesh {
  std::vector<Eigen::Vector3d> positions;
  std::vector<std::array<int, 3>> triangles;

  explicit ObjMesh(const std::filesystem::path& file) {
    std::istringstream text(readFile(file));
    for (std::string line; std::getline(text, line);) {
      std::istringstream words(line);
      std::string keyword;
      words >> keyword;
      if (keyword == "v") {
        Eigen::Vector3d position;
        words >> position.x() >> position.y() >> position.z();
        positions.push_back(position);
      } else if (keyword == "f") {
        std::array<int, 3> triangle{};
        for (int& corner : triangle) {
          std::string word;
          words >> word;
          corner = std::stoi(word) - 1;
        }
        triangles.push_back(triangle);
      }
    }
  }

  [[nodiscard]] std::size_t intersectingPairs() const {
    return intersection::intersectingPairs({positions, triangles}).size();
  }
};

/// The largest distance between corresponding corners of two meshes with the same triangles, whose vertices may have
/// other numbers [m].
double largestMotion(const ObjMesh& before, const ObjMesh& after) {
  EXPECT_EQ(after.positions.size(), before.positions.size());
  EXPECT_EQ(after.triangles.size(), before.triangles.size());
  double largest = 0.0;
  for (std::size_t t = 0; t < after.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Eigen::Vector3d& corner = before.positions[before.triangles[t][k]];
      largest = std::max(largest, (after.positions[after.triangles[t][k]] - corner).norm());
    }
  }
  return largest;
}

/// Writes sheets of n x n vertices.
/// @param at the position of a vertex: of sheet number i at (u, v) from 0 to 1
std::string writeSheets(const std::filesystem::path& file, int sheets, int n,
                        const std::function<Eigen::Vector3d(int i, double u, double v)>& at) {
  std::ofstream text(file);
  for (int sheet = 0; sheet < sheets; ++sheet) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const Eigen::Vector3d position = at(sheet, static_cast<double>(i) / (n - 1), static_cast<double>(j) / (n - 1));
        text << "v " << position.x() << ' ' << position.y() << ' ' << position.z() << '\n';
      }
    }
  }
  for (int sheet = 0; sheet < sheets; ++sheet) {
    for (int j = 0; j + 1 < n; ++j) {
      for (int i = 0; i + 1 < n; ++i) {
        const int a = sheet * n * n + j * n + i + 1;
        text << "f " << a << ' ' << a + 1 << ' ' << a + n + 1 << "\nf " << a << ' ' << a + n + 1 << ' ' << a + n
             << '\n';
      }
    }
  }
  return file.string();
}

/// Writes two upright sheets of n x n vertices. The second one crosses the first in a strip.
std::string crossingSheets(const std::filesystem::path& folder, int n) {
  return writeSheets(folder / "crossing.obj", 2, n, [](int sheet, double u, double v) {
    const double bulge = 0.06 * std::exp(-20.0 * (u - 0.45) * (u - 0.45));
    return Eigen::Vector3d(0.5 * u + 0.017 * sheet, v, sheet == 0 ? 0.0 : bulge - 0.03);
  });
}

TEST(Untangle, writesTheSameMeshWithoutIntersections) {
  const auto folder = testFolder();
  const std::string input = crossingSheets(folder, 16);
  const ObjMesh before(input);
  ASSERT_GT(before.intersectingPairs(), 20U);
  const auto output = folder / "free.obj";
  const Outcome outcome = headless("untangle " + input + " " + output.string());
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find(std::to_string(before.intersectingPairs()) + " pairs of triangles intersected"),
            std::string::npos)
      << outcome.output;
  const ObjMesh after(output);
  EXPECT_EQ(after.intersectingPairs(), 0U);
  EXPECT_LT(largestMotion(before, after), 0.1);
  // The result does not intersect when it is simulated either.
  const Outcome run = headless("run " + output.string() + " --seconds 0.1 --check-intersections 1");
  EXPECT_NE(run.output.find("intersecting triangle pairs: none"), std::string::npos) << run.output << run.errors;
}

TEST(Untangle, separatesPatternPiecesThatLieInOnePlane) {
  const auto folder = testFolder();
  const std::string input = writeSheets(folder / "pieces.obj", 3, 12, [](int sheet, double u, double v) {
    return Eigen::Vector3d(0.4 * u + 0.01 * sheet, 0.6 * v, 0.0);
  });
  const auto output = folder / "free.obj";
  ASSERT_GT(ObjMesh(input).intersectingPairs(), 500U);
  const Outcome outcome = headless("untangle " + input + " " + output.string());
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(ObjMesh(output).intersectingPairs(), 0U);
}

TEST(Untangle, separatesTheLayersOfASheetThatIsFoldedFlatLikeALetter) {
  const auto folder = testFolder();
  // Each third has another width, so that no vertices coincide.
  const std::string input = writeSheets(folder / "letter.obj", 1, 19, [](int /*sheet*/, double u, double v) {
    const double first = 0.3 * std::min(u, 1.0 / 3.0);
    const double second = 0.27 * std::clamp(u - 1.0 / 3.0, 0.0, 1.0 / 3.0);
    const double third = 0.25 * std::max(0.0, u - 2.0 / 3.0);
    return Eigen::Vector3d(3.0 * (first - second + third), 0.4 * v, 0.0);
  });
  const auto output = folder / "free.obj";
  const ObjMesh before(input);
  ASSERT_GT(before.intersectingPairs(), 500U);
  const Outcome outcome = headless("untangle " + input + " " + output.string());
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  const ObjMesh after(output);
  EXPECT_EQ(after.intersectingPairs(), 0U);
  EXPECT_LT(largestMotion(before, after), 0.02);
}

TEST(Untangle, doesNotChangeAMeshWithoutIntersections) {
  const auto output = testFolder() / "flag.obj";
  const Outcome outcome = headless("untangle grid --set grid.resolution=3 " + output.string());
  EXPECT_NE(outcome.output.find("no triangles intersected"), std::string::npos) << outcome.output << outcome.errors;
  for (const Eigen::Vector3d& position : ObjMesh(output).positions) {
    EXPECT_EQ((2.0 * position.x()), std::round(2.0 * position.x()));
    EXPECT_EQ(position.y(), 1.3);
  }
}

TEST(Untangle, writesTheLastPositionsAndFailsWhenTheTimeIsOver) {
  const auto folder = testFolder();
  const auto output = folder / "unfinished.obj";
  const Outcome outcome =
      headless("untangle " + crossingSheets(folder, 16) + " " + output.string() + " --max-seconds 0.02");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.errors.find("still intersect"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("--max-seconds"), std::string::npos) << outcome.errors;
  EXPECT_GT(ObjMesh(output).intersectingPairs(), 0U);
}

TEST(Untangle, refusesOutputsThatItCannotWrite) {
  const auto folder = testFolder();
  const std::string input = crossingSheets(folder, 5);
  const Outcome format = headless("untangle " + input + " " + (folder / "free.ply").string());
  EXPECT_EQ(format.status, 2);
  EXPECT_NE(format.errors.find(".obj"), std::string::npos) << format.errors;
  const Outcome nowhere = headless("untangle " + input + " /nowhere/free.obj");
  EXPECT_EQ(nowhere.status, 1);
  EXPECT_NE(nowhere.errors.find("/nowhere/free.obj"), std::string::npos) << nowhere.errors;
  EXPECT_EQ(headless("untangle " + input).status, 2);
}

}  // namespace
}  // namespace drape::app::testing
