#pragma once

#include "scene/boundary_loops.hpp"
#include "scene/scene.hpp"
#include "ui/gizmo.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace drape::ui {

/// A place on an open border.
struct BorderSpot {
  std::size_t border = 0;  ///< index into BorderPicker::borders()
  std::size_t edge = 0;    ///< of the border: from this vertex of it to the next one
  std::size_t vertex = 0;  ///< of the border, that is nearest

  bool operator==(const BorderSpot&) const = default;
};

/// A border, or a part of it, that the user picked.
struct PickedBorder {
  scene::BorderDescription description;  ///< as a scene file has it
  std::vector<int> vertices;             ///< of the model, in order
  bool isClosed = false;
  double length = 0.0;  ///< at rest [m]
};

/// Finds the open borders of a scene in the picture, and their parts.
class BorderPicker {
 public:
  explicit BorderPicker(const scene::Scene& scene);

  [[nodiscard]] std::span<const scene::BoundaryLoop> borders() const { return borders_; }

  /// The border at a place in the window. Of two that are nearly at the same place, the one nearer to the eye.
  /// @param positions of the cloth now [m]  @param maxDistance of the place from it [window units]
  [[nodiscard]] std::optional<BorderSpot> at(const Vec2& place, double maxDistance, std::span<const Vec3> positions,
                                             const GizmoPicture& picture) const;

  /// A vertex of the model in the middle of each part between corners.
  [[nodiscard]] std::vector<int> middles() const;

  /// The vertex of the model at a spot.
  [[nodiscard]] int vertexAt(const BorderSpot& spot) const { return borders_[spot.border].vertices[spot.vertex]; }

  /// The whole border, from the vertex at the spot.
  [[nodiscard]] PickedBorder whole(const BorderSpot& spot) const;
  /// The part with the spot that ends at two corners of the rest shape; the whole border if it has fewer than two.
  [[nodiscard]] PickedBorder betweenCorners(const BorderSpot& spot) const;
  /// The part between two spots of one border; empty when they are at the same vertex.
  /// @param longer whether it is the longer one
  [[nodiscard]] std::optional<PickedBorder> between(const BorderSpot& from, const BorderSpot& to, bool longer) const;

 private:
  [[nodiscard]] PickedBorder picked(std::vector<int> vertices, bool isClosed) const;
  [[nodiscard]] std::vector<int> forward(std::size_t border, std::size_t from, std::size_t to) const;
  [[nodiscard]] double lengthOf(std::span<const int> vertices, bool isClosed) const;

  const scene::Scene& scene_;
  std::vector<scene::BoundaryLoop> borders_;
  std::vector<std::vector<std::size_t>> corners_;  // of each border, ascending
};

}  // namespace drape::ui
