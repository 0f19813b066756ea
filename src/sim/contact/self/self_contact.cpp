#include "sim/contact/self/self_contact.hpp"

#include "sim/forces/diagnostics.hpp"
#include "sim/simd/convert.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace drape::sim::contact {
namespace {

/// Default thickness, in mean rest lengths of the springs.
constexpr double thicknessOfEdge = 0.75;

/// Minimum and maximum margin of a search, in thicknesses, and the number of steps for which it should suffice.
constexpr double minMargin = 0.25;
constexpr double maxMargin = 0.7;
constexpr double stepsOfMargin = 4.0;

/// Substep contacts, in thicknesses: pairs are listed up to `listMargin` beyond the thickness at their predicted
/// distance. They rest on each other within `restGap` beyond the thickness.
constexpr double listMargin = 0.05;
constexpr double restGap = 0.001;

constexpr int maxSearchesPerGrowth = 64;  // see PatchUpdater

/// With more patches than this, points are not culled by the bounding boxes of patches, since the cost of comparing all
/// boxes grows with the square of their number.
constexpr int maxBoxes = 64;

/// Shift of the grids per search, modulo 1: powers of the root of x^4 = x + 1, a low-discrepancy sequence.
constexpr std::array<double, 3> phaseSteps = {0.8191725133961645, 0.6710436067037893, 0.5497004779019703};

double diagonalOf(const LaneBox& box) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double side = static_cast<double>(box.high[axis]) - static_cast<double>(box.low[axis]);
    sum += side * side;
  }
  return std::sqrt(sum);
}

void copyPositions(const std::vector<Vec3>& from, PositionLanes& to) {
  to.resize(from.size());
  simd::splitCoordinates(from.data()->data(), from.size(), Vec3::Zero(), {to.x.data(), to.y.data(), to.z.data()});
}

double squaredDistance(const PositionLanes& positions, const VertexPair& pair) {
  const int a = pair.a;
  const int b = pair.b;
  const auto square = [](float x, float y) { return (x - y) * (x - y); };
  return static_cast<double>(square(positions.x[a], positions.x[b]) + square(positions.y[a], positions.y[b]) +
                             square(positions.z[a], positions.z[b]));
}

/// Whether a search is possible. The caller of the step handles states that are not finite.
bool allFinite(const std::vector<float>& values, std::size_t count) {
  constexpr std::uint32_t exponent = 0x7f800000U;
  std::uint32_t bad = 0;
  for (std::size_t i = 0; i < count; ++i) {
    bad |= (std::bit_cast<std::uint32_t>(values[i]) & exponent) == exponent ? 1U : 0U;
  }
  return bad == 0;
}

bool allFinite(const PositionLanes& positions, std::size_t count) {
  return allFinite(positions.x, count) && allFinite(positions.y, count) && allFinite(positions.z, count);
}

/// The intersection of two boxes, the second extended by `margin` on all sides.
LaneBox common(const LaneBox& a, const LaneBox& b, float margin) {
  LaneBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::max(a.low[axis], b.low[axis] - margin);
    box.high[axis] = std::min(a.high[axis], b.high[axis] + margin);
  }
  return box;
}

bool isEmpty(const LaneBox& box) {
  return box.low[0] > box.high[0] || box.low[1] > box.high[1] || box.low[2] > box.high[2];
}

bool connected(const ClothModel& model, const VertexPair& pair) {
  const std::span<const SpringEnd> ends = model.springEnds[pair.a];
  return std::any_of(ends.begin(), ends.end(), [&](const SpringEnd& end) { return end.neighbour == pair.b; });
}

}  // namespace

double selfThicknessOf(const ClothModel& model, const ContactParameters& parameters) {
  return parameters.selfThickness > 0.0 ? parameters.selfThickness : thicknessOfEdge * meanEdge(model);
}

bool SelfContact::pairListIsValid(const ClothModel& model, double thickness, const ClothState& state) const {
  const SelfContactMemory* memory = state.selfContact.get();
  return memory != nullptr && memory->vertices == model.vertexCount() &&
         memory->triangles == static_cast<int>(model.triangles.size()) && memory->thickness == thickness &&
         diagonalOf(displacementsBetween(positions_, memory->positions, model.vertexCount())) <=
             memory->reach - memory->thickness;
}

