#include "report/validation/drape_disc.hpp"

#include "report/validation/cases.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace drape::report::validation {
namespace {

constexpr int testCells = 12;

/// The disc with every point moved to this distance from the axis, as a function of its angle; the support stays.
std::vector<Vec3> rimMovedTo(const Disc& disc, double (*distance)(double)) {
  std::vector<Vec3> positions = disc.sheet.mesh.positions;
  for (const int vertex : rimOf(disc)) {
    const double angle = std::atan2(positions[vertex].z(), positions[vertex].x());
    positions[vertex] = distance(angle) * Vec3(std::cos(angle), 0.0, std::sin(angle));
  }
  return positions;
}

TEST(DrapeDisc, coversTheDiscWithGoodTrianglesOfEveryKind) {
  for (const MeshKind kind : meshKinds) {
    const Disc disc = discOf(cusickDisc, 24, kind);
    const double area = std::numbers::pi * 0.15 * 0.15;
    EXPECT_NEAR(sim::restAreaOf(disc.sheet.mesh), area, 0.002 * area) << nameOf(kind);
    for (const Triangle& triangle : disc.sheet.mesh.triangles) {
      const Vec3& a = disc.sheet.mesh.positions[triangle[0]];
      const Vec3 normal =
          (disc.sheet.mesh.positions[triangle[1]] - a).cross(disc.sheet.mesh.positions[triangle[2]] - a);
      EXPECT_GT(normal.y(), 1e-6) << "a sliver, or a triangle upside down: " << nameOf(kind);
    }
  }
}

TEST(DrapeDisc, hasTheEdgeOfTheSupportInTheMiddleBetweenItsLastHeldRings) {
  const Disc disc = discOf(cusickDisc, testCells, MeshKind::Irregular);
  double largest = 0.0;
  double second = 0.0;
  for (const int vertex : disc.pinned) {
    largest = std::max(largest, disc.sheet.mesh.positions[vertex].norm());
  }
  for (const int vertex : disc.pinned) {
    const double radius = disc.sheet.mesh.positions[vertex].norm();
    second = radius < largest - 1e-9 ? std::max(second, radius) : second;
  }
  EXPECT_NEAR(0.5 * (largest + second), cusickDisc.support, 1e-12);
  for (const int vertex : rimOf(disc)) {
    EXPECT_NEAR(disc.sheet.mesh.positions[vertex].norm(), cusickDisc.radius, 1e-12);
  }
}

TEST(DrapeCoefficient, ofAFlatDiscIs100AndOfAVerticalRimIsZero) {
  Disc disc = discOf(cusickDisc, 48, MeshKind::Grid);
  const std::vector<Triangle>& triangles = disc.sheet.mesh.triangles;
  EXPECT_NEAR(drapeCoefficient(shadowOf(disc.sheet.mesh.positions, triangles)), 100.0, 0.2);
  for (Vec3& position : disc.sheet.mesh.positions) {
    const double radius = std::hypot(position.x(), position.z());
    if (radius > cusickDisc.support) {
      position *= cusickDisc.support / radius;
      position.y() = cusickDisc.support - radius;
    }
  }
  EXPECT_NEAR(drapeCoefficient(shadowOf(disc.sheet.mesh.positions, triangles)), 0.0, 0.2);
}

TEST(DrapeCoefficient, ofAConeIsTheShareOfItsShadow) {
  Disc disc = discOf(cusickDisc, 48, MeshKind::Alternating);
  constexpr double rim = 0.12;  // [m]
  for (Vec3& position : disc.sheet.mesh.positions) {
    position *= rim / cusickDisc.radius;
  }
  const double exact = 100.0 * (0.12 * 0.12 - 0.09 * 0.09) / (0.15 * 0.15 - 0.09 * 0.09);
  EXPECT_NEAR(drapeCoefficient(shadowOf(disc.sheet.mesh.positions, disc.sheet.mesh.triangles)), exact, 0.2);
}

TEST(Folds, areTheMaximaOfTheShadow) {
  const Disc disc = discOf(cusickDisc, 48, MeshKind::Grid);
  const auto foldsWith = [&](double (*distance)(double)) {
    return foldsOf(shadowOf(rimMovedTo(disc, distance), disc.sheet.mesh.triangles));
  };
  EXPECT_EQ(foldsWith([](double) { return 0.15; }), 0);
  EXPECT_EQ(foldsWith([](double angle) { return 0.15 + 0.01 * std::cos(5.0 * angle); }), 5);
  EXPECT_EQ(foldsWith([](double angle) { return 0.15 + 0.01 * std::cos(4.0 * angle + 1.0); }), 4);
}

TEST(DrapedDisc, hangsLowerTheLessItResistsBending) {
  fabrics::Preset stiff = *fabrics::findPreset("canvas");
  fabrics::Preset soft = stiff;
  soft.material.bendWarp = soft.material.bendWeft = soft.material.bendBias = 0.3 * stiff.material.bendWarp;
  const CaseMesh mesh{.resolution = testCells, .kind = MeshKind::Alternating};
  const auto coefficient = [&](const fabrics::Preset& preset) {
    const DrapedDisc draped = drapedDisc(cusickDisc, preset, mesh);
    EXPECT_TRUE(draped.converged);
    return drapeCoefficient(shadowOf(draped.positions, draped.disc.sheet.mesh.triangles));
  };
  const double ofStiff = coefficient(stiff);
  EXPECT_LT(ofStiff, 99.0);
  EXPECT_LT(coefficient(soft), ofStiff - 5.0);
}

TEST(DrapedDisc, continuesOnAFinerMeshWithTheSameFolds) {
  const fabrics::Preset& denim = *fabrics::findPreset("denim");
  for (const int cells : {testCells, 18}) {
    const DrapedDisc draped = drapedDisc(cusickDisc, denim, {.resolution = cells, .kind = MeshKind::Alternating});
    const std::vector<double> shadow = shadowOf(draped.positions, draped.disc.sheet.mesh.triangles);
    EXPECT_EQ(foldsOf(shadow), 4) << cells;
    EXPECT_NEAR(drapeCoefficient(shadow), 83.0, 2.0) << cells;
  }
}

TEST(Cusick, isOffOutsideTheRangeOfThePreset) {
  const Comparison silk = cusick({.resolution = testCells, .kind = MeshKind::Alternating, .subject = "silk"});
  EXPECT_EQ(silk.exact, fabrics::findPreset("silk")->drape->lower);
  EXPECT_EQ(silk.upper, fabrics::findPreset("silk")->drape->upper);
  EXPECT_GT(silk.error(), 0.1);
  EXPECT_EQ(silk.note, "4 folds");
}

TEST(Cusick, findsLeatherWithinItsRange) {
  const Comparison leather = cusick({.resolution = testCells, .kind = MeshKind::Alternating, .subject = "leather"});
  EXPECT_EQ(leather.error(), 0.0) << leather.measured;
}

}  // namespace
}  // namespace drape::report::validation
