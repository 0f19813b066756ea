#include "sim/contact/separating_planes/separating_plane_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drape {
namespace {

constexpr int rounds = 8;
constexpr int lastRounds = 64;      // of a vertex that has no place yet
constexpr double rounding = 1e-10;  // [m] far below the guard that every barrier holds

double slack(const Barrier& barrier, const Vec3& position) {
  return barrier.normal.dot(position) - barrier.height;
}

double leastSlack(std::span<const Barrier> barriers, const Vec3& position) {
  double least = std::numeric_limits<double>::infinity();
  for (const Barrier& barrier : barriers) {
    least = std::min(least, slack(barrier, position));
  }
  return least;
}

/// Puts a vertex onto each barrier that it has crossed, one after the other.
void project(std::span<const Barrier> barriers, int most, Vec3& position) {
  bool moved = true;
  for (int round = 0; round < most && moved; ++round) {
    moved = false;
    for (const Barrier& barrier : barriers) {
      const double missing = -slack(barrier, position);
      if (missing > 0.0) {
        position += missing * barrier.normal;
        moved = true;
      }
    }
  }
}

/// How far from `base` towards `position` one can go with all barriers held, 0 to 1. Both are on the right side of
/// those that are met, or `base` is as far on the wrong side as one gets.
double shareOfWay(std::span<const Barrier> barriers, const Vec3& base, const Vec3& position) {
  double share = 1.0;
  for (const Barrier& barrier : barriers) {
    const double from = slack(barrier, base);
    const double to = slack(barrier, position);
    if (to < 0.0 && to < from) {
      share = std::min(share, std::clamp(from / (from - to), 0.0, 1.0));
    }
  }
  return share;
}

/// A vertex with the places where it is safe.
struct Vertex {
  std::span<const Barrier> barriers;
  double room;  // [m]
  int bodies;
  int index;
};

/// Goes back towards a refuge until every barrier is held. With bodies that move differently there are several; the one
/// that suits all barriers best is taken. Where none does, a place may be found from there.
bool retreat(const Vertex& vertex, const BarrierFilter::ShelterOf& shelterOf, Vec3& position) {
  double best = -std::numeric_limits<double>::infinity();
  BarrierFilter::Shelter from{position, position};
  for (int body = 0; body < vertex.bodies; ++body) {
    const BarrierFilter::Shelter shelter = shelterOf(body, vertex.index);
    const double least = leastSlack(vertex.barriers, shelter.refuge);
    if (least > best) {
      best = least;
      from = shelter;
    }
  }
  if (best < -rounding) {
    Vec3 found = from.refuge;
    project(vertex.barriers, lastRounds, found);
    if (leastSlack(vertex.barriers, found) >= -rounding && (found - from.base).norm() <= vertex.room) {
      position = found;
      return true;
    }
  }
  const double way = (position - from.refuge).norm();
  const double room = std::max(0.0, vertex.room - (from.refuge - from.base).norm());
  const double share = std::min(shareOfWay(vertex.barriers, from.refuge, position), way > room ? room / way : 1.0);
  position = from.refuge + share * (position - from.refuge);
  return best >= -rounding;
}

bool hasLeft(const Vertex& vertex, const BarrierFilter::ShelterOf& shelterOf, const Vec3& position) {
  for (int body = 0; body < vertex.bodies; ++body) {
    if ((position - shelterOf(body, vertex.index).base).norm() > vertex.room + rounding) {
      return true;
    }
  }
  return false;
}

}  // namespace

void BarrierFilter::sortByVertex(std::span<const Barrier> barriers, std::size_t vertices) {
  begin_.assign(vertices + 1, 0);
  for (const Barrier& barrier : barriers) {
    ++begin_[static_cast<std::size_t>(barrier.vertex)];
  }
  std::size_t sum = 0;
  for (std::size_t& each : begin_) {
    sum += each;
    each = sum;
  }
  sorted_.resize(barriers.size());
  for (std::size_t i = barriers.size(); i-- > 0;) {
    sorted_[--begin_[static_cast<std::size_t>(barriers[i].vertex)]] = barriers[i];
  }
}

int BarrierFilter::apply(std::span<const Barrier> barriers, std::span<const double> inverseMass,
                         std::span<const double> room, int bodies, const ShelterOf& shelterOf,
                         std::span<const Vec3> targets, std::span<Vec3> positions) {
  sortByVertex(barriers, positions.size());
  int squeezed = 0;
  farthest_ = 0.0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const Vertex vertex{barriersOf(v), room[v], bodies, static_cast<int>(v)};
    const bool free = inverseMass[v] > 0.0;
    const Vec3 before = positions[v];
    if (free) {
      project(vertex.barriers, rounds, positions[v]);
    }
    const bool crossed = leastSlack(vertex.barriers, positions[v]) < -rounding;
    if (crossed || (positions[v] != targets[v] && hasLeft(vertex, shelterOf, positions[v]))) {
      squeezed += free && retreat(vertex, shelterOf, positions[v]) ? 0 : 1;
    }
    farthest_ = std::max(farthest_, (positions[v] - before).norm());
  }
  return squeezed;
}

}  // namespace drape
