#include "sim/contact/solve/body_contact.hpp"

#include "sim/bounds.hpp"
#include "sim/contact/constraints/collect_in_order.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace drape {
namespace {

constexpr int mostPasses = 4;
constexpr int mostAsked = 6;  // rounds in which planes are looked for only where vertices were moved
constexpr int positionRounds = 6;
constexpr int velocityRounds = 6;

std::vector<double> inverseMassOf(const ClothModel& model) {
  std::vector<double> inverse(model.vertexMass.size());
  for (std::size_t v = 0; v < inverse.size(); ++v) {
    inverse[v] = model.pinned[v] ? 0.0 : 1.0 / model.vertexMass[v];
  }
  return inverse;
}

/// How far the point of a mesh that is nearest moves in the body's frame [m], however far away it is: a triangle can be
/// stopped by what none of its vertices comes near to.
Vec3 moveNear(const MeshInStep& mesh, const Vec3& place) {
  NearestSearch search(mesh);
  const NearVertex near = search.anywhere(place, std::numeric_limits<double>::infinity());
  return near.triangle < 0
             ? Vec3(Vec3::Zero())
             : Vec3(pointAt(mesh.end(near.triangle), near.weights) - pointAt(mesh.start(near.triangle), near.weights));
}

}  // namespace

MeshInStep BodyContact::NearBody::meshInStep(bool settled) const {
  const std::span<const Vec3> own = mesh->shape.positions;
  const bool moves = mesh->movesInItself();
  return {*mesh, moves ? step->startVertices : own, moves ? step->endVertices : own, settled};
}

/// Brings the cloth into the frame of every body that is near, and says how far each vertex may go.
/// @param safe positions at the end of the step that meet no body, or nullptr: the start, carried by each body
void BodyContact::place(const Cloth& cloth, const std::vector<Vec3>* safe) {
  const std::size_t count = cloth.start.size();
  room_.assign(count, 0.0);
  for (std::size_t b = 0; b < nearCount_; ++b) {
    NearBody& near = near_[b];
    near.base.resize(count);
    near.target.resize(count);
    workers_.forEach(cloth.parameters.threads, count, [&](std::size_t v) {
      near.base[v] = safe != nullptr ? near.step->end.toLocal((*safe)[v]) : near.step->start.toLocal(cloth.start[v]);
      near.target[v] = near.step->end.toLocal(cloth.target[v]);
      room_[v] = std::max(room_[v], (near.target[v] - near.base[v]).norm());
    });
  }
  // Bodies that move differently carry a vertex to different places; all of them must have been searched.
  const double apart = nearCount_ > 1 && safe == nullptr ? 2.0 : 1.0;
  const double keep = largestKeep();
  for (double& room : room_) {
    room = apart * room + 2.0 * keep;
  }
  moves_.clear();
  for (std::size_t b = 0; b < nearCount_ && safe == nullptr; ++b) {
    if (near_[b].mesh != nullptr && near_[b].mesh->movesInItself()) {
      makeRoomForMoves(cloth, near_[b]);
    }
  }
  for (std::size_t v = 0; v < moves_.size(); ++v) {
    room_[v] += moves_[v];
  }
}

/// What a mesh that moves in itself takes along goes as far as the mesh does there.
void BodyContact::makeRoomForMoves(const Cloth& cloth, const NearBody& near) {
  moves_.resize(room_.size(), 0.0);
  const ClothClusters& clusters = clustersOf(cloth.model);
  for (std::size_t c = 0; c < clusters.count(); ++c) {
    Eigen::AlignedBox3d box;
    for (const int vertex : clusters.vertices(c)) {
      const auto v = static_cast<std::size_t>(vertex);
      box.extend((near.base[v].array() - room_[v]).matrix());
      box.extend((near.base[v].array() + room_[v]).matrix());
    }
    double most = 0.0;
    near.mesh->tree.forEachLeafIn(box, [&](std::size_t leaf) { most = std::max(most, near.mesh->moveOf(leaf)); });
    for (const int vertex : clusters.vertices(c)) {
      const auto v = static_cast<std::size_t>(vertex);
      moves_[v] = std::max(moves_[v], most);
    }
  }
}