std::shared_ptr<SelfContactMemory> SelfContact::unusedMemory() {
  for (std::shared_ptr<SelfContactMemory>& memory : memories_) {
    if (memory == nullptr) {
      memory = std::make_shared<SelfContactMemory>();
    }
    if (memory.use_count() == 1) {
      return memory;
    }
  }
  return std::make_shared<SelfContactMemory>();  // all are in use, since many states are kept
}

void SelfContact::gatherPointsNearOtherPatches(const CollisionFreePatches& patches, float reach) {
  const std::size_t vertices = patches.vertices.size();
  sorted_.resize(vertices);
  for (std::size_t i = 0; i < vertices; ++i) {
    const int v = patches.vertices[i];
    sorted_.x[i] = positions_.x[v];
    sorted_.y[i] = positions_.y[v];
    sorted_.z[i] = positions_.z[v];
  }
  near_.assign(vertices, patches.count() > maxBoxes ? 1 : 0);
  if (patches.count() <= maxBoxes) {
    boxes_.resize(patches.patches.size());
    inside_.resize(vertices + maxLanes);
    for (std::size_t c = 0; c < boxes_.size(); ++c) {
      boxes_[c] = boxOf(sorted_, patches.patches[c].firstVertex, patches.patches[c].lastVertex);
    }
    for (std::size_t c = 0; c < boxes_.size(); ++c) {
      for (std::size_t other = 0; other < boxes_.size(); ++other) {
        const LaneBox box = common(boxes_[c], boxes_[other], reach);
        if (other != c && !isEmpty(box)) {
          int count = 0;
          positionsInside(sorted_, patches.patches[c].firstVertex, patches.patches[c].lastVertex, box, inside_.data(),
                          count);
          std::for_each(inside_.begin(), inside_.begin() + count, [&](int i) { near_[i] = 1; });
        }
      }
    }
  }
  points_.resize(vertices);
  points_.count = 0;
  pointOf_.assign(vertices, -1);
  for (std::size_t i = 0; i < vertices; ++i) {
    if (near_[i] != 0) {
      const int v = patches.vertices[i];
      const int at = points_.count;
      points_.positions.x[at] = sorted_.x[i];
      points_.positions.y[at] = sorted_.y[i];
      points_.positions.z[at] = sorted_.z[i];
      points_.patch[at] = patches.patchOfVertex[v];
      points_.vertex[at] = patches.vertices[i];
      pointOf_[v] = points_.count++;
    }
  }
}

void SelfContact::keepKnownPairs(const SelfContactMemory& old, const CollisionFreePatches& patches, double reach,
                                 std::vector<VertexPair>& pairs) const {
  for (std::size_t i = 0; i < static_cast<std::size_t>(old.pairs.count()); ++i) {
    const VertexPair& pair = old.pairs.pairs[i];
    const int a = pointOf_[pair.a];
    const int b = pointOf_[pair.b];
    const bool apart = patches.patchOfVertex[pair.a] != patches.patchOfVertex[pair.b];
    if (a >= 0 && b >= 0 && apart && !hash_.compared(a, b) && squaredDistance(positions_, pair) < reach * reach) {
      pairs.push_back(pair);
    }
  }
}

void SelfContact::removeConnectedPairs(const ClothModel& model, double thickness, std::vector<VertexPair>& pairs) {
  const auto joined = [&](const VertexPair& pair) {
    const Vec3 atRest = model.restPositions[pair.b] - model.restPositions[pair.a];
    const bool restNear = atRest.squaredNorm() < thickness * thickness && model.areInOneCloth(pair.a, pair.b);
    const bool isWelded = model.vertexTriangles[pair.a].empty() || model.vertexTriangles[pair.b].empty();
    return restNear || isWelded || connected(model, pair);
  };
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), joined), pairs.end());
}

