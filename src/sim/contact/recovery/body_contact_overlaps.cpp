// The part of BodyContact that handles cloth inside a body at the start of a step.
#include "sim/contact/solve/body_contact.hpp"
#include "sim/model/mesh_topology.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace drape::sim::contact {
namespace {

constexpr double maxSpeedAtOverlap = 1.0;  // maximum speed, relative to the body, of cloth at an overlap [m/s]
constexpr int minRings = 3;                // rings of triangles around the overlap whose speed is limited, at least
constexpr double ringsPerWidth = 1.0;      // additional rings per triangle of the overlap's width

/// The vector, limited to a maximum length.
Vec3 limited(const Vec3& vector, double maxLength) {
  const double length = vector.norm();
  return length > maxLength ? Vec3(maxLength / length * vector) : vector;
}

/// The first vertex of each connected piece of a cloth.
std::vector<int> firstOfPieces(const ClothModel& model) {
  return componentsOf(model.triangles, model.restPositions.size()).lowestVertex;
}

}  // namespace

const std::vector<int>& BodyContact::piecesOf(const ClothModel& model) {
  return pieces_.get(model, firstOfPieces);
}

/// @return true if an overlap was found that was not known
bool BodyContact::findPrimitiveOverlap(const Cloth& cloth, NearBody& near, CapsuleSolid&& solid) {
  if (near.overlaps) {
    return false;
  }
  std::vector<char> inside(near.start.size());
  std::transform(near.start.begin(), near.start.end(), inside.begin(),
                 [&](const Vec3& point) { return static_cast<char>(solid.contains(point)); });
  near.overlap.find(solid, std::move(inside), near.start, cloth.model.triangles,
                    near.step->end.rotation.conjugate() * Vec3::UnitY());
  near.overlaps = true;
  return near.overlap.any();
}

/// Finds the cloth inside closed meshes. The first search tests one vertex of each connected piece. When the piercing
/// triangles are known, it classifies each vertex.
void BodyContact::findOverlaps(const Cloth& cloth, bool atEnd, bool first) {
  for (std::size_t b = 0; b < nearCount_; ++b) {
    NearBody& near = near_[b];
    near.overlaps = near.overlaps && !first;
    if (near.mesh != nullptr && near.mesh->closed) {
      const MeshInStep mesh = near.meshInStep(atEnd);
      MeshSolid solid(mesh);
      const std::vector<int>& pieces = piecesOf(cloth.model);
      near.overlaps = first ? std::any_of(pieces.begin(), pieces.end(),
                                          [&](int v) { return solid.contains(vectorAt(near.start, v)); })
                            : near.overlaps || near.meshSearch.pierced();
      if (near.overlaps) {
        const std::vector<bool> pierces = near.meshSearch.pierces(cloth.model.triangles.size());
        near.overlap.find(solid, verticesInside(solid, near.start, cloth.model.triangles, pierces), near.start,
                          cloth.model.triangles, near.step->end.rotation.conjugate() * Vec3::UnitY());
      }
    }
  }
}

void BodyContact::extendBoundsForRecovery() {
  for (std::size_t b = 0; b < nearCount_; ++b) {
    const NearBody& near = near_[b];
    if (near.overlaps) {
      const double maxStep = near.offsets.recoveryStepAt(std::numeric_limits<double>::max());
      for (const int v : near.overlap.members()) {
        displacementBounds_[v] += maxStep;
      }
    }
  }
}

bool BodyContact::overlaps() const {
  const auto last = near_.begin() + static_cast<std::ptrdiff_t>(nearCount_);
  return std::any_of(near_.begin(), last, [](const NearBody& near) { return near.overlaps; });
}

/// Per vertex: whether it belongs to a triangle that overlaps the body, or is a few edges away from one.
std::vector<bool> BodyContact::verticesAtOverlap(const Cloth& cloth, const NearBody& near) {
  const std::vector<Triangle>& triangles = cloth.model.triangles;
  const std::vector<bool> pierces = near.meshSearch.pierces(triangles.size());
  std::vector<bool> atOverlap(predicted_.size(), false);
  std::vector<int> newest;
  const auto mark = [&](int v, std::vector<int>& marked) {
    if (!atOverlap[v]) {
      atOverlap[v] = true;
      marked.push_back(v);
    }
  };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if ((near.mesh != nullptr && pierces[t]) ||
        std::any_of(triangles[t].begin(), triangles[t].end(), [&](int v) { return near.overlap.inside(v); })) {
      std::for_each(triangles[t].begin(), triangles[t].end(), [&](int v) { mark(v, newest); });
    }
  }
  const double width = std::sqrt(static_cast<double>(near.overlap.members().size()));  // approximate, in triangles
  const int rings = minRings + static_cast<int>(ringsPerWidth * width);
  std::vector<int> next;
  for (int ring = 1; ring < rings && !newest.empty(); ++ring) {
    next.clear();
    for (const int v : newest) {
      for (const SpringEnd& end : cloth.model.springEnds[v]) {
        mark(end.neighbour, next);
      }
    }
    newest.swap(next);
  }
  return atOverlap;
}

/// Limits the speed of cloth at an overlap. Cloth that has left a body pulls at cloth that is still inside; without a
/// limit stretched springs would accelerate it.
void BodyContact::limitDisplacementsAtOverlap(const Cloth& cloth) {
  slowed_.clear();
  for (std::size_t b = 0; b < nearCount_; ++b) {
    const NearBody& near = near_[b];
    if (!near.overlaps) {
      continue;
    }
    const std::vector<bool> atOverlap = verticesAtOverlap(cloth, near);
    for (std::size_t v = 0; v < predicted_.size(); ++v) {
      if (atOverlap[v] && !cloth.model.pinned[v]) {
        const Vec3 carried = near.step->end.toWorld(near.start[v]);
        slowed_.push_back({v, carried - cloth.start[v]});
        predicted_[v] = carried + limited(predicted_[v] - carried, maxSpeedAtOverlap * cloth.parameters.timeStep);
      }
    }
  }
}

void BodyContact::limitVelocitiesAtOverlap(const Cloth& cloth, ClothState& state) const {
  for (const SlowedVertex& each : slowed_) {
    const Vec3 bodyVelocity = each.displacement / cloth.parameters.timeStep;
    Vec3& velocity = state.velocities[each.vertex];
    velocity = bodyVelocity + limited(velocity - bodyVelocity, maxSpeedAtOverlap);
  }
}

}  // namespace drape::sim::contact
