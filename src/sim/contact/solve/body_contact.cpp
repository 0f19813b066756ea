#include "sim/contact/solve/body_contact.hpp"

#include "sim/contact/constraints/collect_in_order.hpp"
#include "sim/model/bounds.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace drape::sim::contact {
namespace {

constexpr int maxPasses = 4;
constexpr int maxPartialPlaneSearches = 6;  // then planes are searched for all triangles, not only for moved ones
constexpr int positionIterations = 6;
constexpr int velocityIterations = 6;

/// The displacement of the closest point of a mesh in the body's frame [m], at any distance: a triangle can be stopped
/// by a part of the mesh that is far from all of its vertices.
Vec3 nearestDisplacement(const MeshInStep& mesh, const Vec3& position) {
  NearestSearch search(mesh);
  const NearestMeshPoint near = search.anywhere(position, std::numeric_limits<double>::infinity());
  return near.triangle < 0 ? Vec3(Vec3::Zero())
                           : Vec3(pointAt(mesh.endCorners(near.triangle), near.weights) -
                                  pointAt(mesh.startCorners(near.triangle), near.weights));
}

}  // namespace

MeshInStep BodyContact::NearBody::meshInStep(bool atEnd) const {
  const std::span<const Vec3> own = mesh->shape.positions;
  const bool moves = mesh->isDeforming();
  return {*mesh, moves ? step->startVertices : own, moves ? step->endVertices : own, atEnd};
}

/// Transforms the cloth into the frame of every near body, and sets the displacement bound of each vertex.
/// @param previous result of the pass before; nullptr in the first pass, which starts from the start of the step
void BodyContact::prepareBodyFrames(const Cloth& cloth, const std::vector<Vec3>* previous) {
  const std::size_t count = cloth.start.size();
  displacementBounds_.assign(count, 0.0);
  for (std::size_t b = 0; b < nearCount_; ++b) {
    NearBody& near = near_[b];
    near.start.resize(count);
    near.predicted.resize(count);
    workers_.forEach(cloth.parameters.threads, count, [&](std::size_t v) {
      near.start[v] =
          previous != nullptr ? near.step->end.toLocal((*previous)[v]) : near.step->start.toLocal(cloth.start[v]);
      near.predicted[v] = near.step->end.toLocal(cloth.predicted[v]);
      displacementBounds_[v] = std::max(displacementBounds_[v], (near.predicted[v] - near.start[v]).norm());
    });
  }
  // In the frames of bodies that move differently a vertex has different starts; the bound must cover all of them.
  const double apart = nearCount_ > 1 && previous == nullptr ? 2.0 : 1.0;
  const double offset = maxContactOffset();
  for (double& bound : displacementBounds_) {
    bound = apart * bound + 2.0 * offset;
  }
  deformations_.clear();
  for (std::size_t b = 0; b < nearCount_ && previous == nullptr; ++b) {
    if (near_[b].mesh != nullptr && near_[b].mesh->isDeforming()) {
      extendBoundsForDeformation(cloth, near_[b]);
    }
  }
  for (std::size_t v = 0; v < deformations_.size(); ++v) {
    displacementBounds_[v] += deformations_[v];
  }
}

/// Adds the displacement of a deforming mesh near each vertex, since the mesh can move the cloth that far.
void BodyContact::extendBoundsForDeformation(const Cloth& cloth, const NearBody& near) {
  deformations_.resize(displacementBounds_.size(), 0.0);
  const ClothClusters& clusters = clustersOf(cloth.model);
  for (std::size_t c = 0; c < clusters.count(); ++c) {
    Eigen::AlignedBox3d box;
    for (const int vertex : clusters.vertices(c)) {
      box.extend((near.start[vertex].array() - displacementBounds_[vertex]).matrix());
      box.extend((near.start[vertex].array() + displacementBounds_[vertex]).matrix());
    }
    double maximum = 0.0;
    near.mesh->tree.forEachLeafIn(box, [&](std::size_t leaf) { maximum = std::max(maximum, near.mesh->moveOf(leaf)); });
    for (const int vertex : clusters.vertices(c)) {
      deformations_[vertex] = std::max(deformations_[vertex], maximum);
    }
  }
}

ClothInBody BodyContact::clothIn(const Cloth& cloth, const NearBody& near, std::span<const Vec3> predicted) {
  return {near.start,
          predicted,
          displacementBounds_,
          cloth.model.triangles,
          ownedOf(cloth),
          inverseMass_.get(cloth.model, inverseMassOf),
          near.overlaps ? &near.overlap : nullptr};
}

