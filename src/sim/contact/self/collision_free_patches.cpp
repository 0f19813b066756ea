#include "sim/contact/self/collision_free_patches.hpp"

#include "sim/contact/self/topology.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace drape::sim::contact {
namespace {

using Direction = std::array<float, 3>;

constexpr int freeTriangle = -1;
constexpr int withoutArea = -2;
constexpr int kept = -3;

/// Number of triangles whose mean normal is the axis of a patch.
constexpr std::size_t trianglesForAxis = 24;

/// The axis of a patch across a border is the mean normal of triangles within 90 degrees, so that it lies between the
/// sides of a fold. The square of the cosine.
constexpr float squaredCosineAcrossFolds = 0.0F;

/// Minimum square of a triangle's normal, twice its area, for which the normal is accurate in float [m^4].
constexpr float minSquaredNormal = 1e-20F;

float squaredCosine(double degrees) {
  const double cosine = std::cos(degrees * std::numbers::pi / 180.0);
  return static_cast<float>(cosine * cosine);
}

float dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The square of the cosine of `growthAngle`.
float growthSquaredCosine() {
  static const float minimum = squaredCosine(PatchGrower::growthAngle);
  return minimum;
}

Direction unit(const Direction& v) {
  const float length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

Direction cross(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Pads to a whole vector with copies of the last entry.
void fillUp(std::vector<std::int32_t>& values) {
  while (values.size() % maxLanes != 0) {
    values.push_back(values.back());
  }
}

}  // namespace

std::vector<int> patchesAroundVertices(const std::vector<Triangle>& triangles, const CollisionFreePatches& patches) {
  constexpr int unknown = -2;
  std::vector<int> common(patches.patchOfVertex.size(), unknown);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const int patch = patches.patchOfTriangle[t];
    for (const int v : triangles[t]) {
      common[v] = common[v] == unknown || common[v] == patch ? patch : -1;
    }
  }
  return common;
}

PatchMesh patchMeshOf(const ClothModel& model) {
  PatchMesh mesh;
  mesh.triangles = model.triangles;
  mesh.across = trianglesAcross(model.triangles, model.restPositions.size());
  mesh.vertices = model.vertexCount();
  for (const Triangle& t : model.triangles) {
    mesh.corners.a.push_back(t[0]);
    mesh.corners.b.push_back(t[1]);
    mesh.corners.c.push_back(t[2]);
  }
  for (auto* part : {&mesh.corners.a, &mesh.corners.b, &mesh.corners.c}) {
    fillUp(*part);
  }
  return mesh;
}

bool BorderCheck::simple(const int* border, int count, const PositionLanes& positions, const Direction& axis) {
  if (count < 4) {
    return true;  // a single triangle that faces the axis
  }
  const Direction aside = std::abs(axis[0]) < 0.6F ? Direction{1.0F, 0.0F, 0.0F} : Direction{0.0F, 1.0F, 0.0F};
  const Direction u = unit(cross(aside, axis));
  const Direction w = cross(axis, u);
  x_.resize(static_cast<std::size_t>(count) + maxLanes + 1);
  y_.resize(static_cast<std::size_t>(count) + maxLanes + 1);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const int v = border[i];
    const Direction position = {positions.x[v], positions.y[v], positions.z[v]};
    x_[i] = dot(position, u);
    y_[i] = dot(position, w);
  }
  x_[count] = x_[0];
  y_[count] = y_[0];
  return isSimplePolygon(x_.data(), y_.data(), count, margin);
}