ClothInBody BodyContact::clothIn(const Cloth& cloth, const NearBody& near, std::span<const Vec3> target) {
  return {near.base,
          target,
          room_,
          cloth.model.triangles,
          ownedOf(cloth),
          inverseMass_.get(cloth.model, inverseMassOf),
          near.overlaps ? &near.overlap : nullptr};
}

/// Looks for touches, of meshes those of vertices, and on planes, spheres and capsules for barriers as well.
/// @param settled the bases are at the end of the step
/// @return true when some of the cloth is inside of what is round: it should be asked again
bool BodyContact::search(const Cloth& cloth, bool settled) {
  found_.clear();
  bool news = false;
  for (std::size_t b = 0; b < nearCount_; ++b) {
    NearBody& near = near_[b];
    ContactReach reach = near.reach;
    reach.free = settled ? 0.0 : reach.free;
    const ClothInBody inBody = clothIn(cloth, near, near.target);
    if (near.mesh != nullptr) {
      near.meshSearch.findTouches(BodySide(*near.step, static_cast<int>(b), reach), near.meshInStep(settled), inBody,
                                  clustersOf(cloth.model), workers_, cloth.parameters.threads, found_);
      continue;
    }
    const int before = found_.overlaps;
    const BodySearch body(*near.step, static_cast<int>(b), reach);
    searchRound(cloth, inBody, body);
    if (found_.overlaps > before && !std::holds_alternative<PlaneShape>(near.step->body->shape)) {
      news = findRoundOverlap(cloth, near, body.solid()) || news;
    }
  }
  firstOfMeshes_ = found_.barriers.size();
  return news;
}

/// Looks for edges and faces that are about to touch meshes although vertices are held: on what is smooth as seen from
/// the cloth there are none.
/// @return true when there are some
bool BodyContact::searchSharp(const Cloth& cloth, bool settled) {
  const std::size_t before = found_.touches.size();
  for (std::size_t b = 0; b < nearCount_; ++b) {
    NearBody& near = near_[b];
    if (near.mesh != nullptr) {
      near.meshSearch.findSharpTouches(BodySide(*near.step, static_cast<int>(b), near.reach), near.meshInStep(settled),
                                       clothIn(cloth, near, near.placed), clustersOf(cloth.model), workers_,
                                       cloth.parameters.threads, found_);
    }
  }
  return found_.touches.size() > before;
}

/// Looks for barriers of meshes between where the cloth is safe and where touches let it go. That is less far than it
/// was about to go, and what it cannot reach any more need not be looked at.
/// @return true when the cloth pierces a mesh in places that the search for touches did not know of
bool BodyContact::searchPlanes(const Cloth& cloth, bool settled) {
  bool news = false;
  for (std::size_t b = 0; b < nearCount_; ++b) {
    NearBody& near = near_[b];
    if (near.mesh != nullptr) {
      const ClothInBody inBody = clothIn(cloth, near, near.placed);
      news = near.meshSearch.findPlanes(BodySide(*near.step, static_cast<int>(b), near.reach), near.meshInStep(settled),
                                        inBody, clustersOf(cloth.model), needed_, workers_, cloth.parameters.threads,
                                        found_) ||
             news;
    }
  }
  return news;
}

