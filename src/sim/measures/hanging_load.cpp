#include "sim/measures/hanging_load.hpp"

#include "sim/forces/forces.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace drape::sim {
namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();
constexpr std::size_t cuts = 64;

/// The distance of each vertex from the nearest pin along the springs (Dijkstra) [m]; infinite where there is no pin.
std::vector<double> distancesFromPins(const ClothModel& model) {
  using Reached = std::pair<double, int>;
  std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
  std::vector<double> distance(model.pinned.size(), unreached);
  for (std::size_t v = 0; v < model.pinned.size(); ++v) {
    if (model.pinned[v]) {
      distance[v] = 0.0;
      queue.emplace(0.0, static_cast<int>(v));
    }
  }
  while (!queue.empty()) {
    const auto [reached, vertex] = queue.top();
    queue.pop();
    if (reached > distance[vertex]) {
      continue;
    }
    for (const SpringEnd& end : model.springEnds[vertex]) {
      const double next = reached + model.springs[end.spring].restLength;
      double& known = distance[end.neighbour];
      if (next < known) {
        known = next;
        queue.emplace(next, end.neighbour);
      }
    }
  }
  return distance;
}

/// For each cut the mass beyond it and the stiffness of the springs across it.
struct CutSums {
  std::vector<double> mass = std::vector<double>(cuts, 0.0);  // [kg]
  std::vector<double> stiffness =
      std::vector<double>(cuts, 0.0);  // of springs of 1 N/m: force for each unit of strain [m]
};

CutSums sumOverCuts(const ClothModel& model, const std::vector<double>& distance, double maxDistance) {
  CutSums sums;
  const auto cutAt = [&](double d) {  // number of cuts nearer than d
    return std::min(cuts, static_cast<std::size_t>(std::ceil(d / maxDistance * static_cast<double>(cuts))));
  };
  for (std::size_t v = 0; v < distance.size(); ++v) {
    if (distance[v] < unreached) {
      const std::size_t end = cutAt(distance[v]);
      for (std::size_t cut = 0; cut < end; ++cut) {
        sums.mass[cut] += model.vertexMass[v];
      }
    }
  }
  for (const Spring& spring : model.springs) {
    const auto [nearer, farther] = std::minmax(distance[spring.a], distance[spring.b]);
    if (!(farther < unreached) || !(spring.restLength > 0.0)) {
      continue;
    }
    // With a strain e away from the pins, a spring at an angle of cosine c is strained by e c^2; c of its force counts.
    const double cosine = std::min(1.0, (farther - nearer) / spring.restLength);
    for (std::size_t cut = cutAt(nearer); cut < cutAt(farther); ++cut) {
      sums.stiffness[cut] += spring.relativeStiffness * spring.restLength * cosine * cosine * cosine;
    }
  }
  return sums;
}

}  // namespace

double strainByWeight(const ClothModel& model, const CommonParameters& parameters) {
  const std::vector<double> distance = distancesFromPins(model);
  double maxDistance = 0.0;
  for (const double each : distance) {
    maxDistance = each < unreached ? std::max(maxDistance, each) : maxDistance;
  }
  if (!(maxDistance > 0.0)) {
    return 0.0;
  }
  const CutSums sums = sumOverCuts(model, distance, maxDistance);
  double strain = 0.0;
  for (std::size_t cut = 0; cut < cuts; ++cut) {
    if (sums.stiffness[cut] > 0.0) {
      strain = std::max(
          strain, sums.mass[cut] * parameters.gravity / (sums.stiffness[cut] * stretchStiffness(model, parameters)));
    }
  }
  return strain;
}

}  // namespace drape::sim