void PatchGrower::begin(const PatchMesh& mesh, const PositionLanes& positions, CollisionFreePatches& patches) {
  const std::size_t triangles = mesh.triangles.size();
  normals_.resize(mesh.corners.a.size());
  normalsOf(positions, mesh.corners, static_cast<int>(mesh.corners.a.size()), normals_);
  owner_.assign(triangles, freeTriangle);
  for (std::size_t t = 0; t < triangles; ++t) {
    const Direction n = normal(static_cast<int>(t));
    if (!(dot(n, n) > minSquaredNormal)) {
      owner_[t] = withoutArea;
    }
  }
  orderIndex_.resize(triangles);
  attemptOfVertex_.assign(mesh.vertices, -1);
  next_.resize(mesh.vertices);
  attempt_ = 0;
  patches.patches.clear();
  patches.border.clear();
  patches.patchOfVertex.assign(mesh.vertices, -1);
  patches.patchOfTriangle.assign(triangles, -1);
  for (auto* part : {&patches.corners.a, &patches.corners.b, &patches.corners.c}) {
    part->clear();
  }
}

Direction PatchGrower::normal(int triangle) const {
  return {normals_.x[triangle], normals_.y[triangle], normals_.z[triangle]};
}

/// Whether the normal of a triangle is within an angle of the axis. @param minSquaredCosine of this angle
bool PatchGrower::faces(int triangle, const Direction& axis, float minSquaredCosine) const {
  const Direction n = normal(triangle);
  const float along = dot(n, axis);
  return along > 0.0F && along * along >= minSquaredCosine * dot(n, n);
}

bool PatchGrower::keepsDisc(const PatchMesh& mesh, int triangle) const {
  int shared = 0;
  std::size_t edge = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const int across = mesh.across[triangle][c];
    if (across >= 0 && owner_[across] == attempt_) {
      ++shared;
      edge = c;
    }
  }
  const int third = mesh.triangles[triangle][(edge + 2) % 3];
  return shared == 2 || (shared == 1 && attemptOfVertex_[third] != attempt_);
}

void PatchGrower::take(const PatchMesh& mesh, int triangle) {
  owner_[triangle] = attempt_;
  orderIndex_[triangle] = static_cast<int>(order_.size());
  order_.push_back(triangle);
  for (std::size_t c = 0; c < 3; ++c) {
    attemptOfVertex_[mesh.triangles[triangle][c]] = attempt_;
    const int across = mesh.across[triangle][c];
    if (across >= 0 && owner_[across] == freeTriangle) {
      queue_.push_back(across);
    }
  }
}

void PatchGrower::takeFrom(const PatchMesh& mesh, int seed, const Direction& axis, float minSquaredCosine,
                           std::size_t maximum) {
  ++attempt_;
  order_.clear();
  queue_.clear();
  take(mesh, seed);
  for (std::size_t i = 0; i < queue_.size() && order_.size() < maximum; ++i) {
    const int t = queue_[i];
    if (owner_[t] == freeTriangle && faces(t, axis, minSquaredCosine) && keepsDisc(mesh, t)) {
      take(mesh, t);
    }
  }
}

void PatchGrower::giveBack(std::size_t keptCount) {
  for (std::size_t i = keptCount; i < order_.size(); ++i) {
    owner_[order_[i]] = freeTriangle;
  }
  order_.resize(keptCount);
}

/// The mean normal of the first triangles around a seed whose normals are within an angle of its own.
/// @param minSquaredCosine of this angle
Direction PatchGrower::axisAround(const PatchMesh& mesh, int seed, float minSquaredCosine) {
  const Direction own = unit(normal(seed));
  takeFrom(mesh, seed, own, minSquaredCosine, trianglesForAxis);
  Direction sum = {0.0F, 0.0F, 0.0F};
  for (const int t : order_) {
    const Direction n = normal(t);
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += n[k];
    }
  }
  giveBack(0);
  const Direction mean = unit(sum);
  return faces(seed, mean, growthSquaredCosine()) ? mean : own;
}

void PatchGrower::findBorder(const PatchMesh& mesh, std::size_t count) {
  int start = -1;
  for (std::size_t i = 0; i < count; ++i) {
    const int t = order_[i];
    for (std::size_t c = 0; c < 3; ++c) {
      const int across = mesh.across[t][c];
      const bool inside = across >= 0 && owner_[across] == attempt_ && orderIndex_[across] < static_cast<int>(count);
      if (!inside) {
        start = mesh.triangles[t][c];
        next_[start] = mesh.triangles[t][(c + 1) % 3];
      }
    }
  }
  border_.clear();
  for (int v = start; border_.empty() || v != start; v = next_[v]) {
    border_.push_back(v);
  }
}

