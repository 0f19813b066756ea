#include "sim/contact/separating_planes/separating_plane_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drape::sim::contact {
namespace {

constexpr int maxProjections = 8;
constexpr int maxFallbackProjections = 64;  // for a vertex without a feasible position so far

double slack(const SeparatingPlane& plane, const Vec3& position) {
  return plane.normal.dot(position) - plane.height;
}

double minSlack(std::span<const SeparatingPlane> planes, const Vec3& position) {
  double minimum = std::numeric_limits<double>::infinity();
  for (const SeparatingPlane& plane : planes) {
    minimum = std::min(minimum, slack(plane, position));
  }
  return minimum;
}

/// Projects a vertex onto each plane that it has crossed, one after the other.
void project(std::span<const SeparatingPlane> planes, int iterations, Vec3& position) {
  bool moved = true;
  for (int iteration = 0; iteration < iterations && moved; ++iteration) {
    moved = false;
    for (const SeparatingPlane& plane : planes) {
      const double missing = -slack(plane, position);
      if (missing > 0.0) {
        position += missing * plane.normal;
        moved = true;
      }
    }
  }
}

/// The maximum fraction of the way from `start` to `position` on which no plane is violated more than at `start`, 0
/// to 1.
double feasibleFraction(std::span<const SeparatingPlane> planes, const Vec3& start, const Vec3& position) {
  double fraction = 1.0;
  for (const SeparatingPlane& plane : planes) {
    const double from = slack(plane, start);
    const double to = slack(plane, position);
    if (to < 0.0 && to < from) {
      fraction = std::min(fraction, std::clamp(from / (from - to), 0.0, 1.0));
    }
  }
  return fraction;
}

/// A vertex with its planes.
struct Vertex {
  std::span<const SeparatingPlane> planes;
  double displacementBound;  // [m]
  int bodies;
  int index;
};

/// Moves a vertex back towards a fallback position until it satisfies every plane. Each body has its own fallback
/// position; the one with the maximum slack is used. If it violates planes, a projection from there may find a feasible
/// position.
/// @return whether the vertex is feasible
bool retreat(const Vertex& vertex, const SeparatingPlaneFilter::Fallback& fallback, Vec3& position) {
  double best = -std::numeric_limits<double>::infinity();
  Vec3 start = position;
  Vec3 from = position;
  for (int body = 0; body < vertex.bodies; ++body) {
    const Vec3 carried = fallback.carried(body, vertex.index);
    const double minimum = minSlack(vertex.planes, carried);
    if (minimum > best) {
      best = minimum;
      start = fallback.start(body, vertex.index);
      from = carried;
    }
  }
  if (best < -planeTolerance) {
    Vec3 found = from;
    project(vertex.planes, maxFallbackProjections, found);
    if (minSlack(vertex.planes, found) >= -planeTolerance && (found - start).norm() <= vertex.displacementBound) {
      position = found;
      return true;
    }
  }
  const double distance = (position - from).norm();
  const double remaining = std::max(0.0, vertex.displacementBound - (from - start).norm());
  const double fraction =
      std::min(feasibleFraction(vertex.planes, from, position), distance > remaining ? remaining / distance : 1.0);
  position = from + fraction * (position - from);
  return best >= -planeTolerance;
}

/// Whether a vertex exceeds its displacement bound.
bool hasLeft(const Vertex& vertex, const SeparatingPlaneFilter::PositionOf& startOf, const Vec3& position) {
  for (int body = 0; body < vertex.bodies; ++body) {
    if ((position - startOf(body, vertex.index)).norm() > vertex.displacementBound + planeTolerance) {
      return true;
    }
  }
  return false;
}

}  // namespace

void SeparatingPlaneFilter::sortByVertex(std::span<const SeparatingPlane> planes, std::size_t vertices) {
  begin_.assign(vertices + 1, 0);
  for (const SeparatingPlane& plane : planes) {
    ++begin_[plane.vertex];
  }
  std::size_t sum = 0;
  for (std::size_t& each : begin_) {
    sum += each;
    each = sum;
  }
  sorted_.resize(planes.size());
  for (std::size_t i = planes.size(); i-- > 0;) {
    sorted_[--begin_[planes[i].vertex]] = planes[i];
  }
}

int SeparatingPlaneFilter::apply(std::span<const SeparatingPlane> planes, std::span<const double> inverseMass,
                                 std::span<const double> displacementBounds, int bodies, const Fallback& fallback,
                                 std::span<const Vec3> predicted, std::span<Vec3> positions) {
  sortByVertex(planes, positions.size());
  int infeasible = 0;
  maxCorrection_ = 0.0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Vertex vertex{planesOf(v), displacementBounds[v], bodies, static_cast<int>(v)};
    const bool free = inverseMass[v] > 0.0;
    const Vec3 before = positions[v];
    if (free) {
      project(vertex.planes, maxProjections, positions[v]);
    }
    const bool crossed = minSlack(vertex.planes, positions[v]) < -planeTolerance;
    if (crossed || (positions[v] != predicted[v] && hasLeft(vertex, fallback.start, positions[v]))) {
      infeasible += free && retreat(vertex, fallback, positions[v]) ? 0 : 1;
    }
    maxCorrection_ = std::max(maxCorrection_, (positions[v] - before).norm());
  }
  return infeasible;
}

}  // namespace drape::sim::contact
