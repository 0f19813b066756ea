#include "sim/contact/body_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace drape {
namespace {

constexpr double inside = 1e-3;      // a nearest point this far in from the border belongs to the inside [-]
constexpr double sharpAngle = 0.02;  // edges of a body that stick out by less count as flat [rad, sine]

const Vec3& at(std::span<const Vec3> points, int i) {
  return points[static_cast<std::size_t>(i)];
}

Corners cornersOf(std::span<const Vec3> points, const Triangle& triangle) {
  return {at(points, triangle[0]), at(points, triangle[1]), at(points, triangle[2])};
}

bool within(const Vec3& weights) {
  return (weights.array() > inside).all();
}

bool within(double along) {
  return along > inside && along < 1.0 - inside;
}

Vec3 onCorner(std::size_t k) {
  Vec3 weights = Vec3::Zero();
  weights[static_cast<Eigen::Index>(k)] = 1.0;
  return weights;
}

Vec3 onSide(std::size_t k, double along) {
  Vec3 weights = Vec3::Zero();
  weights[static_cast<Eigen::Index>(k)] = 1.0 - along;
  weights[static_cast<Eigen::Index>((k + 1) % 3)] = along;
  return weights;
}

Vec3 faceNormal(const Corners& corners) {
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double length = normal.norm();
  return length > 0.0 ? Vec3(normal / length) : Vec3(Vec3::UnitY());
}

std::vector<std::array<bool, 3>> sharpSides(const MeshShape& mesh) {
  struct Side {
    int a, b;
    std::size_t triangle, side;
  };
  std::vector<std::array<bool, 3>> sharp(mesh.triangles.size(), {true, true, true});
  if (mesh.frames.size() > 1) {
    return sharp;  // what is flat now may stick out later
  }
  std::vector<Side> sides;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = mesh.triangles[t][k];
      const int b = mesh.triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, k});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
    return std::tie(x.a, x.b, x.triangle) < std::tie(y.a, y.b, y.triangle);
  });
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const bool pair = sides[i].a == sides[i + 1].a && sides[i].b == sides[i + 1].b;
    const bool more = i + 2 < sides.size() && sides[i + 2].a == sides[i].a && sides[i + 2].b == sides[i].b;
    if (!pair || more) {
      continue;
    }
    const Triangle& other = mesh.triangles[sides[i + 1].triangle];
    const Corners first = cornersOf(mesh.positions, mesh.triangles[sides[i].triangle]);
    const Vec3 apex = at(mesh.positions, other[(sides[i + 1].side + 2) % 3]) - at(mesh.positions, sides[i].a);
    const double rise = faceNormal(first).dot(apex);
    const bool flat = rise > -sharpAngle * apex.norm();
    sharp[sides[i].triangle][sides[i].side] = !flat;
    sharp[sides[i + 1].triangle][sides[i + 1].side] = !flat;
  }
  return sharp;
}

}  // namespace

void Findings::append(const Findings& more) {
  touches.insert(touches.end(), more.touches.begin(), more.touches.end());
  barriers.insert(barriers.end(), more.barriers.begin(), more.barriers.end());
  overlaps += more.overlaps;
  deepestOverlap = std::max(deepestOverlap, more.deepestOverlap);
}

SearchableMesh::SearchableMesh(MeshShape mesh)
    : shape(std::move(mesh)),
      tree(shape.positions, shape.triangles),
      owned(ownedFeatures(shape.triangles, static_cast<int>(shape.positions.size()))),
      sharp(sharpSides(shape)) {}

/// The nearest point of the body to a point of the cloth, in the body's frame.
struct BodySearch::Near {
  double gap = std::numeric_limits<double>::infinity();  // at the base [m]
  Vec3 normal = Vec3::UnitY();
  Vec3 startPoint = Vec3::Zero();  // of the body, when the step begins ...
  Vec3 endPoint = Vec3::Zero();    // ... and when it ends, both in its own frame
};

