#include "sim/contact/bodies/world.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drape::sim::contact {
namespace {

const MeshShape* meshOf(const Body& body) {
  const auto* mesh = std::get_if<std::shared_ptr<const MeshShape>>(&body.shape);
  return mesh == nullptr ? nullptr : mesh->get();
}

/// The number of the frame at that time [s], with a fraction towards the next one.
double frameAt(const MeshShape& mesh, double time) {
  const auto count = static_cast<double>(mesh.frames.size());
  const double at = time / mesh.frameTime;
  if (!mesh.loop) {
    return std::clamp(at, 0.0, count - 1.0);
  }
  const auto start = static_cast<double>(mesh.loopStart);
  if (at < start) {
    return std::max(at, 0.0);
  }
  const double period = count - start;
  return at - period * std::floor((at - start) / period);
}

bool deforms(const Body& body) {
  const MeshShape* mesh = meshOf(body);
  return mesh != nullptr && mesh->deforms();
}

}  // namespace

void meshPositionsAt(const MeshShape& mesh, double time, std::vector<Vec3>& positions) {
  if (mesh.deformation) {
    mesh.deformation->positionsAt(time, positions);
    return;
  }
  const std::size_t count = mesh.frames.size();
  if (count < 2) {
    positions = mesh.positions;
    return;
  }
  const double at = frameAt(mesh, time);
  const auto last = static_cast<double>(mesh.loop ? count : count - 1);
  const double whole = std::min(std::floor(at), last - 1.0);
  const auto k = static_cast<std::size_t>(whole);
  const double fraction = at - whole;
  const std::vector<Vec3>& from = mesh.frames[k];
  const std::vector<Vec3>& to = mesh.frames[k + 1 < count ? k + 1 : mesh.loopStart];
  positions.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    positions[i] = (1.0 - fraction) * from[i] + fraction * to[i];
  }
}

BodyWorld::BodyWorld(std::shared_ptr<const std::vector<Body>> bodies, double time)
    : bodies_(std::move(bodies)), states_(bodies_->size()) {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    states_[i].surface = (*bodies_)[i].surface;
  }
  reset(time);
}

void BodyWorld::reset(double time) {
  for (BodyState& state : states_) {
    state.targetShift.setZero();
    state.shift.setZero();
  }
  placeAt(time);
}

std::vector<BodyShift> BodyWorld::shifts() const {
  std::vector<BodyShift> all;
  for (const BodyState& each : states_) {
    all.push_back({each.shift, each.targetShift, each.deformation});
  }
  return all;
}

void BodyWorld::resume(double time, std::span<const BodyShift> shifts) {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    states_[i].shift = shifts[i].shift;
    states_[i].targetShift = shifts[i].target;
    states_[i].deformation = shifts[i].deformation;
  }
  placeAt(time);
}

/// Puts every body at its pose at that time, without velocity.
void BodyWorld::placeAt(double time) {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    updatePose(i, time);
    states_[i].start = states_[i].end;
    states_[i].startVertices = states_[i].endVertices;
  }
  collect();
}

void BodyWorld::switchOn(std::size_t body, bool on) {
  states_[body].on = on;
  collect();
}

void BodyWorld::setSurface(std::size_t body, const SurfaceProperties& surface) {
  states_[body].surface = surface;
  collect();
}

void BodyWorld::deform(std::size_t body, std::shared_ptr<const Deformation> deformation) {
  states_[body].deformation = std::move(deformation);
}

std::shared_ptr<const Deformation> BodyWorld::deformation(std::size_t body) const {
  if (states_[body].deformation) {
    return states_[body].deformation;
  }
  const MeshShape* mesh = meshOf((*bodies_)[body]);
  return mesh == nullptr ? nullptr : mesh->deformation;
}

void BodyWorld::advance(double time, double timeStep) {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    BodyState& each = states_[i];
    const Vec3 remaining = each.targetShift - each.shift;
    const double maxShift = maxDragSpeed * timeStep;
    each.shift =
        remaining.norm() <= maxShift ? each.targetShift : Vec3(each.shift + maxShift / remaining.norm() * remaining);
    each.start = each.end;
    each.startVertices.swap(each.endVertices);
    updatePose(i, time + timeStep);
  }
  collect();
}

void BodyWorld::updatePose(std::size_t body, double time) {
  const Body& shape = (*bodies_)[body];
  BodyState& at = states_[body];
  at.end = poseAt(shape.motion, time);
  at.end.position += at.shift;
  if (at.deformation) {
    at.deformation->positionsAt(time, at.endVertices);
  } else if (deforms(shape)) {
    meshPositionsAt(*meshOf(shape), time, at.endVertices);
  }
}

bool BodyWorld::isDeforming(std::size_t body) const {
  return deforms((*bodies_)[body]);
}

std::span<const Vec3> BodyWorld::vertices(std::size_t body) const {
  const Body& shape = (*bodies_)[body];
  if (deforms(shape)) {
    return states_[body].endVertices;
  }
  const MeshShape* mesh = meshOf(shape);
  return mesh == nullptr ? std::span<const Vec3>() : std::span<const Vec3>(mesh->positions);
}

void BodyWorld::collect() {
  steps_.clear();
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const BodyState& each = states_[i];
    if (each.on) {
      const bool isDeforming = deforms((*bodies_)[i]);
      steps_.push_back({&(*bodies_)[i], each.start, each.end,
                        isDeforming ? std::span<const Vec3>(each.startVertices) : vertices(i), vertices(i),
                        each.surface});
    }
  }
}

}  // namespace drape::sim::contact
