#include "render/body_drawing.hpp"

#include "render/creases.hpp"

#include <algorithm>
#include <cmath>

namespace drape::render {
namespace {

constexpr double creaseAngle = 0.7;  // sharper edges get separate normals [rad]
constexpr double sectors = 8.0;      // number of coloured sectors around a round body

/// The sector of a point around a round body's axis, as a wave that changes its sign from sector to sector. A wave has
/// no seam where the circle closes.
Vec2 sectorWave(const sim::contact::BodyShape& shape, const Vec3& position) {
  const bool round = std::holds_alternative<sim::contact::SphereShape>(shape) ||
                     std::holds_alternative<sim::contact::CapsuleShape>(shape);
  return {round ? std::sin(0.5 * sectors * std::atan2(position.x(), position.z())) : 0.0, 0.0};
}

}  // namespace

void BodyDrawing::takeScene(const scene::Scene& scene) {
  bodies_.clear();
  for (std::size_t i = 0; i < scene.bodies->size(); ++i) {
    const sim::contact::Body& body = (*scene.bodies)[i];
    if (!body.drawn) {
      continue;
    }
    auto drawn = std::make_unique<Drawn>();
    const sim::contact::BodySurface surface = sim::contact::surfaceOf(body.shape);
    CreasedMesh creased = splitAtCreases(surface.positions, surface.triangles, creaseAngle);
    drawn->body = i;
    drawn->endless = std::holds_alternative<sim::contact::PlaneShape>(body.shape);
    drawn->source.assign(creased.positions.size(), 0);
    for (std::size_t t = 0; t < creased.triangles.size(); ++t) {
      for (std::size_t c = 0; c < 3; ++c) {
        drawn->source[creased.triangles[t][c]] = surface.triangles[t][c];
      }
    }
    std::vector<Vec2> waves;
    std::transform(creased.positions.begin(), creased.positions.end(), std::back_inserter(waves),
                   [&](const Vec3& position) { return sectorWave(body.shape, position); });
    drawn->mesh.setTopology({creased.triangles, creased.triangles, {}, waves});
    drawn->positions = std::move(creased.positions);
    bodies_.push_back(std::move(drawn));
  }
}

void BodyDrawing::take(const session::Snapshot& snapshot) {
  for (const auto& drawn : bodies_) {
    const session::BodyStatus& status = snapshot.bodies[drawn->body];
    drawn->on = status.on && snapshot.settings.step.contact.bodies;
    const bool stays = drawn->placed && !drawn->deformed && status.vertices.empty() &&
                       drawn->pose.position == status.pose.position &&
                       drawn->pose.rotation.coeffs() == status.pose.rotation.coeffs();
    if (!stays) {
      place(status, *drawn);
    }
  }
}

void BodyDrawing::place(const session::BodyStatus& status, Drawn& drawn) {
  drawn.placed = true;
  drawn.pose = status.pose;
  drawn.deformed = !status.vertices.empty();
  moved_.resize(drawn.positions.size());
  for (std::size_t v = 0; v < moved_.size(); ++v) {
    const Vec3& local = status.vertices.empty() ? drawn.positions[v] : status.vertices[drawn.source[v]];
    moved_[v] = status.pose.toWorld(local);
  }
  drawn.mesh.setPositions(moved_);
}

void BodyDrawing::draw() const {
  for (const auto& drawn : bodies_) {
    if (drawn->on) {
      drawn->mesh.draw();
    }
  }
}

void BodyDrawing::addMeshes(std::vector<const SmoothMesh*>& meshes) const {
  for (const auto& drawn : bodies_) {
    if (drawn->on) {
      meshes.push_back(&drawn->mesh);
    }
  }
}

Eigen::AlignedBox3d BodyDrawing::bounds() const {
  Eigen::AlignedBox3d box;
  for (const auto& drawn : bodies_) {
    if (drawn->on && !drawn->endless) {
      box.extend(drawn->mesh.bounds());
    }
  }
  return box;
}

}  // namespace drape::render