BodySearch::BodySearch(const BodyStep& step, int index, const SearchableMesh* mesh, const ContactReach& reach)
    : step_(step), index_(index), mesh_(mesh), reach_(reach) {
  if (mesh != nullptr) {
    startVertices_ = step.startVertices.empty() ? std::span<const Vec3>(mesh->shape.positions) : step.startVertices;
    endVertices_ = step.endVertices.empty() ? std::span<const Vec3>(mesh->shape.positions) : step.endVertices;
  } else if (const auto* sphere = std::get_if<SphereShape>(&step.body->shape)) {
    radius_ = sphere->radius;
  } else if (const auto* capsule = std::get_if<CapsuleShape>(&step.body->shape)) {
    radius_ = capsule->radius;
    core_ = {Vec3(0.0, -capsule->halfLength, 0.0), Vec3(0.0, capsule->halfLength, 0.0)};
  } else {
    plane_ = true;
  }
}

void BodySearch::search(const ClothInBody& cloth, std::size_t begin, std::size_t end, Findings& findings) const {
  for (std::size_t t = begin; t < end; ++t) {
    if (plane_) {
      searchPlane(cloth, t, findings);
    } else if (mesh_ != nullptr) {
      searchMesh(cloth, t, findings);
    } else {
      searchRound(cloth, t, findings);
    }
  }
}

Vec3 BodySearch::moveOf(const Vec3& startPoint, const Vec3& endPoint) const {
  return step_.end.toWorld(endPoint) - step_.start.toWorld(startPoint);
}

/// A point that already is nearer than it may be goes out gently.
void BodySearch::addTouch(const ClothInBody& cloth, std::size_t t, const Vec3& weights, const Near& near, double wanted,
                          Findings& findings) const {
  const double keep = std::min(wanted, near.gap + reach_.push);
  const double height = near.normal.dot(near.endPoint);
  const Vec3 target = pointAt(cornersOf(cloth.target, cloth.triangles[t]), weights);
  if (near.normal.dot(target) - height >= keep) {
    return;
  }
  Touch touch;
  touch.vertices = cloth.triangles[t];
  touch.weights = weights;
  touch.normal = step_.end.rotation * near.normal;
  touch.height = height + touch.normal.dot(step_.end.position);
  touch.keep = keep;
  touch.bodyMove = moveOf(near.startPoint, near.endPoint);
  touch.staticFriction = step_.body->staticFriction;
  touch.kineticFriction = std::min(step_.body->kineticFriction, step_.body->staticFriction);
  findings.touches.push_back(touch);
}

/// @param height of the body's highest point over the plane through the frame's origin, at the end of the step [m]
/// @param gap between triangle and body at the base [m]
void BodySearch::addBarriers(const ClothInBody& cloth, std::size_t t, const Vec3& normal, double height, double gap,
                             Findings& findings) const {
  const double guarded = height + std::min(reach_.guard, gap);  // what is nearer than the guard comes no nearer
  const Vec3 world = step_.end.rotation * normal;
  const double origin = world.dot(step_.end.position);
  for (const int v : cloth.triangles[t]) {
    if (normal.dot(at(cloth.base, v)) - cloth.room[static_cast<std::size_t>(v)] < guarded) {
      findings.barriers.push_back({v, index_, world, guarded + origin});
    }
  }
}

void BodySearch::searchPlane(const ClothInBody& cloth, std::size_t t, Findings& findings) const {
  bool overlaps = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const int v = cloth.triangles[t][k];
    const Vec3& base = at(cloth.base, v);
    const double gap = base.y();
    overlaps = overlaps || gap <= 0.0;
    findings.deepestOverlap = std::max(findings.deepestOverlap, -gap);
    if (!cloth.owned[t].corners[k] || gap > reach_.keep + cloth.room[static_cast<std::size_t>(v)]) {
      continue;
    }
    const Vec3 foot(base.x(), 0.0, base.z());
    addTouch(cloth, t, onCorner(k), {gap, Vec3::UnitY(), foot, foot}, reach_.keep, findings);
    if (gap > 0.0) {
      const Vec3 world = step_.end.rotation * Vec3::UnitY();
      findings.barriers.push_back({v, index_, world, std::min(reach_.guard, gap) + world.dot(step_.end.position)});
    }
  }
  findings.overlaps += overlaps ? 1 : 0;
}

void BodySearch::roundTouch(const ClothInBody& cloth, std::size_t t, const Vec3& weights, const Vec3& onCore,
                            double keep, Findings& findings) const {
  const Vec3 way = pointAt(cornersOf(cloth.base, cloth.triangles[t]), weights) - onCore;
  const double distance = way.norm();
  if (!(distance > 0.0)) {
    return;
  }
  const Vec3 normal = way / distance;
  const Vec3 point = onCore + radius_ * normal;
  addTouch(cloth, t, weights, {distance - radius_, normal, point, point}, keep, findings);
}

