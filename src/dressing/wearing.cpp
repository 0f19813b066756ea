#include "dressing/wearing.hpp"

#include "dressing/closed_body.hpp"
#include "dressing/inside.hpp"
#include "sim/model/bounds.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace drape::dressing {
namespace {

/// The parts that may pass through an opening.
std::vector<BodyPart> partsThrough(OpeningKind kind) {
  switch (kind) {
    case OpeningKind::LeftSleeve:
      return {BodyPart::LeftArm};
    case OpeningKind::RightSleeve:
      return {BodyPart::RightArm};
    case OpeningKind::LeftLeg:
      return {BodyPart::LeftLeg};
    case OpeningKind::RightLeg:
      return {BodyPart::RightLeg};
    case OpeningKind::Neck:
    case OpeningKind::Waist:
      return {BodyPart::Whole, BodyPart::Head, BodyPart::Trunk};
    case OpeningKind::Hood:
    case OpeningKind::Hem:
      break;
  }
  return {};
}

/// The triangles of the trunk around the border of an arm. A wide armhole lies there, farther inside than the arm.
std::vector<Triangle> shoulderOf(BodyPart arm, const ShrinkingBody& body, const BodyParts& parts) {
  constexpr double reach = 0.05;  // of the height of the body
  const std::vector<Vec3>& positions = body.frames().front();
  std::vector<int> border;
  for (const Triangle& triangle : body.triangles()) {
    const bool touchesTrunk =
        std::ranges::any_of(triangle, [&](int vertex) { return parts.ofVertex(vertex) == BodyPart::Trunk; });
    std::ranges::copy_if(triangle, std::back_inserter(border),
                         [&](int vertex) { return touchesTrunk && parts.ofVertex(vertex) == arm; });
  }
  Vec3 centre = Vec3::Zero();
  for (const int vertex : border) {
    centre += positions[vertex] / static_cast<double>(border.size());
  }
  double radius = 0.0;
  for (const int vertex : border) {
    radius = std::max(radius, (positions[vertex] - centre).norm());
  }
  radius += reach * sim::boundsOf(positions).sizes().y();
  std::vector<Triangle> shoulder;
  std::ranges::copy_if(body.triangles(), std::back_inserter(shoulder), [&](const Triangle& triangle) {
    return parts.ofTriangle(triangle) == BodyPart::Trunk && (positions[triangle[0]] - centre).norm() < radius;
  });
  return shoulder;
}

/// Whether an opening is for one part of a person, so that it is wrong if this part does not pass through it.
bool isForLimb(OpeningKind kind) {
  return isSleeve(kind) || isLeg(kind);
}

}  // namespace

/// The part that an opening is for, by which its fault is named.
BodyPart Wearing::partFor(OpeningKind kind) const {
  if (!parts_.isPerson()) {
    return BodyPart::Whole;
  }
  return kind == OpeningKind::Neck    ? BodyPart::Head
         : kind == OpeningKind::Waist ? BodyPart::Trunk
                                      : partsThrough(kind).front();
}

Wearing::Wearing(const ShrinkingBody& body, const BodyParts& parts, const GarmentOpenings& openings,
                 std::span<const Triangle> garment)
    : body_(body), parts_(parts), openings_(openings), garment_(garment) {
  for (const Triangle& triangle : body.triangles()) {
    trianglesOf_[parts.ofTriangle(triangle)].push_back(triangle);
  }
  for (const BodyPart arm : {BodyPart::LeftArm, BodyPart::RightArm}) {
    shoulders_[arm] = shoulderOf(arm, body, parts);
  }
}

std::vector<intersection::TrianglePair> Wearing::intersecting(std::span<const Vec3> positions,
                                                              const std::vector<Vec3>& body) const {
  return intersection::intersectingPairs({positions, garment_}, {body, body_.triangles()});
}

std::size_t Wearing::pairs(std::span<const Vec3> positions, const std::vector<Vec3>& body) const {
  return intersecting(positions, body).size();
}

