#include "report/body_intersections.hpp"

#include "intersection/intersections.hpp"

namespace drape::report {
namespace {

/// A body's current surface, in the world.
sim::contact::BodySurface placed(const sim::contact::BodyWorld& world, std::size_t body) {
  sim::contact::BodySurface surface = sim::contact::surfaceOf(world.bodies()[body].shape);
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
                            const sim::contact::BodyWorld& world) {
  const intersection::Surface cloth{positions, triangles};
  std::size_t pairs = 0;
  sim::contact::BodySurface solids;
  for (std::size_t body = 0; body < world.bodies().size(); ++body) {
    if (!world.isOn(body)) {
      continue;
    }
    const sim::contact::BodySurface surface = placed(world, body);
    if (std::holds_alternative<sim::contact::PlaneShape>(world.bodies()[body].shape)) {
      pairs +=
          intersection::trianglesReaching(cloth, {surface.positions[0], surface.positions[1], surface.positions[2]})
              .size();
      continue;
    }
    const auto first = static_cast<int>(solids.positions.size());
    solids.positions.insert(solids.positions.end(), surface.positions.begin(), surface.positions.end());
    for (const Triangle& t : surface.triangles) {
      solids.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }
  return pairs +
         intersection::intersectingPairs(cloth, intersection::Surface{solids.positions, solids.triangles}).size();
}

}  // namespace drape::report
