#include "sim/contact/broad_phase/reachable_bodies.hpp"

#include "sim/contact/recovery/solid.hpp"
#include "sim/model/bounds.hpp"

#include <algorithm>
#include <variant>

namespace drape::sim::contact {
namespace {

constexpr double clearanceRatio = 1.25;  // distance beyond which there is no contact, over the contact offset [-]

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

/// Whether points that move from one box into another in the step could come closer to the body than `far` [m]. They
/// move on straight lines in the body's frame.
bool couldMeet(const BodyStep& body, const SearchableMesh* mesh, const Eigen::AlignedBox3d& start,
               const Eigen::AlignedBox3d& end, double far) {
  const Eigen::AlignedBox3d sweep = inFrame(body.start, start).merged(inFrame(body.end, end));
  if (std::holds_alternative<PlaneShape>(body.body->shape)) {
    return sweep.min().y() < far;
  }
  const double radius = boundingRadius(body.body->shape);
  const Eigen::AlignedBox3d box =
      mesh != nullptr ? mesh->tree.bounds() : Eigen::AlignedBox3d(Vec3::Constant(-radius), Vec3::Constant(radius));
  return inflated(box, far).intersects(sweep);
}

/// Transforms positions into a frame.
class IntoFrame {
 public:
  explicit IntoFrame(const Pose& pose) : turn_(pose.rotation.conjugate().toRotationMatrix()), origin_(pose.position) {}
  Vec3 operator()(const Vec3& position) const { return turn_ * (position - origin_); }