void BodySearch::searchRound(const ClothInBody& cloth, std::size_t t, Findings& findings) const {
  const Corners base = cornersOf(cloth.base, cloth.triangles[t]);
  double room = 0.0;
  Eigen::AlignedBox3d box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.extend(base[k]);
    room = std::max(room, cloth.room[static_cast<std::size_t>(cloth.triangles[t][k])]);
  }
  const double far = radius_ + reach_.keep + room;
  const Eigen::AlignedBox3d core(core_[0] - Vec3::Constant(far), core_[1] + Vec3::Constant(far));
  if (!box.intersects(core)) {
    return;
  }
  TriangleSegmentPair nearest;
  if (core_[0] == core_[1]) {
    nearest.weights = nearestOnTriangle(core_[0], base);
  } else {
    nearest = nearestOfTriangleAndSegment(base, core_);
  }
  const auto coreAt = [&](double along) -> Vec3 { return core_[0] + along * (core_[1] - core_[0]); };
  const Vec3 onCore = coreAt(nearest.along);
  const Vec3 way = pointAt(base, nearest.weights) - onCore;
  const double distance = way.norm();
  if (distance > far) {
    return;
  }
  if (distance > radius_) {
    const Vec3 normal = way / distance;
    addBarriers(cloth, t, normal, normal.dot(onCore) + radius_, distance - radius_, findings);
  } else {
    ++findings.overlaps;
    findings.deepestOverlap = std::max(findings.deepestOverlap, radius_ - distance);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (cloth.owned[t].corners[k]) {
      roundTouch(cloth, t, onCorner(k), coreAt(nearestOnSegment(base[k], core_[0], core_[1])), reach_.keep, findings);
    }
  }
  if (distance - radius_ > reach_.inner + room - 2.0 * reach_.keep) {
    return;  // edges and faces cannot come that near
  }
  if (within(nearest.weights)) {
    roundTouch(cloth, t, nearest.weights, onCore, reach_.inner, findings);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (cloth.owned[t].sides[k]) {
      const SegmentPair pair = nearestOfSegments({base[k], base[(k + 1) % 3]}, core_);
      if (within(pair.first)) {
        roundTouch(cloth, t, onSide(k, pair.first), coreAt(pair.second), reach_.inner, findings);
      }
    }
  }
}

void BodySearch::searchMesh(const ClothInBody& cloth, std::size_t t, Findings& findings) const {
  Eigen::AlignedBox3d box;
  for (const int v : cloth.triangles[t]) {
    const double far = cloth.room[static_cast<std::size_t>(v)] + reach_.keep;
    box.extend((at(cloth.base, v).array() - far).matrix());
    box.extend((at(cloth.base, v).array() + far).matrix());
  }
  std::array<Near, 3> vertices;
  const int overlapsBefore = findings.overlaps;
  mesh_->tree.forEachIn(box, [&](int triangle) { meetTriangle(cloth, t, triangle, vertices, findings); });
  findings.overlaps = std::min(findings.overlaps, overlapsBefore + 1);
  for (std::size_t k = 0; k < 3; ++k) {
    if (cloth.owned[t].corners[k] && vertices[k].gap < std::numeric_limits<double>::infinity()) {
      addTouch(cloth, t, onCorner(k), vertices[k], reach_.keep, findings);
    }
  }
}

