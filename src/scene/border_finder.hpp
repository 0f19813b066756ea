#pragma once

#include "scene/boundary_loops.hpp"
#include "scene/seam_matching.hpp"
#include "sim/model/cloth_model.hpp"
#include "text/sentence.hpp"

#include <functional>
#include <span>
#include <vector>

namespace drape::scene {

/// Finds paths along the open borders of a mesh, for seams and elastic bands.
class BorderFinder {
 public:
  /// How messages name a vertex.
  using Naming = std::function<text::Sentence(int vertex)>;

  /// @param mesh must outlive it  @param named "vertex 12" if it is empty
  explicit BorderFinder(const sim::ClothMesh& mesh, Naming named = {});

  [[nodiscard]] int vertexCount() const { return static_cast<int>(mesh_.positions.size()); }

  /// The path through points of a border: one is the start of the whole border, two are the ends of the path on the
  /// shorter way, and three go through the second one. Throws InputError when they are not on one open border.
  /// @param isReversed whether a whole border runs against the sides of its triangles
  [[nodiscard]] BorderPath pathThrough(std::span<const int> points, bool isReversed = false) const;

  /// The vertices of the border with the vertex nearest to a place. Throws InputError without an open border.
  [[nodiscard]] std::vector<int> nearestBorder(const Vec3& place) const;

  /// The vertex of a border nearest to a place, among `count` of them from `first`. Throws InputError when they have no
  /// open border.
  [[nodiscard]] int nearestVertex(const Vec3& place, int first, int count) const;

  /// Throws InputError for a vertex that is not on an open border.
  [[nodiscard]] const BoundaryLoop& borderWith(int vertex) const;

 private:
  const sim::ClothMesh& mesh_;
  Naming named_;
  std::vector<BoundaryLoop> borders_;
};

}  // namespace drape::scene
