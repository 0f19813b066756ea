#pragma once

#include "sim/model/cloth_model.hpp"
#include "sim/model/seams.hpp"

#include <optional>
#include <span>
#include <vector>

namespace drape::scene {

/// Vertices along an open border.
struct BorderPath {
  std::vector<int> vertices;
  bool isClosed = false;  ///< the whole border; its first vertex is not repeated
};

/// The path between two vertices of a closed border on the shorter way, or through a third one.
/// @param border its vertices in order
/// @return nothing if one of them is not part of the border
[[nodiscard]] std::optional<BorderPath> pathAlong(std::span<const int> border, std::span<const Vec3> positions,
                                                  int first, int last, std::optional<int> between);

/// The whole border from a vertex of it, in the direction in which the sides of its triangles run, or against it.
[[nodiscard]] BorderPath wholeBorder(std::span<const int> border, const sim::ClothMesh& mesh, int start, bool reversed);

/// Pairs the vertices of two paths. Equal numbers: one after the other. Otherwise each vertex of the path with fewer
/// ones gets the vertex of the other at the nearest share of the length, in order and each once.
[[nodiscard]] std::vector<sim::SeamPair> matched(const BorderPath& from, const BorderPath& to,
                                                 std::span<const Vec3> positions);

}  // namespace drape::scene
