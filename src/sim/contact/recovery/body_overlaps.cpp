#include "sim/contact/recovery/body_overlaps.hpp"

#include "sim/contact/constraints/primitive_search.hpp"

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

/// The direction upwards in the frame of a body.
Vec3 upIn(const NearBody& body) {
  return body.step->end.rotation.conjugate() * Vec3::UnitY();
}

}  // namespace

void BodyOverlaps::clear() {
  for (InBody& each : inBodies_) {
    each.known = false;
  }
  slowed_.clear();
}

void BodyOverlaps::find(const ContactPass& pass, const ClothFrames& frames, bool first) {
  inBodies_.resize(std::max(inBodies_.size(), pass.bodies.size()));
  const std::vector<Triangle>& triangles = pass.step.model.triangles;
  for (const NearBody& body : pass.bodies) {
    InBody& here = inBodies_[body.index];
    here.known = here.known && !first;
    if (body.mesh == nullptr || !body.mesh->closed) {
      continue;
    }
    const MeshInStep mesh = body.meshInStep(pass.atEnd());
    MeshSolid solid(mesh);
    const std::span<const Vec3> start = frames.startIn(body);
    const std::vector<int>& pieces = pass.cloth.pieces;
    here.known =
        first ? std::any_of(pieces.begin(), pieces.end(), [&](int v) { return solid.contains(vectorAt(start, v)); })
              : here.known || body.search->pierced();
    if (here.known) {
      const std::vector<bool> pierces = body.search->pierces(triangles.size());
      here.overlap.find(solid, verticesInside(solid, start, triangles, pierces), start, triangles, upIn(body));
    }
  }
}

bool BodyOverlaps::findInPrimitives(const ContactPass& pass, const ClothFrames& frames, std::span<const int> bodies) {
  bool newlyFound = false;
  for (const int b : bodies) {
    const NearBody& body = pass.bodies[b];
    InBody& here = inBodies_[b];
    if (here.known) {
      continue;
    }
    const std::span<const Vec3> start = frames.startIn(body);
    CapsuleSolid solid = PrimitiveSearch(*body.step, b, body.offsets).solid();
    std::vector<char> inside(start.size());
    std::transform(start.begin(), start.end(), inside.begin(),
                   [&](const Vec3& point) { return static_cast<char>(solid.contains(point)); });
    here.overlap.find(solid, std::move(inside), start, pass.step.model.triangles, upIn(body));
    here.known = true;
    newlyFound = newlyFound || here.overlap.any();
  }
  return newlyFound;
}

bool BodyOverlaps::any() const {
  return std::any_of(inBodies_.begin(), inBodies_.end(), [](const InBody& each) { return each.known; });
}

const Overlap* BodyOverlaps::in(const NearBody& body) const {
  const auto b = static_cast<std::size_t>(body.index);
  return b < inBodies_.size() && inBodies_[b].known ? &inBodies_[b].overlap : nullptr;
}

void BodyOverlaps::extendBounds(const ContactPass& pass, ClothFrames& frames) const {
  for (const NearBody& body : pass.bodies) {
    if (const Overlap* overlap = in(body)) {
      frames.extendBounds(overlap->members(), body.offsets.recoveryStepAt(std::numeric_limits<double>::max()));
    }
  }
}

/// Per vertex: whether it belongs to a triangle that overlaps the body, or is a few edges away from one.
std::vector<bool> BodyOverlaps::verticesAtOverlap(const ContactPass& pass, const NearBody& body) const {
  const std::vector<Triangle>& triangles = pass.step.model.triangles;
  const Overlap& overlap = *in(body);
  const std::vector<bool> pierces =
      body.mesh != nullptr ? body.search->pierces(triangles.size()) : std::vector<bool>(triangles.size(), false);
  std::vector<bool> atOverlap(pass.step.start.size(), false);
  std::vector<int> newest;
  const auto mark = [&](int v, std::vector<int>& marked) {
    if (!atOverlap[v]) {
      atOverlap[v] = true;
      marked.push_back(v);
    }
  };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (pierces[t] || std::any_of(triangles[t].begin(), triangles[t].end(), [&](int v) { return overlap.inside(v); })) {
      std::for_each(triangles[t].begin(), triangles[t].end(), [&](int v) { mark(v, newest); });
    }
  }
  const double width = std::sqrt(static_cast<double>(overlap.members().size()));  // approximate, in triangles
  const int rings = minRings + static_cast<int>(ringsPerWidth * width);
  std::vector<int> next;
  for (int ring = 1; ring < rings && !newest.empty(); ++ring) {
    next.clear();
    for (const int v : newest) {
      for (const SpringEnd& end : pass.step.model.springEnds[v]) {
        mark(end.neighbour, next);
      }
    }
    newest.swap(next);
  }
  return atOverlap;
}

void BodyOverlaps::limitDisplacements(const ContactPass& pass, const ClothFrames& frames,
                                      std::vector<Vec3>& predicted) {
  slowed_.clear();
  for (const NearBody& body : pass.bodies) {
    if (in(body) == nullptr) {
      continue;
    }
    const std::span<const Vec3> start = frames.startIn(body);
    const std::vector<bool> atOverlap = verticesAtOverlap(pass, body);
    for (std::size_t v = 0; v < predicted.size(); ++v) {
      if (atOverlap[v] && !pass.step.model.pinned[v]) {
        const Vec3 carried = body.step->end.toWorld(start[v]);
        slowed_.push_back({v, carried - pass.step.start[v]});
        predicted[v] = carried + limited(predicted[v] - carried, maxSpeedAtOverlap * pass.step.parameters.timeStep);
      }
    }
  }
}

void BodyOverlaps::limitVelocities(double timeStep, ClothState& state) const {
  for (const SlowedVertex& each : slowed_) {
    const Vec3 bodyVelocity = each.displacement / timeStep;
    Vec3& velocity = state.velocities[each.vertex];
    velocity = bodyVelocity + limited(velocity - bodyVelocity, maxSpeedAtOverlap);
  }
}

}  // namespace drape::sim::contact
