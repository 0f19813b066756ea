#include "io/garments/flat_pattern.hpp"
#include "io/garments/garments.hpp"
#include "io/garments/puff.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>

namespace drape::io {
namespace {

using namespace garment;

constexpr double edgeLength = 0.0205;  // [m]
constexpr double pi = std::numbers::pi;
constexpr double neckHalfWidth = 0.085;  // [m]
constexpr double frontNeckDepth = 0.09;  // [m]
constexpr double backNeckDepth = 0.025;  // [m]
constexpr double sleeveLength = 0.19;    // [m]
constexpr double sleeveWidth = 0.17;     // laid flat [m]
const Vec2 underarm(0.25, 1.2);          // [m]
const Vec2 shoulder(shoulderHalfWidth, shoulderLine(shoulderHalfWidth));
const Vec2 sleeveDirection = Vec2(0.88, -0.475).normalized();
const Vec2 cuffTop = shoulder + sleeveLength * sleeveDirection;
const Vec2 cuffBottom = cuffTop + sleeveWidth * Vec2(sleeveDirection.y(), -sleeveDirection.x());

/// What differs between T-shirts.
struct Cut {
  Vec2 hemCorner;           // [m]
  double puffHeight = 0.0;  // distance of front and back from the seam plane in the middle of a wide piece [m]
};
const Cut longCut{{0.26, 0.79}, 0.11};
const Cut shortCut{{0.25, 0.93}, 0.15};

Vec2 mirrored(const Vec2& point) {
  return {-point.x(), point.y()};
}

/// From the shoulder to the underarm, slightly concave.
Vec2 armhole(double t) {
  const Vec2 hollow = (shoulder + underarm) / 2.0 - Vec2(0.04, 0.01);
  return (1.0 - t) * (1.0 - t) * shoulder + 2.0 * t * (1.0 - t) * hollow + t * t * underarm;
}

/// The outline of front or back with both sleeves, in the hanging position.
Outline makeOutline(const Vec2& hemCorner, double neckDepth) {
  Outline outline(mirrored(hemCorner), edgeLength);
  outline.lineTo(hemCorner, false);
  outline.lineTo(underarm, true);
  outline.lineTo(cuffBottom, true);
  outline.lineTo(cuffTop, false);
  outline.lineTo(shoulder, true);
  const auto along = [](double x) { return Vec2(x, shoulderLine(x)); };
  constexpr double length = shoulderHalfWidth - neckHalfWidth;
  outline.curveTo([&](double t) { return along(shoulderHalfWidth - length * t); }, true);
  outline.curveTo(
      [&](double t) {
        const double x = neckHalfWidth * std::cos(pi * t);
        return Vec2(x, shoulderLine(neckHalfWidth) - neckDepth * std::sin(pi * t));
      },
      false);
  outline.curveTo([&](double t) { return along(-neckHalfWidth - length * t); }, true);
  outline.lineTo(mirrored(cuffTop), true);
  outline.lineTo(mirrored(cuffBottom), false);
  outline.lineTo(mirrored(underarm), true);
  outline.lineTo(mirrored(hemCorner), true);
  return outline;
}

/// The right sleeve, laid flat.
std::vector<Vec2> sleeveOutline() {
  std::vector<Vec2> outline = sampleCurve(armhole, edgeLength);
  outline.push_back(cuffBottom);
  outline.push_back(cuffTop);
  return outline;
}

/// The shift of the texture coordinates of each triangle: the sleeves lie apart from the body.
std::vector<Vec2> chartsOf(const FlatMesh& mesh, const Vec2& aside) {
  constexpr double gap = 0.06;
  const std::vector<Vec2> sleeve = sleeveOutline();
  std::vector<Vec2> charts;
  for (const Triangle& triangle : mesh.triangles) {
    Vec2 centre = Vec2::Zero();
    for (const int corner : triangle) {
      centre += mesh.points[corner] / 3.0;
    }
    const bool onSleeve = isInside(sleeve, {std::abs(centre.x()), centre.y()});
    charts.emplace_back(aside + Vec2(onSleeve ? std::copysign(gap, centre.x()) : 0.0, 0.0));
  }
  return charts;
}

void addSide(const Cut& cut, bool front, RawMesh& tshirt) {
  const Outline outline = makeOutline(cut.hemCorner, front ? frontNeckDepth : backNeckDepth);
  std::vector<Vec2> seam = sampleCurve(armhole, edgeLength);
  std::vector<Vec2> otherSeam;
  std::transform(seam.begin(), seam.end(), std::back_inserter(otherSeam), mirrored);
  const FlatMesh mesh = meshPattern({outline.points(), {seam, otherSeam}}, edgeLength);
  const std::vector<double> height = puffed(mesh, outline.sewn(), edgeLength, cut.puffHeight);
  std::vector<Vec3> positions;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Vec2& flat = mesh.points[i];
    positions.emplace_back(front ? flat.x() : -flat.x(), flat.y(), front ? height[i] : -height[i]);
  }
  const Vec2 aside(front ? 0.0 : 1.1, -cut.hemCorner.y());
  addPiece(mesh, positions, chartsOf(mesh, aside), tshirt);
}

}  // namespace

double garment::shoulderLine(double x) {
  const double beyond = std::max(0.0, std::abs(x) - 0.12);
  return shoulderHeight - 1.5 * beyond * beyond;
}

RawMesh makeTshirt() {
  RawMesh tshirt;
  addSide(longCut, true, tshirt);
  addSide(longCut, false, tshirt);
  return tshirt;
}

RawMesh makeShortTshirt() {
  RawMesh tshirt;
  addSide(shortCut, true, tshirt);
  addSide(shortCut, false, tshirt);
  return tshirt;
}

}  // namespace drape::io