void BodySearch::meetTriangle(const ClothInBody& cloth, std::size_t t, int bodyTriangle, std::array<Near, 3>& vertices,
                              Findings& findings) const {
  const Triangle& indices = mesh_->shape.triangles[static_cast<std::size_t>(bodyTriangle)];
  const Corners base = cornersOf(cloth.base, cloth.triangles[t]);
  const Corners start = cornersOf(startVertices_, indices);
  const Corners end = cornersOf(endVertices_, indices);
  // Far above or below the body's triangle nothing can happen; most that the tree finds ends here.
  const Vec3 face = faceNormal(start);
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  double room = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double height = face.dot(base[k] - start[0]);
    low = std::min(low, height);
    high = std::max(high, height);
    room = std::max(room, cloth.room[static_cast<std::size_t>(cloth.triangles[t][k])] + (end[k] - start[k]).norm());
  }
  const double far = reach_.keep + room;
  if (low > far || high < -far) {
    return;
  }
  const TriangleGap gap = gapOfTriangles(base, start);
  if (gap.distance > far) {
    return;
  }
  if (gap.distance <= 0.0) {
    pushOut(cloth, t, bodyTriangle, findings);
    return;
  }
  double height = -std::numeric_limits<double>::infinity();
  for (const Vec3& corner : end) {
    height = std::max(height, gap.normal.dot(corner));
  }
  addBarriers(cloth, t, gap.normal, height, gap.distance, findings);
  for (std::size_t k = 0; k < 3; ++k) {
    if (cloth.owned[t].corners[k]) {
      const Near near = nearOf(base, start, end, onCorner(k), nearestOnTriangle(base[k], start));
      vertices[k] = near.gap < vertices[k].gap ? near : vertices[k];
    }
  }
  if (gap.distance <= reach_.inner + room - 2.0 * reach_.keep) {
    touchSharp(cloth, t, bodyTriangle, findings);
  }
}

BodySearch::Near BodySearch::nearOf(const Corners& base, const Corners& start, const Corners& end, const Vec3& weights,
                                    const Vec3& bodyWeights) {
  const Vec3 startPoint = pointAt(start, bodyWeights);
  const Vec3 way = pointAt(base, weights) - startPoint;
  const double gap = way.norm();
  return {gap, gap > 0.0 ? Vec3(way / gap) : Vec3(Vec3::UnitY()), startPoint, pointAt(end, bodyWeights)};
}

/// The body's vertices that come near to the cloth's faces, and its sharp edges that come near to the cloth's edges.
void BodySearch::touchSharp(const ClothInBody& cloth, std::size_t t, int bodyTriangle, Findings& findings) const {
  const auto b = static_cast<std::size_t>(bodyTriangle);
  const Triangle& indices = mesh_->shape.triangles[b];
  const Corners base = cornersOf(cloth.base, cloth.triangles[t]);
  const Corners start = cornersOf(startVertices_, indices);
  const Corners end = cornersOf(endVertices_, indices);
  const OwnedFeatures& theirs = mesh_->owned[b];
  for (std::size_t k = 0; k < 3; ++k) {
    if (theirs.corners[k]) {
      const Vec3 weights = nearestOnTriangle(start[k], base);
      if (within(weights)) {
        addTouch(cloth, t, weights, nearOf(base, start, end, weights, onCorner(k)), reach_.inner, findings);
      }
    }
    for (std::size_t m = 0; cloth.owned[t].sides[k] && m < 3; ++m) {
      if (theirs.sides[m] && mesh_->sharp[b][m]) {
        const SegmentPair pair = nearestOfSegments({base[k], base[(k + 1) % 3]}, {start[m], start[(m + 1) % 3]});
        if (within(pair.first) && within(pair.second)) {
          addTouch(cloth, t, onSide(k, pair.first),
                   nearOf(base, start, end, onSide(k, pair.first), onSide(m, pair.second)), reach_.inner, findings);
        }
      }
    }
  }
}

/// What pierces a triangle of the body goes out along its normal, slowly.
void BodySearch::pushOut(const ClothInBody& cloth, std::size_t t, int bodyTriangle, Findings& findings) const {
  const Triangle& indices = mesh_->shape.triangles[static_cast<std::size_t>(bodyTriangle)];
  const Corners base = cornersOf(cloth.base, cloth.triangles[t]);
  const Corners start = cornersOf(startVertices_, indices);
  const Corners end = cornersOf(endVertices_, indices);
  const Vec3 face = faceNormal(end);
  ++findings.overlaps;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 weights = nearestOnTriangle(base[k], start);
    const double depth = face.dot(base[k] - start[0]);
    findings.deepestOverlap =
        std::max(findings.deepestOverlap, std::min(-depth, (base[k] - pointAt(start, weights)).norm()));
    if (depth < reach_.keep) {
      addTouch(cloth, t, onCorner(k), {depth, face, pointAt(start, weights), pointAt(end, weights)}, reach_.keep,
               findings);
    }
  }
}

}  // namespace drape
