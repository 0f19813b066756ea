#include "ui/placed_shape.hpp"

#include "render/picking.hpp"
#include "sim/model/bounds.hpp"
#include "ui/body_picking.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <span>
#include <variant>

namespace drape::ui {
namespace {

using MeshPointer = std::shared_ptr<const sim::contact::MeshShape>;

/// The points and the radius of a shape in its own frame.
PlacedShape ownShapeOf(const sim::contact::BodyShape& shape) {
  if (const auto* sphere = std::get_if<sim::contact::SphereShape>(&shape)) {
    return {{Vec3::Zero()}, sphere->radius};
  }
  if (const auto* capsule = std::get_if<sim::contact::CapsuleShape>(&shape)) {
    return {{capsule->halfLength * Vec3::UnitY(), -capsule->halfLength * Vec3::UnitY()}, capsule->radius};
  }
  return {sim::contact::surfaceOf(shape).positions, 0.0};
}

/// The points before the placement that brought them to where they are.
PlacedShape withoutPlacement(PlacedShape shape, const scene::Placement& placement) {
  if (placement.isNone()) {
    return shape;
  }
  const sim::contact::Pose pose = placement.pose();
  for (Vec3& point : shape.points) {
    point = pose.toLocal(point) / placement.scale;
  }
  shape.radius /= placement.scale;
  return shape;
}

std::span<Vec3> positionsOf(const scene::ClothPart& cloth, std::vector<Vec3>& positions) {
  return std::span(positions).subspan(static_cast<std::size_t>(cloth.firstVertex),
                                      static_cast<std::size_t>(cloth.vertexCount));
}

/// From where one placement puts a point to where another one does.
class Moved {
 public:
  Moved(const scene::Placement& from, const scene::Placement& to)
      : from_(from.pose()), to_(to.pose()), scale_(to.scale / from.scale) {}

  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] Eigen::Quaterniond rotation() const { return to_.rotation * from_.rotation.conjugate(); }
  [[nodiscard]] Vec3 operator()(const Vec3& point) const { return to_.toWorld(scale_ * from_.toLocal(point)); }

 private:
  sim::contact::Pose from_;
  sim::contact::Pose to_;
  double scale_;
};

void showBody(const sim::contact::Body& body, double time, session::BodyStatus& status) {
  status.pose = sim::contact::poseAt(body.motion, time);
  status.shift.setZero();
  const auto* mesh = std::get_if<MeshPointer>(&body.shape);
  status.vertices = mesh != nullptr && (*mesh)->deforms() ? (*mesh)->positions : std::vector<Vec3>();
}

void moveBody(const Moved& moved, const sim::contact::Body& body, session::BodyStatus& status) {
  status.pose = {(moved.rotation() * status.pose.rotation).normalized(), moved(status.pose.position)};
  if (moved.scale() != 1.0) {
    status.vertices = sim::contact::surfaceOf(body.shape).positions;
    for (Vec3& vertex : status.vertices) {
      vertex *= moved.scale();
    }
  }
}

/// The first of several things that a ray hits.
struct NearestHit {
  double distance = std::numeric_limits<double>::infinity();
  PlacedHit hit;

  void add(double at, PlacedHit next) {
    if (at < distance) {
      distance = at;
      hit = std::move(next);
    }
  }
};

/// The cloth of a triangle.
std::size_t clothWith(int triangle, const scene::Scene& scene) {
  std::size_t cloth = 0;
  while (cloth + 1 < scene.cloths.size() && triangle >= scene.cloths[cloth + 1].firstTriangle) {
    ++cloth;
  }
  return cloth;
}

void addBodies(const render::Ray& ray, const session::Snapshot& snapshot, NearestHit& nearest) {
  const scene::Scene& scene = *snapshot.scene;
  const std::size_t placeable = scene.description.bodies.size();
  for (std::size_t i = 0; i < snapshot.bodies.size(); ++i) {
    const session::BodyStatus& status = snapshot.bodies[i];
    const sim::contact::Body& body = (*scene.bodies)[i];
    const bool isStand = i >= placeable && std::holds_alternative<MeshPointer>(body.shape);
    if (i < placeable ? !status.on || !body.drawn : !isStand) {
      continue;
    }
    if (const auto hit = pickBody(ray, body, status)) {
      nearest.add(hit->distance,
                  isStand ? PlacedHit{std::nullopt,
                                      "The stand cannot be placed. Write it as a body in the scene file to move it."}
                          : PlacedHit{scene::Placeable{scene::Placeable::Kind::Body, i}, {}});
    }
  }
}

void addGround(const render::Ray& ray, const session::Snapshot& snapshot, NearestHit& nearest) {
  const double distance = (snapshot.scene->groundHeight - ray.origin.y()) / ray.direction.y();
  if (std::isfinite(distance) && distance > 0.0) {
    nearest.add(distance,
                {std::nullopt, "The ground cannot be placed. ground.height in the scene file sets its height."});
  }
}

}  // namespace