/// Finds contacts: on meshes those of vertices; on planes, spheres and capsules all of them, and separating planes.
/// @param atEnd the pass starts from positions at the end of the step
/// @return true if cloth was found inside a sphere or capsule, so that the search must be repeated
bool BodyContact::searchVertexContacts(const Cloth& cloth, bool atEnd) {
  candidates_.clear();
  bool newlyFound = false;
  for (std::size_t b = 0; b < nearCount_; ++b) {
    NearBody& near = near_[b];
    ContactOffsets offsets = near.offsets;
    offsets.recoveryStep = atEnd ? 0.0 : offsets.recoveryStep;
    const ClothInBody inBody = clothIn(cloth, near, near.predicted);
    if (near.mesh != nullptr) {
      near.meshSearch.findVertexContacts(ConstraintBuilder(*near.step, static_cast<int>(b), offsets),
                                         near.meshInStep(atEnd), inBody, clustersOf(cloth.model), workers_,
                                         cloth.parameters.threads, candidates_);
      continue;
    }
    const int before = candidates_.overlaps;
    const PrimitiveSearch body(*near.step, static_cast<int>(b), offsets);
    searchPrimitive(cloth, inBody, body);
    if (candidates_.overlaps > before && !std::holds_alternative<PlaneShape>(near.step->body->shape)) {
      newlyFound = findPrimitiveOverlap(cloth, near, body.solid()) || newlyFound;
    }
  }
  firstOfMeshes_ = candidates_.planes.size();
  return newlyFound;
}

/// Finds contacts of edges and faces with meshes that remain when the contacts of vertices are satisfied. On surfaces
/// that are smooth at the scale of the cloth there are none.
/// @return true if there are some
bool BodyContact::searchSharpFeatures(const Cloth& cloth, bool atEnd) {
  const std::size_t before = candidates_.contacts.size();
  for (std::size_t b = 0; b < nearCount_; ++b) {
    NearBody& near = near_[b];
    if (near.mesh != nullptr) {
      near.meshSearch.findSharpFeatureContacts(
          ConstraintBuilder(*near.step, static_cast<int>(b), near.offsets), near.meshInStep(atEnd),
          clothIn(cloth, near, near.solved), clustersOf(cloth.model), workers_, cloth.parameters.threads, candidates_);
    }
  }
  return candidates_.contacts.size() > before;
}

/// Finds separating planes on meshes for the motion from the start of the pass to the solved positions. This motion is
/// shorter than the predicted one, so fewer triangles need planes.
/// @return true if the cloth pierces a mesh where the search for contacts did not know of it
bool BodyContact::searchPlanes(const Cloth& cloth, bool atEnd) {
  bool newlyFound = false;
  for (std::size_t b = 0; b < nearCount_; ++b) {
    NearBody& near = near_[b];
    if (near.mesh != nullptr) {
      const ClothInBody inBody = clothIn(cloth, near, near.solved);
      newlyFound = near.meshSearch.findPlanes(ConstraintBuilder(*near.step, static_cast<int>(b), near.offsets),
                                              near.meshInStep(atEnd), inBody, clustersOf(cloth.model), displacements_,
                                              workers_, cloth.parameters.threads, candidates_) ||
                   newlyFound;
    }
  }
  return newlyFound;
}

/// Requests planes for triangles that were skipped and have a vertex that planes moved from `solved_`.
/// @param all whether to request planes for all triangles
/// @return true if there are such triangles
bool BodyContact::requestPlanesAround(const Cloth& cloth, bool all, const std::vector<Vec3>& positions) {
  if (!hasMeshes()) {
    return false;
  }
  moved_.resize(positions.size());
  bool any = false;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const bool moved = positions[v] != solved_[v];
    moved_[v] = moved;
    any = any || moved;
  }
  if (!any) {
    return false;
  }
  bool anySkipped = false;
  for (std::size_t b = 0; b < nearCount_; ++b) {
    if (near_[b].mesh != nullptr && near_[b].meshSearch.requestPlanesAround(cloth.model.triangles, moved_)) {
      anySkipped = true;
      if (all) {
        near_[b].meshSearch.requestAllPlanes();
      }
    }
  }
  return anySkipped;
}

