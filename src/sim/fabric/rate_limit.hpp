#pragma once

#include <span>
#include <vector>

namespace drape::sim::fabric {

/// The limit on the local frequencies of a cloth. Without it a few slivers or tiny triangles would determine the time
/// step of the whole cloth. On meshes of even quality no vertex reaches it.
///
/// A rate is the largest stiffness at a vertex per area [N/m^3]. It is proportional to the square of the local
/// frequency.
class RateLimit {
 public:
  /// The limit is the larger of `maxRatio` times the median, and of the rate that one vertex in 100 exceeds. A triangle
  /// may have half of it, since several triangles meet at a vertex.
  /// @param rates of all vertices
  RateLimit(std::vector<double> rates, double maxRatio);

  /// The factor on the stiffness of a triangle [-], at most 1. @param rate its own part of the rate at a vertex
  [[nodiscard]] double scaleOf(double rate) const { return rate > limit_ ? limit_ / rate : 1.0; }

 private:
  double limit_ = 0.0;  // of a triangle [N/m^3]
};

/// `maxRatio` for the membrane, whose rate goes with the inverse square of a triangle's size, and for bending, with the
/// inverse fourth power [-]. Meshes of even quality have at most 12.
inline constexpr double maxMembraneRatio = 16.0;
inline constexpr double maxBendingRatio = maxMembraneRatio * maxMembraneRatio;

/// The areas of vertices [m^2], with a lower bound for degenerate ones.
[[nodiscard]] std::vector<double> boundedAreas(std::span<const double> vertexAreas);

}  // namespace drape::sim::fabric
