#include "sim/contact/barrier_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drape {
namespace {

constexpr int rounds = 8;
constexpr double rounding = 1e-10;  // [m] far below the guard that every barrier holds

double slack(const Barrier& barrier, const Vec3& position) {
  return barrier.normal.dot(position) - barrier.height;
}

/// How far from `base` towards `position` one can go with all barriers of the vertex held, 0 to 1. Both are on the
/// right side of those that are met, or `base` is as far on the wrong side as one gets.
double shareOfWay(std::span<const Barrier> barriers, int vertex, const Vec3& base, const Vec3& position) {
  double share = 1.0;
  for (const Barrier& barrier : barriers) {
    if (barrier.vertex != vertex) {
      continue;
    }
    const double from = slack(barrier, base);
    const double to = slack(barrier, position);
    if (to < 0.0 && to < from) {
      share = std::min(share, std::clamp(from / (from - to), 0.0, 1.0));
    }
  }
  return share;
}

}  // namespace

void BarrierFilter::project(std::span<const Barrier> barriers, std::span<const double> inverseMass,
                            std::span<Vec3> positions) {
  for (int round = 0; round < rounds; ++round) {
    bool moved = false;
    for (const Barrier& barrier : barriers) {
      Vec3& position = positions[static_cast<std::size_t>(barrier.vertex)];
      const double missing = -slack(barrier, position);
      if (missing > 0.0 && inverseMass[static_cast<std::size_t>(barrier.vertex)] > 0.0) {
        position += missing * barrier.normal;
        moved = true;
      }
    }
    if (!moved) {
      return;
    }
  }
}

/// Goes back towards a base until every barrier is held. With bodies that move differently there are several bases; the
/// one that suits all barriers best is taken.
bool BarrierFilter::retreat(std::span<const Barrier> barriers, double room, int bodies, const BaseOf& baseOf,
                            int vertex, Vec3& position) const {
  double best = -std::numeric_limits<double>::infinity();
  Vec3 from = position;
  for (int body = 0; body < bodies; ++body) {
    const Vec3 base = baseOf(body, vertex);
    double least = std::numeric_limits<double>::infinity();
    for (const Barrier& barrier : barriers) {
      if (barrier.vertex == vertex) {
        least = std::min(least, slack(barrier, base));
      }
    }
    if (least > best) {
      best = least;
      from = base;
    }
  }
  const double way = (position - from).norm();
  const double share = std::min(shareOfWay(barriers, vertex, from, position), way > room ? room / way : 1.0);
  position = from + share * (position - from);
  return best >= -rounding;
}

int BarrierFilter::apply(std::span<const Barrier> barriers, std::span<const double> inverseMass,
                         std::span<const double> room, int bodies, const BaseOf& baseOf, std::span<const Vec3> targets,
                         std::span<Vec3> positions) {
  before_.assign(positions.begin(), positions.end());
  project(barriers, inverseMass, positions);
  offenders_.clear();
  for (const Barrier& barrier : barriers) {
    if (slack(barrier, positions[static_cast<std::size_t>(barrier.vertex)]) < -rounding) {
      offenders_.push_back(barrier.vertex);
    }
  }
  for (std::size_t v = 0; v < positions.size(); ++v) {
    for (int body = 0; body < bodies && positions[v] != targets[v]; ++body) {
      if ((positions[v] - baseOf(body, static_cast<int>(v))).norm() > room[v] + rounding) {
        offenders_.push_back(static_cast<int>(v));
      }
    }
  }
  std::sort(offenders_.begin(), offenders_.end());
  offenders_.erase(std::unique(offenders_.begin(), offenders_.end()), offenders_.end());
  int squeezed = 0;
  for (const int vertex : offenders_) {
    const auto v = static_cast<std::size_t>(vertex);
    const bool free = inverseMass[v] > 0.0;
    squeezed += free && retreat(barriers, room[v], bodies, baseOf, vertex, positions[v]) ? 0 : 1;
  }
  farthest_ = 0.0;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    farthest_ = std::max(farthest_, (positions[v] - before_[v]).norm());
  }
  return squeezed;
}

}  // namespace drape