/// Applies the separating planes. Searches the planes of skipped triangles when their vertices are moved.
/// @return number of infeasible vertices
int BodyContact::applySeparatingPlanes(const Cloth& cloth, bool atEnd, std::vector<Vec3>& positions) {
  const auto fallbackOf = [&](int body, int vertex) {
    const NearBody& near = near_[body];
    const Vec3& start = near.start[vertex];
    const bool carried = !atEnd && near.mesh != nullptr && near.mesh->isDeforming();
    const Vec3 move = carried ? nearestDisplacement(near.meshInStep(false), start) : Vec3(Vec3::Zero());
    return SeparatingPlaneFilter::Fallback{near.step->end.toWorld(start), near.step->end.toWorld(start + move)};
  };
  solved_ = positions;
  for (int attempt = 1;; ++attempt) {
    const int infeasible =
        filter_.apply(candidates_.planes, inverseMass_.get(cloth.model, inverseMassOf), displacementBounds_,
                      static_cast<int>(nearCount_), fallbackOf, cloth.predicted, positions);
    if (!requestPlanesAround(cloth, attempt >= maxPartialPlaneSearches, positions)) {
      return infeasible;
    }
    candidates_.planes.resize(firstOfMeshes_);
    searchPlanes(cloth, atEnd);
    positions = solved_;
  }
}

bool BodyContact::hasMeshes() const {
  const auto last = near_.begin() + static_cast<std::ptrdiff_t>(nearCount_);
  return std::any_of(near_.begin(), last, [](const NearBody& near) { return near.mesh != nullptr; });
}

double BodyContact::maxContactOffset() const {
  double offset = 0.0;
  for (std::size_t b = 0; b < nearCount_; ++b) {
    offset = std::max(offset, near_[b].offsets.contactOffset);
  }
  return offset;
}

const std::vector<OwnedFeatures>& BodyContact::ownedOf(const Cloth& cloth) {
  return owned_.get(cloth.model,
                    [](const ClothModel& m) { return ownedFeatures(m.triangles, m.restPositions.size()); });
}

const ClothClusters& BodyContact::clustersOf(const ClothModel& model) {
  return clusters_.get(model, [this](const ClothModel& m) {
    ++models_;
    return ClothClusters(m);
  });
}

/// Transforms the solved positions into the frames of the bodies.
void BodyContact::transformSolved(const Cloth& cloth, const std::vector<Vec3>& positions) {
  displacements_.assign(positions.size(), 0.0);
  for (std::size_t b = 0; b < nearCount_; ++b) {
    NearBody& near = near_[b];
    near.solved.resize(positions.size());
    workers_.forEach(cloth.parameters.threads, positions.size(), [&](std::size_t v) {
      near.solved[v] = near.step->end.toLocal(positions[v]);
      displacements_[v] = std::max(displacements_[v], (near.solved[v] - near.start[v]).norm());
    });
  }
}

/// Reduces the displacement bounds to the displacement by the impulses and a margin for the correction by planes.
void BodyContact::tightenBounds() {
  const double apart = nearCount_ > 1 ? 2.0 : 1.0;
  const double offset = maxContactOffset();
  for (std::size_t v = 0; v < displacements_.size(); ++v) {
    displacementBounds_[v] = std::min(
        displacementBounds_[v], apart * displacements_[v] + offset + (deformations_.empty() ? 0.0 : deformations_[v]));
  }
}

void BodyContact::searchPrimitive(const Cloth& cloth, const ClothInBody& inBody, const PrimitiveSearch& body) {
  const auto count = static_cast<int>(cloth.model.triangles.size());
  if (cloth.parameters.threads <= 1) {
    body.search(inBody, 0, static_cast<std::size_t>(count), candidates_);
    return;
  }
  const auto parts =
      collectInOrder<Candidates>(workers_, cloth.parameters.threads, count, [&](int begin, int end, Candidates& part) {
        body.search(inBody, static_cast<std::size_t>(begin), static_cast<std::size_t>(end), part);
      });
  for (const Candidates& part : parts) {
    candidates_.append(part);
  }
}

void BodyContact::correctPositions(const Cloth& cloth, std::vector<Vec3>& positions) {
  goals_.clear();
  for (const ContactConstraint& contact : candidates_.contacts) {
    goals_.push_back({contact.height + contact.offset, pointOf(contact, cloth.start) + contact.bodyDisplacement});
  }
  solver_.solve(candidates_.contacts, goals_, inverseMass_.get(cloth.model, inverseMassOf), positionIterations,
                positions);
}

