#include "sim/contact/recovery/overlap.hpp"

#include "sim/model/mesh_topology.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace drape::sim::contact {
namespace {

constexpr double tearRatio = 3.0;        // maximum distance between the exits of a side's ends, over its length [-]
constexpr double maxPullRatio = 3.0;     // maximum common exit distance, over the elongation of the piece [-]
constexpr double directExitRatio = 1.5;  // common exit distance that is always allowed, over the depth of the piece [-]
constexpr double maxTornRatio = 0.2;     // maximum fraction of torn sides between a part and the rest that it joins [-]
constexpr double minMainRatio = 0.6;     // minimum fraction of a piece that the other parts can join [-]

/// Calls visit(a, b) for the sides with both ends inside.
template <typename Visit>
void forEachSideInside(const std::vector<char>& inside, std::span<const Triangle> triangles, Visit&& visit) {
  forEachSide(triangles, [&](int a, int b) {
    if (inside[a] != 0 && inside[b] != 0) {
      visit(a, b);
    }
  });
}

/// Calls visit(a, b) for the sides with one end inside (a) and one outside (b).
template <typename Visit>
void forEachSideThrough(const std::vector<char>& inside, std::span<const Triangle> triangles, Visit&& visit) {
  forEachSide(triangles, [&](int a, int b) {
    if ((inside[a] != 0) != (inside[b] != 0)) {
      inside[a] != 0 ? visit(a, b) : visit(b, a);
    }
  });
}

/// Elongation of a side whose ends move to these exits [m]; 0 if it is tolerable.
double tearOf(double length, const NearPoint& a, const NearPoint& b) {
  const double apart = (a.startPoint - b.startPoint).norm();
  const bool opposite = a.normal.dot(b.normal) < 0.0 && apart > length;  // the exits are on opposite sides of a limb
  return opposite || apart > tearRatio * length ? apart - length : 0.0;
}

/// Candidate directions for a common exit, preferred ones first.
std::vector<Vec3> directionsOf(const Vec3& up, const Vec3& across) {
  std::vector<Vec3> directions{
      up, Vec3::UnitY(), -Vec3::UnitY(), Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitZ(), -Vec3::UnitZ()};
  const double length = across.norm();
  if (length > 0.0) {
    directions.emplace_back(across / length);
    directions.emplace_back(-across / length);
  }
  return directions;
}

}  // namespace

/// A connected set of vertices inside, and the elongation that their nearest exits would cause.
struct Overlap::Piece {
  std::vector<int> vertices;
  Vec3 across = Vec3::Zero();  // sum of the triangles' normals, times twice their areas [m^2]
  double tear = 0.0;           // maximum elongation of a side [m]; 0 if tolerable
  double depth = 0.0;          // maximum depth [m]
};

std::vector<char> verticesInside(Solid& solid, std::span<const Vec3> start, std::span<const Triangle> triangles,
                                 const std::vector<bool>& pierces) {
  DisjointSets pieces(start.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!pierces[t]) {
      joinCorners(triangles[t], pieces);
    }
  }
  std::vector<char> inside(start.size(), 0);
  for (std::size_t v = 0; v < start.size(); ++v) {
    const auto root = static_cast<std::size_t>(pieces.root(static_cast<int>(v)));
    inside[v] = root == v ? static_cast<char>(solid.contains(start[v])) : inside[root];
  }
  return inside;
}

void Overlap::clear() {
  inside_.clear();
  members_.clear();
  followers_.clear();
}

void Overlap::find(Solid& solid, std::vector<char> inside, std::span<const Vec3> start,
                   std::span<const Triangle> triangles, const Vec3& up) {
  clear();
  inside_ = std::move(inside);
  exits_.resize(start.size());
  depths_.assign(start.size(), 0.0);
  for (std::size_t v = 0; v < start.size(); ++v) {
    if (inside_[v] != 0) {
      members_.push_back(static_cast<int>(v));
      exits_[v] = solid.nearestExit(start[v]);
      depths_[v] = -exits_[v].gap;
    }
  }
  const Cloth cloth{start, triangles};
  findOutsides(solid, cloth);
  for (const Piece& piece : piecesOf(cloth)) {
    const std::size_t before = followers_.size();
    if (piece.tear > 0.0) {
      leadOutTogether(solid, cloth, piece, up);
    }
    // The whole piece moves at one speed, so that shallow vertices do not separate from deep ones.
    double depth = 0.0;
    for (const int v : piece.vertices) {
      depth = std::max(depth, -exitOf(v).gap);
    }
    for (const int v : piece.vertices) {
      exits_[v].depth = depth;
    }
    for (std::size_t i = before; i < followers_.size(); ++i) {
      followers_[i].second.depth = depth;
    }
  }
  addFollowers();
}

/// Finds the closest surface points of the outside vertices next to a piece.
void Overlap::findOutsides(Solid& solid, const Cloth& cloth) {
  std::vector<bool> found(cloth.start.size(), false);
  forEachSideThrough(inside_, cloth.triangles, [&](int /*inside*/, int v) {
    if (!found[v]) {
      found[v] = true;
      exits_[v] = solid.nearestSurface(cloth.start[v]);
    }
  });
}

