#include "io/garments/flat_pattern.hpp"
#include "io/garments/garments.hpp"
#include "io/garments/puff.hpp"

#include <cmath>
#include <numbers>

namespace drape::io {
namespace {

using namespace garment;

constexpr double edgeLength = 0.0225;  // [m]
constexpr double pi = std::numbers::pi;
constexpr double neckHalfWidth = 0.095;   // [m]
constexpr double frontNeckDepth = 0.12;   // [m]
constexpr double backNeckDepth = 0.05;    // [m]
constexpr double strapHalfWidth = 0.150;  // the outer end of the shoulder seam [m]
constexpr double puffHeight = 0.15;       // as puffed() takes it [m]
const Vec2 hemCorner(0.40, 0.53);         // [m]
const Vec2 hip(0.222, 0.88);              // [m]
const Vec2 waist(0.176, 1.06);            // [m]
const Vec2 underarm(0.205, 1.235);        // [m]

Vec2 mirrored(const Vec2& point) {
  return {-point.x(), point.y()};
}

/// The side seam from the hem to the underarm: straight to the hip, then a curve through the waist.
Vec2 sideSeam(double t) {
  const Vec2 control = 2.0 * waist - 0.5 * (hip + underarm);  // the curve passes through the waist at t = 1/2
  return (1.0 - t) * (1.0 - t) * hip + 2.0 * t * (1.0 - t) * control + t * t * underarm;
}

/// From the underarm to the shoulder, hollow.
Vec2 armhole(double t) {
  const Vec2 strap(strapHalfWidth, shoulderLine(strapHalfWidth));
  const Vec2 hollow = 0.5 * (underarm + strap) - Vec2(0.035, 0.02);
  return (1.0 - t) * (1.0 - t) * underarm + 2.0 * t * (1.0 - t) * hollow + t * t * strap;
}

Outline dressOutline(double neckDepth) {
  const auto along = [](double x) { return Vec2(x, shoulderLine(x)); };
  constexpr double strap = strapHalfWidth - neckHalfWidth;
  Outline outline(mirrored(hemCorner), edgeLength);
  outline.lineTo(hemCorner, false);
  outline.lineTo(hip, true);
  outline.curveTo(sideSeam, true);
  outline.curveTo(armhole, false);
  outline.curveTo([&](double t) { return along(strapHalfWidth - strap * t); }, true);
  outline.curveTo(
      [&](double t) {
        const double x = neckHalfWidth * std::cos(pi * t);
        return Vec2(x, shoulderLine(neckHalfWidth) - neckDepth * std::sin(pi * t));
      },
      false);
  outline.curveTo([&](double t) { return along(-neckHalfWidth - strap * t); }, true);
  outline.curveTo([](double t) { return mirrored(armhole(1.0 - t)); }, false);
  outline.curveTo([](double t) { return mirrored(sideSeam(1.0 - t)); }, true);
  outline.lineTo(mirrored(hemCorner), true);
  return outline;
}

/// The front or the back of the dress.
/// @param distanceOf the distance of each point from the plane between both [m]
template <typename DistanceOf>
void addDressSide(bool front, const DistanceOf& distanceOf, RawMesh& dress) {
  const Outline outline = dressOutline(front ? frontNeckDepth : backNeckDepth);
  const FlatMesh mesh = meshPattern({outline.points(), {}}, edgeLength);
  const std::vector<double> distance = distanceOf(mesh, outline);
  std::vector<Vec3> positions;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Vec2& flat = mesh.points[i];
    positions.emplace_back(front ? flat.x() : -flat.x(), flat.y(), front ? distance[i] : -distance[i]);
  }
  const Vec2 aside(front ? 0.0 : 1.0, -hemCorner.y());
  addPiece(mesh, positions, std::vector<Vec2>(mesh.triangles.size(), aside), dress);
}

}  // namespace

RawMesh makeDress() {
  const auto puff = [](const FlatMesh& mesh, const Outline& outline) {
    return puffed(mesh, outline.sewn(), edgeLength, puffHeight);
  };
  RawMesh dress;
  addDressSide(true, puff, dress);
  addDressSide(false, puff, dress);
  return dress;
}

RawMesh makeDressPattern() {
  const auto flat = [](const FlatMesh& mesh, const Outline&) {
    return std::vector<double>(mesh.points.size(), garment::patternDistance);
  };
  RawMesh pieces;
  addDressSide(true, flat, pieces);
  addDressSide(false, flat, pieces);
  return pieces;
}

}  // namespace drape::io
