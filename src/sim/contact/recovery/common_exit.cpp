#include "sim/contact/recovery/common_exit.hpp"

#include <algorithm>
#include <cmath>

namespace drape::sim::contact {
namespace {

constexpr std::size_t maxProbes = 64;            // maximum number of vertices by which directions are compared
constexpr double improvementRatio = 1.0 - 1e-6;  // shorter than an earlier direction: at most this ratio to it [-]
constexpr double maxSlope = 3.0;  // maximum change of the distance to the body between neighbours, per edge length [-]
constexpr double followersPerVertex = 0.5;  // maximum number of followers per vertex inside ...
constexpr double extraFollowers = 16;       // ... and in addition

enum class VertexRole : char { Unknown, Leaves, Follows, Free };

}  // namespace

void CommonExit::begin(std::span<const int> vertices, const std::vector<Vec3>& directions) {
  vertices_ = vertices;
  directions_.clear();
  const std::size_t every = 1 + vertices.size() / maxProbes;
  for (const Vec3& along : directions) {
    Direction direction{along, 0.0};
    for (std::size_t i = 0; i < vertices.size(); i += every) {
      direction.maxDistance =
          std::max(direction.maxDistance, -solid_.exitAlong(vectorAt(start_, vertices[i]), direction.along).gap);
    }
    // Sorted by distance; of equal directions the earlier one stays first.
    const auto before = std::find_if(directions_.begin(), directions_.end(), [&](const Direction& other) {
      return direction.maxDistance < improvementRatio * other.maxDistance;
    });
    directions_.insert(before, direction);
  }
}

std::vector<CommonExit::Exit> CommonExit::find(double maxDistance, bool follow,
                                               const std::function<bool(const std::vector<Exit>&)>& suits) {
  std::vector<Exit> exits;
  for (const Direction& direction : directions_) {
    exits.clear();
    if (!(direction.maxDistance < maxDistance)) {
      break;
    }
    if (!follow || findFollowers(direction, exits)) {
      for (const int v : vertices_) {
        exits.emplace_back(v, solid_.exitAlong(vectorAt(start_, v), direction.along));
      }
      if (suits(exits)) {
        return exits;
      }
    }
  }
  return {};
}

/// Collects neighbours of the leaving vertices that must follow through the body: those that would hit it in this
/// direction.
/// @return false if they extend too far
bool CommonExit::findFollowers(const Direction& direction, std::vector<Exit>& followers) {
  const auto maxFollowers =
      static_cast<std::size_t>(followersPerVertex * static_cast<double>(vertices_.size()) + extraFollowers);
  std::vector<VertexRole> roles(start_.size(), VertexRole::Unknown);
  std::vector<double> enters(start_.size(), 0.0);
  for (const int v : vertices_) {
    roles[v] = VertexRole::Leaves;
  }
  const auto moves = [&](int v) {
    const VertexRole role = roles[v];
    return role == VertexRole::Leaves || role == VertexRole::Follows;
  };
  for (bool more = true; more;) {
    more = false;
    for (const Triangle& t : triangles_) {
      const auto from = std::find_if(t.begin(), t.end(), moves);
      if (from == t.end()) {
        continue;
      }
      for (const int v : t) {
        if (roles[v] != VertexRole::Unknown || inside_[v] != 0) {
          continue;
        }
        roles[v] = VertexRole::Free;
        const std::optional<Passage> passage = solid_.passageAlong(start_[v], direction.along);
        if (!passage) {
          continue;
        }
        if (passage->enter <= direction.maxDistance) {
          roles[v] = VertexRole::Follows;
          enters[v] = passage->enter;
          followers.emplace_back(v, passage->exit);
          more = true;
        } else if (passage->enter - enters[*from] < maxSlope * (start_[v] - vectorAt(start_, *from)).norm()) {
          return false;
        }
        if (followers.size() > maxFollowers) {
          return false;
        }
      }
    }
  }
  return true;
}

}  // namespace drape::sim::contact
