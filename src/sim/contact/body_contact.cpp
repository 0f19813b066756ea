#include "sim/contact/body_contact.hpp"

#include "sim/bounds.hpp"
#include "sim/contact/found_in_order.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drape {
namespace {

constexpr int mostPasses = 4;
constexpr int mostAsked = 6;  // rounds in which planes are looked for only where vertices were moved
constexpr int positionRounds = 6;
constexpr int velocityRounds = 6;
constexpr double innerShare = 0.6;     // of the distance that is kept: at which edges and faces are stopped [-]
constexpr double guardShare = 0.1;     // of the distance that is kept: what is never gone below [-]
constexpr double linearShare = 0.25;   // of it: how far a touch may move before it is looked at again [-]
constexpr double overlapSpeed = 0.25;  // at which an overlap is undone [m/s]

std::vector<double> inverseMassOf(const ClothModel& model) {
  std::vector<double> inverse(model.vertexMass.size());
  for (std::size_t v = 0; v < inverse.size(); ++v) {
    inverse[v] = model.pinned[v] ? 0.0 : 1.0 / model.vertexMass[v];
  }
  return inverse;
}

Vec3 pointOf(const Touch& touch, const std::vector<Vec3>& values) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t c = 0; c < 3; ++c) {
    sum += touch.weights[static_cast<Eigen::Index>(c)] * values[static_cast<std::size_t>(touch.vertices[c])];
  }
  return sum;
}

/// Half the extent of a body around its origin, as far as it is known without looking at its mesh [m].
double roundRadius(const BodyShape& shape) {
  if (const auto* sphere = std::get_if<SphereShape>(&shape)) {
    return sphere->radius;
  }
  const auto* capsule = std::get_if<CapsuleShape>(&shape);
  return capsule == nullptr ? 0.0 : capsule->radius + capsule->halfLength;
}

