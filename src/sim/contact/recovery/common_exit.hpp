#pragma once

#include "sim/contact/recovery/solid.hpp"

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace drape::sim::contact {

/// Finds one direction in which a part of a cloth can leave a body as a whole.
///
/// A sheet that a limb passes through cannot leave it sideways: the part inside would come out at one side, and the
/// adjacent cloth would stay at the other. A direction is feasible only if the adjacent cloth behind the body, seen
/// along the direction, is small. Then it follows through the body.
class CommonExit {
 public:
  /// A vertex inside, or one outside that follows, with the point where it leaves.
  using Exit = std::pair<int, NearPoint>;

  /// @param inside per vertex
  CommonExit(Solid& solid, std::span<const Vec3> start, std::span<const Triangle> triangles,
             const std::vector<char>& inside)
      : solid_(solid), start_(start), triangles_(triangles), inside_(inside) {}

  /// Sets the vertices that must leave, and the directions to try (unit vectors). Of directions with equal distances
  /// the earlier one is preferred.
  void begin(std::span<const int> vertices, const std::vector<Vec3>& directions);

  /// The exits of all vertices in the feasible direction with the smallest maximum distance, if that is less than
  /// `maxDistance` [m]; empty if there is none.
  /// @param follow whether adjacent cloth must be able to follow; then its exits are included
  /// @param suits additional condition on the exits in a direction
  [[nodiscard]] std::vector<Exit> find(
      double maxDistance, bool follow,
      const std::function<bool(const std::vector<Exit>&)>& suits = [](const auto&) { return true; });

 private:
  struct Direction {
    Vec3 along = Vec3::Zero();
    double maxDistance = 0.0;  // maximum distance to the exit [m]
  };
  [[nodiscard]] bool findFollowers(const Direction& direction, std::vector<Exit>& followers);

  Solid& solid_;
  std::span<const Vec3> start_;
  std::span<const Triangle> triangles_;
  const std::vector<char>& inside_;
  std::span<const int> vertices_;
  std::vector<Direction> directions_;  // by distance
};

}  // namespace drape::sim::contact