/// True when vertices were moved from `solved_` whose triangles were spared the search for planes. They are not again.
/// @param all whether no triangle is to be spared any more
bool BodyContact::askAround(const Cloth& cloth, bool all, const std::vector<Vec3>& positions) {
  if (!meshes()) {
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
  bool news = false;
  for (std::size_t b = 0; b < nearCount_; ++b) {
    if (near_[b].mesh != nullptr && near_[b].meshSearch.askAround(cloth.model.triangles, moved_)) {
      news = true;
      if (all) {
        near_[b].meshSearch.askForAll();
      }
    }
  }
  return news;
}

/// Has all barriers held, those of meshes where it matters.
/// @return how many vertices found no place
int BodyContact::holdBarriers(const Cloth& cloth, bool settled, std::vector<Vec3>& positions) {
  const auto shelterOf = [&](int body, int vertex) {
    const NearBody& near = near_[static_cast<std::size_t>(body)];
    const Vec3& base = near.base[static_cast<std::size_t>(vertex)];
    const bool carried = !settled && near.mesh != nullptr && near.mesh->movesInItself();
    const Vec3 move = carried ? moveNear(near.meshInStep(false), base) : Vec3(Vec3::Zero());
    return BarrierFilter::Shelter{near.step->end.toWorld(base), near.step->end.toWorld(base + move)};
  };
  solved_ = positions;
  for (int round = 1;; ++round) {
    const int squeezed = filter_.apply(found_.barriers, inverseMass_.get(cloth.model, inverseMassOf), room_,
                                       static_cast<int>(nearCount_), shelterOf, cloth.target, positions);
    if (!askAround(cloth, round >= mostAsked, positions)) {
      return squeezed;
    }
    found_.barriers.resize(firstOfMeshes_);
    searchPlanes(cloth, settled);
    positions = solved_;
  }
}

bool BodyContact::meshes() const {
  const auto last = near_.begin() + static_cast<std::ptrdiff_t>(nearCount_);
  return std::any_of(near_.begin(), last, [](const NearBody& near) { return near.mesh != nullptr; });
}

double BodyContact::largestKeep() const {
  double keep = 0.0;
  for (std::size_t b = 0; b < nearCount_; ++b) {
    keep = std::max(keep, near_[b].reach.keep);
  }
  return keep;
}

const std::vector<OwnedFeatures>& BodyContact::ownedOf(const Cloth& cloth) {
  return owned_.get(cloth.model, [](const ClothModel& m) { return ownedFeatures(m.triangles, m.vertexCount()); });
}

const ClothClusters& BodyContact::clustersOf(const ClothModel& model) {
  return clusters_.get(model, [this](const ClothModel& m) {
    ++models_;
    return ClothClusters(m);
  });
}

/// Brings what touches let the cloth do into the frames of the bodies.
void BodyContact::placeSolved(const Cloth& cloth, const std::vector<Vec3>& positions) {
  needed_.assign(positions.size(), 0.0);
  for (std::size_t b = 0; b < nearCount_; ++b) {
    NearBody& near = near_[b];
    near.placed.resize(positions.size());
    workers_.forEach(cloth.parameters.threads, positions.size(), [&](std::size_t v) {
      near.placed[v] = near.step->end.toLocal(positions[v]);
      needed_[v] = std::max(needed_[v], (near.placed[v] - near.base[v]).norm());
    });
  }
}

/// Leaves to each vertex the room that it needs to get there, and some to be put across planes.
void BodyContact::narrowRoom() {
  const double apart = nearCount_ > 1 ? 2.0 : 1.0;
  const double keep = largestKeep();
  for (std::size_t v = 0; v < needed_.size(); ++v) {
    room_[v] = std::min(room_[v], apart * needed_[v] + keep + (moves_.empty() ? 0.0 : moves_[v]));
  }
}

void BodyContact::searchRound(const Cloth& cloth, const ClothInBody& inBody, const BodySearch& body) {
  const auto count = static_cast<int>(cloth.model.triangles.size());
  if (cloth.parameters.threads <= 1) {
    body.search(inBody, 0, static_cast<std::size_t>(count), found_);
    return;
  }
  const auto parts =
      foundInOrder<Findings>(workers_, cloth.parameters.threads, count, [&](int begin, int end, Findings& part) {
        body.search(inBody, static_cast<std::size_t>(begin), static_cast<std::size_t>(end), part);
      });
  for (const Findings& part : parts) {
    found_.append(part);
  }
}

void BodyContact::correctPositions(const Cloth& cloth, std::vector<Vec3>& positions) {
  goals_.clear();
  for (const Touch& touch : found_.touches) {
    goals_.push_back({touch.height + touch.keep, pointOf(touch, cloth.start) + touch.bodyMove});
  }
  solver_.solve(found_.touches, goals_, inverseMass_.get(cloth.model, inverseMassOf), positionRounds, positions);
}

/// One search and one correction. True when the touches moved so far that they should be looked at again.
bool BodyContact::pass(const Cloth& cloth, const std::vector<Vec3>* safe, ContactReport& report,
                       std::vector<Vec3>& positions) {
  const bool settled = safe != nullptr;
  for (std::size_t b = 0; b < nearCount_; ++b) {
    if (near_[b].mesh != nullptr) {
      clustersOf(cloth.model);  // counts models
      near_[b].meshSearch.begin(*near_[b].mesh, models_);
    }
  }
  bool news = true;
  for (int i = 0; i < 2 && news; ++i) {
    place(cloth, safe);
    findOverlaps(cloth, settled, i == 0);
    if (overlaps() && !settled) {
      calmTargets(cloth);
      place(cloth, safe);
    }
    makeRoomForExits();
    news = search(cloth, settled);
    positions = cloth.target;
    correctPositions(cloth, positions);
    if (meshes()) {
      placeSolved(cloth, positions);
      if (searchSharp(cloth, settled)) {
        positions = cloth.target;
        correctPositions(cloth, positions);
        placeSolved(cloth, positions);
      }
      narrowRoom();
      news = searchPlanes(cloth, settled) || news;
    }
  }
  if (!settled) {
    report.overlaps = found_.overlaps;
    report.deepestOverlap = found_.deepestOverlap;
  }
  const int squeezed = holdBarriers(cloth, settled, positions);
  report.squeezed = std::max(report.squeezed, squeezed);
  if (found_.touches.empty()) {
    return filter_.farthest() > 0.0;
  }
  return leftItsTouches(cloth, safe, positions);
}

/// Takes the velocity into the bodies away where the cloth touches them now, and slows down what slides.
void BodyContact::correctVelocities(const Cloth& cloth, ClothState& state) {
  const double h = cloth.parameters.timeStep;
  active_.clear();
  goals_.clear();
  for (const Touch& touch : found_.touches) {
    const double above = touch.normal.dot(pointOf(touch, state.positions)) - touch.height - touch.keep;
    constexpr double near = 0.1;
    if (above < near * touch.keep || touch.keep <= 0.0) {
      const Vec3 still = touch.bodyMove / h;
      active_.push_back(touch);
      goals_.push_back({touch.normal.dot(still) - std::max(0.0, above) / h, still});
    }
  }
  solver_.solve(active_, goals_, inverseMass_.get(cloth.model, inverseMassOf), velocityRounds, state.velocities);
}

void BodyContact::passes(const Cloth& cloth, ContactReport& report, std::vector<Vec3>& positions) {
  report.squeezed = 0;
  bool again = pass(cloth, nullptr, report, positions);
  for (int i = 1; i < mostPasses && again; ++i) {
    safe_ = positions;
    again = pass(cloth, &safe_, report, positions);
  }
}

void BodyContact::resolve(const ClothModel& model, const StepParameters& parameters,
                          const std::vector<BodyStep>& bodies, const std::vector<Vec3>& start, ClothState& state,
                          ContactReport& report, std::vector<ContactPoint>& points) {
  const Cloth cloth{model, parameters, start, target_};
  target_ = state.positions;
  Eigen::AlignedBox3d ends = boundsOf(target_);
  calmed_.clear();
  nearCount_ = 0;
  while (chooseBodies(cloth, bodies, state.positions, ends)) {
    passes(cloth, report, state.positions);
    ends.extend(boundsOf(state.positions));  // where bodies have taken it there may be others
  }
  if (nearCount_ == 0) {
    return;
  }
  correctVelocities(cloth, state);
  calmVelocities(cloth, state);
  report.bodyContacts = static_cast<int>(active_.size());
  for (const Touch& touch : active_) {
    points.push_back({pointOf(touch, state.positions), touch.normal});
  }
}

}  // namespace drape
