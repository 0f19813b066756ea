#include "dressing/piercing.hpp"

#include "dressing/closed_body.hpp"
#include "dressing/dressing.hpp"
#include "intersection/intersections.hpp"

#include <algorithm>
#include <functional>
#include <utility>
#include <variant>

namespace drape::dressing {
namespace {

/// Larger bodies are not taken apart: it would take seconds.
constexpr std::size_t maxTriangles = 60'000;

Vec3 centreOf(std::span<const Vec3> positions, const Triangle& triangle) {
  return (positions[triangle[0]] + positions[triangle[1]] + positions[triangle[2]]) / 3.0;
}

}  // namespace

/// The parts of a body and the openings of the cloth, as they are at the start.
struct PiercingSearch::Anatomy {
  ShrinkingBody body;
  BodyParts parts;
  GarmentOpenings openings;
  Wearing wearing;

  Anatomy(sim::ClothMesh mesh, const scene::Scene& scene)
      : body(closedBody(std::move(mesh)).mesh),
        parts(body),
        openings({scene.start.positions, scene.model->triangles}),
        wearing(body, parts, openings, scene.model->triangles) {}
};

sim::ClothMesh placedBody(const sim::contact::Body& body, const sim::contact::Pose& pose,
                          std::span<const Vec3> vertices) {
  sim::contact::BodySurface surface = sim::contact::surfaceOf(body.shape);
  if (!vertices.empty()) {
    surface.positions.assign(vertices.begin(), vertices.end());
  }
  for (Vec3& position : surface.positions) {
    position = pose.toWorld(position);
  }
  return {std::move(surface.positions), std::move(surface.triangles)};
}

std::vector<PlacedBody> bodiesAtStart(const scene::Scene& scene) {
  std::vector<PlacedBody> placed;
  for (std::size_t i = 0; i < scene.bodies->size(); ++i) {
    const sim::contact::Body& body = (*scene.bodies)[i];
    if (!std::holds_alternative<sim::contact::PlaneShape>(body.shape)) {
      placed.push_back({i, placedBody(body, sim::contact::poseAt(body.motion, 0.0))});
    }
  }
  return placed;
}

PiercingSearch::PiercingSearch(std::shared_ptr<const scene::Scene> scene) : scene_(std::move(scene)) {}

PiercingSearch::~PiercingSearch() = default;

std::vector<Piercing> PiercingSearch::find(std::span<const Vec3> positions, std::span<const PlacedBody> bodies) {
  const std::vector<Triangle>& triangles = scene_->model->triangles;
  std::vector<Piercing> found;
  for (const PlacedBody& body : bodies) {
    const auto pairs =
        intersection::intersectingPairs({positions, triangles}, {body.mesh.positions, body.mesh.triangles});
    if (pairs.empty()) {
      continue;
    }
    Piercing piercing{body.body, pairs.size(), {}, Vec3::Zero()};
    for (const intersection::TrianglePair& pair : pairs) {
      piercing.centre += centreOf(positions, triangles[pair.first]) / static_cast<double>(pairs.size());
    }
    const Anatomy* anatomy = anatomyOf(body.body);
    piercing.faults = anatomy == nullptr
                          ? std::vector<Fault>{{FaultKind::PassesWall, BodyPart::Whole, false, pairs.size()}}
                          : anatomy->wearing.wallFaults(positions, pairs);
    std::ranges::stable_sort(piercing.faults, std::greater(), &Fault::pairs);
    found.push_back(std::move(piercing));
  }
  std::ranges::stable_sort(found, std::greater(), &Piercing::pairs);
  return found;
}

const PiercingSearch::Anatomy* PiercingSearch::anatomyOf(std::size_t body) {
  const auto known = anatomies_.find(body);
  if (known != anatomies_.end()) {
    return known->second.get();
  }
  std::unique_ptr<Anatomy>& anatomy = anatomies_[body];
  const sim::contact::Body& described = (*scene_->bodies)[body];
  sim::ClothMesh mesh = placedBody(described, sim::contact::poseAt(described.motion, 0.0));
  const Misfit misfit = misfitOf({scene_->start.positions, scene_->model->triangles}, mesh);
  const bool isClosed = misfit != Misfit::OpenBody && misfit != Misfit::NoVolume;
  if (isClosed && mesh.triangles.size() <= maxTriangles) {
    anatomy = std::make_unique<Anatomy>(std::move(mesh), *scene_);
  }
  return anatomy.get();
}

}  // namespace drape::dressing
