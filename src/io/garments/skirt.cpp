#include "io/garments/flat_pattern.hpp"
#include "io/garments/garments.hpp"

#include <cmath>
#include <numbers>

namespace drape {
namespace {

using namespace garment;

constexpr double edgeLength = 0.026;  // [m]
constexpr double pi = std::numbers::pi;

/// A cone that is half a disc when laid flat: a point at slant distance s from its tip is s/2 from its axis.
constexpr double slantPerRadius = 2.0;
const double slantPerHeight = 1.0 / std::sqrt(0.75);
const double waistSlant = waistRadius * slantPerRadius;
const double hemSlant = waistSlant + (waistHeight - hemHeight) * slantPerHeight;

/// Shallow waves towards the hem give the folds a place to begin.
constexpr double waveHeight = 0.03;  // [m]
constexpr int waves = 7;

Vec2 flatPoint(double slant, double angle) {
  return {slant * std::sin(angle), -slant * std::cos(angle)};
}

/// A quarter of a ring, with the waist on top.
FlatMesh meshPanel() {
  constexpr double half = pi / 4.0;
  Outline outline(flatPoint(waistSlant, -half), edgeLength);
  outline.lineTo(flatPoint(hemSlant, -half), true);
  outline.curveTo([](double t) { return flatPoint(hemSlant, -half + 2.0 * half * t); }, false);
  outline.lineTo(flatPoint(waistSlant, half), true);
  outline.curveTo([](double t) { return flatPoint(waistSlant, half - 2.0 * half * t); }, false);
  return meshPattern({outline.points(), {}}, edgeLength);
}

/// Where a point of a panel is whose middle looks in the direction `facing` (0: +z).
Vec3 place(const Vec2& flat, double facing) {
  const double slant = flat.norm();
  const double azimuth = facing + slantPerRadius * std::atan2(flat.x(), -flat.y());
  const double down = (slant - waistSlant) / (hemSlant - waistSlant);
  const double radius = slant / slantPerRadius + waveHeight * down * down * std::cos(waves * azimuth);
  return {radius * std::sin(azimuth), waistHeight - (slant - waistSlant) / slantPerHeight, radius * std::cos(azimuth)};
}

}  // namespace

RawMesh makeSkirt() {
  const FlatMesh panel = meshPanel();
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

}  // namespace drape
