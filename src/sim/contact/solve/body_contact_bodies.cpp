// Broad phase of BodyContact: chooses the bodies that the cloth could reach in a step.
#include "sim/contact/solve/body_contact.hpp"
#include "sim/model/bounds.hpp"

#include <algorithm>
#include <variant>

namespace drape::sim::contact {
namespace {

// Ratios to the contact offset [-]:
constexpr double edgeOffsetRatio = 0.6;         // distance of edges and faces
constexpr double minimumSeparationRatio = 0.1;  // minimum separation
constexpr double clearanceRatio = 1.25;         // distance beyond which there is no contact
constexpr double recoverySpeed =
    0.25;  // speed at which overlaps are resolved, up to four times as fast where deep [m/s]

/// Radius of a sphere or a capsule around its origin [m]; 0 for other shapes.
double boundingRadius(const BodyShape& shape) {
  if (const auto* sphere = std::get_if<SphereShape>(&shape)) {
    return sphere->radius;
  }
  const auto* capsule = std::get_if<CapsuleShape>(&shape);
  return capsule == nullptr ? 0.0 : capsule->radius + capsule->halfLength;
}

/// The bounding box in a body's frame of a box in the world frame.
Eigen::AlignedBox3d inFrame(const Pose& pose, const Eigen::AlignedBox3d& box) {
  Eigen::AlignedBox3d local;
  for (int corner = 0; corner < 8; ++corner) {
    local.extend(pose.toLocal(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner))));
  }
  return local;
}

/// Whether points that move from one box into another during the step could come closer to the body than `far` [m].
/// Motion is straight in the body's frame.
bool couldMeet(const BodyStep& step, const SearchableMesh* mesh, const Eigen::AlignedBox3d& start,
               const Eigen::AlignedBox3d& end, double far) {
  const Eigen::AlignedBox3d sweep = inFrame(step.start, start).merged(inFrame(step.end, end));
  if (std::holds_alternative<PlaneShape>(step.body->shape)) {
    return sweep.min().y() < far;
  }
  const double radius = boundingRadius(step.body->shape);
  const Eigen::AlignedBox3d body =
      mesh != nullptr ? mesh->tree.bounds() : Eigen::AlignedBox3d(Vec3::Constant(-radius), Vec3::Constant(radius));
  return inflated(body, far).intersects(sweep);
}

/// Whether a body is a rigid mesh.
bool isRigidMesh(const BodyStep& step, const SearchableMesh* mesh) {
  return mesh != nullptr && !mesh->isDeforming() && !std::holds_alternative<BoxShape>(step.body->shape);
}

/// The contact offset of vertices from a body [m].
double contactOffsetOf(const BodyStep& step, const ContactParameters& contact) {
  return step.surface.thickness + 0.5 * contact.thickness;
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
  if (mesh->isDeforming()) {
    mesh->follow(step.startVertices, step.endVertices);
  }
  return mesh.get();
}

ClothMotion BodyContact::motionIn(const BodyStep& step, const ClothModel& model, const std::vector<Vec3>& start,
                                  const std::vector<Vec3>& end) {
  const auto toFrame = [](const Pose& pose, const std::vector<Vec3>& positions, std::vector<Vec3>& local) {
    const Mat3 turn = pose.rotation.conjugate().toRotationMatrix();
    local.resize(positions.size());
    std::transform(positions.begin(), positions.end(), local.begin(),
                   [&](const Vec3& position) -> Vec3 { return turn * (position - pose.position); });
  };
  toFrame(step.start, start, localStart_);
  toFrame(step.end, end, localEnd_);
  return {model, clustersOf(model), localStart_, localEnd_};
}

