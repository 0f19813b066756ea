#pragma once

#include "sim/contact/recovery/solid.hpp"

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace drape {

/// Looks for one direction in which some of a cloth can leave a body as a whole.
///
/// A sheet that a limb passes through cannot leave it sideways: what is inside would come out at one side, and what
/// hangs on it would stay at the other. It can where that is little: as far as it lies behind the body, seen along the
/// direction, it follows through the body. Where that does not end, the direction is none.
class CommonExit {
 public:
  /// A vertex that is outside and follows, or one that is inside, and where it leaves.
  using Exit = std::pair<int, NearPoint>;

  /// @param inside one a vertex
  CommonExit(Solid& solid, std::span<const Vec3> start, std::span<const Triangle> triangles,
             const std::vector<char>& inside)
      : solid_(solid), start_(start), triangles_(triangles), inside_(inside) {}

  /// Takes what is to leave, and the directions that are tried, the preferred ones first.
  void begin(std::span<const int> vertices, const std::vector<Vec3>& directions);

  /// The ways of all in the direction in which the farthest way is least, of those in which it is at most that far [m];
  /// empty when there is none.
  /// @param follow whether directions count only in which the rest can follow
  /// @param suits asked about the ways in a direction, whether they will do
  [[nodiscard]] std::vector<Exit> find(
      double maxDistance, bool follow,
      const std::function<bool(const std::vector<Exit>&)>& suits = [](const auto&) { return true; });

 private:
  struct Direction {
    Vec3 along = Vec3::Zero();
    double maxDistance = 0.0;  // way out of it [m]
  };
  [[nodiscard]] bool findFollowers(const Direction& direction, std::vector<Exit>& followers);

  Solid& solid_;
  std::span<const Vec3> start_;
  std::span<const Triangle> triangles_;
  const std::vector<char>& inside_;
  std::span<const int> vertices_;
  std::vector<Direction> directions_;  // the best first
};

}  // namespace drape
