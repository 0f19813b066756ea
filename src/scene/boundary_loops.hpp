#pragma once

#include "sim/model/cloth_model.hpp"

#include <Eigen/Geometry>

#include <vector>

namespace drape::scene {

/// A closed chain of edges with one face each: an opening of a garment, or the outline of a sheet.
struct BoundaryLoop {
  std::vector<int> vertices;   ///< in the order of the walk
  double length = 0.0;         ///< [m]
  Vec3 centre = Vec3::Zero();  ///< length-weighted mean [m]
  Vec3 area = Vec3::Zero();    ///< enclosed area times its normal [m^2]; the sign has no meaning
  Eigen::AlignedBox3d box;     ///< around its vertices [m]
  double thickness = 0.0;      ///< its smallest extent over the middle one, from its spread [-]; 0 in a plane
  int piece = 0;               ///< index into ClothPieces::pieces
};

/// A connected part of a mesh.
struct ClothPiece {
  double area = 0.0;          ///< [m^2]
  Eigen::AlignedBox3d box;    ///< around its vertices [m]
  int loops = 0;              ///< boundary loops
  int eulerNumber = 0;        ///< vertices - edges + triangles; 1 for a disc, 0 for a tube
  std::vector<int> vertices;  ///< ascending
};

/// The connected parts of a mesh and their boundaries.
struct ClothPieces {
  std::vector<ClothPiece> pieces;   ///< ordered by their lowest vertex
  std::vector<BoundaryLoop> loops;  ///< ordered by their lowest vertex

  /// Whether the loop is the outline of a sheet, not an opening of a hollow shape. A flat disc has at most the area of
  /// the circle with its circumference; a sock or a cap has more. The outline of a sheet with holes is far from round:
  /// that of an apron extends from one end of the piece to the other along all axes, and that of a jacket which is open
  /// at the front encloses little area for its length and does not lie in a plane.
  [[nodiscard]] bool isOutline(const BoundaryLoop& loop) const;
};

/// Finds the pieces and the boundary loops of a mesh. Cost: sorting the edges.
[[nodiscard]] ClothPieces findPieces(const sim::ClothMesh& mesh);

}  // namespace drape::scene
