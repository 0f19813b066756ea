#include "io/garments/flat_pattern.hpp"
#include "io/garments/garments.hpp"

#include <cmath>
#include <numbers>

namespace drape::io {
namespace {

using namespace garment;

constexpr double edgeLength = 0.027;  // [m]
constexpr double pi = std::numbers::pi;
constexpr double halfSide = 0.6;         // [m]
constexpr double neckHalfWidth = 0.11;   // [m]
constexpr double frontNeckDepth = 0.12;  // [m]
constexpr double backNeckDepth = 0.05;   // [m]
constexpr double foldRadius = 0.025;     // of the bend over the shoulder line [m]
constexpr double steepness = 1.36;       // of the hanging sides [rad from level]
constexpr double waveHeight = 0.012;     // at the lower border [m]
constexpr double waveLength = 0.3;       // [m]

/// One half, from the shoulder line (y = 0) down.
FlatMesh meshHalf(double neckDepth) {
  Outline outline({-halfSide, 0.0}, edgeLength);
  outline.lineTo({-halfSide, -halfSide}, false);
  outline.lineTo({halfSide, -halfSide}, false);
  outline.lineTo({halfSide, 0.0}, false);
  outline.lineTo({neckHalfWidth, 0.0}, true);
  outline.curveTo(
      [neckDepth](double t) { return Vec2(neckHalfWidth * std::cos(pi * t), -neckDepth * std::sin(pi * t)); }, false);
  outline.lineTo({-halfSide, 0.0}, true);
  return meshPattern({outline.points(), {}}, edgeLength);
}

/// The position of a point of the front: bent over the shoulder line, then straight down and slightly outwards.
Vec3 place(const Vec2& flat) {
  const double down = -flat.y();
  const double angle = std::min(down / foldRadius, steepness);
  const double straight = down - angle * foldRadius;
  const double wave = waveHeight * down / halfSide * std::cos(2.0 * pi * flat.x() / waveLength);
  return {flat.x(), shoulderHeight - foldRadius * (1.0 - std::cos(angle)) - straight * std::sin(angle),
          foldRadius * std::sin(angle) + straight * std::cos(angle) + wave};
}

}  // namespace

RawMesh makePoncho() {
  RawMesh poncho;
  for (const bool front : {true, false}) {
    const FlatMesh half = meshHalf(front ? frontNeckDepth : backNeckDepth);
    std::vector<Vec3> positions;
    for (const Vec2& point : half.points) {
      // The back is the front rotated by half a turn about the y axis.
      const Vec3 place3 = place(point);
      positions.push_back(front ? place3 : Vec3(-place3.x(), place3.y(), -place3.z()));
    }
    const Vec2 aside(front ? 0.0 : 2.0 * halfSide + 0.1, halfSide);
    addPiece(half, positions, std::vector<Vec2>(half.triangles.size(), aside), poncho);
  }
  return poncho;
}

}  // namespace drape::io
