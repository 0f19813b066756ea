#pragma once

#include "sim/contact/recovery/common_exit.hpp"
#include "sim/contact/recovery/solid.hpp"

#include <span>
#include <vector>

namespace drape::sim::contact {

/// The part of a cloth that is inside a body at the start of a step, and the exit of each of its vertices.
///
/// Usually the exit is the closest point of the surface. If these exits would tear neighbours apart, the whole
/// connected piece leaves in one direction (CommonExit): that with the shortest way out among those in which the
/// adjacent cloth can follow. If only a small part would be torn off, it leaves with the rest of the piece.
class Overlap {
 public:
  void clear();

  /// Finds the exits of all vertices that are marked as inside.
  /// @param inside per vertex  @param start positions at the start of the pass, in the body's frame [m]
  /// @param up the preferred one of equally short directions, a unit vector
  void find(Solid& solid, std::vector<char> inside, std::span<const Vec3> start, std::span<const Triangle> triangles,
            const Vec3& up);

  /// Whether any vertex is inside. Vertices that follow through the body count as inside.
  [[nodiscard]] bool any() const { return !members_.empty(); }
  [[nodiscard]] bool inside(int vertex) const { return !inside_.empty() && inside_[vertex] != 0; }
  /// The exit of a vertex inside. Its gap is negative.
  [[nodiscard]] const NearPoint& exitOf(int vertex) const { return exits_[vertex]; }
  /// The distance of a vertex inside to the surface [m]; 0 if it follows.
  [[nodiscard]] double depthOf(int vertex) const { return depths_[vertex]; }
  /// The vertices inside, ascending.
  [[nodiscard]] std::span<const int> members() const { return members_; }

 private:
  struct Piece;
  struct Cloth {
    std::span<const Vec3> start;
    std::span<const Triangle> triangles;
  };
  void findOutsides(Solid& solid, const Cloth& cloth);
  [[nodiscard]] std::vector<Piece> piecesOf(const Cloth& cloth) const;
  void leadOutTogether(Solid& solid, const Cloth& cloth, const Piece& piece, const Vec3& up);
  bool joinPartsToRest(Solid& solid, const Cloth& cloth, const Piece& piece, const std::vector<Vec3>& directions);
  void joinPartToRest(Solid& solid, const Cloth& cloth, const std::vector<int>& part, double maxDistance,
                      std::vector<Vec3> directions);
  [[nodiscard]] bool tears(const Cloth& cloth, int a, int b) const;
  void take(const std::vector<CommonExit::Exit>& exits);
  void addFollowers();

  std::vector<char> inside_;
  std::vector<int> members_;
  std::vector<NearPoint> exits_;
  std::vector<double> depths_;
  std::vector<CommonExit::Exit> followers_;
};

/// Classifies the vertices of a cloth as inside or outside a solid. Connected triangles that do not pierce the surface
/// are on the same side, so one test per connected part suffices.
/// @param pierces per triangle, whether it intersects the surface
[[nodiscard]] std::vector<char> verticesInside(Solid& solid, std::span<const Vec3> start,
                                               std::span<const Triangle> triangles, const std::vector<bool>& pierces);

}  // namespace drape::sim::contact
