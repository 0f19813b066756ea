#include "sim/fabric/rest_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace drape::sim::fabric {
namespace {

/// A triangle whose height is below this fraction of its longest side has no plane that rounding does not move.
constexpr double minHeight = 1e-9;

/// Twice the area, along the normal [m^2]; zero for a degenerate triangle.
Vec3 areaVector(std::span<const Vec3> positions, const Triangle& triangle) {
  const Vec3 first = positions[triangle[1]] - positions[triangle[0]];
  const Vec3 second = positions[triangle[2]] - positions[triangle[1]];
  const Vec3 third = positions[triangle[0]] - positions[triangle[2]];
  const double longest = std::max({first.squaredNorm(), second.squaredNorm(), third.squaredNorm()});
  const Vec3 vector = first.cross(second);
  return vector.norm() > minHeight * longest ? vector : Vec3(Vec3::Zero());
}

/// The part of a direction in the plane with this unit normal, as a unit vector; zero if nothing is left.
Vec3 inPlane(const Vec3& direction, const Vec3& normal) {
  constexpr double minSine = 1e-3;
  const Vec3 part = direction - direction.dot(normal) * normal;
  const double length = part.norm();
  return length > minSine * direction.norm() ? Vec3(part / length) : Vec3(Vec3::Zero());
}

RestTriangle measured(std::span<const Vec3> positions, const Triangle& triangle, const Vec3& warp) {
  RestTriangle rest;
  const Vec3 vector = areaVector(positions, triangle);
  const double twice = vector.norm();
  if (!(twice > 0.0)) {
    return rest;
  }
  const Vec3 weft = (vector / twice).cross(warp);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 side = positions[triangle[(k + 1) % 3]] - positions[triangle[k]];
    rest.sides[k] = {side.dot(warp), side.dot(weft)};
  }
  rest.area = 0.5 * twice;
  return rest;
}

/// Adds the weights of one triangle: its derivative of x along the outward normal of the hinge's edge in its plane.
void addWeights(const SideFrame& frame, Eigen::Index opposite, Eigen::Vector4d& weights) {
  const double atSecond = 0.5 + frame.offset / frame.length;  // of the foot of the height, between the edge's ends
  weights[0] += (1.0 - atSecond) / frame.height;
  weights[1] += atSecond / frame.height;
  weights[opposite] = -1.0 / frame.height;
}

}  // namespace

double qualityOf(const RestTriangle& triangle) {
  double squares = 0.0;
  for (const Vec2& side : triangle.sides) {
    squares += side.squaredNorm();
  }
  return squares > 0.0 ? 4.0 * std::numbers::sqrt3 * triangle.area / squares : 0.0;
}

SideFrame sideFrameOf(const RestTriangle& triangle, int side, bool reversed) {
  const Vec2& own = triangle.sides[side];
  SideFrame frame;
  frame.length = own.norm();
  frame.height = 2.0 * triangle.area / frame.length;
  // The corners are counter-clockwise in the coordinates along warp and weft.
  frame.outward = Vec2(own.y(), -own.x()) / frame.length;
  frame.along = (reversed ? -1.0 : 1.0) * own / frame.length;
  frame.offset = (0.5 * own + triangle.sides[(side + 1) % 3]).dot(frame.along);
  return frame;
}

std::vector<Vec3> warpAlong(const Vec3& direction, std::span<const Vec3> positions,
                            std::span<const Triangle> triangles) {
  std::vector<Vec3> warp;
  warp.reserve(triangles.size());
  for (const Triangle& triangle : triangles) {
    const Vec3 vector = areaVector(positions, triangle);
    if (vector.isZero(0.0)) {
      warp.emplace_back(Vec3::Zero());
      continue;
    }
    const Vec3 normal = vector.normalized();
    Vec3 own = inPlane(direction, normal);
    if (own.isZero(0.0)) {
      Eigen::Index closest = 0;
      normal.cwiseAbs().minCoeff(&closest);
      own = inPlane(Vec3::Unit(closest), normal);
    }
    warp.push_back(own);
  }
  return warp;
}

std::vector<RestTriangle> restTrianglesOf(std::span<const Vec3> positions, std::span<const Triangle> triangles,
                                          std::span<const Vec3> warp) {
  std::vector<RestTriangle> rest;
  rest.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    rest.push_back(measured(positions, triangles[t], warp[t]));
  }
  return rest;
}

RestTriangle restTriangleOf(const std::array<Vec2, 3>& corners) {
  RestTriangle rest;
  std::array<Vec2, 3> sides;
  double longest = 0.0;  // squared
  for (std::size_t k = 0; k < 3; ++k) {
    sides[k] = corners[(k + 1) % 3] - corners[k];
    longest = std::max(longest, sides[k].squaredNorm());
  }
  const double twice = sides[0].x() * sides[1].y() - sides[0].y() * sides[1].x();
  if (!(std::abs(twice) > minHeight * longest)) {
    return rest;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    rest.sides[k] = {sides[k].x(), twice > 0.0 ? sides[k].y() : -sides[k].y()};
  }
  rest.area = 0.5 * std::abs(twice);
  return rest;
}

RestShape restShapeOf(std::span<const Vec3> positions, std::span<const Triangle> triangles, const MeshEdges& edges,
                      std::span<const Vec3> warp) {
  return restShapeOf(restTrianglesOf(positions, triangles, warp), triangles, edges);
}

RestShape restShapeOf(std::vector<RestTriangle> rest, std::span<const Triangle> triangles, const MeshEdges& edges) {
  RestShape shape;
  shape.triangles = std::move(rest);
  for (std::size_t e = 0; e < edges.edges.size(); ++e) {
    const std::span<const TriangleSide> sides = edges.sides[e];
    const bool bends = sides.size() == 2 && shape.triangles[sides[0].triangle].area > 0.0 &&
                       shape.triangles[sides[1].triangle].area > 0.0;
    if (!bends) {
      continue;
    }
    Hinge hinge;
    hinge.vertices = {edges.edges[e].a, edges.edges[e].b};
    for (std::size_t s = 0; s < 2; ++s) {
      const auto& [triangle, corner, ascending] = sides[s];
      hinge.triangles[s] = triangle;
      hinge.sides[s] = corner;
      hinge.vertices[2 + s] = triangles[triangle][(corner + 2) % 3];
      hinge.frames[s] = sideFrameOf(shape.triangles[triangle], corner, !ascending);
      addWeights(hinge.frames[s], static_cast<Eigen::Index>(2 + s), hinge.weights);
    }
    shape.hinges.push_back(hinge);
  }
  return shape;
}

}  // namespace drape::sim::fabric
