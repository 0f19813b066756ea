#include "sim/contact/exact/pair_separation.hpp"

#include <algorithm>
#include <utility>

namespace drape::sim::contact {
namespace {

constexpr double minRoundings = 1e3;     // of the distance that conservative advancement can prove
constexpr double maxTurn = 300.0;        // displacement of vertices relative to each other, in separations
constexpr double closingPerStep = 1e-9;  // fraction of its separation that a close pair may lose in a step

/// A normal, and a lower bound of the distance along it [m].
struct Separation {
  Vec3 normal = Vec3::UnitY();
  double distance = 0.0;
};

/// Takes the direction of an axis, or its opposite, if the pair is farther apart along it than along the present
/// normal.
void offer(const Vec3& axis, const PairVertices& vertices, std::span<const Vec3> positions, Separation& best) {
  const double length = axis.norm();
  if (!(length > 0.0)) {
    return;
  }
  for (const double sign : {1.0, -1.0}) {
    const Vec3 normal = sign / length * axis;
    const double distance = separationAlong(normal, vertices, positions);
    if (distance > best.distance) {
      best = {normal, distance};
    }
  }
}

/// Finds a plane between the features. If rounding spoils the normal of the closest points, it tries the normals of the
/// faces, and those of planes along the sides.
Separation separationAt(const PairVertices& vertices, std::span<const Vec3> positions) {
  const PairGap gap = gapOf(vertices, positions);
  Separation best{gap.normal, separationAlong(gap.normal, vertices, positions)};
  if (best.distance > 0.0) {
    return best;
  }
  const auto& [a, b, c, d] = vertices.all;
  const auto side = [&](int from, int to) { return Vec3(positions[to] - positions[from]); };
  if (vertices.firstCount == 2) {
    offer(side(a, b).cross(side(c, d)), vertices, positions, best);
    offer(side(a, b).cross(side(a, c)).cross(side(a, b)), vertices, positions, best);
    offer(side(c, d).cross(side(a, c)).cross(side(c, d)), vertices, positions, best);
  } else {
    offer(side(b, c).cross(side(b, d)), vertices, positions, best);
    for (const auto& [from, to] : {std::pair{b, c}, {c, d}, {d, b}}) {
      offer(side(from, to).cross(side(from, a)).cross(side(from, to)), vertices, positions, best);
    }
  }
  return best;
}

/// Whether a pair that is at least `kept` apart at both ends of the step, and turns little, certainly does not meet in
/// between.
bool turnsApart(double kept, const PairVertices& vertices, std::span<const Vec3> start, std::span<const Vec3> end) {
  const auto move = [&](int v) { return Vec3(end[v] - start[v]); };
  const Vec3 common = move(vertices.all[0]);
  const bool turnsLittle = std::all_of(vertices.all.begin(), vertices.all.end(),
                                       [&](int v) { return (move(v) - common).norm() <= maxTurn * kept; });
  const double rounding = std::max(roundingOf(vertices, start), roundingOf(vertices, end));
  return turnsLittle && kept > minRoundings * rounding && !comesWithin(0.5 * kept, vertices, start, end);
}

}  // namespace

PairInStep separationInStep(const PairVertices& vertices, std::span<const Vec3> start, std::span<const Vec3> end,
                            const SeparationGoal& goal) {
  const Separation first = separationAt(vertices, start);
  if (!(first.distance > 0.0)) {
    return {PairInStep::Kind::Touching, first.normal, 0.0};
  }
  const double kept = std::min(goal.kept, (1.0 - closingPerStep) * first.distance);
  PairInStep separated{PairInStep::Kind::Separated, first.normal, kept};
  if (separationAlong(first.normal, vertices, end) >= kept) {
    return separated;
  }
  const Vec3 other = gapOf(vertices, end).normal;
  if (separationAlong(other, vertices, end) >= kept &&
      (separationAlong(other, vertices, start) >= kept || turnsApart(kept, vertices, start, end))) {
    return separated;
  }
  if (!comesWithin(goal.distance / approachSlack, vertices, start, end)) {
    return separated;
  }
  return {PairInStep::Kind::NotSeparated, first.normal, kept};
}

}  // namespace drape::sim::contact
