// Which bodies BodyContact looks at in a step.
#include "sim/bounds.hpp"
#include "sim/contact/solve/body_contact.hpp"

#include <algorithm>
#include <variant>

namespace drape {
namespace {

constexpr double edgeOffsetRatio = 0.6;  // of the distance that is kept: at which edges and faces are stopped [-]
constexpr double minimumSeparationRatio = 0.1;  // of the distance that is kept: what is never gone below [-]
constexpr double clearanceRatio = 1.25;         // of the distance that is kept: beyond that there is no contact [-]
constexpr double recoverySpeed = 0.25;          // at which an overlap is undone, or up to four times that [m/s]

/// Half the extent of a body around its origin, as far as it is known without looking at its mesh [m].
double boundingRadius(const BodyShape& shape) {
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
  const Eigen::AlignedBox3d path = inFrame(step.start, start).merged(inFrame(step.end, end));
  if (std::holds_alternative<PlaneShape>(step.body->shape)) {
    return path.min().y() < far;
  }
  const double radius = boundingRadius(step.body->shape);
  const Eigen::AlignedBox3d body =
      mesh != nullptr ? mesh->tree.bounds() : Eigen::AlignedBox3d(Vec3::Constant(-radius), Vec3::Constant(radius));
  return inflated(body, far).intersects(path);
}

/// Whether a body is a mesh that does not move in itself.
bool isRigidMesh(const BodyStep& step, const SearchableMesh* mesh) {
  return mesh != nullptr && !mesh->isDeforming() && !std::holds_alternative<BoxShape>(step.body->shape);
}

/// How far vertices are kept from a body [m].
double contactOffsetOf(const BodyStep& step, const StepParameters& parameters) {
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
                   [&](const Vec3& prepareBodyFrames) -> Vec3 { return turn * (prepareBodyFrames - pose.position); });
  };
  toFrame(step.start, start, localStart_);
  toFrame(step.end, end, localEnd_);
  return {model, clustersOf(model), localStart_, localEnd_};
}

/// Whether the cloth can be known not to contact a mesh on its way to where the solver, or another body, put it.
bool BodyContact::isKnownClearOf(const Cloth& cloth, const BodyStep& step, const SearchableMesh& mesh,
                                 const std::vector<Vec3>& positions) {
  const double offset = clearanceRatio * contactOffsetOf(step, cloth.parameters);
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
    const Vec3& prepareBodyFrames = vectorAt(localStart_, v);
    return mesh.tree.bounds().contains(prepareBodyFrames) && solid.contains(prepareBodyFrames);
  });
}

/// Chooses the bodies that the cloth could meet on its way into the box `ends` [m], besides those already chosen.
/// @param positions where the bodies that are chosen have put it [m]
/// @return true when there are such
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
    if (couldMeet(step, mesh, start, ends, 2.0 * contactOffsetOf(step, cloth.parameters)) &&
        !(isRigidMesh(step, mesh) && isKnownClearOf(cloth, step, *mesh, positions))) {
      addNearBody(cloth, step, mesh);
    }
  }
  return nearCount_ > before;
}

bool BodyContact::couldReachAnyBody(const StepParameters& parameters, const std::vector<BodyStep>& bodies,
                                    const Eigen::AlignedBox3d& start, const Eigen::AlignedBox3d& end) {
  return std::any_of(bodies.begin(), bodies.end(), [&](const BodyStep& step) {
    return couldMeet(step, meshOf(step), start, end, 2.0 * contactOffsetOf(step, parameters));
  });
}

bool BodyContact::isNearAnyBody(const ClothModel& model, const StepParameters& parameters,
                                const std::vector<BodyStep>& bodies, const std::vector<Vec3>& start,
                                const std::vector<Vec3>& end, double spread) {
  const Eigen::AlignedBox3d startBox = boundsOf(start);
  const Eigen::AlignedBox3d endBox = inflated(boundsOf(end), spread);
  return std::any_of(bodies.begin(), bodies.end(), [&](const BodyStep& step) {
    const SearchableMesh* mesh = meshOf(step);
    const double offset = contactOffsetOf(step, parameters);
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
  const double offset = contactOffsetOf(step, cloth.parameters);
  const double recoveryStep = recoverySpeed * cloth.parameters.timeStep;
  near.offsets = {offset, edgeOffsetRatio * offset, minimumSeparationRatio * offset, recoveryStep, recoveryStep};
}

}  // namespace drape
