#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <vector>

namespace drape::io {

using GltfMatrix = Eigen::Matrix4d;

/// A matrix as glTF writes it, column by column.
[[nodiscard]] nlohmann::json numbersOf(const GltfMatrix& matrix);

/// The places of the nodes of a glTF document in its scene. Source: glTF 2.0 specification, section 3.5.
class GltfPlaces {
 public:
  /// @param nodes trees, whose placements and children were checked; it must outlive this
  explicit GltfPlaces(const nlohmann::json& nodes);

  /// The number of nodes above this one.
  [[nodiscard]] std::size_t depthOf(std::size_t node) const;

  /// The transform from the coordinates of a node to those of the scene.
  [[nodiscard]] GltfMatrix of(std::size_t node) const;

 private:
  const nlohmann::json& nodes_;
  std::vector<std::size_t> parents_;  // the number of nodes: none
};

}  // namespace drape::io
