#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace drape::sim::fabric {

/// The limit on the local frequencies of a cloth. Without it a few slivers or tiny triangles would determine the time
/// step of the whole cloth. On meshes of even quality no triangle reaches it. Each cloth of a model has its own limit.
///
/// A rate is the largest stiffness at a vertex per area [N/m^3]. It is proportional to the square of the local
/// frequency.
class RateLimit {
 public:
  /// The limit is the larger of two rates: `maxRatio` times the median, and the rate that one vertex in 100 exceeds. A
  /// triangle may have half of it, since several triangles meet at a vertex.
  /// @param stiffness of all vertices [N/m]  @param vertexAreas of all vertices [m^2]
  /// @param clothOf the cloth of each vertex (ClothModel::clothOf); empty: there is one
  RateLimit(std::span<const double> stiffness, std::span<const double> vertexAreas, double maxRatio,
            std::span<const int> clothOf = {});

  /// The factor that clamps a triangle's stiffness at one of its vertices [-], at most 1.
  /// @param stiffness the triangle's part of the stiffness at the vertex [N/m]
  [[nodiscard]] double scaleOf(double stiffness, std::size_t vertex) const {
    const double rate = stiffness / areas_[vertex];
    const double limit = limits_[clothOf_.empty() ? 0 : clothOf_[vertex]];
    return rate > limit ? limit / rate : 1.0;
  }

 private:
  std::vector<double> areas_;   // with a lower bound for degenerate vertices [m^2]
  std::vector<int> clothOf_;    // of each vertex; empty: there is one cloth
  std::vector<double> limits_;  // of a triangle of each cloth [N/m^3]
};

/// `maxRatio` for the membrane [-]. Its rate goes with the inverse square of a triangle's size. Meshes of even quality
/// have at most 12.
inline constexpr double maxMembraneRatio = 16.0;
/// The same for bending, whose rate goes with the inverse fourth power of the size.
/// @param maxRatio of the membrane [-]
[[nodiscard]] constexpr double maxBendingRatio(double maxRatio) {
  return maxRatio * maxRatio;
}

}  // namespace drape::sim::fabric
