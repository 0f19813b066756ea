#include "io/garments/garments.hpp"

#include "intersection/intersections.hpp"
#include "io/mesh_import.hpp"
#include "sim/model/enclosed_volume.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace drape::io {
namespace {

ImportedMesh welded(const RawMesh& raw) {
  return weldMesh(raw, "garment", {});
}

intersection::Surface trianglesOf(const ImportedMesh& mesh) {
  return {mesh.cloth.positions, mesh.cloth.triangles};
}

/// The ratio of the longest and the shortest edge.
double edgeRatio(const sim::ClothMesh& mesh) {
  double shortest = HUGE_VAL;
  double longest = 0.0;
  for (const Triangle& triangle : mesh.triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Vec3& a = mesh.positions[triangle[corner]];
      const Vec3& b = mesh.positions[triangle[(corner + 1) % 3]];
      shortest = std::min(shortest, (a - b).norm());
      longest = std::max(longest, (a - b).norm());
    }
  }
  return longest / shortest;
}

void expectSoundGarment(const ImportedMesh& mesh, int borders) {
  EXPECT_TRUE(mesh.summary.warnings.empty()) << mesh.summary.warnings.front();
  EXPECT_EQ(mesh.summary.components, 1);
  EXPECT_EQ(mesh.summary.boundaryLoops, borders);
  EXPECT_EQ(mesh.summary.nonManifoldEdges, 0);
  EXPECT_EQ(mesh.summary.misorientedEdges, 0);
  EXPECT_GT(mesh.render.particle.size(), mesh.cloth.positions.size()) << "seams split the texture";
  EXPECT_GT(mesh.summary.vertices, 1500);
  EXPECT_LT(mesh.summary.vertices, 2500);
  EXPECT_LT(edgeRatio(mesh.cloth), 3.5);
}

TEST(Garments, areMadeTheSameAsTheyAreKept) {
  for (const GarmentFile& file : garmentFiles()) {
    std::ostringstream kept;
    kept << std::ifstream(std::filesystem::path(DRAPE_MESH_FOLDER) / file.name, std::ios::binary).rdbuf();
    EXPECT_TRUE(kept.str() == file.text) << file.name << " differs: run drape-make-garments assets/meshes";
  }
}

TEST(Garments, includeASkirtWithAWaistAndAHem) {
  const ImportedMesh mesh = welded(makeSkirt());
  expectSoundGarment(mesh, 2);
  int atWaist = 0;
  for (const Vec3& position : mesh.cloth.positions) {
    EXPECT_GE(position.y(), garment::hemHeight - 1e-9);
    EXPECT_LE(position.y(), garment::waistHeight + 1e-9);
    if (position.y() > garment::waistHeight - 1e-6) {
      ++atWaist;
      EXPECT_NEAR(std::hypot(position.x(), position.z()), garment::waistRadius, 1e-6);
    }
  }
  EXPECT_GE(atWaist, 24);
}

TEST(Garments, includeAPonchoThatIsFoldedOverItsShoulderLine) {
  const ImportedMesh mesh = welded(makePoncho());
  expectSoundGarment(mesh, 2);
  int onLine = 0;
  for (const Vec3& position : mesh.cloth.positions) {
    EXPECT_LE(position.y(), garment::shoulderHeight + 1e-9);
    onLine += position.y() > garment::shoulderHeight - 1e-6 && std::abs(position.z()) < 1e-6 ? 1 : 0;
  }
  EXPECT_GE(onLine, 30);
}

TEST(Garments, includeATshirtThatIsOpenAtNeckSleevesAndHem) {
  const ImportedMesh mesh = welded(makeTshirt());
  expectSoundGarment(mesh, 4);
  int onShoulders = 0;
  for (const Vec3& position : mesh.cloth.positions) {
    const bool isOnLine = std::abs(position.x()) <= garment::shoulderHalfWidth + 1e-6 &&
                          std::abs(position.y() - garment::shoulderLine(position.x())) < 1e-6;
    onShoulders += isOnLine && std::abs(position.z()) < 1e-9 ? 1 : 0;
  }
  EXPECT_GE(onShoulders, 14);
}