/// Whether the cloth certainly does not touch a mesh on its way to the predicted and to the current positions.
bool BodyContact::isKnownClearOf(const Cloth& cloth, const BodyStep& step, const SearchableMesh& mesh,
                                 const std::vector<Vec3>& positions) {
  const double offset = clearanceRatio * contactOffsetOf(step, cloth.contact);
  MeshClearance& clearance = clearances_[step.body];
  for (const std::vector<Vec3>* ends : {&cloth.predicted, &positions}) {
    if (clearance.couldMeet(mesh, motionIn(step, cloth.model, cloth.start, *ends), offset, models_)) {
      return false;
    }
  }
  if (!mesh.closed) {
    return true;
  }
  const MeshInStep inStep{mesh, mesh.shape.positions, mesh.shape.positions};
  MeshSolid solid(inStep);
  const std::vector<int>& pieces = piecesOf(cloth.model);
  return std::none_of(pieces.begin(), pieces.end(), [&](int v) {
    const Vec3& position = vectorAt(localStart_, v);
    return mesh.tree.bounds().contains(position) && solid.contains(position);
  });
}

/// Adds the bodies that the cloth could reach on its way into the box `ends`, besides those already chosen.
/// @param positions current positions, corrected by the bodies already chosen [m]
/// @return true if bodies were added
bool BodyContact::chooseBodies(const Cloth& cloth, const std::vector<BodyStep>& bodies,
                               const std::vector<Vec3>& positions, const Eigen::AlignedBox3d& ends) {
  const Eigen::AlignedBox3d start = boundsOf(cloth.start);
  const std::size_t before = nearCount_;
  for (const BodyStep& step : bodies) {
    const auto last = near_.begin() + static_cast<std::ptrdiff_t>(before);
    if (std::any_of(near_.begin(), last, [&](const NearBody& near) { return near.step == &step; })) {
      continue;
    }
    SearchableMesh* mesh = meshOf(step);
    if (couldMeet(step, mesh, start, ends, 2.0 * contactOffsetOf(step, cloth.contact)) &&
        !(isRigidMesh(step, mesh) && isKnownClearOf(cloth, step, *mesh, positions))) {
      addNearBody(cloth, step, mesh);
    }
  }
  return nearCount_ > before;
}

void BodyContact::carryAlong(std::vector<Vec3>& positions) const {
  std::vector<int> bodyOf(positions.size(), -1);
  for (const SeparatingPlane& plane : planes()) {
    if (bodyOf[plane.vertex] < 0) {
      bodyOf[plane.vertex] = plane.body;
      const BodyStep& step = *near_[plane.body].step;
      positions[plane.vertex] = step.end.toWorld(step.start.toLocal(positions[plane.vertex]));
    }
  }
}

bool BodyContact::couldReachAnyBody(const ContactParameters& contact, const std::vector<BodyStep>& bodies,
                                    const Eigen::AlignedBox3d& start, const Eigen::AlignedBox3d& end) {
  return std::any_of(bodies.begin(), bodies.end(), [&](const BodyStep& step) {
    return couldMeet(step, meshOf(step), start, end, 2.0 * contactOffsetOf(step, contact));
  });
}

bool BodyContact::isNearAnyBody(const ClothModel& model, const ContactParameters& contact,
                                const std::vector<BodyStep>& bodies, const std::vector<Vec3>& start,
                                const std::vector<Vec3>& end, double spread) {
  const Eigen::AlignedBox3d startBox = boundsOf(start);
  const Eigen::AlignedBox3d endBox = inflated(boundsOf(end), spread);
  return std::any_of(bodies.begin(), bodies.end(), [&](const BodyStep& step) {
    const SearchableMesh* mesh = meshOf(step);
    const double offset = contactOffsetOf(step, contact);
    return couldMeet(step, mesh, startBox, endBox, 2.0 * offset) &&
           (!isRigidMesh(step, mesh) || freeClothIsNear(*mesh, motionIn(step, model, start, end), offset + spread));
  });
}

void BodyContact::addNearBody(const Cloth& cloth, const BodyStep& step, SearchableMesh* mesh) {
  if (near_.size() == nearCount_) {
    near_.emplace_back();
  }
  NearBody& near = near_[nearCount_++];
  near.step = &step;
  near.mesh = mesh;
  const double offset = contactOffsetOf(step, cloth.contact);
  const double recoveryStep = recoverySpeed * cloth.parameters.timeStep;
  near.offsets = {offset, edgeOffsetRatio * offset, minimumSeparationRatio * offset, recoveryStep, recoveryStep};
}

}  // namespace drape::sim::contact
