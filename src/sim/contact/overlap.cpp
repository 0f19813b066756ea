#include "sim/contact/overlap.hpp"

#include "sim/disjoint_sets.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace drape {
namespace {

constexpr double tearing = 3.0;        // times its length: how far the ends of a side may come out from each other [-]
constexpr double pulled = 3.0;         // times as far as it would be torn apart a piece may go in one direction [-]
constexpr std::size_t mostAsked = 64;  // vertices of a piece by which its direction is chosen
constexpr double better = 1.0 - 1e-6;  // by so much less a way must be to be taken instead of an earlier one [-]

/// Calls visit(a, b) for the sides of all triangles whose both ends are inside.
template <typename Visit>
void forEachSideInside(const std::vector<char>& inside, std::span<const Triangle> triangles, Visit&& visit) {
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = static_cast<std::size_t>(t[k]);
      const auto b = static_cast<std::size_t>(t[(k + 1) % 3]);
      if (inside[a] != 0 && inside[b] != 0) {
        visit(a, b);
      }
    }
  }
}

/// Vertices that hang together, and how far their nearest ways out would tear them apart.
struct Piece {
  std::vector<int> vertices;
  Vec3 across = Vec3::Zero();  // sum of its triangles' normals times twice their areas [m^2]
  double tear = 0.0;           // [m]; 0 where it is not too far
};

/// The directions in which a piece could leave, the preferred ones first.
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

std::vector<char> verticesInside(Solid& solid, std::span<const Vec3> base, std::span<const Triangle> triangles,
                                 const std::vector<bool>& pierces) {
  DisjointSets pieces(static_cast<int>(base.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!pierces[t]) {
      pieces.join(triangles[t][0], triangles[t][1]);
      pieces.join(triangles[t][0], triangles[t][2]);
    }
  }
  std::vector<char> inside(base.size(), 0);
  for (std::size_t v = 0; v < base.size(); ++v) {
    const auto root = static_cast<std::size_t>(pieces.root(static_cast<int>(v)));
    inside[v] = root == v ? static_cast<char>(solid.contains(base[v])) : inside[root];
  }
  return inside;
}

void Overlap::clear() {
  inside_.clear();
  members_.clear();
}

void Overlap::find(Solid& solid, std::vector<char> inside, std::span<const Vec3> base,
                   std::span<const Triangle> triangles, const Vec3& up) {
  clear();
  inside_ = std::move(inside);
  exits_.resize(base.size());
  for (std::size_t v = 0; v < base.size(); ++v) {
    if (inside_[v] != 0) {
      members_.push_back(static_cast<int>(v));
      exits_[v] = solid.nearestExit(base[v]);
    }
  }
  DisjointSets sets(static_cast<int>(base.size()));
  forEachSideInside(inside_, triangles,
                    [&](std::size_t a, std::size_t b) { sets.join(static_cast<int>(a), static_cast<int>(b)); });
  std::map<int, Piece> pieces;
  for (const int v : members_) {
    pieces[sets.root(v)].vertices.push_back(v);
  }
  const auto wayOut = [&](std::size_t v) -> Vec3 { return base[v] - exits_[v].gap * exits_[v].normal; };
  forEachSideInside(inside_, triangles, [&](std::size_t a, std::size_t b) {
    const double length = (base[a] - base[b]).norm();
    const double apart = (wayOut(a) - wayOut(b)).norm();
    Piece& piece = pieces[sets.root(static_cast<int>(a))];
    piece.tear = apart > tearing * length ? std::max(piece.tear, apart - length) : piece.tear;
  });
  for (const Triangle& t : triangles) {
    const auto at = [&](std::size_t k) { return base[static_cast<std::size_t>(t[k])]; };
    if (this->inside(t[0]) && this->inside(t[1]) && this->inside(t[2])) {
      pieces[sets.root(t[0])].across += (at(1) - at(0)).cross(at(2) - at(0));
    }
  }
  for (const auto& [root, piece] : pieces) {
    if (piece.tear > 0.0) {
      leadOut(solid, piece.vertices, pulled * piece.tear, base, directionsOf(up, piece.across));
    }
    // All of it goes as fast: what is less deep must not run away from the rest.
    double depth = 0.0;
    for (const int v : piece.vertices) {
      depth = std::max(depth, -exitOf(v).gap);
    }
    for (const int v : piece.vertices) {
      exits_[static_cast<std::size_t>(v)].depth = depth;
    }
  }
}

/// Sends a piece out in one direction, if there is one in which none of it has farther to go than that.
void Overlap::leadOut(Solid& solid, const std::vector<int>& piece, double farthestOut, std::span<const Vec3> base,
                      const std::vector<Vec3>& directions) {
  const std::size_t every = 1 + piece.size() / mostAsked;
  double least = farthestOut;
  const Vec3* best = nullptr;
  for (const Vec3& direction : directions) {
    double farthest = 0.0;
    for (std::size_t i = 0; i < piece.size() && farthest < least; i += every) {
      farthest = std::max(farthest, -solid.exitAlong(vectorAt(base, piece[i]), direction).gap);
    }
    if (farthest < better * least) {
      least = farthest;
      best = &direction;
    }
  }
  for (const int v : piece) {
    if (best != nullptr) {
      exits_[static_cast<std::size_t>(v)] = solid.exitAlong(vectorAt(base, v), *best);
    }
  }
}

}  // namespace drape
