#include "scene/ground.hpp"

#include "sim/bounds.hpp"

#include <algorithm>
#include <limits>

namespace drape {
namespace {

constexpr double clearance = 0.01;    // cloth that starts so near to y = 0, or below, gets its ground below itself [m]
constexpr double shareBelow = 0.25;   // of the cloth's largest extent, between cloth and ground [-]
constexpr double shareStretch = 0.1;  // of the cloth's largest extent, that hanging cloth may be longer [-]
constexpr std::size_t maxVertices = 4096;  // that the lowest point is looked for among: it need not be exact
constexpr std::size_t maxPins = 256;

/// The step from one sample to the next that leaves at most `most` of `count`.
std::size_t strideOf(std::size_t count, std::size_t most) {
  return std::max<std::size_t>(1, (count + most - 1) / most);
}

/// The lowest height that the cloth can hang down to [m]. A vertex cannot be further from a pin than the cloth between
/// them is long. Their straight distance stands for that length.
double lowestHang(std::span<const Vec3> start, std::span<const int> pins) {
  double lowest = std::numeric_limits<double>::infinity();
  const std::size_t nextVertex = strideOf(start.size(), maxVertices);
  const std::size_t nextPin = strideOf(pins.size(), maxPins);
  for (std::size_t v = 0; v < start.size(); v += nextVertex) {
    double held = -std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < pins.size(); p += nextPin) {
      const Vec3& pin = start[static_cast<std::size_t>(pins[p])];
      held = std::max(held, pin.y() - (start[v] - pin).norm());
    }
    lowest = std::min(lowest, held);
  }
  return lowest;
}

double heightBelow(std::span<const Vec3> start, std::span<const int> pins) {
  const Eigen::AlignedBox3d box = boundsOf(start);
  const double extent = box.sizes().maxCoeff();
  const double below = box.min().y() - shareBelow * extent;
  return pins.empty() ? below : std::min(below, lowestHang(start, pins) - shareStretch * extent);
}

}  // namespace

Body groundToTouch() {
  Body ground;
  ground.name = "ground";
  ground.shape = PlaneShape{};
  ground.drawn = false;
  return ground;
}

Body standToTouch() {
  Body stand;
  stand.name = "stand";
  stand.drawn = false;
  return stand;
}

double groundHeightOf(const SceneDescription& description, std::span<const Vec3> start, std::span<const int> pins) {
  if (description.groundHeight) {
    return *description.groundHeight;
  }
  constexpr double usualHeight = 0.0;
  const bool above = boundsOf(start).min().y() > usualHeight + clearance;
  return above && !description.groundBelowCloth ? usualHeight : heightBelow(start, pins);
}

}  // namespace drape
