#include "sim/contact/separating_planes/separating_planes.hpp"

#include "sim/contact/closest_features/nearest_search.hpp"

#include <limits>
#include <utility>

namespace drape::sim::contact {
namespace {

constexpr int maxPartialSearches = 6;  // after these, planes are searched for all triangles, not only for moved ones

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

void SeparatingPlanes::begin(std::vector<SeparatingPlane> planes) {
  planes_ = std::move(planes);
  firstOfMeshes_ = planes_.size();
}

bool SeparatingPlanes::find(const ContactPass& pass, const ClothFrames& frames, const BodyOverlaps& overlaps) {
  planes_.resize(firstOfMeshes_);
  bool newlyFound = false;
  Candidates found;
  for (const NearBody& body : pass.bodies) {
    if (body.mesh != nullptr) {
      newlyFound = body.search->findPlanes(body.builder(), body.meshInStep(pass.atEnd()),
                                           frames.solvedIn(body, pass, overlaps.in(body)), pass.cloth.clusters,
                                           frames.displacements(), pass.workers, pass.step.parameters.threads, found) ||
                   newlyFound;
    }
  }
  planes_.insert(planes_.end(), found.planes.begin(), found.planes.end());
  return newlyFound;
}

void SeparatingPlanes::complete(const ContactPass& pass, const ClothFrames& frames, const BodyOverlaps& overlaps) {
  for (const NearBody& body : pass.bodies) {
    if (body.mesh != nullptr) {
      body.search->requestAllPlanes();
    }
  }
  find(pass, frames, overlaps);
}

/// Requests planes for triangles that were skipped and have a vertex that planes moved from `solved_`.
/// @param all whether to request planes for all triangles
/// @return true if there are such triangles
bool SeparatingPlanes::requestAroundMoved(const ContactPass& pass, bool all, const std::vector<Vec3>& positions) {
  if (!pass.bodies.haveMeshes()) {
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
  for (const NearBody& body : pass.bodies) {
    if (body.mesh != nullptr && body.search->requestPlanesAround(pass.step.model.triangles, moved_)) {
      anySkipped = true;
      if (all) {
        body.search->requestAllPlanes();
      }
    }
  }
  return anySkipped;
}

int SeparatingPlanes::apply(const ContactPass& pass, const ClothFrames& frames, const BodyOverlaps& overlaps,
                            std::vector<Vec3>& positions) {
  const auto startOf = [&](int index, int vertex) {
    const NearBody& body = pass.bodies[index];
    return body.step->end.toWorld(frames.startIn(body)[vertex]);
  };
  const auto carriedOf = [&](int index, int vertex) {
    const NearBody& body = pass.bodies[index];
    const Vec3& start = frames.startIn(body)[vertex];
    const bool moves = !pass.atEnd() && body.mesh != nullptr && body.mesh->isDeforming();
    return body.step->end.toWorld(moves ? Vec3(start + nearestDisplacement(body.meshInStep(false), start)) : start);
  };
  const SeparatingPlaneFilter::Fallback fallback{startOf, carriedOf};
  solved_ = positions;
  for (int attempt = 1;; ++attempt) {
    const int infeasible =
        filter_.apply(planes_, pass.cloth.inverseMass, frames.displacementBounds(),
                      static_cast<int>(pass.bodies.size()), fallback, pass.step.predicted, positions);
    if (!requestAroundMoved(pass, attempt >= maxPartialSearches, positions)) {
      return infeasible;
    }
    find(pass, frames, overlaps);
    positions = solved_;
  }
}

}  // namespace drape::sim::contact
