#include "sim/fields/body_gaps.hpp"

#include "sim/contact/broad_phase/searchable_mesh.hpp"
#include "sim/contact/closest_features/nearest_search.hpp"
#include "sim/contact/recovery/solid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>
#include <utility>
#include <variant>

namespace drape::sim::fields {
namespace {

using contact::MeshShape;

double distanceTo(const contact::PlaneShape& /*plane*/, const Vec3& point) {
  return point.y();
}

double distanceTo(const contact::SphereShape& sphere, const Vec3& point) {
  return point.norm() - sphere.radius;
}

double distanceTo(const contact::CapsuleShape& capsule, const Vec3& point) {
  const Vec3 core(0.0, std::clamp(point.y(), -capsule.halfLength, capsule.halfLength), 0.0);
  return (point - core).norm() - capsule.radius;
}

double distanceTo(const contact::BoxShape& box, const Vec3& point) {
  const Vec3 beyond = point.cwiseAbs() - box.half;
  return beyond.cwiseMax(0.0).norm() + std::min(0.0, beyond.maxCoeff());
}

/// Meshes are searched apart.
double distanceTo(const std::shared_ptr<const MeshShape>& /*mesh*/, const Vec3& /*point*/) {
  return std::numeric_limits<double>::infinity();
}

/// Whether the front of the nearest triangle points away from the point. Only then it may be inside.
bool pointsAway(const contact::MeshInStep& mesh, const contact::NearestMeshPoint& near, const Vec3& point) {
  const contact::Corners corners = mesh.startCorners(near.triangle);
  return contact::faceNormal(corners).dot(point - contact::pointAt(corners, near.weights)) < 0.0;
}

}  // namespace

struct BodyGaps::Mesh {
  contact::SearchableMesh search;
};

BodyGaps::BodyGaps(std::shared_ptr<const std::vector<contact::Body>> bodies) : bodies_(std::move(bodies)) {
  for (const contact::Body& body : *bodies_) {
    const auto* mesh = std::get_if<std::shared_ptr<const MeshShape>>(&body.shape);
    meshes_.push_back(mesh == nullptr ? nullptr : std::make_unique<Mesh>(Mesh{contact::SearchableMesh(**mesh)}));
  }
}

BodyGaps::~BodyGaps() = default;

bool BodyGaps::moveTo(std::vector<BodyPlace> places) {
  places_ = std::move(places);
  BodyPlace off;
  off.on = false;
  places_.resize(bodies_->size(), off);
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (meshes_[i] && places_[i].on && meshes_[i]->search.isDeforming()) {
      meshes_[i]->search.follow(places_[i].vertices, places_[i].vertices);
    }
  }
  return std::any_of(places_.begin(), places_.end(), [](const BodyPlace& place) { return place.on; });
}

void BodyGaps::compute(std::span<const Vec3> positions, std::span<double> gaps) {
  std::fill(gaps.begin(), gaps.end(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (!places_[i].on) {
      continue;
    }
    if (meshes_[i]) {
      meetMesh(i, positions, gaps);
      continue;
    }
    for (std::size_t v = 0; v < positions.size(); ++v) {
      const Vec3 local = places_[i].pose.toLocal(positions[v]);
      const double gap = std::visit([&](const auto& shape) { return distanceTo(shape, local); }, (*bodies_)[i].shape);
      gaps[v] = std::min(gaps[v], gap);
    }
  }
}

/// A vertex is at most as far from the mesh as the vertex before it plus their distance, which bounds its search.
void BodyGaps::meetMesh(std::size_t body, std::span<const Vec3> positions, std::span<double> gaps) {
  const contact::SearchableMesh& mesh = meshes_[body]->search;
  const BodyPlace& place = places_[body];
  const std::span<const Vec3> vertices =
      mesh.isDeforming() ? place.vertices : std::span<const Vec3>(mesh.shape.positions);
  const contact::MeshInStep in{mesh, vertices, vertices};
  const int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  workers_.forRange(threads, static_cast<int>(positions.size()), [&](int begin, int end) {
    contact::NearestSearch search(in);
    contact::MeshSolid solid(in);
    double radius = std::numeric_limits<double>::infinity();
    Vec3 previous = Vec3::Zero();
    for (int v = begin; v < end; ++v) {
      const Vec3 local = place.pose.toLocal(positions[v]);
      const contact::NearestMeshPoint near = search.anywhere(local, radius + (local - previous).norm());
      if (near.triangle < 0) {
        radius = std::numeric_limits<double>::infinity();
        continue;
      }
      const bool inside = mesh.closed && pointsAway(in, near, local) && solid.contains(local);
      gaps[v] = std::min(gaps[v], inside ? -near.gap : near.gap);
      constexpr double rounding = 1e-9;  // so that the bound never excludes the nearest point [m]
      radius = near.gap * (1.0 + rounding) + rounding;
      previous = local;
    }
  });
}

}  // namespace drape::sim::fields