 private:
  Mat3 turn_;
  Vec3 origin_;
};

/// Whether a body is a rigid mesh.
bool isRigidMesh(const BodyStep& body, const SearchableMesh* mesh) {
  return mesh != nullptr && !mesh->isDeforming() && !std::holds_alternative<BoxShape>(body.body->shape);
}

}  // namespace

double contactOffsetOf(const BodyStep& step, const ContactParameters& contact) {
  return step.surface.thickness + 0.5 * contact.thickness;
}

ReachableBodies::Mesh* ReachableBodies::meshOf(const BodyStep& body) {
  const auto* shape = std::get_if<std::shared_ptr<const MeshShape>>(&body.body->shape);
  const bool box = std::holds_alternative<BoxShape>(body.body->shape);
  if (shape == nullptr && !box) {
    return nullptr;
  }
  auto at = meshes_.find(body.body);
  if (at == meshes_.end()) {
    if (box) {
      const BodySurface surface = surfaceOf(body.body->shape);
      at = meshes_.try_emplace(body.body, MeshShape{surface.positions, surface.triangles, {}, 1.0, false}).first;
    } else {
      at = meshes_.try_emplace(body.body, **shape).first;
    }
  }
  Mesh& mesh = at->second;
  if (mesh.searchable.isDeforming()) {
    mesh.searchable.follow(body.startVertices, body.endVertices);
  }
  return &mesh;
}

ClothMotion ReachableBodies::motionIn(const BodyStep& body, const ClothModel& model, const PreparedCloth& cloth,
                                      const std::vector<Vec3>& start, const std::vector<Vec3>& end) {
  const IntoFrame toStart(body.start);
  const IntoFrame toEnd(body.end);
  localStart_.resize(start.size());
  localEnd_.resize(end.size());
  std::transform(start.begin(), start.end(), localStart_.begin(), toStart);
  std::transform(end.begin(), end.end(), localEnd_.begin(), toEnd);
  return {model, cloth.clusters, localStart_, localEnd_};
}

/// The same for one cluster only.
ClothMotion ReachableBodies::clusterMotionIn(const BodyStep& body, const ClothModel& model, const PreparedCloth& cloth,
                                             std::size_t cluster, const std::vector<Vec3>& start,
                                             const std::vector<Vec3>& end) {
  const IntoFrame toStart(body.start);
  const IntoFrame toEnd(body.end);
  localStart_.resize(start.size());
  localEnd_.resize(end.size());
  for (const int v : cloth.clusters.vertices(cluster)) {
    localStart_[v] = toStart(start[v]);
    localEnd_[v] = toEnd(end[v]);
  }
  return {model, cloth.clusters, localStart_, localEnd_};
}

/// Whether free cloth comes within the distance `far` [m] of a rigid mesh. The cluster that was near the last time is
/// tested first, so that the rest of the cloth need not be transformed.
bool ReachableBodies::isNear(const BodyStep& body, Mesh& mesh, const ClothModel& model, const PreparedCloth& cloth,
                             const std::vector<Vec3>& start, const std::vector<Vec3>& end, double far) {
  const std::size_t first = mesh.nearCluster;
  if (first < cloth.clusters.count() &&
      freeClothIsNear(mesh.searchable, clusterMotionIn(body, model, cloth, first, start, end), far, first)) {
    return true;
  }
  return anyFreeClothIsNear(mesh.searchable, motionIn(body, model, cloth, start, end), far, mesh.nearCluster);
}

/// Whether the cloth certainly does not touch a mesh on its way to the predicted and to the present positions. The
/// cluster that could meet the mesh the last time is tested first, so that the rest of the cloth need not be
/// transformed.
bool ReachableBodies::isKnownClearOf(const ClothStep& step, const PreparedCloth& cloth, const BodyStep& body,
                                     Mesh& mesh, const std::vector<Vec3>& positions) {
  const SearchableMesh& searchable = mesh.searchable;
  const double offset = clearanceRatio * contactOffsetOf(body, step.contact);
  const std::size_t first = mesh.clearance.lastCluster();
  if (first < cloth.clusters.count() &&
      mesh.clearance.couldMeet(searchable, clusterMotionIn(body, step.model, cloth, first, step.start, step.predicted),
                               offset, cloth.number, first)) {
    return false;
  }
  for (const std::vector<Vec3>* ends : {&step.predicted, &positions}) {
    if (mesh.clearance.couldMeet(searchable, motionIn(body, step.model, cloth, step.start, *ends), offset,
                                 cloth.number)) {
      return false;
    }
  }
  if (!searchable.closed) {
    return true;
  }
  const MeshInStep inStep{searchable, searchable.shape.positions, searchable.shape.positions};
  MeshSolid solid(inStep);
  return std::none_of(cloth.pieces.begin(), cloth.pieces.end(), [&](int v) {
    const Vec3& position = vectorAt(localStart_, v);
    return searchable.tree.bounds().contains(position) && solid.contains(position);
  });
}

bool ReachableBodies::couldReachAny(const ContactParameters& contact, const std::vector<BodyStep>& bodies,
                                    const Eigen::AlignedBox3d& start, const Eigen::AlignedBox3d& end) {
  return std::any_of(bodies.begin(), bodies.end(), [&](const BodyStep& body) {
    const Mesh* mesh = meshOf(body);
    return couldMeet(body, mesh != nullptr ? &mesh->searchable : nullptr, start, end,
                     2.0 * contactOffsetOf(body, contact));
  });
}

bool ReachableBodies::isNearAny(const ClothModel& model, const PreparedCloth& cloth, const ContactParameters& contact,
                                const std::vector<BodyStep>& bodies, const std::vector<Vec3>& start,
                                const std::vector<Vec3>& end, double spread) {
  const Eigen::AlignedBox3d startBox = boundsOf(start);
  const Eigen::AlignedBox3d endBox = inflated(boundsOf(end), spread);
  return std::any_of(bodies.begin(), bodies.end(), [&](const BodyStep& body) {
    Mesh* found = meshOf(body);
    const SearchableMesh* mesh = found != nullptr ? &found->searchable : nullptr;
    const double offset = contactOffsetOf(body, contact);
    return couldMeet(body, mesh, startBox, endBox, 2.0 * offset) &&
           (!isRigidMesh(body, mesh) || isNear(body, *found, model, cloth, start, end, offset + spread));
  });
}

std::vector<ReachableBody> ReachableBodies::find(const ClothStep& step, const PreparedCloth& cloth,
                                                 const std::vector<BodyStep>& bodies,
                                                 const std::vector<Vec3>& positions, const Eigen::AlignedBox3d& ends,
                                                 const std::vector<const BodyStep*>& known) {
  const Eigen::AlignedBox3d start = boundsOf(step.start);
  std::vector<ReachableBody> found;
  for (const BodyStep& body : bodies) {
    if (std::find(known.begin(), known.end(), &body) != known.end()) {
      continue;
    }
    Mesh* mesh = meshOf(body);
    SearchableMesh* searchable = mesh != nullptr ? &mesh->searchable : nullptr;
    if (couldMeet(body, searchable, start, ends, 2.0 * contactOffsetOf(body, step.contact)) &&
        !(isRigidMesh(body, searchable) && isKnownClearOf(step, cloth, body, *mesh, positions))) {
      found.push_back({&body, searchable});
    }
  }
  return found;
}

}  // namespace drape::sim::contact