/// One search and one correction. Returns true if another pass is needed.
bool BodyContact::runPass(const Cloth& cloth, const std::vector<Vec3>* previous, ContactReport& report,
                          std::vector<Vec3>& positions) {
  const bool atEnd = previous != nullptr;
  for (std::size_t b = 0; b < nearCount_; ++b) {
    if (near_[b].mesh != nullptr) {
      clustersOf(cloth.model);  // updates models_
      near_[b].meshSearch.begin(*near_[b].mesh, models_);
    }
  }
  bool newlyFound = true;
  for (int i = 0; i < 2 && newlyFound; ++i) {
    prepareBodyFrames(cloth, previous);
    findOverlaps(cloth, atEnd, i == 0);
    if (overlaps() && !atEnd) {
      limitDisplacementsAtOverlap(cloth);
      prepareBodyFrames(cloth, previous);
    }
    extendBoundsForRecovery();
    newlyFound = searchVertexContacts(cloth, atEnd);
    positions = cloth.predicted;
    correctPositions(cloth, positions);
    if (hasMeshes()) {
      transformSolved(cloth, positions);
      if (searchSharpFeatures(cloth, atEnd)) {
        positions = cloth.predicted;
        correctPositions(cloth, positions);
        transformSolved(cloth, positions);
      }
      tightenBounds();
      newlyFound = searchPlanes(cloth, atEnd) || newlyFound;
    }
  }
  if (!atEnd) {
    report.overlaps = candidates_.overlaps;
    report.deepestOverlap = candidates_.deepestOverlap;
  }
  const int infeasible = applySeparatingPlanes(cloth, atEnd, positions);
  report.infeasible = std::max(report.infeasible, infeasible);
  if (candidates_.contacts.empty()) {
    return filter_.maxCorrection() > 0.0;
  }
  return needsAnotherPass(cloth, previous, positions);
}

/// Removes the velocity into the bodies at active contacts, and applies friction.
void BodyContact::correctVelocities(const Cloth& cloth, ClothState& state) {
  const double h = cloth.parameters.timeStep;
  active_.clear();
  goals_.clear();
  for (const ContactConstraint& contact : candidates_.contacts) {
    const double excess = contact.normal.dot(pointOf(contact, state.positions)) - contact.height - contact.offset;
    constexpr double near = 0.1;  // ratio to the required distance [-]
    if (excess < near * contact.offset || contact.offset <= 0.0) {
      const Vec3 bodyVelocity = contact.bodyDisplacement / h;
      active_.push_back(contact);
      goals_.push_back({contact.normal.dot(bodyVelocity) - std::max(0.0, excess) / h, bodyVelocity});
    }
  }
  solver_.solve(active_, goals_, inverseMass_.get(cloth.model, inverseMassOf), velocityIterations, state.velocities);
}

void BodyContact::runPasses(const Cloth& cloth, ContactReport& report, std::vector<Vec3>& positions) {
  report.infeasible = 0;
  bool again = runPass(cloth, nullptr, report, positions);
  for (int i = 1; i < maxPasses && again; ++i) {
    previous_ = positions;
    again = runPass(cloth, &previous_, report, positions);
  }
}

void BodyContact::resolve(const ClothModel& model, const CommonParameters& parameters, const ContactParameters& contact,
                          const std::vector<BodyStep>& bodies, const std::vector<Vec3>& start, ClothState& state,
                          ContactReport& report, std::vector<ContactPoint>& points) {
  const Cloth cloth{model, parameters, contact, start, predicted_};
  predicted_ = state.positions;
  Eigen::AlignedBox3d ends = boundsOf(predicted_);
  slowed_.clear();
  nearCount_ = 0;
  while (chooseBodies(cloth, bodies, state.positions, ends)) {
    runPasses(cloth, report, state.positions);
    ends.extend(boundsOf(state.positions));  // there may be other bodies
  }
  if (nearCount_ == 0) {
    return;
  }
  correctVelocities(cloth, state);
  limitVelocitiesAtOverlap(cloth, state);
  report.bodyContacts = static_cast<int>(active_.size());
  for (const ContactConstraint& constraint : active_) {
    points.push_back({pointOf(constraint, state.positions), constraint.normal});
  }
}

}  // namespace drape::sim::contact