void PatchGrower::cutBack(const PatchMesh& mesh, const PositionLanes& positions, const Direction& axis) {
  const auto simple = [&](std::size_t count) {
    findBorder(mesh, count);
    return check_.simple(border_.data(), static_cast<int>(border_.size()), positions, axis);
  };
  if (simple(order_.size())) {
    return;
  }
  std::size_t good = 1;
  std::size_t bad = order_.size();
  while (bad - good > 1) {
    const std::size_t middle = std::midpoint(good, bad);
    (simple(middle) ? good : bad) = middle;
  }
  giveBack(good);
  findBorder(mesh, good);
}

void PatchGrower::add(const PatchMesh& mesh, const Direction& axis, CollisionFreePatches& patches) {
  CollisionFreePatch patch;
  patch.axis = axis;
  patch.firstCorner = static_cast<int>(patches.corners.a.size());
  patch.firstBorder = static_cast<int>(patches.border.size());
  const int index = patches.count();
  for (const int t : order_) {
    patches.patchOfTriangle[t] = index;
    const Triangle& triangle = mesh.triangles[t];
    patches.corners.a.push_back(triangle[0]);
    patches.corners.b.push_back(triangle[1]);
    patches.corners.c.push_back(triangle[2]);
    for (const int v : triangle) {
      int& own = patches.patchOfVertex[v];
      own = own < 0 ? index : own;
    }
  }
  for (auto* part : {&patches.corners.a, &patches.corners.b, &patches.corners.c}) {
    fillUp(*part);
  }
  patches.border.insert(patches.border.end(), border_.begin(), border_.end());
  patch.lastCorner = static_cast<int>(patches.corners.a.size());
  patch.lastBorder = static_cast<int>(patches.border.size());
  patches.patches.push_back(patch);
}

void PatchGrower::sortVertices(CollisionFreePatches& patches) {
  for (int& patch : patches.patchOfVertex) {
    if (patch < 0) {
      patch = patches.count();
      CollisionFreePatch loose;
      loose.firstCorner = loose.lastCorner = static_cast<int>(patches.corners.a.size());
      loose.firstBorder = loose.lastBorder = static_cast<int>(patches.border.size());
      patches.patches.push_back(loose);
    }
    ++patches.patches[patch].lastVertex;
  }
  int sum = 0;
  for (CollisionFreePatch& patch : patches.patches) {
    patch.firstVertex = sum;
    sum += patch.lastVertex;
    patch.lastVertex = patch.firstVertex;
  }
  patches.vertices.resize(patches.patchOfVertex.size());
  for (std::size_t v = 0; v < patches.vertices.size(); ++v) {
    CollisionFreePatch& patch = patches.patches[patches.patchOfVertex[v]];
    patches.vertices[patch.lastVertex++] = static_cast<int>(v);
  }
}

void PatchGrower::keepPatches(const CollisionFreePatches& old, const std::vector<char>& valid,
                              CollisionFreePatches& patches) {
  std::vector<int> indices(valid.size(), -1);
  for (std::size_t c = 0; c < valid.size(); ++c) {
    CollisionFreePatch patch = old.patches[c];
    if (valid[c] == 0 || patch.firstCorner == patch.lastCorner) {
      continue;
    }
    indices[c] = patches.count();
    const auto copied = [&](const std::vector<int>& from, int first, int last, std::vector<int>& to) {
      to.insert(to.end(), from.begin() + first, from.begin() + last);
    };
    const int firstCorner = static_cast<int>(patches.corners.a.size());
    const int firstBorder = static_cast<int>(patches.border.size());
    copied(old.corners.a, patch.firstCorner, patch.lastCorner, patches.corners.a);
    copied(old.corners.b, patch.firstCorner, patch.lastCorner, patches.corners.b);
    copied(old.corners.c, patch.firstCorner, patch.lastCorner, patches.corners.c);
    copied(old.border, patch.firstBorder, patch.lastBorder, patches.border);
    for (auto i = static_cast<std::size_t>(firstCorner); i < patches.corners.a.size(); ++i) {
      for (const int v : {patches.corners.a[i], patches.corners.b[i], patches.corners.c[i]}) {
        int& own = patches.patchOfVertex[v];
        own = own < 0 ? indices[c] : own;
      }
    }
    patch.firstCorner = firstCorner;
    patch.lastCorner = static_cast<int>(patches.corners.a.size());
    patch.firstBorder = firstBorder;
    patch.lastBorder = static_cast<int>(patches.border.size());
    patch.firstVertex = patch.lastVertex = 0;
    patches.patches.push_back(patch);
  }
  for (std::size_t t = 0; t < owner_.size(); ++t) {
    const int was = old.patchOfTriangle[t];
    if (was >= 0 && indices[was] >= 0) {
      owner_[t] = kept;
      patches.patchOfTriangle[t] = indices[was];
    }
  }
}

