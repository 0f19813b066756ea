#include "scene/ground.hpp"

#include "sim/model/bounds.hpp"

#include <algorithm>
#include <limits>

namespace drape::scene {
namespace {

constexpr double clearance = 0.01;         // cloth that starts below this height gets a ground below itself [m]
constexpr double shareBelow = 0.25;        // share of the cloth's largest extent, between cloth and ground [-]
constexpr double shareStretch = 0.1;       // share of the cloth's largest extent, for the stretch of hanging cloth [-]
constexpr std::size_t maxVertices = 4096;  // number of samples for the lowest point, which need not be exact
constexpr std::size_t maxPins = 256;

/// The stride that leaves at most `maxCount` samples of `count`.
std::size_t strideOf(std::size_t count, std::size_t maxCount) {
  return std::max<std::size_t>(1, (count + maxCount - 1) / maxCount);
}

double heightBelow(std::span<const Vec3> start, std::span<const int> pins) {
  const Eigen::AlignedBox3d box = sim::boundsOf(start);
  const double extent = box.sizes().maxCoeff();
  const double below = box.min().y() - shareBelow * extent;
  return pins.empty() ? below : std::min(below, lowestHang(start, pins) - shareStretch * extent);
}

}  // namespace

// A vertex is at most as far from a pin as the cloth between them is long. The straight distance approximates that
// length.
double lowestHang(std::span<const Vec3> start, std::span<const int> pins) {
  double lowest = std::numeric_limits<double>::infinity();
  const std::size_t nextVertex = strideOf(start.size(), maxVertices);
  const std::size_t nextPin = strideOf(pins.size(), maxPins);
  for (std::size_t v = 0; v < start.size(); v += nextVertex) {
    double reach = -std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < pins.size(); p += nextPin) {
      const Vec3& pin = start[pins[p]];
      reach = std::max(reach, pin.y() - (start[v] - pin).norm());
    }
    lowest = std::min(lowest, reach);
  }
  return lowest;
}

sim::contact::Body groundBody() {
  sim::contact::Body ground;
  ground.name = "ground";
  ground.shape = sim::contact::PlaneShape{};
  ground.drawn = false;
  return ground;
}

sim::contact::Body standBody() {
  sim::contact::Body stand;
  stand.name = "stand";
  stand.drawn = false;
  return stand;
}

double groundHeightOf(const SceneDescription& description, std::span<const Vec3> start, std::span<const int> pins) {
  if (description.groundHeight) {
    return *description.groundHeight;
  }
  constexpr double usualHeight = 0.0;
  const bool above = sim::boundsOf(start).min().y() > usualHeight + clearance;
  return above && !description.groundBelowCloth ? usualHeight : heightBelow(start, pins);
}

}  // namespace drape::scene