/// The pieces, ordered by their first vertices.
std::vector<Overlap::Piece> Overlap::piecesOf(const Cloth& cloth) const {
  DisjointSets sets(cloth.start.size());
  forEachSideInside(inside_, cloth.triangles, [&](int a, int b) { sets.join(a, b); });
  std::map<int, Piece> pieces;
  for (const int v : members_) {
    Piece& piece = pieces[sets.root(v)];
    piece.vertices.push_back(v);
    piece.depth = std::max(piece.depth, depthOf(v));
  }
  const auto tear = [&](int a, int b) {
    Piece& piece = pieces[sets.root(a)];
    piece.tear = std::max(piece.tear, tearOf((cloth.start[a] - cloth.start[b]).norm(), exits_[a], exits_[b]));
  };
  forEachSideInside(inside_, cloth.triangles, tear);
  forEachSideThrough(inside_, cloth.triangles, tear);
  for (const Triangle& t : cloth.triangles) {
    if (inside(t[0]) && inside(t[1]) && inside(t[2])) {
      const Corners at = cornersOf(cloth.start, t);
      pieces[sets.root(t[0])].across += (at[1] - at[0]).cross(at[2] - at[0]);
    }
  }
  std::vector<Piece> found;
  for (auto& [root, piece] : pieces) {
    found.push_back(std::move(piece));
  }
  return found;
}

/// Gives a piece that would be torn a common exit direction, if there is one with tolerable distances.
void Overlap::leadOutTogether(Solid& solid, const Cloth& cloth, const Piece& piece, const Vec3& up) {
  const std::vector<Vec3> directions = directionsOf(up, piece.across);
  CommonExit exit(solid, cloth.start, cloth.triangles, inside_);
  exit.begin(piece.vertices, directions);
  auto exits = exit.find(directExitRatio * piece.depth, true);
  if (exits.empty() && joinPartsToRest(solid, cloth, piece, directions)) {
    return;
  }
  if (exits.empty()) {
    exits = exit.find(maxPullRatio * std::max(piece.tear, 2.0 * piece.depth), true);
  }
  if (exits.empty()) {
    exits = exit.find(maxPullRatio * piece.tear, false);
  }
  take(exits);
}

/// If most of a piece is not torn, lets its other parts leave where the main part does.
/// @return false if there is no main part
bool Overlap::joinPartsToRest(Solid& solid, const Cloth& cloth, const Piece& piece,
                              const std::vector<Vec3>& directions) {
  DisjointSets sets(cloth.start.size());
  forEachSideInside(inside_, cloth.triangles, [&](int a, int b) {
    if (!tears(cloth, a, b)) {
      sets.join(a, b);
    }
  });
  std::map<int, std::vector<int>> parts;
  for (const int v : piece.vertices) {
    parts[sets.root(v)].push_back(v);
  }
  const auto main = std::max_element(parts.begin(), parts.end(),
                                     [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
  if (parts.size() == 1 ||
      static_cast<double>(main->second.size()) < minMainRatio * static_cast<double>(piece.vertices.size())) {
    return false;
  }
  int through = 0;
  int torn = 0;
  forEachSideThrough(inside_, cloth.triangles, [&](int a, int b) {
    if (sets.root(a) == main->first) {
      ++through;
      torn += tears(cloth, a, b) ? 1 : 0;
    }
  });
  if (torn > maxTornRatio * through) {
    return false;  // the main part itself is torn from the cloth outside
  }
  for (const auto& [root, part] : parts) {
    if (root != main->first) {
      joinPartToRest(solid, cloth, part, maxPullRatio * piece.tear, directions);
    }
  }
  return true;
}

/// Lets a part of a piece leave in the mean direction of its neighbours, or in another direction that tears few sides.
/// @param maxDistance to its exits [m]
void Overlap::joinPartToRest(Solid& solid, const Cloth& cloth, const std::vector<int>& part, double maxDistance,
                             std::vector<Vec3> directions) {
  const std::set<int> members(part.begin(), part.end());
  std::vector<std::pair<int, int>> sides;  // from the part to the rest of the piece
  Vec3 where = Vec3::Zero();
  forEachSideInside(inside_, cloth.triangles, [&](int a, int b) {
    const bool first = members.count(a) > 0;
    if (first != (members.count(b) > 0)) {
      sides.emplace_back(first ? a : b, first ? b : a);
      where += exits_[first ? b : a].normal;
    }
  });
  if (where.norm() > 0.0) {
    directions.insert(directions.begin(), where.normalized());
  }
  CommonExit exit(solid, cloth.start, cloth.triangles, inside_);
  exit.begin(part, directions);
  take(exit.find(maxDistance, true, [&](const std::vector<CommonExit::Exit>& exits) {
    std::map<int, const NearPoint*> of;
    for (const CommonExit::Exit& each : exits) {
      of[each.first] = &each.second;
    }
    const auto torn = std::count_if(sides.begin(), sides.end(), [&](const auto& side) {
      const double length = (cloth.start[side.first] - cloth.start[side.second]).norm();
      return tearOf(length, *of.at(side.first), exits_[side.second]) > 0.0;
    });
    return static_cast<double>(torn) <= maxTornRatio * static_cast<double>(sides.size());
  }));
}

bool Overlap::tears(const Cloth& cloth, int a, int b) const {
  return tearOf((cloth.start[a] - cloth.start[b]).norm(), exits_[a], exits_[b]) > 0.0;
}

void Overlap::take(const std::vector<CommonExit::Exit>& exits) {
  for (const CommonExit::Exit& each : exits) {
    if (inside(each.first)) {
      exits_[each.first] = each.second;
    } else {
      followers_.push_back(each);
    }
  }
}

void Overlap::addFollowers() {
  for (const auto& [v, exit] : followers_) {
    exits_[v] = exit;
    if (!inside(v)) {
      inside_[v] = 1;
      members_.push_back(v);
    }
  }
  std::sort(members_.begin(), members_.end());
}

}  // namespace drape::sim::contact
