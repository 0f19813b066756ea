#pragma once

#include "sim/contact/recovery/common_exit.hpp"
#include "sim/contact/recovery/solid.hpp"

#include <span>
#include <vector>

namespace drape {

/// What of a cloth is inside a body where its step begins, and the way out for each of its vertices.
///
/// Mostly that is the way to the nearest point of the surface. Where these ways would tear neighbours apart, all of a
/// connected piece goes in one direction: the one in which it has the least way to go, of those in which what hangs on
/// it can follow. Where only a small part of a piece is torn off the rest, that part joins the rest.
class Overlap {
 public:
  void clear();

  /// Finds the ways out of all vertices that are marked.
  /// @param inside one a vertex  @param base [m]  @param up preferred among directions that are as good
  void find(Solid& solid, std::vector<char> inside, std::span<const Vec3> start, std::span<const Triangle> triangles,
            const Vec3& up);

  /// Whether anything is inside. What follows it through the body counts as such.
  [[nodiscard]] bool any() const { return !members_.empty(); }
  [[nodiscard]] bool inside(int vertex) const {
    return !inside_.empty() && inside_[static_cast<std::size_t>(vertex)] != 0;
  }
  /// Of a vertex that is inside: where it comes out. The gap is negative.
  [[nodiscard]] const NearPoint& exitOf(int vertex) const { return exits_[static_cast<std::size_t>(vertex)]; }
  /// Of a vertex that is inside: how far away the surface is [m]; 0 of one that follows.
  [[nodiscard]] double depthOf(int vertex) const { return depths_[static_cast<std::size_t>(vertex)]; }
  /// The vertices that are inside, ascending.
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
  [[nodiscard]] bool tears(const Cloth& cloth, std::size_t a, std::size_t b) const;
  void take(const std::vector<CommonExit::Exit>& exits);
  void addFollowers();

  std::vector<char> inside_;
  std::vector<int> members_;
  std::vector<NearPoint> exits_;
  std::vector<double> depths_;
  std::vector<CommonExit::Exit> followers_;
};

/// Which vertices of a cloth are inside a solid: pieces of it that do not pierce the surface are inside or outside as a
/// whole.
/// @param pierces for each triangle whether it meets the surface
[[nodiscard]] std::vector<char> verticesInside(Solid& solid, std::span<const Vec3> start,
                                               std::span<const Triangle> triangles, const std::vector<bool>& pierces);

}  // namespace drape
