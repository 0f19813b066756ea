#include "io/garments/flat_pattern.hpp"
#include "io/garments/garments.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drape::io {
namespace {

using namespace garment;

constexpr double pi = std::numbers::pi;

/// A cone whose flat pattern is half a disc: a point at slant distance s from the tip is s/2 from the axis.
constexpr double slantPerRadius = 2.0;
const double slantPerHeight = 1.0 / std::sqrt(0.75);
const double waistSlant = waistRadius * slantPerRadius;
const double hipSlant = waistSlant + (waistHeight - hipHeight) * slantPerHeight;

/// Below the hips the skirt hangs in folds around a steeper cone.
constexpr double flare = 0.15;  // increase of the radius per metre of cloth [m]
constexpr int folds = 12;
const double dropPerSlant = std::sqrt(1.0 - flare * flare);
const double hemSlant = hipSlant + (hipHeight - hemHeight) / dropPerSlant;

Vec2 flatPoint(double slant, double angle) {
  return {slant * std::sin(angle), -slant * std::cos(angle)};
}

/// A quarter of a ring, with the waist at the top.
FlatMesh meshPanel(double edgeLength) {
  constexpr double half = pi / 4.0;
  Outline outline(flatPoint(waistSlant, -half), edgeLength);
  outline.lineTo(flatPoint(hemSlant, -half), true);
  outline.curveTo([](double t) { return flatPoint(hemSlant, -half + 2.0 * half * t); }, false);
  outline.lineTo(flatPoint(waistSlant, half), true);
  outline.curveTo([](double t) { return flatPoint(waistSlant, half - 2.0 * half * t); }, false);
  const auto hips = sampleCurve([](double t) { return flatPoint(hipSlant, -half + 2.0 * half * t); }, edgeLength);
  return meshPattern({outline.points(), {hips}}, edgeLength);
}

/// A point of the cloth below the hips. At mean radius R the cloth is too long by the factor 1 + b. Folds of the height
/// 2 sqrt(b) R / n take up this length. Moving points from the flanks towards the crests by b / (2 n) distributes the
/// cloth evenly.
Vec3 placeInFolds(double slant, double azimuth) {
  const double below = slant - hipSlant;
  const double radius = hipRadius() + flare * below;
  const double surplus = slant / slantPerRadius / radius - 1.0;
  const double height = 2.0 * std::sqrt(std::max(0.0, surplus)) * radius / folds;
  const double angle = azimuth + surplus / (2.0 * folds) * std::sin(2.0 * folds * azimuth);
  const double r = radius + height * std::cos(folds * azimuth);
  return {r * std::sin(angle), hipHeight - below * dropPerSlant, r * std::cos(angle)};
}

/// The position of a point of the panel whose middle faces `facing` (0: +z).
Vec3 place(const Vec2& flat, double facing) {
  const double slant = flat.norm();
  const double azimuth = facing + slantPerRadius * std::atan2(flat.x(), -flat.y());
  if (slant > hipSlant) {
    return placeInFolds(slant, azimuth);
  }
  const double radius = slant / slantPerRadius;
  return {radius * std::sin(azimuth), waistHeight - (slant - waistSlant) / slantPerHeight, radius * std::cos(azimuth)};
}

}  // namespace

double garment::hipRadius() {
  return hipSlant / slantPerRadius;
}

RawMesh makeSkirt() {
  constexpr double edgeLength = 0.026;  // [m]
  return makeSkirtOfEdges(edgeLength);
}

RawMesh makeSkirtOfEdges(double edgeLength) {
  const FlatMesh panel = meshPanel(edgeLength);
  RawMesh skirt;
  for (const bool front : {true, false}) {
    std::vector<Vec3> positions;
    for (const Vec2& point : panel.points) {
      positions.push_back(place(point, front ? 0.0 : pi));
    }
    const Vec2 aside(front ? 0.0 : 1.5, hemSlant);
    addPiece(panel, positions, std::vector<Vec2>(panel.triangles.size(), aside), skirt);
  }
  return skirt;
}

}  // namespace drape::io