/// Grows a patch from a triangle, unless it belongs to one already.
void PatchGrower::growFrom(const PatchMesh& mesh, const PositionLanes& positions, int seed, float axisSquaredCosine,
                           CollisionFreePatches& patches) {
  if (owner_[seed] == freeTriangle) {
    const Direction axis = axisAround(mesh, seed, axisSquaredCosine);
    takeFrom(mesh, seed, axis, growthSquaredCosine(), mesh.triangles.size());
    cutBack(mesh, positions, axis);
    add(mesh, axis, patches);
  }
}

void PatchGrower::growRest(const PatchMesh& mesh, const PositionLanes& positions, CollisionFreePatches& patches) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    growFrom(mesh, positions, static_cast<int>(t), growthSquaredCosine(), patches);
  }
  sortVertices(patches);
}

void PatchGrower::grow(const PatchMesh& mesh, const PositionLanes& positions, CollisionFreePatches& patches) {
  begin(mesh, positions, patches);
  growRest(mesh, positions, patches);
}

void PatchGrower::growAcrossBorders(const PatchMesh& mesh, const PositionLanes& positions,
                                    std::span<const std::shared_ptr<const CollisionFreePatches>> others,
                                    CollisionFreePatches& patches) {
  std::vector<char> inside(static_cast<std::size_t>(mesh.vertices), 0);
  for (const auto& each : others) {
    const std::vector<int> common = patchesAroundVertices(mesh.triangles, *each);
    std::ranges::transform(inside, common, inside.begin(),
                           [](char was, int patch) { return static_cast<char>(was != 0 || patch >= 0 ? 1 : 0); });
  }
  begin(mesh, positions, patches);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (std::ranges::any_of(mesh.triangles[t], [&](int v) { return inside[v] == 0; })) {
      growFrom(mesh, positions, static_cast<int>(t), squaredCosineAcrossFolds, patches);
    }
  }
}

void PatchGrower::repair(const PatchMesh& mesh, const PositionLanes& positions, const CollisionFreePatches& old,
                         const std::vector<char>& valid, CollisionFreePatches& patches) {
  begin(mesh, positions, patches);
  keepPatches(old, valid, patches);
  growRest(mesh, positions, patches);
}

int PatchCheck::failures(const CollisionFreePatches& patches, const PositionLanes& positions,
                         std::vector<char>& valid) {
  static const float minimum = squaredCosine(holdAngle);
  valid.assign(patches.patches.size(), 1);
  int failed = 0;
  for (std::size_t c = 0; c < valid.size(); ++c) {
    const CollisionFreePatch& patch = patches.patches[c];
    if (!normalsWithin(positions, patches.corners, patch.firstCorner, patch.lastCorner, patch.axis, minimum) ||
        !border_.simple(patches.border.data() + patch.firstBorder, patch.lastBorder - patch.firstBorder, positions,
                        patch.axis)) {
      valid[c] = 0;
      ++failed;
    }
  }
  return failed;
}

}  // namespace drape::sim::contact