bool Wearing::passes(const Opening& opening, std::span<const Vec3> positions, const std::vector<Vec3>& body) const {
  const sim::ClothMesh span = spanning(opening, positions);
  const auto isCrossedBy = [&](const std::map<BodyPart, std::vector<Triangle>>& groups, BodyPart part) {
    const auto triangles = groups.find(part);
    return triangles != groups.end() &&
           !intersection::intersectingPairs({span.positions, span.triangles}, {body, triangles->second}).empty();
  };
  return std::ranges::any_of(partsThrough(opening.kind), [&](BodyPart part) {
    return isCrossedBy(trianglesOf_, part) || isCrossedBy(shoulders_, part);
  });
}

std::vector<const Opening*> Wearing::missed(std::span<const Vec3> positions, const std::vector<Vec3>& body) const {
  std::vector<const Opening*> result;
  for (const Opening& opening : openings_.all()) {
    const bool counts = !partsThrough(opening.kind).empty() && (parts_.isPerson() || !isForLimb(opening.kind));
    if (counts && !passes(opening, positions, body)) {
      result.push_back(&opening);
    }
  }
  return result;
}

/// Whether the end of a limb is inside the garment and near the opening: the sleeve or the trouser leg is too long.
bool Wearing::endsBefore(const Opening& opening, std::span<const Vec3> positions,
                         const std::vector<Vec3>& limbs) const {
  const auto triangles = trianglesOf_.find(partsThrough(opening.kind).front());
  if (triangles == trianglesOf_.end()) {
    return false;
  }
  const Vec3& neck = parts_.landmarks()->neck;
  Vec3 end = neck;
  for (const Triangle& triangle : triangles->second) {
    for (const int vertex : triangle) {
      if ((limbs[vertex] - neck).squaredNorm() > (end - neck).squaredNorm()) {
        end = limbs[vertex];
      }
    }
  }
  constexpr double near = 0.5;  // of the distance from neck to opening
  const Vec3 centre = centreOf(opening, positions);
  if ((end - centre).norm() > near * (centre - neck).norm()) {
    return false;
  }
  sim::ClothMesh closed = closedBody({{positions.begin(), positions.end()}, {garment_.begin(), garment_.end()}}).mesh;
  const std::vector<Vec3> point{end};
  if (shareInside(point, closed.positions, closed.triangles) > 0.0) {
    return true;
  }
  for (Triangle& triangle : closed.triangles) {  // a garment may be inside out
    std::swap(triangle[0], triangle[1]);
  }
  return shareInside(point, closed.positions, closed.triangles) > 0.0;
}

bool Wearing::isAtSleeve(int triangle, std::span<const Vec3> positions) const {
  const Triangle& corners = garment_[triangle];
  const Vec3 centre = (positions[corners[0]] + positions[corners[1]] + positions[corners[2]]) / 3.0;
  double nearest = std::numeric_limits<double>::max();
  bool atSleeve = false;
  for (const Opening& opening : openings_.all()) {
    for (const int vertex : opening.vertices) {
      const double distance = (positions[vertex] - centre).squaredNorm();
      if (distance < nearest) {
        nearest = distance;
        atSleeve = isSleeve(opening.kind);
      }
    }
  }
  return atSleeve;
}

std::vector<Fault> Wearing::wallFaults(std::span<const Vec3> positions,
                                       std::span<const intersection::TrianglePair> pairs) const {
  std::map<BodyPart, Fault> faults;
  for (const intersection::TrianglePair& pair : pairs) {
    const BodyPart part = parts_.ofTriangle(body_.triangles()[pair.second]);
    const bool isArm = part == BodyPart::LeftArm || part == BodyPart::RightArm;
    Fault& fault = faults.try_emplace(part, Fault{.part = part}).first->second;
    ++fault.pairs;
    fault.atSleeve = fault.atSleeve || (isArm && isAtSleeve(pair.first, positions));
  }
  std::vector<Fault> result;
  for (const auto& [part, fault] : faults) {
    result.push_back(fault);
  }
  return result;
}

std::vector<Fault> Wearing::faults(std::span<const Vec3> positions, std::size_t frame,
                                   const std::vector<Vec3>& limbs) const {
  std::vector<Fault> result = wallFaults(positions, intersecting(positions, body_.frames()[frame]));
  for (const Opening* opening : missed(positions, limbs)) {
    if (isForLimb(opening->kind) && endsBefore(*opening, positions, limbs)) {
      continue;
    }
    result.push_back({.kind = FaultKind::MissesOpening, .part = partFor(opening->kind), .opening = opening->kind});
  }
  return result;
}

}  // namespace drape::dressing
