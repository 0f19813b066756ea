#include "report/body_intersections.hpp"

#include "intersection/intersections.hpp"

namespace drape {
namespace {

/// A body's current surface, in the world.
BodySurface placed(const BodyWorld& world, std::size_t body) {
  BodySurface surface = surfaceOf(world.bodies()[body].shape);
  const auto vertices = world.vertices(body);
  if (!vertices.empty()) {
    surface.positions.assign(vertices.begin(), vertices.end());
  }
  for (Vec3& position : surface.positions) {
    position = world.pose(body).toWorld(position);
  }
  return surface;
}

}  // namespace

std::size_t pairsWithBodies(const std::vector<Vec3>& positions, const std::vector<Triangle>& triangles,
                            const BodyWorld& world) {
  const Surface cloth{positions, triangles};
  std::size_t pairs = 0;
  BodySurface solids;
  for (std::size_t body = 0; body < world.bodies().size(); ++body) {
    if (!world.isOn(body)) {
      continue;
    }
    const BodySurface surface = placed(world, body);
    if (std::holds_alternative<PlaneShape>(world.bodies()[body].shape)) {
      pairs += trianglesReaching(cloth, {surface.positions[0], surface.positions[1], surface.positions[2]}).size();
      continue;
    }
    const auto first = static_cast<int>(solids.positions.size());
    solids.positions.insert(solids.positions.end(), surface.positions.begin(), surface.positions.end());
    for (const Triangle& t : surface.triangles) {
      solids.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }
  return pairs + intersectingPairs(cloth, Surface{solids.positions, solids.triangles}).size();
}

}  // namespace drape