TEST(Garments, standOnClosedStandsThatReachTheGround) {
  for (const RawMesh& raw : {makeSkirtStand(), makeHangerStand()}) {
    const ImportedMesh mesh = welded(raw);
    EXPECT_EQ(mesh.summary.boundaryLoops, 0);
    EXPECT_EQ(mesh.summary.nonManifoldEdges, 0);
    EXPECT_EQ(mesh.summary.misorientedEdges, 0);
    double lowest = HUGE_VAL;
    for (const Vec3& position : mesh.cloth.positions) {
      lowest = std::min(lowest, position.y());
    }
    EXPECT_DOUBLE_EQ(lowest, 0.0);
    EXPECT_GT(sim::enclosedVolume(mesh.cloth.positions, mesh.cloth.triangles), 1e-3) << "faces look outwards";
  }
}

void expectOneClosedSurface(const ImportedMesh& mesh) {
  EXPECT_EQ(mesh.summary.components, 1);
  EXPECT_EQ(mesh.summary.boundaryLoops, 0);
  EXPECT_EQ(mesh.summary.nonManifoldEdges, 0);
  EXPECT_EQ(mesh.summary.misorientedEdges, 0);
  EXPECT_EQ(mesh.summary.vertices - mesh.summary.springs + mesh.summary.triangles, 2) << "Euler's formula: no holes";
  EXPECT_EQ(intersection::intersectingPairs(trianglesOf(mesh)).size(), 0U);
}

TEST(Garments, lieAroundFiguresThatAreClosedSurfacesAndTouchThemNowhere) {
  const ImportedMesh mannequin = welded(makeMannequin());
  expectOneClosedSurface(mannequin);
  EXPECT_NEAR(mannequin.summary.size[1], 1.74, 0.01);
  const ImportedMesh skater = welded(makeSkater());
  expectOneClosedSurface(skater);
  EXPECT_NEAR(skater.summary.size[1], 1.67, 0.02);
  const ImportedMesh tshirt = welded(makeTshirt());
  EXPECT_EQ(intersection::intersectingPairs(trianglesOf(tshirt), trianglesOf(mannequin)).size(), 0U);
  const ImportedMesh cape = welded(makeCape());
  EXPECT_EQ(intersection::intersectingPairs(trianglesOf(cape), trianglesOf(skater)).size(), 0U);
}

TEST(Garments, includeAFigureWithClothesThatTouchNeitherItNorEachOther) {
  const ImportedMesh figure = welded(makeFigure());
  expectOneClosedSurface(figure);
  EXPECT_NEAR(figure.summary.size[1], 1.75, 0.01);
  const ImportedMesh skirt = welded(makeFittedSkirt());
  const ImportedMesh tshirt = welded(makeShortTshirt());
  const ImportedMesh dress = welded(makeDress());
  expectSoundGarment(skirt, 2);
  expectSoundGarment(tshirt, 4);
  expectSoundGarment(dress, 4);
  for (const ImportedMesh* garment : {&skirt, &tshirt, &dress}) {
    EXPECT_EQ(intersection::intersectingPairs(trianglesOf(*garment)).size(), 0U);
    EXPECT_EQ(intersection::intersectingPairs(trianglesOf(*garment), trianglesOf(figure)).size(), 0U);
  }
  EXPECT_EQ(intersection::intersectingPairs(trianglesOf(skirt), trianglesOf(tshirt)).size(), 0U);
}

TEST(Garments, includeACapeWithOneBorder) {
  const ImportedMesh cape = welded(makeCape());
  EXPECT_TRUE(cape.summary.warnings.empty());
  EXPECT_EQ(cape.summary.components, 1);
  EXPECT_EQ(cape.summary.boundaryLoops, 1);
  EXPECT_EQ(cape.summary.nonManifoldEdges, 0);
  EXPECT_LT(edgeRatio(cape.cloth), 6.0);
  EXPECT_EQ(intersection::intersectingPairs(trianglesOf(cape)).size(), 0U);
}

TEST(Garments, lieOnATableThatIsOneClosedSurfaceAndLevel) {
  const ImportedMesh table = welded(makeTable());
  expectOneClosedSurface(table);
  EXPECT_NEAR(table.summary.size[0], 2.0 * garment::tableRadius, 1e-9);
  EXPECT_NEAR(table.summary.size[1], garment::tableHeight, 1e-9);
}

}  // namespace
}  // namespace drape::io
