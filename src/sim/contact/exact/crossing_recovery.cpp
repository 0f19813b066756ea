#include "sim/contact/exact/crossing_recovery.hpp"

#include "sim/contact/closest_features/triangle_geometry.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace drape::sim::contact {
namespace {

constexpr double recoverySpeed = 2.0;  // maximum speed of a vertex [m/s]
constexpr double maxMoveRatio = 0.3;   // maximum motion of a step, in lengths of the crossing edge

/// The motion that resolves a crossing: the edge moves along the direction, the triangle against it.
struct Exit {
  std::array<int, 5> vertices{};  // the ends of the edge, then the corners of the triangle
  int wrongEnd = -1;              // -1: the distance to move is not known
  Vec3 direction = Vec3::Zero();  // unit vector
};

constexpr std::array<double, 5> exitWeights{1.0 / 2.0, 1.0 / 2.0, -1.0 / 3.0, -1.0 / 3.0, -1.0 / 3.0};

/// The direction in which the wrong end passes back through the triangle.
Vec3 wayBack(const EntangledCloth& cloth, const Triangle& triangle, int wrongEnd) {
  const Vec3 normal = faceNormal(cornersOf(cloth.start, triangle));
  return normal.dot(cloth.start[wrongEnd] - cloth.start[triangle[0]]) > 0.0 ? Vec3(-normal) : normal;
}

std::vector<Exit> exitsOf(const EntangledCloth& cloth) {
  const IntersectionContours contours = contoursOf(cloth.mesh, cloth.crossings);
  const std::vector<int> wrong = wrongEndsOf(cloth.mesh, cloth.crossings, contours, cloth.field, cloth.start);
  const std::vector<Vec3> rates = shorteningRates(cloth.mesh, cloth.crossings, cloth.start);
  std::vector<char> cutsOff(static_cast<std::size_t>(contours.count), 0);
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    char& any = cutsOff[contours.contourOf[i]];
    any = any != 0 || wrong[i] >= 0 ? 1 : 0;
  }
  std::vector<Exit> exits;
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    const auto& [a, b] = cloth.mesh.edges.edges[cloth.crossings[i].edge];
    const Triangle& triangle = cloth.mesh.triangles[cloth.crossings[i].triangle];
    const std::array<int, 5> vertices{a, b, triangle[0], triangle[1], triangle[2]};
    if (wrong[i] >= 0) {
      exits.push_back({vertices, wrong[i], wayBack(cloth, triangle, wrong[i])});
    } else if (cutsOff[contours.contourOf[i]] == 0 && rates[i] != Vec3::Zero()) {
      exits.push_back({vertices, -1, rates[i].normalized()});
    }  // else the contour's other curve says how to move
  }
  return exits;
}

/// Changes the value of the edge relative to that of the triangle by `change` along the direction.
void changeBy(double change, const Exit& exit, std::span<const double> inverseMass, std::span<Vec3> values) {
  double response = 0.0;
  for (std::size_t i = 0; i < 5; ++i) {
    response += inverseMass[exit.vertices[i]] * exitWeights[i] * exitWeights[i];
  }
  if (response <= 0.0) {
    return;
  }
  for (std::size_t i = 0; i < 5; ++i) {
    const int v = exit.vertices[i];
    values[v] += change / response * inverseMass[v] * exitWeights[i] * exit.direction;
  }
}

/// The speed or displacement of the edge relative to the triangle along the direction.
double relativeValue(const Exit& exit, std::span<const Vec3> values) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 5; ++i) {
    sum += exitWeights[i] * exit.direction.dot(values[exit.vertices[i]]);
  }
  return sum;
}

/// How far the wrong end must still move [m].
double missingOf(const Exit& exit, double margin, double unknown, std::span<const Vec3> positions) {
  if (exit.wrongEnd < 0) {
    return unknown;
  }
  return margin - exit.direction.dot(positions[exit.wrongEnd] - positions[exit.vertices[2]]);
}

}  // namespace

void recoverFromCrossings(const EntangledCloth& cloth, ClothState& state) {
  const double maxStep = recoverySpeed * cloth.timeStep;
  const std::vector<Vec3> before = state.positions;
  for (const Exit& exit : exitsOf(cloth)) {
    const double length = (cloth.start[exit.vertices[1]] - cloth.start[exit.vertices[0]]).norm();
    const double limit = std::min(maxStep, maxMoveRatio * length);
    const double missing = missingOf(exit, cloth.margin, limit, state.positions);
    changeBy(std::clamp(missing, 0.0, limit), exit, cloth.inverseMass, state.positions);
    changeBy(std::max(0.0, -relativeValue(exit, state.velocities)), exit, cloth.inverseMass, state.velocities);
  }
  for (std::size_t v = 0; v < before.size(); ++v) {
    const Vec3 moved = state.positions[v] - before[v];
    const double distance = moved.norm();
    if (distance > maxStep) {
      state.positions[v] = before[v] + maxStep / distance * moved;
    }
  }
}

}  // namespace drape::sim::contact