void SelfContact::updatePairs(const ClothModel& model, double thickness, const std::vector<Vec3>& start,
                              ClothState& state) {
  const std::shared_ptr<const SelfContactMemory> last = state.selfContact;
  const bool same = last != nullptr && last->vertices == model.vertexCount() &&
                    last->triangles == static_cast<int>(model.triangles.size());
  const SelfContactMemory* old = same ? last.get() : nullptr;
  const std::shared_ptr<SelfContactMemory> memory = unusedMemory();
  copyPositions(start, startPositions_);
  const double moved = diagonalOf(displacementsBetween(positions_, startPositions_, model.vertexCount()));
  memory->thickness = thickness;
  memory->reach = thickness + std::clamp(stepsOfMargin * moved, minMargin * thickness, maxMargin * thickness);
  memory->vertices = model.vertexCount();
  memory->triangles = static_cast<int>(model.triangles.size());
  memory->searches = old != nullptr ? old->searches + 1 : 0;
  memory->patches = patches_.update(mesh_.get(model, patchMeshOf), positions_,
                                    old != nullptr ? old->patches : PatchHistory{}, maxSearchesPerGrowth);
  memory->positions = positions_;
  found_.clear();
  const CollisionFreePatches& patches = *memory->patches.patches;
  if (patches.count() > 1) {
    gatherPointsNearOtherPatches(patches, static_cast<float>(memory->reach));
    std::array<float, 3> phase{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double all = phaseSteps[axis] * memory->searches;
      phase[axis] = static_cast<float>(all - std::floor(all));
    }
    hash_.findPairs(points_, static_cast<float>(memory->reach), phase, found_);
    removeConnectedPairs(model, thickness, found_);
    if (old != nullptr && old->thickness == thickness) {
      keepKnownPairs(*old, patches, memory->reach, found_);
    }
  }
  colourPairs(model.vertexCount(), found_, colours_, memory->pairs);
  state.selfContact = memory;
}

double SelfContact::thicknessOf(const ClothModel& model, const ContactParameters& contact) {
  return contact.selfThickness > 0.0
             ? contact.selfThickness
             : edge_.get(model, [&](const ClothModel& m) { return selfThicknessOf(m, contact); });
}

void SelfContact::findSubstepContacts(const ClothModel& model, const CommonParameters& parameters,
                                      const ContactParameters& contact, const std::vector<Vec3>& ahead,
                                      ClothState& state, std::vector<SubstepContact>& found) {
  const double thickness = thicknessOf(model, contact);
  const double h = parameters.timeStep;
  copyPositions(ahead, positions_);
  if (!allFinite(positions_, ahead.size())) {
    return;
  }
  if (!pairListIsValid(model, thickness, state)) {
    updatePairs(model, thickness, state.positions, state);
  }
  const SelfContactMemory* memory = state.selfContact.get();
  const double margin = listMargin * thickness + parameters.gravity * h * h;
  for (std::size_t i = 0; i < static_cast<std::size_t>(memory->pairs.count()); ++i) {
    const auto [a, b] = memory->pairs.pairs[i];
    const Vec3 offset = state.positions[a] - state.positions[b];
    const double distance = offset.norm();
    if (distance == 0.0 || distance > thickness + memory->reach) {
      continue;
    }
    const Vec3 normal = offset / distance;
    const double approach = -h * normal.dot(state.velocities[a] - state.velocities[b]);
    if (distance - std::max(0.0, approach) < thickness + margin) {
      found.push_back({.vertices = {a, b, b, b},
                       .weights = {1.0, -1.0, 0.0, 0.0},
                       .normal = normal,
                       .height = std::min(thickness, distance),
                       .restGap = restGap * thickness,
                       .staticFriction = contact.staticFriction,
                       .kineticFriction = std::min(contact.kineticFriction, contact.staticFriction)});
    }
  }
}

int SelfContact::resolve(const ClothModel& model, const ContactParameters& contact, double timeStep,
                         const std::vector<Vec3>& start, ClothState& state, std::vector<ContactPoint>& points,
                         double stepFraction) {
  const double thickness = thicknessOf(model, contact);
  copyPositions(state.positions, positions_);
  if (!pairListIsValid(model, thickness, state)) {
    if (!allFinite(positions_, state.positions.size())) {
      return 0;
    }
    updatePairs(model, thickness, start, state);
  }
  const SelfContactMemory& memory = *state.selfContact;
  if (memory.pairs.count() == 0) {
    return 0;
  }
  copyPositions(start, startPositions_);
  const Friction friction = {static_cast<float>(contact.staticFriction), static_cast<float>(contact.kineticFriction)};
  const auto pushOut = static_cast<float>(1.0 - std::pow(1.0 - SelfResponse::pushOut, stepFraction));
  return response_.resolve(model, {timeStep, thickness, friction, pushOut}, memory.pairs, startPositions_, positions_,
                           state, points);
}

}  // namespace drape::sim::contact
