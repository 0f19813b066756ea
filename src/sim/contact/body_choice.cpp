// Which bodies BodyContact looks at in a step.
#include "sim/bounds.hpp"
#include "sim/contact/body_contact.hpp"

#include <algorithm>

namespace drape {
namespace {

constexpr double innerShare = 0.6;     // of the distance that is kept: at which edges and faces are stopped [-]
constexpr double guardShare = 0.1;     // of the distance that is kept: what is never gone below [-]
constexpr double overlapSpeed = 0.25;  // at which an overlap is undone, or up to four times that [m/s]

/// Half the extent of a body around its origin, as far as it is known without looking at its mesh [m].
double roundRadius(const BodyShape& shape) {
  if (const auto* sphere = std::get_if<SphereShape>(&shape)) {
    return sphere->radius;
  }
  const auto* capsule = std::get_if<CapsuleShape>(&shape);
  return capsule == nullptr ? 0.0 : capsule->radius + capsule->halfLength;
}

/// The box in a body's frame around what a box in the world holds.
Eigen::AlignedBox3d inFrame(const Pose& pose, const Eigen::AlignedBox3d& box) {
  Eigen::AlignedBox3d local;
  for (int corner = 0; corner < 8; ++corner) {
    local.extend(pose.toLocal(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner))));
  }
  return local;
}

/// Whether what is in one box when the step begins and in another when it ends could come nearer to the body than
/// `far` meanwhile. As everything here, that is judged in the body's frame.
bool couldMeet(const BodyStep& step, const SearchableMesh* mesh, const Eigen::AlignedBox3d& start,
               const Eigen::AlignedBox3d& end, double far) {
  const Eigen::AlignedBox3d way = inFrame(step.start, start).merged(inFrame(step.end, end));
  if (std::holds_alternative<PlaneShape>(step.body->shape)) {
    return way.min().y() < far;
  }
  const double radius = roundRadius(step.body->shape);
  const Eigen::AlignedBox3d body =
      mesh != nullptr ? mesh->tree.bounds() : Eigen::AlignedBox3d(Vec3::Constant(-radius), Vec3::Constant(radius));
  return inflated(body, far).intersects(way);
}

/// How far vertices are kept from a body [m].
double keptFrom(const BodyStep& step, const StepParameters& parameters) {
  return step.surface.thickness + 0.5 * parameters.contact.thickness;
}

}  // namespace

SearchableMesh* BodyContact::meshOf(const BodyStep& step) {
  const auto* shape = std::get_if<std::shared_ptr<const MeshShape>>(&step.body->shape);
  const bool box = std::holds_alternative<BoxShape>(step.body->shape);
  if (shape == nullptr && !box) {
    return nullptr;
  }
  std::unique_ptr<SearchableMesh>& mesh = meshes_[step.body];
  if (!mesh) {
    if (box) {
      const BodySurface surface = surfaceOf(step.body->shape);
      mesh = std::make_unique<SearchableMesh>(MeshShape{surface.positions, surface.triangles, {}, 1.0, false});
    } else {
      mesh = std::make_unique<SearchableMesh>(**shape);
    }
  }
  if (mesh->movesInItself()) {
    mesh->follow(step.startVertices, step.endVertices);
  }
  return mesh.get();
}

/// Chooses the bodies that the cloth could meet on its way into the box `ends` [m], besides those already chosen.
/// @return true when there are such
bool BodyContact::chooseBodies(const Cloth& cloth, const std::vector<BodyStep>& bodies,
                               const Eigen::AlignedBox3d& ends) {
  const Eigen::AlignedBox3d start = boundsOf(cloth.start);
  const std::size_t before = nearCount_;
  for (const BodyStep& step : bodies) {
    const auto last = near_.begin() + static_cast<std::ptrdiff_t>(before);
    if (std::any_of(near_.begin(), last, [&](const NearBody& near) { return near.step == &step; })) {
      continue;
    }
    SearchableMesh* mesh = meshOf(step);
    if (couldMeet(step, mesh, start, ends, 2.0 * keptFrom(step, cloth.parameters))) {
      addNear(cloth, step, mesh);
    }
  }
  return nearCount_ > before;
}

bool BodyContact::couldMeetAny(const StepParameters& parameters, const std::vector<BodyStep>& bodies,
                               const Eigen::AlignedBox3d& start, const Eigen::AlignedBox3d& end) {
  return std::any_of(bodies.begin(), bodies.end(), [&](const BodyStep& step) {
    return couldMeet(step, meshOf(step), start, end, 2.0 * keptFrom(step, parameters));
  });
}

void BodyContact::addNear(const Cloth& cloth, const BodyStep& step, SearchableMesh* mesh) {
  if (near_.size() == nearCount_) {
    near_.emplace_back();
  }
  NearBody& near = near_[nearCount_++];
  near.step = &step;
  near.mesh = mesh;
  const double keep = keptFrom(step, cloth.parameters);
  const double push = overlapSpeed * cloth.parameters.timeStep;
  near.reach = {keep, innerShare * keep, guardShare * keep, push, push};
}

}  // namespace drape