Eigen::AlignedBox3d PlacedShape::box() const {
  Eigen::AlignedBox3d box = sim::boundsOf(points);
  box.min().array() -= radius;
  box.max().array() += radius;
  return box;
}

double PlacedShape::lowest(const scene::Placement& placement) const {
  const sim::contact::Pose pose = placement.pose();
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vec3& point : points) {
    lowest = std::min(lowest, pose.toWorld(placement.scale * point).y());
  }
  return lowest - placement.scale * radius;
}

PlacedShape placedShapeOf(const scene::Scene& scene, const scene::Placeable& thing) {
  const scene::Placement placement = scene::placementsOf(scene.description).of(thing);
  if (thing.kind == scene::Placeable::Kind::Cloth) {
    std::vector<Vec3> start = scene.start.positions;
    const std::span<Vec3> own = positionsOf(scene.cloths[thing.index], start);
    return withoutPlacement({{own.begin(), own.end()}, 0.0}, placement);
  }
  const sim::contact::Body& body = (*scene.bodies)[thing.index];
  PlacedShape shape = ownShapeOf(body.shape);
  const sim::contact::Pose pose = sim::contact::poseAt(body.motion, scene.start.time);
  for (Vec3& point : shape.points) {
    point = pose.toWorld(point);
  }
  return withoutPlacement(std::move(shape), placement);
}

void showPlaced(const scene::Placements& placements, session::Snapshot& snapshot) {
  const scene::Scene& scene = *snapshot.scene;
  snapshot.positions = scene.start.positions;
  for (std::size_t i = 0; i < scene.cloths.size(); ++i) {
    const scene::Placement& own = scene.description.cloths[i].placement;
    if (placements.cloths[i] != own) {
      const Moved moved(own, placements.cloths[i]);
      std::ranges::transform(positionsOf(scene.cloths[i], snapshot.positions),
                             positionsOf(scene.cloths[i], snapshot.positions).begin(), moved);
    }
  }
  for (std::size_t i = 0; i < snapshot.bodies.size(); ++i) {
    const sim::contact::Body& body = (*scene.bodies)[i];
    showBody(body, scene.start.time, snapshot.bodies[i]);
    if (i < placements.bodies.size() && placements.bodies[i] != scene.description.bodies[i].placement) {
      moveBody(Moved(scene.description.bodies[i].placement, placements.bodies[i]), body, snapshot.bodies[i]);
    }
  }
  snapshot.ghost.reset();
  snapshot.attachment.reset();
  snapshot.contactPoints.clear();
  snapshot.intersections.clear();
}

double gapToGround(const session::Snapshot& snapshot, const scene::Placeable& thing) {
  if (thing.kind == scene::Placeable::Kind::Body || !snapshot.scene->description.ground || snapshot.bodies.empty()) {
    return 0.0;
  }
  // The ground is the last body. The contact offset is its thickness and half of that of the cloth.
  return snapshot.bodies.back().surface.thickness + 0.5 * snapshot.settings.step.contact.thickness;
}

PlacedHit placedHitBy(const render::Ray& ray, const session::Snapshot& snapshot) {
  NearestHit nearest;
  if (const auto hit = render::pick(ray, snapshot.positions, snapshot.model->triangles)) {
    nearest.add(hit->distance,
                {scene::Placeable{scene::Placeable::Kind::Cloth, clothWith(hit->triangle, *snapshot.scene)}, {}});
  }
  addBodies(ray, snapshot, nearest);
  addGround(ray, snapshot, nearest);
  return nearest.hit;
}

}  // namespace drape::ui