/// Whether anything in the box could be nearer to the body than `far`, over the whole step.
bool couldMeet(const BodyStep& step, const SearchableMesh* mesh, const Eigen::AlignedBox3d& cloth, double far) {
  double radius = roundRadius(step.body->shape) + far;
  Vec3 middle = Vec3::Zero();
  if (std::holds_alternative<PlaneShape>(step.body->shape)) {
    return true;
  }
  if (mesh != nullptr) {
    const Eigen::AlignedBox3d box = mesh->tree.bounds();
    middle = box.center();
    radius = 0.5 * box.diagonal().norm() + far;
  }
  Eigen::AlignedBox3d swept;
  for (const Pose& pose : {step.start, step.end}) {
    swept.extend((pose.toWorld(middle).array() - radius).matrix());
    swept.extend((pose.toWorld(middle).array() + radius).matrix());
  }
  return swept.intersects(cloth);
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

void BodyContact::chooseBodies(const Cloth& cloth, const std::vector<BodyStep>& bodies) {
  Eigen::AlignedBox3d box = boundsOf(cloth.start);
  box.extend(boundsOf(cloth.target));
  nearCount_ = 0;
  for (const BodyStep& step : bodies) {
    const double keep = step.body->thickness + 0.5 * cloth.parameters.contact.thickness;
    SearchableMesh* mesh = meshOf(step);
    if (!couldMeet(step, mesh, box, 2.0 * keep)) {
      continue;
    }
    if (near_.size() == nearCount_) {
      near_.emplace_back();
    }
    NearBody& near = near_[nearCount_++];
    near.step = &step;
    near.mesh = mesh;
    near.reach = {keep, innerShare * keep, guardShare * keep, overlapSpeed * cloth.parameters.timeStep};
  }
}

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
  const ClothClusters& clusters = clustersOf(cloth);
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

/// Looks for touches, and on planes, spheres and capsules for barriers as well.
/// @param settled the bases are at the end of the step
void BodyContact::search(const Cloth& cloth, bool settled) {
  const std::vector<OwnedFeatures>& owned = ownedOf(cloth);
  found_.touches.clear();
  found_.barriers.clear();
  found_.overlaps = 0;
  found_.deepestOverlap = 0.0;
  for (std::size_t b = 0; b < nearCount_; ++b) {
    NearBody& near = near_[b];
    const ClothInBody inBody{near.base, near.target, room_, cloth.model.triangles, owned};
    if (near.mesh == nullptr) {
      searchRound(cloth, inBody, BodySearch(*near.step, static_cast<int>(b), near.reach));
    } else {
      near.meshSearch.findTouches(BodySide(*near.step, static_cast<int>(b), near.reach), near.meshInStep(settled),
                                  inBody, clustersOf(cloth), workers_, cloth.parameters.threads, found_);
    }
  }
  firstOfMeshes_ = found_.barriers.size();
}

/// Looks for barriers of meshes between where the cloth is safe and where touches let it go. That is less far than it
/// was about to go, and what it cannot reach any more need not be looked at.
/// @return true when the cloth pierces a mesh in places that the search for touches did not know of
bool BodyContact::searchPlanes(const Cloth& cloth, bool settled) {
  const std::vector<OwnedFeatures>& owned = ownedOf(cloth);
  bool news = false;
  for (std::size_t b = 0; b < nearCount_; ++b) {
    NearBody& near = near_[b];
    if (near.mesh != nullptr) {
      const ClothInBody inBody{near.base, near.placed, room_, cloth.model.triangles, owned};
      news =
          near.meshSearch.findPlanes(BodySide(*near.step, static_cast<int>(b), near.reach), near.meshInStep(settled),
                                     inBody, clustersOf(cloth), needed_, workers_, cloth.parameters.threads, found_) ||
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
  for (std::size_t v = 0; v < positions.size(); ++v) {
    moved_[v] = positions[v] != solved_[v];
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
    const Vec3 move = carried ? near.meshSearch.moveAt(near.meshInStep(false), vertex) : Vec3(Vec3::Zero());
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

const ClothClusters& BodyContact::clustersOf(const Cloth& cloth) {
  return clusters_.get(cloth.model, [this](const ClothModel& m) {
    ++models_;
    return ClothClusters(m);
  });
}

/// Leaves to each vertex the room that it needs to get to `positions`, and some to be put across planes.
void BodyContact::narrowRoom(const Cloth& cloth, const std::vector<Vec3>& positions) {
  needed_.assign(positions.size(), 0.0);
  for (std::size_t b = 0; b < nearCount_; ++b) {
    NearBody& near = near_[b];
    near.placed.resize(positions.size());
    workers_.forEach(cloth.parameters.threads, positions.size(), [&](std::size_t v) {
      near.placed[v] = near.step->end.toLocal(positions[v]);
      needed_[v] = std::max(needed_[v], (near.placed[v] - near.base[v]).norm());
    });
  }
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
      clustersOf(cloth);  // counts models
      near_[b].meshSearch.begin(*near_[b].mesh, models_);
    }
  }
  bool news = true;
  for (int i = 0; i < 2 && news; ++i) {
    place(cloth, safe);
    search(cloth, settled);
    positions = cloth.target;
    correctPositions(cloth, positions);
    news = false;
    if (meshes()) {
      narrowRoom(cloth, positions);
      news = searchPlanes(cloth, settled);
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
  double farthest = filter_.farthest();
  for (const Touch& touch : found_.touches) {
    for (const int vertex : touch.vertices) {
      const auto v = static_cast<std::size_t>(vertex);
      const Vec3 from = safe != nullptr ? (*safe)[v] : Vec3(cloth.start[v] + touch.bodyMove);
      farthest = std::max(farthest, (positions[v] - from).norm());
    }
  }
  return farthest > linearShare * largestKeep();
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

void BodyContact::resolve(const ClothModel& model, const StepParameters& parameters,
                          const std::vector<BodyStep>& bodies, const std::vector<Vec3>& start, ClothState& state,
                          ContactReport& report, std::vector<ContactPoint>& points) {
  const std::vector<Vec3> target = state.positions;
  const Cloth cloth{model, parameters, start, target};
  chooseBodies(cloth, bodies);
  if (nearCount_ == 0) {
    return;
  }
  bool again = pass(cloth, nullptr, report, state.positions);
  for (int i = 1; i < mostPasses && again; ++i) {
    safe_ = state.positions;
    again = pass(cloth, &safe_, report, state.positions);
  }
  correctVelocities(cloth, state);
  report.bodyContacts = static_cast<int>(active_.size());
  for (const Touch& touch : active_) {
    points.push_back({pointOf(touch, state.positions), touch.normal});
  }
}

}  // namespace drape
