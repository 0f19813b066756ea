#include "sim/contact/exact/corrections.hpp"

#include "sim/model/distances.hpp"

#include <algorithm>

namespace drape::sim::contact {
namespace {

constexpr double allowedThicknesses = 4.0;  // that a correction may exceed the largest motion of the step
constexpr double ratioToPins = 3.0;         // of the speed of a vertex

}  // namespace

double largestCorrection(std::span<const Vec3> start, std::span<const Vec3> end, double thickness) {
  return largestDistance(start, end) + allowedThicknesses * thickness;
}

void limitCorrections(double limit, std::span<const Vec3> before, std::span<Vec3> after) {
  for (std::size_t v = 0; v < before.size(); ++v) {
    const Vec3 moved = after[v] - before[v];
    const double distance = moved.norm();
    if (distance > limit) {
      after[v] = before[v] + limit / distance * moved;
    }
  }
}

void limitSpeeds(std::span<const double> inverseMass, double pinSpeed, std::span<const Vec3> before,
                 std::span<Vec3> after) {
  if (pinSpeed == 0.0) {
    return;
  }
  double limit = ratioToPins * pinSpeed;
  for (std::size_t v = 0; v < before.size(); ++v) {
    limit = std::max(limit, inverseMass[v] > 0.0 ? before[v].norm() : 0.0);
  }
  for (std::size_t v = 0; v < after.size(); ++v) {
    const double speed = after[v].norm();
    if (inverseMass[v] > 0.0 && speed > limit) {
      after[v] *= limit / speed;
    }
  }
}

}  // namespace drape::sim::contact
